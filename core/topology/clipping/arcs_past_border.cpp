// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/topology/clipping/arcs_past_border.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "core/forms/spline.h"
#include "core/results/hermite_curves.h"
#include "core/topology/clipping/curve_clip.h"

namespace blossom {
namespace {

constexpr int kCubic = 3;
constexpr std::array kLooks{0.1, 0.3, 0.5, 0.7, 0.9};  // at a piece

Vec2 in_chart(const FaceTrims& trims, const Vec2& uv) {
  return {uv[0] * trims.scale[0], uv[1] * trims.scale[1]};
}

HermiteJet turned_round(const HermiteJet& jet) {
  return {jet.value, {-1.0 * jet.rate.point, -1.0 * jet.rate.uv_a, -1.0 * jet.rate.uv_b}};
}

// An end of a curve: its place, and by arc length how the curve would go on beyond it.
HermiteJet jet_beyond(const IntersectionCurve& curve, bool last) {
  const double t = last ? curve.curve.domain().to : curve.curve.domain().from;
  const Vec3 along = derivative_at(curve.curve, t);
  const double per_length = (last ? 1 : -1) / norm(along);
  return {last ? curve.samples.back() : curve.samples.front(),
          {per_length * along, per_length * derivative_at(curve.chart_a, t),
           per_length * derivative_at(curve.chart_b, t)}};
}

// By whole periods, so that the arc's image goes on where that of the curve ends. None if both are
// not there in one place, or the arc is at no border that is a period away.
std::optional<Vec2> chart_move(const FaceTrims& trims, const Spline2& arc, const Vec2& arc_end,
                               const Vec2& end, double apart, double tolerance) {
  const Vec2 by = end - arc_end;
  Vec2 move;
  for (int k = 0; k < 2; ++k) {
    const double period = trims.period[k] / trims.scale[k];
    if (period > 0) move[k] = std::round(by[k] / period) * period;
  }
  const SurfaceJet jet = trims.jet(end);
  const Vec2 rest = by - move;
  if (norm(rest[0] * jet.du + rest[1] * jet.dv) > 2 * (apart + tolerance)) return {};
  if (!(move == Vec2{}) && !keeps_to_border(trims, arc, tolerance)) return {};
  return move;
}

// The same polynomials in a higher degree.
template <class Point>
void elevate(SplineOf<Point>& span, int degree) {
  for (; span.degree < degree; ++span.degree) {
    std::vector<Point> points{span.points.front()};
    const double n = span.degree + 1;
    for (std::size_t i = 1; i < span.points.size(); ++i) {
      const double part = static_cast<double>(i) / n;
      points.push_back(part * span.points[i - 1] + (1 - part) * span.points[i]);
    }
    points.push_back(span.points.back());
    span.points = std::move(points);
    for (int& multiplicity : span.multiplicities) ++multiplicity;
  }
}

double worst(const Deviation& of) { return std::max({of.a, of.b, of.between}); }

// At samples.
Deviation deviation_of(const IntersectionCurve& piece, const FaceTrims& a, const FaceTrims* b) {
  Deviation largest;
  largest.proven = false;
  for (const double part : kLooks) {
    const double t = at(piece.curve.domain(), part);
    const Vec3 point = point_at(piece.curve, t), on_a = a.jet(point_at(piece.chart_a, t)).point;
    const Vec3 on_b = b == nullptr ? on_a : b->jet(point_at(piece.chart_b, t)).point;
    raise(largest, {distance(point, on_a), b == nullptr ? 0 : distance(point, on_b),
                    b == nullptr ? 0 : distance(on_a, on_b)});
  }
  return largest;
}

// An end of a curve that an arc begins or ends at, and the moves of the arc's images to its own.
struct Neighbour {
  std::size_t curve = 0;
  bool last = false;
  double apart = 0;
  Vec2 move_a, move_b;
};

// The nearest one at an end of the arc. Rounding takes the two ends apart along the border, where
// on it both are found, but by no more than the arc is long: what is farther off does not go on in
// it.
std::optional<Neighbour> neighbour(const IntersectionCurve& arc, bool arc_last, const FaceTrims& a,
                                   const FaceTrims* b, const std::vector<IntersectionCurve>& curves,
                                   double tolerance) {
  const SurfacePoint& end = arc_last ? arc.samples.back() : arc.samples.front();
  const SurfacePoint& opposite = arc_last ? arc.samples.front() : arc.samples.back();
  std::optional<Neighbour> best;
  for (std::size_t i = 0; i < curves.size(); ++i)
    for (const bool last : {false, true}) {
      const SurfacePoint& x = last ? curves[i].samples.back() : curves[i].samples.front();
      const double apart = distance(x.point, end.point);
      if (curves[i].closed || apart > (best ? best->apart : arc.length) ||
          apart >= distance(x.point, opposite.point))
        continue;
      const auto move_a = chart_move(a, arc.chart_a, end.uv_a, x.uv_a, apart, tolerance);
      const auto move_b = b == nullptr
                              ? std::optional(Vec2{})
                              : chart_move(*b, arc.chart_b, end.uv_b, x.uv_b, apart, tolerance);
      if (move_a && move_b) best = {i, last, apart, *move_a, *move_b};
    }
  return best;
}

// From the end of a curve to where the arc ends, or to the curve that goes on there.
IntersectionCurve bridge(const IntersectionCurve& curve, const Neighbour& of, HermiteJet to) {
  to.value.uv_a = to.value.uv_a + of.move_a;
  to.value.uv_b = to.value.uv_b + of.move_b;
  const HermiteJet from = jet_beyond(curve, of.last);
  const Interval domain = curve.curve.domain();
  const double length = distance(from.value.point, to.value.point);
  IntersectionCurve piece = of.last ? hermite_curve({from, to}, {domain.to, domain.to + length})
                                    : hermite_curve({turned_round(to), turned_round(from)},
                                                    {domain.from - length, domain.from});
  elevate(piece.curve, curve.curve.degree);
  elevate(piece.chart_a, curve.curve.degree);
  elevate(piece.chart_b, curve.curve.degree);
  piece.length = length;
  return piece;
}

void append(const IntersectionCurve& piece, bool last, CurveEnd end, IntersectionCurve& curve) {
  const auto add = [&](auto& spline, const auto& more) {
    spline = last ? joined(spline, more) : joined(more, spline);
  };
  add(curve.curve, piece.curve);
  add(curve.chart_a, piece.chart_a);
  add(curve.chart_b, piece.chart_b);
  const std::size_t added = last ? 1 : 0;  // of the piece's two samples
  const auto put = [&](auto& list, const auto& value) {
    list.insert(last ? list.end() : list.begin(), value);
  };
  put(curve.samples, piece.samples[added]);
  put(curve.sample_parameters, piece.sample_parameters[added]);
  curve.ends[added] = end;
  curve.length += piece.length;
  raise(curve.deviation, piece.deviation);
  curve.deviation.proven = false;
}

}  // namespace

bool keeps_to_border(const FaceTrims& trims, const Spline2& chart, double tolerance) {
  const Interval domain = chart.domain();
  const auto place = [&](double part) {
    return in_chart(trims, point_at(chart, at(domain, part)));
  };
  const Vec2 middle = place(0.5);
  if (distance(place(0), middle) + distance(middle, place(1)) > wire_touch_length(trims, tolerance))
    return false;
  return std::ranges::all_of(std::array{0.5, 0.25, 0.75}, [&](double part) {
    const Vec2 point = place(part);
    return std::ranges::any_of(trims.loops, [&](const std::vector<Coedge>& loop) {
      return std::ranges::any_of(
          loop, [&](const Coedge& of) { return nearest(of.curve, point).distance <= tolerance; });
    });
  });
}

bool append_border_arc(const IntersectionCurve& arc, const FaceTrims& a, const FaceTrims* b,
                       std::vector<IntersectionCurve>& curves, double tolerance) {
  const std::array neighbours{neighbour(arc, false, a, b, curves, tolerance),
                              neighbour(arc, true, a, b, curves, tolerance)};
  for (const std::size_t at : {0u, 1u}) {
    const std::optional<Neighbour>&of = neighbours[at], &other = neighbours[1 - at];
    if (!of) continue;
    IntersectionCurve& curve = curves[of->curve];
    if (curve.conic || curve.curve.degree < kCubic) continue;
    HermiteJet to = jet_beyond(arc, at == 0);
    if (other) {
      to = turned_round(jet_beyond(curves[other->curve], other->last));
      to.value.uv_a = to.value.uv_a - other->move_a;
      to.value.uv_b = to.value.uv_b - other->move_b;
    }
    IntersectionCurve piece = bridge(curve, *of, to);
    piece.deviation = deviation_of(piece, a, b);
    if (worst(piece.deviation) > std::max(kOnWire, worst(curve.deviation))) continue;
    append(piece, of->last, arc.ends[1 - at], curve);
    return true;
  }
  return false;
}

}  // namespace blossom
