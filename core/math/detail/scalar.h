// SPDX-License-Identifier: LGPL-2.1-or-later
// The scalar of a point, where a point may also be a plain number.

#pragma once

#include <type_traits>

#include "core/math/vec.h"

namespace blossom::detail {

template <class T>
struct ScalarType {
  using type = T;
  static constexpr int dimension = 1;
};
template <class Scalar, int Dim>
struct ScalarType<Vec<Scalar, Dim>> {
  using type = Scalar;
  static constexpr int dimension = Dim;
};

/// The coordinates' type of a point, or the type itself of a number.
template <class T>
using scalar_of = typename ScalarType<T>::type;

template <class T>
inline constexpr int dimension_of = ScalarType<T>::dimension;

/// Coordinate k of a point; of a number, itself.
template <class T>
auto& coordinate(T& point, int k) {
  if constexpr (dimension_of<std::remove_const_t<T>> == 1)
    return point;
  else
    return point[k];
}

}  // namespace blossom::detail
