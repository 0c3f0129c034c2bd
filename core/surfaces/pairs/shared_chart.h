// SPDX-License-Identifier: LGPL-2.1-or-later
// Two patches that are parts of one surface, proven by an identity of polynomials.
//
// Sub-patches of one surface, also elevated, turned over, transposed or re-parametrised by linear
// rational functions, satisfy A(u, v) = B(s, t) with s, t linear rational functions of one of
// u, v each. Three points in each direction give the functions; with them both sides of
//   w_B X_A = w_A X_B
// are polynomials, so the largest coefficient of their difference bounds the distance.

#pragma once

#include <array>
#include <optional>

#include "core/forms/patch.h"
#include "core/math/interval.h"
#include "core/surfaces/pairs/border_roots.h"

namespace blossom {

/// A monotone linear rational function on an interval.
struct LinearRational {
  Interval from;
  Interval to;       ///< values at the ends; decreasing if to.from > to.to
  double ratio = 1;  ///< of the rates at both ends; 1: linear

  double operator()(double x) const;

  /// The inverse function.
  LinearRational inverse() const { return {to, from, 1 / ratio}; }
};

/// Where the points of patch a lie on patch b.
struct SharedChart {
  bool transposed = false;  ///< s depends on v and t on u
  LinearRational s, t;
  std::array<Interval, 2> domain;  ///< of u, v: where this is proven

  /// The rectangle of b's parameters that belongs to one inside `domain`.
  std::array<Interval, 2> image(const Interval& u, const Interval& v) const;

  /// Likewise the rectangle of a's parameters.
  std::array<Interval, 2> inverse_image(const Interval& in_s, const Interval& in_t) const;
};

/// The chart through a point near (u, v, s, t).
///
/// tolerance    the distance that is proven over the whole domain, model units
/// returns      nothing if the patches are not parts of one surface, or not in this way; the
///              domain contains all of a that lies on b or on b's extension by a half
///
/// Source: Farouki and Rajan 1988, for the products; `core/surfaces/README.md`, "Coincidence".
std::optional<SharedChart> shared_chart(const RationalBezierPatch& a, const RationalBezierPatch& b,
                                        const Point4& near, double tolerance);

}  // namespace blossom
