// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/intersection_edges.h"

#include <algorithm>
#include <cstddef>

#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/splitting/edges/joined_curves.h"
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

}  // namespace

TopoDS_Compound compound_of(const ShapeIntersection& found, const std::vector<TopoDS_Face>& a,
                            const std::vector<TopoDS_Face>& b) {
  std::vector<FoundCurve> curves;
  std::vector<FoundPoint> points;
  for (const FaceIntersection& pair : found.pairs) {
    const double stated = std::max(stated_by(a[static_cast<std::size_t>(pair.face_a)]),
                                   stated_by(b[static_cast<std::size_t>(pair.face_b)]));
    for (std::size_t i = 0; i < pair.edges.size(); ++i)
      curves.push_back(found_curve(pair.edges[i], pair.found, i, stated));
    for (const SurfacePoint& contact : pair.found.points) {
      const double reach = contact_reach(pair.found, contact.point);
      points.push_back({contact.point, std::max(Precision::Confusion(), reach)});
    }
  }
  return guarded("joining intersection curves", [&] { return joined_curves(curves, points); });
}

}  // namespace blossom::occt
