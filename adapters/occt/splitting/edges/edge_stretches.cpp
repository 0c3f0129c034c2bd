// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/splitting/edges/edge_stretches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>

#include "adapters/occt/base/points.h"

namespace blossom::occt {
namespace {

// What touches with a radius r keeps within a tolerance t for sqrt(8 r t); the stretch in which it
// is found is a few times longer.
constexpr double kLongestTouch = 16;
constexpr double kStatedShare = 0.1;  // of an edge's length: what its tolerance may be at most
constexpr double kLeaving = 0.5;   // of the reach: a surface so far off at the end of a run is left
constexpr int kTinyPoints = 64;    // of a curve of about a millionth: the next one is 1e-8 off
constexpr int kContactPoints = 8;  // of a contact that an edge may stand for

double chord(const RangedCurve& of, const Interval& range) {
  const gp_Pnt middle = of.curve->Value(at(range, 0.5));
  return middle.Distance(of.curve->Value(range.from)) + middle.Distance(of.curve->Value(range.to));
}

}  // namespace

RangedCurve curve_of(const TopoDS_Edge& edge) {
  RangedCurve of;
  of.curve = BRep_Tool::Curve(edge, of.range.from, of.range.to);
  return of;
}

EdgeFoot foot_on(const RangedCurve& of, const gp_Pnt& point) {
  EdgeFoot best{of.range.from, point.Distance(of.curve->Value(of.range.from))};
  const auto consider = [&](double parameter, double distance) {
    if (distance < best.distance) best = {parameter, distance};
  };
  consider(of.range.to, point.Distance(of.curve->Value(of.range.to)));
  try {
    const GeomAPI_ProjectPointOnCurve found(point, of.curve, of.range.from, of.range.to);
    if (found.NbPoints() > 0) consider(found.LowerDistanceParameter(), found.LowerDistance());
  } catch (const Standard_Failure&) {  // of what is about as short as its own tolerances
    for (int i = 1; i < kTinyPoints; ++i) {
      const double t = at(of.range, static_cast<double>(i) / kTinyPoints);
      consider(t, point.Distance(of.curve->Value(t)));
    }
  }
  return best;
}

bool is_short(const RangedCurve& of, const Interval& stretch, double tolerance) {
  return chord(of, stretch) <= kLongestTouch * std::sqrt(tolerance * chord(of, of.range));
}

bool passes(const RangedCurve& of, const Interval& stretch, const SurfaceProjector& feet,
            double reach) {
  const auto leaves = [&](double t) {
    return std::abs(feet.height(vec(of.curve->Value(t)))) > kLeaving * reach;
  };
  return is_short(of, stretch, reach) && (leaves(stretch.from) || leaves(stretch.to));
}

bool keeps_on(const RangedCurve& of, const Interval& stretch, const SurfaceProjector& feet,
              double reach) {
  return std::ranges::all_of(std::array{0.0, 0.25, 0.5, 0.75, 1.0}, [&](double part) {
    return std::abs(feet.height(vec(of.curve->Value(at(stretch, part))))) <= reach;
  });
}

std::vector<Interval> one_places(const RangedCurve& of, const TopoDS_Face& face,
                                 const std::vector<CurveSurfacePoint>& points, double tolerance,
                                 double within) {
  std::vector<Interval> found;
  std::optional<SurfaceProjector> feet;
  const auto add = [&](const Interval& between) {
    if (!is_short(of, between, tolerance)) return;
    if (!feet) feet.emplace(face, tolerance);
    if (keeps_on(of, between, *feet, within)) found.push_back(between);
  };
  if (!points.empty()) add({of.range.from, points.front().t});
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].tangential) add(points[i].box_t);
    add({points[i].t, i + 1 < points.size() ? points[i + 1].t : of.range.to});
  }
  return found;
}

std::optional<Interval> stretch_beside(const RangedCurve& along, const RangedCurve& of,
                                       const Interval& stretch, double within) {
  std::array<EdgeFoot, 3> feet;
  for (std::size_t i = 0; i < feet.size(); ++i)
    feet[i] = foot_on(along, of.curve->Value(at(stretch, 0.5 * static_cast<double>(i))));
  if (std::ranges::any_of(feet, [&](const EdgeFoot& foot) { return foot.distance > within; }))
    return {};
  const double from = feet.front().parameter, to = feet.back().parameter;
  return Interval{std::min(from, to), std::max(from, to)};
}

std::optional<Interval> stretch_in_node(const RangedCurve& of, const Place& node,
                                        double tolerance) {
  const double size = distance(node.box_low, node.box_high);
  const EdgeFoot foot = foot_on(of, pnt(0.5 * (node.box_low + node.box_high)));
  if (size <= tolerance || foot.distance > size) return {};
  const Interval stretch = widened_by(of, {foot.parameter, foot.parameter}, size);
  if (!is_short(of, stretch, tolerance)) return {};
  return stretch;
}

bool lies_throughout(const RangedCurve& of, const SurfaceProjector& feet, double reach) {
  return std::ranges::all_of(std::array{0.07, 0.21, 0.39, 0.58, 0.74, 0.93}, [&](double part) {
    return std::abs(feet.height(vec(of.curve->Value(at(of.range, part))))) <= reach;
  });
}

Interval widened_by(const RangedCurve& of, const Interval& stretch, double length) {
  gp_Pnt point;
  gp_Vec rate;
  of.curve->D1(at(stretch, 0.5), point, rate);
  const double step = length / std::max(rate.Magnitude(), Precision::Confusion());
  return {stretch.from - step, stretch.to + step};
}

double stated_together(const TopoDS_Edge& a, const TopoDS_Edge& b) {
  double sum = 0;
  for (const TopoDS_Edge& edge : {a, b}) {
    const RangedCurve of = curve_of(edge);
    sum += std::min(BRep_Tool::Tolerance(edge), kStatedShare * chord(of, of.range));
  }
  return sum;
}

bool stands_for_contact(const std::vector<TopoDS_Edge>& edges, const IntersectionCurve& curve,
                        const SurfaceProjector& on_a, const SurfaceProjector& on_b,
                        double tolerance) {
  return std::ranges::any_of(edges, [&](const TopoDS_Edge& edge) {
    const RangedCurve of = curve_of(edge);
    const double beside = kLongestTouch * std::sqrt(tolerance * chord(of, of.range));
    const double within = tolerance + BRep_Tool::Tolerance(edge);
    for (int i = 0; i <= kContactPoints; ++i) {
      const double part = static_cast<double>(i) / kContactPoints;
      const Vec3 x = point_at(curve.curve, at(curve.curve.domain(), part));
      const EdgeFoot foot = foot_on(of, {x[0], x[1], x[2]});
      if (foot.distance > beside) return false;
      const Vec3 on_edge = vec(of.curve->Value(foot.parameter));
      if (std::abs(on_a.height(on_edge)) > within || std::abs(on_b.height(on_edge)) > within)
        return false;
    }
    return true;
  });
}

}  // namespace blossom::occt
