// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/queries/section_wires.h"

#include <algorithm>
#include <cmath>

#include <BRep_Builder.hxx>
#include <GeomAbs_CurveType.hxx>
#include <GeomAbs_Shape.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "core/math/functions/quadrature.h"

namespace blossom::occt {
namespace {

constexpr double kMinTolerance = 1e-7;  // Open CASCADE's Precision::Confusion

using End = std::size_t;  // 2 * curve + side
constexpr End kNone = static_cast<End>(-1);

// The direction in which a curve leaves its end.
Vec3 leaving(const SectionCurve& curve, bool last) {
  const auto& p = curve.samples;
  return last ? p[p.size() - 2] - p.back() : p[1] - p.front();
}

// The ends of curves at each node, by angle round it: of those that bound, or of the others.
std::vector<std::vector<End>> ends_at_nodes(const PlaneSection& section, const Vec3& normal,
                                            bool bounding) {
  std::vector<std::vector<End>> ends(section.nodes.size());
  for (std::size_t i = 0; i < section.curves.size(); ++i)
    for (std::size_t side = 0; side < 2; ++side)
      if (section.curves[i].bounding == bounding && section.curves[i].nodes[side] >= 0)
        ends[static_cast<std::size_t>(section.curves[i].nodes[side])].push_back(2 * i + side);
  for (std::vector<End>& here : ends) {
    if (here.size() < 3) continue;
    const auto direction = [&](End end) { return leaving(section.curves[end / 2], end % 2 == 1); };
    const Vec3 x = unit(direction(here.front())), y = cross(normal, x);
    const auto angle = [&](End end) {
      return std::atan2(dot(direction(end), y), dot(direction(end), x));
    };
    std::sort(here.begin(), here.end(), [&](End a, End b) { return angle(a) < angle(b); });
  }
  return ends;
}

// The end that goes on from each; kNone where a wire ends.
std::vector<End> partners(const PlaneSection& section, const Vec3& normal) {
  std::vector<End> partner(2 * section.curves.size(), kNone);
  for (const bool bounding : {true, false})
    for (const std::vector<End>& here : ends_at_nodes(section, normal, bounding)) {
      if (here.size() % 2 == 1) continue;
      for (std::size_t k = 0; k < here.size(); k += 2) {
        partner[here[k]] = here[k + 1];
        partner[here[k + 1]] = here[k];
      }
    }
  return partner;
}

// The wire that starts with an end, as far as it goes.
SectionWire wire_from(End start, const PlaneSection& section, const std::vector<End>& partner,
                      std::vector<bool>& used) {
  SectionWire wire;
  wire.bounding = section.curves[start / 2].bounding;
  for (End at = start; at != kNone; at = partner[at ^ 1]) {
    if (used[at / 2]) {
      wire.closed = at == start;
      break;
    }
    used[at / 2] = true;
    wire.uses.push_back({at / 2, at % 2 == 0});
    wire.length += section.curves[at / 2].length;
  }
  return wire;
}

TopoDS_Vertex vertex_at(const gp_Pnt& point, double tolerance) {
  TopoDS_Vertex vertex;
  BRep_Builder().MakeVertex(vertex, point, std::max(kMinTolerance, tolerance));
  return vertex;
}

TopoDS_Edge edge_of(const SectionCurve& curve, const std::vector<TopoDS_Vertex>& nodes) {
  TopoDS_Edge edge;
  const BRep_Builder builder;
  builder.MakeEdge(edge, curve.curve, std::max(kMinTolerance, curve.tolerance));
  const TopoDS_Vertex lone = vertex_at(curve.curve->Value(curve.range.from), curve.tolerance);
  for (std::size_t side = 0; side < 2; ++side) {
    const int node = curve.nodes[side];
    const TopoDS_Vertex vertex = node < 0 ? lone : nodes[static_cast<std::size_t>(node)];
    builder.Add(edge, vertex.Oriented(side == 0 ? TopAbs_FORWARD : TopAbs_REVERSED));
  }
  builder.Range(edge, curve.range.from, curve.range.to);
  return edge;
}

// By Green's theorem, round the start of the wire; the spans of a spline are smooth.
double area_in(const PlaneSection& section, const SectionWire& wire, const Vec3& normal) {
  const Vec3 origin = section.curves[wire.uses.front().curve].samples.front();
  double twice = 0;
  for (const CurveUse& use : wire.uses) {
    const SectionCurve& curve = section.curves[use.curve];
    const auto swept = [&](double t) {
      gp_Pnt point;
      gp_Vec along;
      curve.curve->D1(t, point, along);
      return dot(normal, cross(vec(point) - origin, vec(along)));
    };
    const GeomAdaptor_Curve spans(curve.curve, curve.range.from, curve.range.to);
    TColStd_Array1OfReal knots(1, spans.NbIntervals(GeomAbs_CN) + 1);
    spans.Intervals(knots, GeomAbs_CN);
    const double tolerance = std::max(kMinTolerance, curve.tolerance) * curve.length;
    for (int i = 1; i < knots.Length(); ++i)
      twice += (use.forward ? 1 : -1) * integral(swept, knots(i), knots(i + 1), tolerance).value;
  }
  return 0.5 * twice;
}

void measure_areas(PlaneSection& section, const Vec3& normal) {
  for (SectionWire& wire : section.wires)
    if (wire.closed && !wire.area) wire.area = area_in(section, wire, normal);
}

}  // namespace

void chain_wires(PlaneSection& section, const Vec3& normal) {
  const std::vector<End> partner = partners(section, normal);
  std::vector<bool> used(section.curves.size());
  // Open wires first, from an end that nothing precedes; what is left then are loops.
  for (const bool open : {true, false})
    for (End end = 0; end < partner.size(); ++end) {
      const SectionCurve& curve = section.curves[end / 2];
      const bool lone = curve.closed && curve.nodes[0] < 0;
      if (used[end / 2] || (open && (lone || partner[end] != kNone))) continue;
      section.wires.push_back(wire_from(end, section, partner, used));
      if (lone) section.wires.back().closed = true;
    }
  measure_areas(section, normal);
}

namespace {

// A closed wire in coordinates of the plane, each point once, and its box; empty of an open one.
struct Polygon {
  std::vector<Vec2> points;
  std::vector<Vec2> corners;  // without those inside of straight curves
  Vec2 low{}, high{};
};

Polygon polygon_of(const PlaneSection& section, const SectionWire& wire, const Vec3& x,
                   const Vec3& y) {
  Polygon polygon;
  if (!wire.closed) return polygon;
  for (const CurveUse& use : wire.uses) {
    const SectionCurve& curve = section.curves[use.curve];
    const bool straight = GeomAdaptor_Curve(curve.curve).GetType() == GeomAbs_Line;
    std::vector<Vec3> samples = curve.samples;
    if (!use.forward) std::ranges::reverse(samples);
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
      polygon.points.push_back({dot(samples[i], x), dot(samples[i], y)});
      if (i == 0 || !straight) polygon.corners.push_back(polygon.points.back());
    }
  }
  if (polygon.points.empty()) return polygon;
  for (const int k : {0, 1}) {
    const auto coordinate = [k](const Vec2& p) { return p[k]; };
    const auto [low, high] = std::ranges::minmax_element(polygon.points, {}, coordinate);
    polygon.low[k] = (*low)[k];
    polygon.high[k] = (*high)[k];
  }
  return polygon;
}

bool box_holds(const Polygon& polygon, const Vec2& point) {
  return polygon.low[0] <= point[0] && point[0] <= polygon.high[0] && polygon.low[1] <= point[1] &&
         point[1] <= polygon.high[1];
}

bool holds(const std::vector<Vec2>& polygon, const Vec2& point) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    if ((p[1] > point[1]) == (q[1] > point[1])) continue;
    if (point[0] < p[0] + (point[1] - p[1]) / (q[1] - p[1]) * (q[0] - p[0])) inside = !inside;
  }
  return inside;
}

