// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/face_data.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <Geom_TrimmedCurve.hxx>

#include "adapters/occt/curves.h"
#include "adapters/occt/errors.h"
#include "adapters/occt/surfaces.h"

namespace blossom::occt {
namespace {

constexpr double kLeastEdgeTolerance = 1e-7;  // Open CASCADE's Precision::Confusion
constexpr double kEdgeMargin = 1.1;           // of the edge's tolerance over the deviation

Box box_of(const BezierSurface& surface, double margin) {
  Box box;
  for (const RationalBezierPatch& patch : surface.patches.values())
    for (const Vec4& p : patch.points.values()) {
      const Vec3 x{p[0] / p[3], p[1] / p[3], p[2] / p[3]};
      box = joined(box, {x, x});
    }
  const Vec3 r{margin, margin, margin};
  return {box.low - r, box.high + r};
}

// Both lists are increasing and disjoint.
std::vector<Interval> common(const std::vector<Interval>& a, const std::vector<Interval>& b) {
  std::vector<Interval> result;
  for (const Interval& x : a)
    for (const Interval& y : b) {
      const Interval both{std::max(x.from, y.from), std::min(x.to, y.to)};
      if (both.from < both.to) result.push_back(both);
    }
  return result;
}

SurfacePoint point_of(const IntersectionCurve& curve, double t) {
  return {point_at(curve.curve, t), point_at(curve.chart_a, t), point_at(curve.chart_b, t)};
}

// The part of a curve on an interval, its ends named where they are new.
IntersectionCurve part_of(const IntersectionCurve& whole, const Interval& part) {
  IntersectionCurve curve = whole;
  const Interval domain = whole.curve.domain();
  curve.closed = false;
  curve.curve = restricted(whole.curve, part);
  curve.chart_a = restricted(whole.chart_a, part);
  curve.chart_b = restricted(whole.chart_b, part);
  curve.ends = {part.from > domain.from || whole.closed ? CurveEnd::Trim : whole.ends[0],
                part.to < domain.to || whole.closed ? CurveEnd::Trim : whole.ends[1]};
  curve.length = whole.conic ? arc_length(*whole.conic, part) : length(part);
  curve.samples.clear();
  curve.sample_parameters.clear();
  const auto add = [&](const SurfacePoint& p, double t) {
    curve.samples.push_back(p);
    curve.sample_parameters.push_back(t);
  };
  const double apart = 1e-3 * length(part);
  add(part.from > domain.from ? point_of(whole, part.from) : whole.samples.front(), part.from);
  for (std::size_t i = 0; i < whole.samples.size(); ++i) {
    const double t = whole.sample_parameters[i];
    if (t > part.from + apart && t < part.to - apart) add(whole.samples[i], t);
  }
  add(part.to < domain.to ? point_of(whole, part.to) : whole.samples.back(), part.to);
  return curve;
}

// The same curve with its conic's parameter in the first turn, where it begins.
IntersectionCurve in_first_turn(IntersectionCurve curve) {
  constexpr double kTurn = 2 * std::numbers::pi;
  if (!curve.conic || !curve.conic->is_closed()) return curve;
  const double shift = -kTurn * std::floor(curve.curve.domain().from / kTurn);
  if (shift == 0) return curve;
  for (std::vector<double>* parameters :
       {&curve.curve.knots, &curve.chart_a.knots, &curve.chart_b.knots, &curve.sample_parameters})
    for (double& t : *parameters) t += shift;
  return curve;
}

// A loop's last part and its first one are one curve through the loop's start.
IntersectionCurve appended(IntersectionCurve first, const IntersectionCurve& second) {
  const double shift = first.curve.domain().to - second.curve.domain().from;
  first.curve = joined(first.curve, second.curve);
  first.chart_a = joined(first.chart_a, second.chart_a);
  first.chart_b = joined(first.chart_b, second.chart_b);
  first.length += second.length;
  for (std::size_t i = 1; i < second.samples.size(); ++i) {
    first.samples.push_back(second.samples[i]);
    first.sample_parameters.push_back(second.sample_parameters[i] + shift);
  }
  return first;
}

void clip(const IntersectionCurve& whole, const std::vector<Interval>& parts,
          std::vector<IntersectionCurve>& result) {
  const Interval domain = whole.curve.domain();
  if (parts.empty()) return;
  if (parts.size() == 1 && parts[0] == domain) {
    result.push_back(whole);
    return;
  }
  std::vector<IntersectionCurve> curves;
  for (const Interval& part : parts) curves.push_back(part_of(whole, part));
  // Only where the charts close too: a curve round a period ends on the seam.
  const bool charts_close = whole.closed &&
                            distance(whole.samples.front().uv_a, whole.samples.back().uv_a) == 0 &&
                            distance(whole.samples.front().uv_b, whole.samples.back().uv_b) == 0;
  if (charts_close && curves.size() > 1 && parts.front().from == domain.from &&
      parts.back().to == domain.to) {
    curves.front() = appended(std::move(curves.back()), curves.front());
    curves.pop_back();
  }
  for (IntersectionCurve& curve : curves) result.push_back(in_first_turn(std::move(curve)));
}

Handle(Geom_Curve) space_curve(const IntersectionCurve& curve) {
  if (!curve.conic) return to_occt(curve.curve);
  const Handle(Geom_Curve) whole = to_occt(*curve.conic);
  const Interval range = curve.curve.domain();
  if (curve.conic->is_closed() && range == Interval{0, 2 * std::numbers::pi}) return whole;
  constexpr bool kSameSense = true, kIntoFirstPeriod = false;  // pcurves keep their parameter
  return guarded("trimming a conic", [&]() -> Handle(Geom_Curve) {
    return new Geom_TrimmedCurve(whole, range.from, range.to, kSameSense, kIntoFirstPeriod);
  });
}

bool inside(const FaceTrims& trims, const Vec2& uv) {
  return trims.natural || is_inside(trims, {uv[0] * trims.scale[0], uv[1] * trims.scale[1]});
}

}  // namespace

FaceData face_data(const TopoDS_Face& face, double tolerance) {
  FaceData data;
  data.surface = bezier_surface(face, tolerance);
  data.trims = face_trims(face);
  data.box = box_of(data.surface, data.surface.error + tolerance);
  return data;
}

PartTest part_test(const FaceTrims& trims) {
  if (trims.natural) return {};
  return [&trims](const Interval& u, const Interval& v) { return part_side(trims, u, v); };
}

void clip(SurfaceIntersection& found, const FaceTrims& a, const FaceTrims* b) {
  const auto counts = [](const FaceTrims* trims) { return trims != nullptr && !trims->natural; };
  if (!counts(&a) && !counts(b)) return;
  std::vector<IntersectionCurve> curves;
  for (const IntersectionCurve& curve : found.curves) {
    const std::vector<Interval> in_a = clip_to_trims(a, curve.chart_a);
    clip(curve, b == nullptr ? in_a : common(in_a, clip_to_trims(*b, curve.chart_b)), curves);
  }
  found.curves = std::move(curves);
  const auto outside = [&](const SurfacePoint& p) {
    return !inside(a, p.uv_a) || (b != nullptr && !inside(*b, p.uv_b));
  };
  std::erase_if(found.points, outside);
  std::erase_if(found.nodes, outside);
  found.overlaps.clear();
}

EdgeCurves edge_curves(const IntersectionCurve& curve) {
  const Deviation& d = curve.deviation;
  return {space_curve(curve), to_occt(curve.chart_a), to_occt(curve.chart_b),
          std::max(kLeastEdgeTolerance, kEdgeMargin * std::max({d.a, d.b, d.between}))};
}

void add(Certificate& sum, const Certificate& one) {
  sum.excluded += one.excluded;
  sum.certified += one.certified;
  sum.critical += one.critical;
  sum.cells_bezier += one.cells_bezier;
  sum.cells_monomial += one.cells_monomial;
  sum.depth = std::max(sum.depth, one.depth);
  sum.rounding_bound = std::max(sum.rounding_bound, one.rounding_bound);
  if (one.least_angle > 0)
    sum.least_angle =
        sum.least_angle > 0 ? std::min(sum.least_angle, one.least_angle) : one.least_angle;
  for (const std::string& reason : one.reasons)
    if (std::find(sum.reasons.begin(), sum.reasons.end(), reason) == sum.reasons.end())
      sum.reasons.push_back(reason);
}

}  // namespace blossom::occt
