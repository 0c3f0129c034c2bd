// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/wires/wire_trim.h"

#include <algorithm>
#include <utility>

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/repair/true_inputs.h"
#include "adapters/occt/splitting/edges/edge_stretches.h"
#include "adapters/occt/splitting/edges/joined_curves.h"
#include "adapters/occt/wires/edge_divider.h"

namespace blossom::occt {
namespace {

// An input as what divides edges.
struct WireTool {
  TopoDS_Shape shape;
  std::vector<TopoDS_Solid> solids;
};

WireTool wire_tool(const TrimTool& input) {
  if (!input.wires.IsNull()) return {input.wires, {}};
  if (input.is_solid()) return {compound_of(input.solids), input.solids};
  return {compound_of(input.faces), {}};
}

bool has_edges(const TopoDS_Shape& shape) { return TopExp_Explorer(shape, TopAbs_EDGE).More(); }

std::vector<TopoDS_Edge> edges_of(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, TopAbs_EDGE, map);
  std::vector<TopoDS_Edge> edges;
  for (int i = 1; i <= map.Extent(); ++i)
    if (!BRep_Tool::Degenerated(TopoDS::Edge(map(i)))) edges.push_back(TopoDS::Edge(map(i)));
  return edges;
}

// In no edge.
std::vector<TopoDS_Vertex> lone_vertices(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape map;
  for (TopExp_Explorer it(shape, TopAbs_VERTEX, TopAbs_EDGE); it.More(); it.Next())
    map.Add(it.Current());
  std::vector<TopoDS_Vertex> vertices;
  for (int i = 1; i <= map.Extent(); ++i) vertices.push_back(TopoDS::Vertex(map(i)));
  return vertices;
}

double length_of(const TopoDS_Shape& shape) {
  double sum = 0;
  for (const TopoDS_Edge& edge : edges_of(shape)) sum += edge_length(edge);
  return sum;
}

bool is_wanted(WireSide side, SolidOperation operation) {
  switch (operation) {
    case SolidOperation::Cut: return side == WireSide::Outside;
    case SolidOperation::Common: return side != WireSide::Outside;
    case SolidOperation::Fuse:
    case SolidOperation::Split: break;
  }
  return true;
}

// What one step leaves.
struct WirePieces {
  std::vector<FoundCurve> curves;
  std::vector<FoundPoint> points;

  void add(const TopoDS_Edge& edge, const Interval& range) {
    const RangedCurve of = curve_of(edge);
    const double tolerance = BRep_Tool::Tolerance(edge);
    const bool whole = range.from == of.range.from && range.to == of.range.to;
    const bool closed = whole && BRep_Tool::IsClosed(edge);
    curves.push_back({{of.curve, range}, closed, tolerance, {tolerance, tolerance}, 0});
  }
  void add(const TopoDS_Vertex& vertex) {
    points.push_back({vec(BRep_Tool::Pnt(vertex)), BRep_Tool::Tolerance(vertex)});
  }
};

// Adds what of a shape's lone vertices lies on the wanted sides of another one.
void take_vertices(const TopoDS_Shape& of, EdgeDivider& by, SolidOperation operation,
                   WirePieces& pieces, SolidTrimResult& result) {
  for (const TopoDS_Vertex& vertex : lone_vertices(of)) {
    const std::optional<WireSide> side = by.side_of(vertex);
    if (!side) result.obstacles.emplace_back("no ray tells on which side of a solid a vertex lies");
    if (side && is_wanted(*side, operation)) pieces.add(vertex);
  }
}

// Likewise of its edges and lone vertices, as far as nothing stands against the result.
void take_wires(const TopoDS_Shape& of, EdgeDivider& by, SolidOperation operation,
                WirePieces& pieces, SolidTrimResult& result) {
  for (const TopoDS_Edge& edge : edges_of(of)) {
    const DividedEdge divided = by.divide(edge);
    result.status = weaker(result.status, divided.status);
    std::vector<std::string>& reasons = result.certificate.reasons;
    for (const std::string& reason : divided.reasons)
      if (std::ranges::find(reasons, reason) == reasons.end()) reasons.push_back(reason);
    if (!divided.obstacle.empty()) {
      result.obstacles.push_back(divided.obstacle);
      return;
    }
    for (const WirePiece& piece : divided.pieces)
      if (is_wanted(piece.side, operation)) pieces.add(edge, piece.range);
  }
  take_vertices(of, by, operation, pieces, result);
}

TopoDS_Shape combined_wires(const TopoDS_Shape& wires, const WireTool& tool,
                            SolidOperation operation, const IntersectionOptions& options,
                            SolidTrimResult& result) {
  WirePieces pieces;
  EdgeDivider by_tool(tool.shape, tool.solids, options);
  take_wires(wires, by_tool, operation, pieces, result);
  if (operation == SolidOperation::Fuse) {
    EdgeDivider by_wires(wires, {}, options);
    take_wires(tool.shape, by_wires, SolidOperation::Cut, pieces, result);
  }
  // Vertices in common are so whichever of the two comes first.
  if (operation == SolidOperation::Common && !lone_vertices(tool.shape).empty()) {
    EdgeDivider by_wires(wires, {}, options);
    take_vertices(tool.shape, by_wires, operation, pieces, result);
  }
  if (!result.obstacles.empty()) return {};
  return joined_curves(pieces.curves, pieces.points);
}

// What is divided comes first: the part, or in common what has the lowest dimension.
std::vector<WireTool> in_order(const TrimTool& part, const std::vector<TrimTool>& tools,
                               SolidOperation operation) {
  std::vector<WireTool> all{wire_tool(part)};
  for (const TrimTool& tool : tools) all.push_back(wire_tool(tool));
  if (operation != SolidOperation::Common) return all;
  const auto dimension = [](const WireTool& tool) {
    if (!has_edges(tool.shape)) return 0;
    return TopExp_Explorer(tool.shape, TopAbs_FACE).More() ? 2 : 1;
  };
  std::swap(all.front(), *std::ranges::min_element(all, {}, dimension));
  return all;
}

}  // namespace

