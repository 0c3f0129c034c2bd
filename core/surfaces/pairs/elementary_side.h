// SPDX-License-Identifier: LGPL-2.1-or-later
// On which side of a plane, cylinder or sphere a patch stays that touches it along a parameter
// line.
//
// Where a rounding ends in the face that it rounds, both are tangent: boxes, planes and directions
// never tell them apart beside the common edge, and within a tolerance e they are for
// sqrt(2 e r). The equation of the other surface over the patch tells: it is 0 along the line, so
// is its slope across, and it bends to one side.

#pragma once

#include <array>
#include <optional>

#include "core/forms/elementary.h"
#include "core/forms/function.h"
#include "core/forms/patch.h"
#include "core/math/interval.h"

namespace blossom {

class ElementarySide {
 public:
  /// The equation, with f the signed distance to first order:
  ///
  ///   plane n . (x - c)      sphere (|x - c|^2 - r^2) / 2r      cylinder the same across the axis
  ///
  /// times the weight, or its square: a form of the patch's degrees, or twice them.
  ///
  /// surface, patch   with one origin, not far away, as coordinates' roundings count
  /// returns          nothing for cones and tori, for weights that are not positive, and for
  ///                  degrees above kMaxDegree
  static std::optional<ElementarySide> of(const Elementary& surface,
                                          const RationalBezierPatch& patch);

  /// A bound on how deep the patch gets behind the surface, seen from the side to which it bends.
  /// With e in `line` where it touches, v the coordinate across and s = +-1 that side:
  ///
  ///   s f >= -g0 - g1 |v - e| + k (v - e)^2 / 2 >= -(g0 + g1^2 / 2k)
  ///
  /// where |f| <= g0 and |f_v| <= g1 at all (u, v) of `along` x `line`, and s f_vv >= k > 0 over
  /// all of `along` x `whole`. Everything that is as deep lies beside the line.
  ///
  /// across    the coordinate across the line: 0 u, 1 v
  /// along     of the other coordinate, in [0, 1] as all
  /// line      where the line is
  /// whole     holds `line`
  /// returns   model units; infinity if the patch is not seen to bend to one side
  double depth(int across, const Interval& along, const Interval& line,
               const Interval& whole) const;

 private:
  BezierFunction2 value_;
  std::array<BezierFunction2, 2> first_, second_;
  std::array<double, 3> rounding_{};  // of the values and of each derivative's points
  double least_scale_ = 1;            // of f in the values: the least weight, or its square
};

}  // namespace blossom
