// SPDX-License-Identifier: LGPL-2.1-or-later
// Normals of patches as Bernstein forms, over any scalar.

#pragma once

#include "core/forms/algebra/detail/derivatives.h"

namespace blossom::detail {

/// S_u x S_v.
template <class Scalar>
Grid<Vec<Scalar, 3>> normal_net(const Grid<Vec<Scalar, 3>>& net) {
  return cross_product(derivative_along_u(net), derivative_along_v(net));
}

/// w (X_u x X_v) + w_v (X x X_u) - w_u (X x X_v).
template <class Scalar>
Grid<Vec<Scalar, 3>> normal_net(const Grid<Vec<Scalar, 4>>& net) {
  const auto [x, w] = parts_of(net);
  const auto x_u = derivative_along_u(x), x_v = derivative_along_v(x);
  Grid<Vec<Scalar, 3>> sum = scalar_product(w, cross_product(x_u, x_v));
  const auto second = scalar_product(derivative_along_v(w), cross_product(x, x_u));
  const auto third = scalar_product(derivative_along_u(w), cross_product(x, x_v));
  for (int i = 0; i < sum.rows(); ++i)
    for (int j = 0; j < sum.columns(); ++j) sum(i, j) += second(i, j) - third(i, j);
  return sum;
}

}  // namespace blossom::detail