bool takes_wires(const TrimTool& part, const std::vector<TrimTool>& tools) {
  return !part.wires.IsNull() ||
         std::ranges::any_of(tools, [](const TrimTool& tool) { return !tool.wires.IsNull(); });
}

std::string misplaced_wires(const TrimTool& part, const std::vector<TrimTool>& tools,
                            SolidOperation operation) {
  if (operation == SolidOperation::Common || !takes_wires(part, tools)) return {};
  const auto told = [](const std::string& name, const char* why) {
    return name + " has edges or vertices and no face; " + why;
  };
  for (std::size_t i = 0; i < tools.size(); ++i) {
    const bool wires = !tools[i].wires.IsNull();
    if (part.wires.IsNull() && wires && operation == SolidOperation::Fuse)
      return told(tool_name(tools, i), "wires are fused with wires alone");
    if (part.wires.IsNull() && wires)
      return told(tool_name(tools, i), "wires take nothing off faces and solids");
    if (!part.wires.IsNull() && !wires && operation == SolidOperation::Fuse)
      return told(part_name(part), "wires are fused with wires alone");
  }
  return {};
}

SolidTrimResult trim_wires(const TrimTool& part, const std::vector<TrimTool>& tools,
                           SolidOperation operation, const IntersectionOptions& options) {
  const SharedLimit limit(options);
  const WorkLimit own_limit(options);
  SolidTrimResult result;
  result.of_wires = true;
  try {
    const TrueInputs sound(part, tools, own_limit);
    result.tolerances = sound.told();
    const std::vector<WireTool> all = in_order(sound.part(), sound.tools(), operation);
    TopoDS_Shape so_far = all.front().shape;
    for (std::size_t i = 1; i < all.size() && result.obstacles.empty(); ++i)
      so_far = guarded("combining wires", [&] {
        return combined_wires(so_far, all[i], operation, limit.remaining_alone(), result);
      });
    if (!result.obstacles.empty()) return result;
    result.wires = TopoDS::Compound(so_far);
    result.lengths.part = length_of(part.wires);
    for (const TrimTool& tool : tools) result.lengths.tools += length_of(tool.wires);
    result.lengths.result = length_of(result.wires);
  } catch (const Failure& error) {
    result.obstacles.emplace_back(error.what());
  }
  if (!result.obstacles.empty() && limit.is_reached()) result.status = Status::Stopped;
  return result;
}

}  // namespace blossom::occt
