// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/flat_fill.h"

#include <algorithm>
#include <map>

#include <BRepBuilderAPI_FindPlane.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <Geom_Plane.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/blending/continuity.h"

namespace blossom::occt {
namespace {

std::optional<TopoDS_Face> face_within(const HoleLoop& loop, double tolerance) {
  BRepBuilderAPI_MakeWire wire;
  for (const HoleEdge& each : loop)
    wire.Add(TopoDS::Edge(each.edge.Oriented(each.backwards ? TopAbs_REVERSED : TopAbs_FORWARD)));
  if (!wire.IsDone() || !wire.Wire().Closed()) return std::nullopt;
  const BRepBuilderAPI_FindPlane plane(wire.Wire(), tolerance);
  if (!plane.Found()) return std::nullopt;
  BRepBuilderAPI_MakeFace face(plane.Plane()->Pln(), wire.Wire());
  if (!face.IsDone() || !BRepCheck_Analyzer(face.Face()).IsValid()) return std::nullopt;
  return face.Face();
}

TopAbs_Orientation orientation_in(const TopoDS_Face& face, const TopoDS_Edge& edge) {
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    if (it.Current().IsSame(edge)) return it.Current().Orientation();
  return TopAbs_EXTERNAL;
}

// Faces that are sewn along an edge use it in opposite directions.
bool is_beside_neighbours(const TopoDS_Face& face, const HoleLoop& loop) {
  for (const HoleEdge& each : loop)
    if (!each.face.IsNull())
      return orientation_in(face, each.edge) != orientation_in(each.face, each.edge);
  return true;
}

void measure(const HoleLoop& loop, FlatFill& fill) {
  std::vector<TopoDS_Shape> faces{fill.face};
  TopTools_IndexedMapOfShape known;
  for (const HoleEdge& each : loop)
    if (!each.face.IsNull() && !known.Contains(each.face)) {
      known.Add(each.face);
      faces.push_back(each.face);
    }
  for (const HoleEdge& each : loop) {
    FillContact& contact = fill.sides.emplace_back();
    if (each.face.IsNull()) continue;
    const TopoDS_Compound both = compound_of(std::vector<TopoDS_Shape>{fill.face, each.face});
    for (const EdgeContinuity& edge : edge_continuity(both))
      if (edge.edge.IsSame(each.edge) && edge.found) {
        contact = {edge.found->gap.value, edge.found->angle.value, edge.found->difference.value};
        // The plane has none, so all of the difference is the neighbour's.
        fill.largest_curvature = std::max(fill.largest_curvature, contact.curvature_difference);
      }
  }
}

}  // namespace

std::optional<FlatFill> flat_fill(const HoleLoop& loop, double tolerance) {
  return guarded("closing a hole by a plane", [&]() -> std::optional<FlatFill> {
    std::optional<TopoDS_Face> face = face_within(loop, tolerance);
    if (!face) return std::nullopt;
    if (!is_beside_neighbours(*face, loop)) face->Reverse();
    FlatFill fill{.face = *face, .sides = {}};
    measure(loop, fill);
    return fill;
  });
}

}  // namespace blossom::occt
