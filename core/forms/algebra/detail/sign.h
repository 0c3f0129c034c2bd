// SPDX-License-Identifier: LGPL-2.1-or-later
// Values of Bernstein forms for their signs, over any scalar.

#pragma once

#include <vector>

#include "core/math/detail/bernstein.h"
#include "core/math/grid.h"

namespace blossom::detail {

/// f(a / b) b^n by de Casteljau's algorithm without a division: c_k becomes (b - a) c_k + a
/// c_(k+1).
template <class Scalar>
Scalar homogeneous_value(std::vector<Scalar> c, const Scalar& a, const Scalar& b) {
  const Scalar rest = b - a;
  for (; c.size() > 1; c.pop_back())
    for (std::size_t k = 0; k + 1 < c.size(); ++k) {
      const Scalar low = rest * c[k], high = a * c[k + 1];
      c[k] = low + high;
    }
  return c[0];
}

/// The same of a tensor product: f(a_u / b_u, a_v / b_v) b_u^n b_v^m.
template <class Scalar>
Scalar homogeneous_value(const Grid<Scalar>& c, const Scalar& a_u, const Scalar& b_u,
                         const Scalar& a_v, const Scalar& b_v) {
  std::vector<Scalar> column;
  for (int i = 0; i < c.rows(); ++i) {
    std::vector<Scalar> row;
    for (int j = 0; j < c.columns(); ++j) row.push_back(c(i, j));
    column.push_back(homogeneous_value(std::move(row), a_v, b_v));
  }
  return homogeneous_value(std::move(column), a_u, b_u);
}

}  // namespace blossom::detail
