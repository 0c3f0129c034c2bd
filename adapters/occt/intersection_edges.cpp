// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/intersection_edges.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <string>

#include <BRep_Tool.hxx>
#include <NCollection_DataMap.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/edge_tolerance.h"
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

std::vector<TopoDS_Edge> loose_edges_of(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Edge> edges;
  if (shape.IsNull()) return edges;
  TopTools_IndexedMapOfShape known;
  for (TopExp_Explorer it(shape, TopAbs_EDGE, TopAbs_FACE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    if (known.Contains(edge) || BRep_Tool::Degenerated(edge)) continue;
    known.Add(edge);
    edges.push_back(edge);
  }
  return edges;
}

namespace {

// The largest tolerance that edges and vertices of a face state.
double stated_by(const TopoDS_Face& face) {
  double largest = largest_edge_tolerance(face);
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

// Of one shape with itself pairs are listed in one order only.
bool is_one_list(const std::vector<TopoDS_Face>& a, const std::vector<TopoDS_Face>& b) {
  return std::ranges::equal(a, b,
                            [](const TopoDS_Face& x, const TopoDS_Face& y) { return x.IsSame(y); });
}

// Faces of a list by their edges, and with which faces of the other list, which may be the same
// one, each has regions in common.
class CommonRegions {
 public:
  CommonRegions(const std::vector<TopoDS_Face>& faces, const ShapeIntersection& found,
                int FaceIntersection::*own, int FaceIntersection::*other, bool one_list)
      : others_(faces.size()) {
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (TopExp_Explorer it(faces[i], TopAbs_EDGE); it.More(); it.Next()) {
        if (!users_.IsBound(it.Current())) users_.Bind(it.Current(), {});
        users_.ChangeFind(it.Current()).insert(i);
      }
    for (const FaceIntersection& pair : found.pairs) {
      if (std::ranges::count(pair.found.places, PlaceKind::Overlap, &Place::kind) == 0) continue;
      others_[static_cast<std::size_t>(pair.*own)].insert(pair.*other);
      if (one_list) others_[static_cast<std::size_t>(pair.*other)].insert(pair.*own);
    }
  }

  /// Whether no face beyond an edge of a face crosses another one there that this face has a region
  /// in common with: the edge is free, or a seam, or the region goes on over it. Of two faces over
  /// which it does, the first is told.
  bool is_border(const TopoDS_Edge& edge, std::size_t of, int other) const {
    return std::ranges::all_of(users_.Find(edge), [&](std::size_t user) {
      return user == of || (user > of && others_[user].contains(other));
    });
  }

 private:
  NCollection_DataMap<TopoDS_Shape, std::set<std::size_t>, TopTools_ShapeMapHasher> users_;
  std::vector<std::set<int>> others_;
};

// Where a common region ends with an edge of one of its faces, or goes on over it, and no neighbour
// crosses the other face: what of such edges lies in that.
template <class IsBorder>
void add_borders(const TopoDS_Face& of, const IsBorder& is_border, const TopoDS_Face& other,
                 const SharedLimit& limit, std::vector<FoundCurve>& curves,
                 std::vector<std::string>& lost) {
  const IntersectionOptions options = limit.remaining_alone();
  std::optional<EdgeDivider> divider;
  TopTools_IndexedMapOfShape edges;  // a seam once
  TopExp::MapShapes(of, TopAbs_EDGE, edges);
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge edge = TopoDS::Edge(edges(i));
    if (BRep_Tool::Degenerated(edge) || !is_border(edge)) continue;
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
                                       const std::vector<TopoDS_Face>& b,
                                       const std::function<bool()>& cancelled) {
  IntersectionOptions options;
  options.cancelled = cancelled;
  options.tolerances.point = found.tolerance;
  options.time_limit = found.time_limit;
  const SharedLimit limit(options);
  JoinedIntersection made;
  std::vector<FoundCurve> curves;
  std::vector<FoundPoint> points;
  const bool one_list = is_one_list(a, b);
  const CommonRegions of_a(a, found, &FaceIntersection::face_a, &FaceIntersection::face_b,
                           one_list);
  const CommonRegions of_b(b, found, &FaceIntersection::face_b, &FaceIntersection::face_a,
                           one_list);
  for (const FaceIntersection& pair : found.pairs) {
    const TopoDS_Face& face_a = a[static_cast<std::size_t>(pair.face_a)];
    const TopoDS_Face& face_b = b[static_cast<std::size_t>(pair.face_b)];
    const double stated = std::max(stated_by(face_a), stated_by(face_b));
    if (std::ranges::count(pair.found.places, PlaceKind::Overlap, &Place::kind) > 0) {
      const auto is_border_a = [&](const TopoDS_Edge& edge) {
        return of_a.is_border(edge, static_cast<std::size_t>(pair.face_a), pair.face_b);
      };
      const auto is_border_b = [&](const TopoDS_Edge& edge) {
        return of_b.is_border(edge, static_cast<std::size_t>(pair.face_b), pair.face_a);
      };
      add_borders(face_a, is_border_a, face_b, limit, curves, made.lost);
      add_borders(face_b, is_border_b, face_a, limit, curves, made.lost);
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
