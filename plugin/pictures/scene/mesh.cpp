// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/pictures/scene/mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Line.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/hulls.h"
#include "adapters/occt/tessellation.h"
#include "core/math/index.h"

namespace blossom::pictures {
namespace {

constexpr int kEdgeSteps = 64;  // of an edge that is not straight

// Sides of one triangle alone. By the numbers of the whole mesh, in which the two borders of a seam
// are one.
std::vector<std::array<int, 2>> border_of(const MeshedFace& face) {
  struct Side {
    std::pair<int, int> ends;  // in numbers of the mesh, the lower one first
    std::array<int, 2> corners{};
  };
  std::vector<Side> sides;
  for (const std::array<int, 3>& triangle : face.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = triangle[k], b = triangle[(k + 1) % 3];
      sides.push_back({std::minmax({face.vertices[index(a)], face.vertices[index(b)]}), {a, b}});
    }
  std::ranges::stable_sort(sides, {}, &Side::ends);
  std::vector<std::array<int, 2>> border;
  for (auto from = sides.begin(); from != sides.end();) {
    const auto to =
        std::find_if(from, sides.end(), [&](const Side& side) { return side.ends != from->ends; });
    if (to - from == 1) border.push_back(from->corners);
    from = to;
  }
  return border;
}

PictureMesh mesh_of(const MeshedFace& face, const std::vector<Vec3>& points, bool reversed) {
  PictureMesh mesh;
  for (const int vertex : face.vertices) mesh.points.push_back(points[index(vertex)]);
  mesh.normals = face.normals;
  mesh.triangles = face.triangles;
  mesh.border = border_of(face);
  if (!reversed) return mesh;
  for (Vec3& normal : mesh.normals) normal = -normal;
  for (std::array<int, 3>& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

PictureMesh border_alone(const TopoDS_Face& face, const std::string& obstacle) {
  PictureMesh mesh;
  mesh.obstacle = obstacle;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const std::vector<Vec3> points = edge_points(TopoDS::Edge(it.Current()));
    for (std::size_t i = 1; i < points.size(); ++i) {
      const int first = static_cast<int>(mesh.points.size() + i) - 1;
      mesh.border.push_back({first, first + 1});
    }
    mesh.points.insert(mesh.points.end(), points.begin(), points.end());
  }
  mesh.normals.resize(mesh.points.size());
  return mesh;
}

}  // namespace

std::vector<PictureMesh> picture_meshes(const std::vector<TopoDS_Face>& faces, double deviation,
                                        double angle) {
  const TopoDS_Compound whole = occt::compound_of(faces);
  const occt::ShapeTessellation made =
      occt::tessellation(whole, {.deviation = deviation, .angle = angle});
  TopTools_IndexedMapOfShape numbers;
  TopExp::MapShapes(whole, TopAbs_FACE, numbers);
  std::vector<PictureMesh> meshes;
  for (const TopoDS_Face& face : faces) {
    const std::size_t number = index(numbers.FindIndex(face)) - 1;
    const MeshedFace& meshed = made.facets.faces[number];
    meshes.push_back(meshed.triangles.empty()
                         ? border_alone(face, meshed.obstacle)
                         : mesh_of(meshed, made.facets.points, made.reversed[number]));
  }
  return meshes;
}

std::vector<Vec3> edge_points(const TopoDS_Edge& edge) {
  Interval range;
  if (BRep_Tool::Curve(edge, range.from, range.to).IsNull()) return {};
  return edge_points(edge, range);
}

std::vector<Vec3> edge_points(const TopoDS_Edge& edge, const Interval& part) {
  const auto& [from, to] = part;
  double first = 0, last = 0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
  std::vector<Vec3> points;
  const int steps = Handle(Geom_Line)::DownCast(curve).IsNull() ? kEdgeSteps : 1;
  for (int i = 0; i <= steps; ++i)
    points.push_back(occt::vec(curve->Value(from + (to - from) * i / steps).XYZ()));
  return points;
}

double size_of(const std::vector<TopoDS_Face>& faces) {
  Bnd_Box box;
  for (const TopoDS_Face& face : faces) box.Add(occt::bounds_of(face));
  return box.IsVoid() ? 0 : std::sqrt(box.SquareExtent());
}

}  // namespace blossom::pictures
