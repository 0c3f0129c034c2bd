// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/tessellation/triangulated_faces.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Dir.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/base/points.h"

namespace blossom::occt {
namespace {

Handle(Poly_Triangulation)
    triangulation_of(const MeshedFace& face, const std::vector<Vec3>& points, const gp_Trsf& back) {
  const Handle(Poly_Triangulation) made =
      new Poly_Triangulation(static_cast<int>(face.vertices.size()),
                             static_cast<int>(face.triangles.size()), Standard_True);
  made->AddNormals();
  for (std::size_t k = 0; k < face.vertices.size(); ++k) {
    const int number = static_cast<int>(k) + 1;
    made->SetNode(number,
                  pnt(points[static_cast<std::size_t>(face.vertices[k])]).Transformed(back));
    made->SetUVNode(number, gp_Pnt2d(face.uv[k][0], face.uv[k][1]));
    const Vec3& n = face.normals[k];
    const gp_Dir normal = norm(n) > 0 ? gp_Dir(n[0], n[1], n[2]) : gp_Dir(0, 0, 1);
    made->SetNormal(number, normal.Transformed(back));
  }
  for (std::size_t k = 0; k < face.triangles.size(); ++k) {
    const auto& [a, b, c] = face.triangles[k];
    made->SetTriangle(static_cast<int>(k) + 1, Poly_Triangle(a + 1, b + 1, c + 1));
  }
  return made;
}

}  // namespace

void put_on_faces(const ShapeTessellation& tessellation, const TopoDS_Shape& shape) {
  BRepTools::Clean(shape);
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  TopTools_MapOfShape done;
  const BRep_Builder builder;
  for (int k = 1; k <= faces.Extent(); ++k) {
    const MeshedFace& face = tessellation.facets.faces[static_cast<std::size_t>(k) - 1];
    if (face.triangles.empty() || !done.Add(faces(k).Located(TopLoc_Location()))) continue;
    const gp_Trsf back = faces(k).Location().Transformation().Inverted();
    builder.UpdateFace(TopoDS::Face(faces(k)),
                       triangulation_of(face, tessellation.facets.points, back));
  }
}

}  // namespace blossom::occt
