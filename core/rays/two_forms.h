// SPDX-License-Identifier: LGPL-2.1-or-later
// What the nets of two functions f and g on the unit square say about their common roots.
//
// With C the inverse of the mean Jacobian, G = C (f, g) differs from the identity by no more than
// the spread: so a root x has |x - c + G(c)| <= E |x - c| for every point c, and there is at most
// one if E is a contraction. Source: Krawczyk 1969.

#pragma once

#include <array>

#include "core/math/value_range.h"
#include "core/math/vec.h"
#include "core/subdivision/cell_nets.h"

namespace blossom {

using Matrix2 = std::array<std::array<double, 2>, 2>;

/// Of the values of a form.
ValueRange range_of(const double* values, int count);
inline double largest_of(const ValueRange& range) {
  return range.high > -range.low ? range.high : -range.low;
}

/// E >= 0 bounds how far a Jacobian is from the identity; true proves that the map is one-to-one:
/// every matrix within the bounds is regular, since their spectral radius is below 1.
bool is_contraction(const Matrix2& e);

/// Whether a region has no root, for a contraction E.
///
/// offset    G at a point p of the region, in its parameters
/// rounding  bound on its error
/// outside   -1 or 1 in a direction in which p lies on the lower or upper border, else 0
bool leads_outside(const Matrix2& e, const Vec2& offset, const Vec2& rounding, const Vec2& outside);

/// Two forms of equal degrees on one square.
struct TwoForms {
  ValueRange f, g;
  std::array<std::array<ValueRange, 2>, 2> slopes{};  ///< of f and g, by u and v
  bool regular = false;  ///< the mean Jacobian has an inverse; else the rest is zero
  Matrix2 inverse{};     ///< C
  Matrix2 spread{};      ///< E
  Vec2 rounding;         ///< of G
};

/// shape     2 planes, degrees at least 1
/// net       f and g, one after the other
/// margin    bound on the error of a value of the net
TwoForms two_forms(const NetShape& shape, const double* net, double margin);

/// (f, g) at a point of the unit square, or beyond.
Vec2 values_at(const NetShape& shape, const double* net, double s, double t);

inline Vec2 product(const Matrix2& m, const Vec2& v) {
  return {m[0][0] * v[0] + m[0][1] * v[1], m[1][0] * v[0] + m[1][1] * v[1]};
}

}  // namespace blossom
