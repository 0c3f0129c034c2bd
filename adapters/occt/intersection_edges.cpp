// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/intersection_edges.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>

#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/splitting/edges/joined_curves.h"
#include "adapters/occt/wires/edge_divider.h"
#include "core/results/contact_places.h"

namespace blossom::occt {

std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape map;
  if (!shape.IsNull()) TopExp::MapShapes(shape, TopAbs_FACE, map);
  std::vector<TopoDS_Face> faces;
  for (int i = 1; i <= map.Extent(); ++i) faces.push_back(TopoDS::Face(map(i)));
  return faces;
}

namespace {

// The largest tolerance that edges and vertices of a face state.
double stated_by(const TopoDS_Face& face) {
  double largest = 0;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    largest = std::max(largest, BRep_Tool::Tolerance(TopoDS::Edge(it.Current())));
  for (TopExp_Explorer it(face, TopAbs_VERTEX); it.More(); it.Next())
    largest = std::max(largest, BRep_Tool::Tolerance(TopoDS::Vertex(it.Current())));
  return largest;
}

FoundCurve found_curve(const EdgeCurves& edge, const SurfaceIntersection& found, std::size_t i,
                       double stated) {
  const Interval range{edge.curve->FirstParameter(), edge.curve->LastParameter()};
  FoundCurve curve{
      {basis_of(edge.curve), range}, found.curves[i].closed, edge.tolerance, {}, stated};
  for (const std::size_t side : {0, 1})
    curve.reach[side] =
        contact_reach(found, vec(edge.curve->Value(side == 0 ? range.from : range.to)));
  return curve;
}

// The edges that one face of a list alone has, and once.
TopTools_MapOfShape free_edges(const std::vector<TopoDS_Face>& faces) {
  TopTools_MapOfShape once, more;
  for (const TopoDS_Face& face : faces)
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
      if (!once.Add(it.Current())) more.Add(it.Current());
  once.Subtract(more);
  return once;
}

// Where a common region ends with one of its faces, and no neighbour of that crosses the other one:
// what of its free edges lies in the other face.
void add_free_borders(const TopoDS_Face& of, const TopTools_MapOfShape& free,
                      const TopoDS_Face& other, const SharedLimit& limit,
                      std::vector<FoundCurve>& curves, std::vector<std::string>& lost) {
  const IntersectionOptions options = limit.remaining_alone();
  std::optional<EdgeDivider> divider;
  for (TopExp_Explorer it(of, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Current());
    if (!free.Contains(edge) || BRep_Tool::Degenerated(edge)) continue;
    if (!divider) divider.emplace(other, std::vector<TopoDS_Solid>(), options);
    const double tolerance = std::max(BRep_Tool::Tolerance(edge), options.tolerances.point);
    const RangedCurve curve = curve_of(edge);
    const DividedEdge divided = divider->divide(edge);
    if (!divided.obstacle.empty() && std::ranges::find(lost, divided.obstacle) == lost.end())
      lost.push_back(divided.obstacle);
    const bool closed = divided.pieces.size() == 1 && BRep_Tool::IsClosed(edge);
    for (const WirePiece& piece : divided.pieces)
      if (piece.side == WireSide::On)
        curves.push_back({{curve.curve, piece.range},
                          closed,
                          tolerance,
                          {tolerance, tolerance},
                          std::max(stated_by(of), stated_by(other))});
  }
}

}  // namespace

JoinedIntersection joined_intersection(const ShapeIntersection& found,
                                       const std::vector<TopoDS_Face>& a,
                                       const std::vector<TopoDS_Face>& b) {
  IntersectionOptions options;
  options.tolerances.point = found.tolerance;
  options.time_limit = found.time_limit;
  const SharedLimit limit(options);
  JoinedIntersection made;
  std::vector<FoundCurve> curves;
  std::vector<FoundPoint> points;
  const TopTools_MapOfShape free_a = free_edges(a), free_b = free_edges(b);
  for (const FaceIntersection& pair : found.pairs) {
    const TopoDS_Face& face_a = a[static_cast<std::size_t>(pair.face_a)];
    const TopoDS_Face& face_b = b[static_cast<std::size_t>(pair.face_b)];
    const double stated = std::max(stated_by(face_a), stated_by(face_b));
    if (std::ranges::count(pair.found.places, PlaceKind::Overlap, &Place::kind) > 0) {
      add_free_borders(face_a, free_a, face_b, limit, curves, made.lost);
      add_free_borders(face_b, free_b, face_a, limit, curves, made.lost);
    }
    for (std::size_t i = 0; i < pair.edges.size(); ++i)
      curves.push_back(found_curve(pair.edges[i], pair.found, i, stated));
    for (const SurfacePoint& contact : pair.found.points) {
      const double reach = contact_reach(pair.found, contact.point);
      points.push_back({contact.point, std::max(Precision::Confusion(), reach)});
    }
  }
  made.wires =
      guarded("joining intersection curves", [&] { return joined_curves(curves, points); });
  return made;
}

}  // namespace blossom::occt
