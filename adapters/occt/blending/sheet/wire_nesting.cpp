// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/sheet/wire_nesting.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include <Geom2d_Curve.hxx>

#include "adapters/occt/convert/edge_charts.h"
#include "adapters/occt/convert/pcurves.h"
#include "core/plane/loops.h"

namespace blossom::occt {
namespace {

// Of the lengths in a loop: ends that are so far apart leave it open, by a period or a half of one.
// Within a loop that closes, tolerances alone leave gaps.
constexpr double kOpen = 0.1;

// A wire in the chart.
struct Loop {
  std::vector<PlanarPath> edges;
  double area = 0;
  bool closes = true;
};

Loop loop_of(const std::vector<TopoDS_Edge>& wire, const TopoDS_Face& face) {
  Loop loop;
  double length = 0, gap = 0;
  for (const TopoDS_Edge& edge : wire) {
    Interval range;
    const Handle(Geom2d_Curve) chart = chart_curve_of(edge, face, range);
    if (chart.IsNull()) return {{}, 0, false};
    const Interval way =
        edge.Orientation() == TopAbs_REVERSED ? Interval{range.to, range.from} : range;
    loop.edges.push_back(bezier_pieces(planar_curve(chart, range), way));
    if (loop.edges.back().empty()) return {{}, 0, false};
  }
  for (std::size_t i = 0; i < loop.edges.size(); ++i) {
    const PlanarPath& path = loop.edges[i];
    const PlanarPath& next = loop.edges[(i + 1) % loop.edges.size()];
    length += distance(start_of(path), middle_of(path)) + distance(middle_of(path), end_of(path));
    gap = std::max(gap, distance(end_of(path), start_of(next)));
    loop.area += area_along(path, start_of(loop.edges.front()));
  }
  loop.closes = gap <= kOpen * length;
  return loop;
}

bool goes_round(const Loop& loop, const Vec2& point) {
  int winding = 0;
  for (std::size_t i = 0; i < loop.edges.size(); ++i) {
    const PlanarPath& next = loop.edges[(i + 1) % loop.edges.size()];
    winding += ray_crossings(loop.edges[i], point) +
               ray_crossings(end_of(loop.edges[i]), start_of(next), point);
  }
  return winding > 0;
}

}  // namespace

std::vector<Wires> nested(const Wires& wires, const TopoDS_Face& face) {
  if (wires.size() < 2) return {wires};
  std::vector<Loop> loops;
  std::vector<std::size_t> outer;
  for (const auto& wire : wires) {
    loops.push_back(loop_of(wire, face));
    if (!loops.back().closes) return {wires};
    if (loops.back().area > 0) outer.push_back(loops.size() - 1);
  }
  if (outer.size() < 2) return {wires};
  std::vector<Wires> faces;
  for (const std::size_t i : outer) faces.push_back({wires[i]});
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (loops[i].area > 0) continue;
    std::optional<std::size_t> in;
    for (std::size_t k = 0; k < outer.size(); ++k)
      if (goes_round(loops[outer[k]], middle_of(loops[i].edges.front())) &&
          (!in || loops[outer[k]].area < loops[outer[*in]].area))
        in = k;
    if (!in) return {wires};
    faces[*in].push_back(wires[i]);
  }
  return faces;
}

}  // namespace blossom::occt