// Of wires that touch, a point of one may lie on the other: most of its points decide.
// Most wires lie beside each other, which their boxes tell.
bool lies_in(const Polygon& one, const Polygon& other) {
  for (const int k : {0, 1})
    if (one.high[k] < other.low[k] || other.high[k] < one.low[k]) return false;
  const auto inside = std::ranges::count_if(
      one.points, [&](const Vec2& p) { return box_holds(other, p) && holds(other.corners, p); });
  return 2 * static_cast<std::size_t>(inside) > one.points.size();
}

}  // namespace

void orient_wires(PlaneSection& section, const Plane& plane) {
  const Vec3 n = unit(plane.normal);
  const Vec3 x = unit(cross(n, std::abs(n[0]) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
  const Vec3 y = cross(n, x);
  measure_areas(section, n);
  std::vector<Polygon> polygons;
  for (const SectionWire& wire : section.wires) polygons.push_back(polygon_of(section, wire, x, y));
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    SectionWire& wire = section.wires[i];
    if (!wire.closed) continue;
    int around = 0;
    for (std::size_t j = 0; j < polygons.size(); ++j)
      if (i != j && section.wires[j].closed && section.wires[j].bounding)
        around += lies_in(polygons[i], polygons[j]) ? 1 : 0;
    if ((*wire.area > 0) == (around % 2 == 0)) continue;
    std::ranges::reverse(wire.uses);
    for (CurveUse& use : wire.uses) use.forward = !use.forward;
    wire.area = -*wire.area;
  }
}

std::optional<double> bounded_area(const PlaneSection& section) {
  double sum = 0;
  for (const SectionWire& wire : section.wires) {
    if (!wire.bounding) continue;
    if (!wire.area) return std::nullopt;
    sum += *wire.area;
  }
  return sum;
}

TopoDS_Compound compound_of(const PlaneSection& section) {
  return guarded("making wires of a section", [&] {
    std::vector<TopoDS_Vertex> nodes;
    for (const SectionNode& node : section.nodes)
      nodes.push_back(vertex_at(pnt(node.point), node.reach));
    const BRep_Builder builder;
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    for (const SectionWire& uses : section.wires) {
      TopoDS_Wire wire;
      builder.MakeWire(wire);
      for (const CurveUse& use : uses.uses)
        builder.Add(wire, edge_of(section.curves[use.curve], nodes)
                              .Oriented(use.forward ? TopAbs_FORWARD : TopAbs_REVERSED));
      wire.Closed(uses.closed);
      builder.Add(compound, wire);
    }
    for (const std::size_t node : section.points) builder.Add(compound, nodes[node]);
    return compound;
  });
}

}  // namespace blossom::occt
