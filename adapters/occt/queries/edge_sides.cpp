// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/queries/edge_sides.h"

#include <algorithm>
#include <cstddef>

#include <BRep_Tool.hxx>
#include <Geom_Curve.hxx>

#include "adapters/occt/curve_queries.h"

namespace blossom::occt {

EdgeStretches stretches_beside(const TopoDS_Edge& edge, const std::vector<TopoDS_Face>& faces,
                               const IntersectionOptions& options) {
  EdgeStretches stretches;
  double first = 0, last = 0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
  std::vector<double> cuts = {first, last};
  const auto add = [&](const Interval& range) { cuts.insert(cuts.end(), {range.from, range.to}); };
  for (const TopoDS_Face& face : faces) {
    const CurveSurfaceIntersection met = intersect(edge, face, options);
    stretches.status = weaker(stretches.status, met.status);
    for (const CurveSurfacePoint& point : met.points) add(point.box_t);
    for (const CurveSurfaceOverlap& run : met.overlaps) add(run.t);
    for (const CurvePlace& place : met.places) add(place.a);
  }
  std::ranges::sort(cuts);
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
    if (cuts[i] < cuts[i + 1])
      stretches.middles.push_back(curve->Value(0.5 * (cuts[i] + cuts[i + 1])));
  return stretches;
}

}  // namespace blossom::occt
