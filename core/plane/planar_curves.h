// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves in a chart: trimming curves and cuts, as rational Bezier spans.
//
// A homogeneous planar point is (wx, wy, w); weights are positive, so the control points still
// hold their curve in their convex hull.

#pragma once

#include <span>
#include <vector>

#include "core/forms/curve.h"
#include "core/forms/spline.h"
#include "core/forms/surface.h"
#include "core/math/interval.h"
#include "core/math/vec.h"

namespace blossom {

using PlanarBezier = BezierCurveOf<Vec3>;

/// One span with its place in the curve's own parameters.
struct PlanarSpan {
  PlanarBezier curve;
  Interval place;  ///< increasing
  ParameterLaw law = ParameterLaw::Linear;
};

/// Spans in the order of their places, each of which starts where the one before ends.
struct PlanarCurve {
  std::vector<PlanarSpan> spans;

  Interval domain() const { return {spans.front().place.from, spans.back().place.to}; }
};

/// An axis-parallel rectangle.
struct PlanarBox {
  Vec2 low;
  Vec2 high;
};

/// Value and derivatives by the curve's own parameter.
struct PlanarJet {
  Vec2 point;
  Vec2 first;
  Vec2 second;
};

/// The B-spline as its Bezier spans.
/// throws   InvalidInput if the numbers of knots, multiplicities and points do not fit together
/// Source: Ramshaw 1989: the Bezier points of a span are the blossom at its ends.
PlanarCurve planar_curve(const Spline2& spline);

/// The straight line from `from` to `to` over `place`.
PlanarCurve planar_line(const Vec2& from, const Vec2& to, const Interval& place);

/// The curve with its coordinates multiplied by `scale` and then moved by `shift`.
PlanarCurve transformed(PlanarCurve curve, const Vec2& scale, const Vec2& shift);

/// By the local parameter.
PlanarJet jet_at(const PlanarBezier& curve, double t);

/// By the curve's own parameter; clamped to the domain.
PlanarJet jet_at(const PlanarCurve& curve, double parameter);
Vec2 point_at(const PlanarCurve& curve, double parameter);

/// How long a piece is, by the chords of its halves.
double chord_length(const PlanarCurve& curve, const Interval& piece);

/// The piece between two parameters as Bezier curves, in order; from > to runs backwards. Pieces
/// of spans that are no longer than rounding are left out; none for an empty range.
std::vector<PlanarBezier> bezier_pieces(const PlanarCurve& curve, const Interval& range);

/// The piece of one span between two of its local parameters in [0, 1]; from > to reverses it.
PlanarBezier bezier_piece(const PlanarBezier& curve, const Interval& local);

/// The box of the control points; it holds the curve.
PlanarBox box_of(std::span<const Vec3> points);
PlanarBox box_of(const PlanarCurve& curve);
PlanarBox united(const PlanarBox& a, const PlanarBox& b);

/// Whether boxes are apart by more than the margin in a coordinate.
inline bool are_disjoint(const PlanarBox& a, const PlanarBox& b, double margin = 0) {
  for (int k = 0; k < 2; ++k)
    if (a.low[k] > b.high[k] + margin || b.low[k] > a.high[k] + margin) return true;
  return false;
}

/// Whether a point leaves the box by no more than the margin in either coordinate.
inline bool holds(const PlanarBox& box, const Vec2& point, double margin = 0) {
  for (int k = 0; k < 2; ++k)
    if (point[k] < box.low[k] - margin || point[k] > box.high[k] + margin) return false;
  return true;
}

inline Vec2 projected(const Vec3& point) { return {point[0] / point[2], point[1] / point[2]}; }

/// The parameter whose point is nearest to `target`, and how near it is. Found from samples and
/// Newton's method: for points that lie near the curve, not a proof of the global minimum.
struct PlanarFoot {
  double parameter = 0;
  double distance = 0;
};
PlanarFoot nearest(const PlanarCurve& curve, const Vec2& target);

}  // namespace blossom
