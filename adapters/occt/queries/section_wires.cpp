// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/queries/section_wires.h"

#include <algorithm>
#include <cmath>

#include <BRep_Builder.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/curves_detail.h"

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

// The ends of curves at each node, by angle round it.
std::vector<std::vector<End>> ends_at_nodes(const PlaneSection& section, const Vec3& normal) {
  std::vector<std::vector<End>> ends(section.nodes.size());
  for (std::size_t i = 0; i < section.curves.size(); ++i)
    for (std::size_t side = 0; side < 2; ++side)
      if (section.curves[i].nodes[side] >= 0)
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
  for (const std::vector<End>& here : ends_at_nodes(section, normal)) {
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
}

TopoDS_Compound compound_of(const PlaneSection& section) {
  return guarded("making wires of a section", [&] {
    std::vector<TopoDS_Vertex> nodes;
    for (const SectionNode& node : section.nodes)
      nodes.push_back(vertex_at(to_pnt(node.point), node.reach));
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
