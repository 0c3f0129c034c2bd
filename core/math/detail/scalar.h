// SPDX-License-Identifier: LGPL-2.1-or-later
// The scalar of a point, where a point may also be a plain number.

#pragma once

#include "core/math/vec.h"

namespace blossom::detail {

template <class T>
struct ScalarType {
  using type = T;
};
template <class Scalar, int Dim>
struct ScalarType<Vec<Scalar, Dim>> {
  using type = Scalar;
};

/// The coordinates' type of a point, or the type itself of a number.
template <class T>
using scalar_of = typename ScalarType<T>::type;

}  // namespace blossom::detail
