// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/edge_intersection.h"

#include <algorithm>
#include <cstddef>

#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <GeomAdaptor_Curve.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/splitting/edges/edge_stretches.h"
#include "adapters/occt/splitting/edges/joined_curves.h"
#include "adapters/occt/wires/edge_divider.h"

namespace blossom::occt {
namespace {

double length_of(const RangedCurve& of, const Interval& range) {
  return GCPnts_AbscissaPoint::Length(GeomAdaptor_Curve(of.curve, range.from, range.to));
}

// What several edges have in common with one shape, each place once.
class EdgeAnswers {
 public:
  explicit EdgeAnswers(double tolerance) : tolerance_(tolerance) {}

  void add(int number, const TopoDS_Edge& edge, const MetEdge& met) {
    const RangedCurve of = curve_of(edge);
    const auto point = [&of](double parameter) { return vec(of.curve->Value(parameter)); };
    const double reach = std::max(tolerance_, BRep_Tool::Tolerance(edge));
    for (const MetStretch& stretch : met.stretches) {
      made_.stretches.push_back({number, stretch.range, stretch.on, length_of(of, stretch.range)});
      for (const double end : {stretch.range.from, stretch.range.to})
        ends_.push_back({point(end), reach});
    }
    for (const MetPoint& each : met.points)
      candidates_.push_back({{number, each.parameter, point(each.parameter), each.on}, reach});
    made_.status = weaker(made_.status, met.status);
    for (const std::string& reason : met.reasons) add_reason(reason);
    if (met.status == Status::Stopped && met.reasons.empty())
      add_reason("an edge was not looked at as a limit was reached");
  }

  // Points in which stretches end, or which edges have in common, are no points of their own.
  EdgeIntersection finish() {
    for (const Candidate& candidate : candidates_) {
      const EdgePoint& point = candidate.point;
      const auto is_here = [&](const Vec3& other, double reach) {
        return distance(point.point, other) <= std::max(candidate.reach, reach);
      };
      const bool ends =
          std::ranges::any_of(ends_, [&](const End& end) { return is_here(end.point, end.reach); });
      const bool known = std::ranges::any_of(made_.points, [&](const EdgePoint& other) {
        return other.on.IsSame(point.on) && is_here(other.point, 0);
      });
      if (!ends && !known) made_.points.push_back(point);
    }
    return std::move(made_);
  }

 private:
  struct End {
    Vec3 point;
    double reach = 0;
  };
  struct Candidate {
    EdgePoint point;
    double reach = 0;
  };

  void add_reason(const std::string& reason) {
    if (std::ranges::find(made_.reasons, reason) == made_.reasons.end())
      made_.reasons.push_back(reason);
  }

  double tolerance_;
  EdgeIntersection made_;
  std::vector<Candidate> candidates_;
  std::vector<End> ends_;
};

}  // namespace

EdgeIntersection intersect_edges(const std::vector<TopoDS_Edge>& edges, const TopoDS_Shape& shape,
                                 const IntersectionOptions& options) {
  return guarded("intersecting edges", [&] {
    EdgeDivider by(shape, {}, options);
    EdgeAnswers answers(options.tolerances.point);
    for (std::size_t i = 0; i < edges.size(); ++i)
      answers.add(static_cast<int>(i), edges[i], by.meet(edges[i]));
    return answers.finish();
  });
}

TopoDS_Compound joined_edges(const std::vector<TopoDS_Edge>& edges, const EdgeIntersection& met) {
  return guarded("joining edges", [&] {
    std::vector<FoundCurve> curves;
    for (const EdgeStretch& stretch : met.stretches) {
      const TopoDS_Edge& edge = edges[static_cast<std::size_t>(stretch.edge)];
      const RangedCurve of = curve_of(edge);
      const double tolerance = BRep_Tool::Tolerance(edge);
      const bool whole = stretch.range.from == of.range.from && stretch.range.to == of.range.to;
      curves.push_back({{of.curve, stretch.range},
                        whole && BRep_Tool::IsClosed(edge),
                        tolerance,
                        {tolerance, tolerance},
                        0});
    }
    std::vector<FoundPoint> points;
    for (const EdgePoint& point : met.points)
      points.push_back(
          {point.point, BRep_Tool::Tolerance(edges[static_cast<std::size_t>(point.edge)])});
    return joined_curves(curves, points);
  });
}

}  // namespace blossom::occt
