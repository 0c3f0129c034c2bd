// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/picture/mesh.h"

#include <algorithm>
#include <cmath>

#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Line.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"

namespace blossom::cli {
namespace {

constexpr double kAngle = 0.2;  // radians between neighbouring triangles: looks smooth when shaded
constexpr double kLargestAngle = 1;      // radians; a full turn keeps six sides
constexpr int kEdgeSteps = 64;           // of an edge that is not straight
constexpr double kOwnDeflection = 1e-4;  // of a face's own size

Vec3 normal_at(const BRepAdaptor_Surface& surface, const gp_Pnt2d& uv) {
  gp_Pnt point;
  gp_Vec along_u, along_v;
  surface.D1(uv.X(), uv.Y(), point, along_u, along_v);
  return unit(occt::vec(along_u.Crossed(along_v).XYZ()));
}

std::vector<std::vector<Vec3>> outlines_of(const TopoDS_Face& face,
                                           const Handle(Poly_Triangulation) & triangles,
                                           const TopLoc_Location& place,
                                           const std::vector<Vec3>& points) {
  std::vector<std::vector<Vec3>> outlines;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    const Handle(Poly_PolygonOnTriangulation) polygon =
        BRep_Tool::PolygonOnTriangulation(edge, triangles, place);
    // A seam is no border to the eye.
    if (polygon.IsNull() || BRep_Tool::IsClosed(edge, face)) continue;
    outlines.emplace_back();
    for (int i = 1; i <= polygon->NbNodes(); ++i)
      outlines.back().push_back(points[static_cast<std::size_t>(polygon->Node(i) - 1)]);
  }
  return outlines;
}

// Faces far smaller than the deflection get no triangles: they are tried with a share of their own
// size.
Handle(Poly_Triangulation) triangulation_of(const TopoDS_Face& face, double deflection,
                                            double angle, TopLoc_Location& place) {
  for (const double within : {deflection, kOwnDeflection * size_of({face})}) {
    BRepMesh_IncrementalMesh(face, within, Standard_False, angle, Standard_False);
    const Handle(Poly_Triangulation) found = BRep_Tool::Triangulation(face, place);
    if (!found.IsNull()) return found;
  }
  return {};
}

PictureMesh mesh_of(const TopoDS_Face& face, double deflection, double angle) {
  const TopoDS_Face copy = TopoDS::Face(BRepBuilderAPI_Copy(face, Standard_False).Shape());
  TopLoc_Location place;
  const Handle(Poly_Triangulation) found = triangulation_of(copy, deflection, angle, place);
  if (found.IsNull()) throw occt::Failure("a face cannot be triangulated for the picture");

  PictureMesh mesh;
  const BRepAdaptor_Surface surface(copy, Standard_False);
  for (int i = 1; i <= found->NbNodes(); ++i) {
    mesh.points.push_back(occt::vec(found->Node(i).Transformed(place).XYZ()));
    mesh.normals.push_back(found->HasUVNodes() ? normal_at(surface, found->UVNode(i)) : Vec3{});
  }
  for (int i = 1; i <= found->NbTriangles(); ++i) {
    std::array<int, 3> t{};
    found->Triangle(i).Get(t[0], t[1], t[2]);
    mesh.triangles.push_back({t[0] - 1, t[1] - 1, t[2] - 1});
  }
  mesh.outlines = outlines_of(copy, found, place, mesh.points);
  return mesh;
}

}  // namespace

PictureMesh picture_mesh(const TopoDS_Face& face, double deflection, double coarseness) {
  const double angle = std::min(kAngle * coarseness, kLargestAngle);
  return occt::guarded("triangulating a face", [&] { return mesh_of(face, deflection, angle); });
}

std::vector<Vec3> edge_points(const TopoDS_Edge& edge) {
  double from = 0, to = 0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, from, to);
  std::vector<Vec3> points;
  if (curve.IsNull()) return points;
  const int steps = Handle(Geom_Line)::DownCast(curve).IsNull() ? kEdgeSteps : 1;
  for (int i = 0; i <= steps; ++i)
    points.push_back(occt::vec(curve->Value(from + (to - from) * i / steps).XYZ()));
  return points;
}

double size_of(const std::vector<TopoDS_Face>& faces) {
  Bnd_Box box;
  for (const TopoDS_Face& face : faces) BRepBndLib::Add(face, box, Standard_False);
  return box.IsVoid() ? 0 : std::sqrt(box.SquareExtent());
}

}  // namespace blossom::cli
