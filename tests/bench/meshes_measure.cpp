// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/meshes_measure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <random>

#include <BRepAdaptor_Surface.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Cone.hxx>
#include <gp_Sphere.hxx>

#include "adapters/occt/tessellation.h"
#include "core/bounds/box_tree.h"
#include "tests/bench/apart.h"

namespace blossom::bench {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

Vec3 vec(const gp_XYZ& p) { return {p.X(), p.Y(), p.Z()}; }

// Nodes on edges and vertices are those of all faces that have them.
class OcctNodes {
 public:
  explicit OcctNodes(FacetMesh& mesh) : mesh_(mesh) {}

  void add(const TopoDS_Face& face, int number) {
    TopLoc_Location location;
    const Handle(Poly_Triangulation) own = BRep_Tool::Triangulation(face, location);
    if (own.IsNull()) {
      ++mesh_.refused;
      return;
    }
    std::map<int, int> names;
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
      add_edge(TopoDS::Edge(it.Current().Oriented(TopAbs_FORWARD)), own, location, names);
    for (int k = 1; k <= own->NbTriangles(); ++k) {
      std::array<int, 3> node{};
      own->Triangle(k).Get(node[0], node[1], node[2]);
      if (face.Orientation() == TopAbs_REVERSED) std::swap(node[1], node[2]);
      std::array<int, 3> triangle{};
      std::array<Vec2, 3> uv;
      for (std::size_t c = 0; c < 3; ++c) {
        const auto [found, is_new] = names.try_emplace(node[c], 0);
        if (is_new) found->second = point(own->Node(node[c]).Transformed(location));
        triangle[c] = found->second;
        const gp_Pnt2d p = own->UVNode(node[c]);
        uv[c] = {p.X(), p.Y()};
      }
      if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
        continue;
      mesh_.triangles.push_back(triangle);
      mesh_.face.push_back(number);
      mesh_.uv.push_back(uv);
    }
  }

 private:
  void add_edge(const TopoDS_Edge& edge, const Handle(Poly_Triangulation) & own,
                const TopLoc_Location& location, std::map<int, int>& names) {
    const Handle(Poly_PolygonOnTriangulation) line =
        BRep_Tool::PolygonOnTriangulation(edge, own, location);
    if (line.IsNull()) return;
    const int number = edges_.Add(edge), count = line->NbNodes();
    for (int k = 1; k <= count; ++k) {
      const bool at_vertex = k == 1 || k == count || BRep_Tool::Degenerated(edge);
      const TopoDS_Shape vertex = k == 1 ? TopExp::FirstVertex(edge) : TopExp::LastVertex(edge);
      const std::pair<int, int> key =
          at_vertex ? std::pair(0, vertices_.Add(vertex)) : std::pair(number, k);
      const auto [found, is_new] = shared_.try_emplace(key, 0);
      if (is_new) found->second = point(own->Node(line->Node(k)).Transformed(location));
      names[line->Node(k)] = found->second;
    }
  }

  int point(const gp_Pnt& p) {
    mesh_.points.push_back(vec(p.XYZ()));
    return static_cast<int>(mesh_.points.size()) - 1;
  }

  FacetMesh& mesh_;
  TopTools_IndexedMapOfShape edges_, vertices_;
  std::map<std::pair<int, int>, int> shared_;
};

// From a surface that has poles, where Newton's method fails; nothing for others.
std::optional<double> closed_distance(const BRepAdaptor_Surface& surface, const Vec3& p) {
  const gp_Pnt at(p[0], p[1], p[2]);
  if (surface.GetType() == GeomAbs_Sphere)
    return std::abs(at.Distance(surface.Sphere().Location()) - surface.Sphere().Radius());
  if (surface.GetType() != GeomAbs_Cone) return {};
  const gp_Cone cone = surface.Cone();
  const gp_Vec off(cone.Apex(), at);
  const double along = off.Dot(cone.Axis().Direction());
  const double across = std::sqrt(std::max(0.0, off.SquareMagnitude() - along * along));
  return std::abs(across * std::cos(cone.SemiAngle()) -
                  std::abs(along) * std::sin(std::abs(cone.SemiAngle())));
}

// From a surface, by Newton's method from parameters that are about right.
double surface_distance(const BRepAdaptor_Surface& surface, const Vec3& p, Vec2 uv) {
  if (const auto distance = closed_distance(surface, p)) return *distance;
  double best = std::numeric_limits<double>::infinity();
  for (int step = 0; step < 8; ++step) {
    gp_Pnt at;
    gp_Vec u, v, uu, vv, uv2;
    surface.D2(uv[0], uv[1], at, u, v, uu, vv, uv2);
    const gp_Vec off(gp_Pnt(p[0], p[1], p[2]), at);
    best = std::min(best, off.Magnitude());
    const double a = u.Dot(u) + off.Dot(uu), b = u.Dot(v) + off.Dot(uv2);
    const double c = v.Dot(v) + off.Dot(vv), f = off.Dot(u), g = off.Dot(v);
    const double det = a * c - b * b;
    if (!(std::abs(det) > 0)) break;
    const Vec2 move{(c * f - b * g) / det, (a * g - b * f) / det};
    if (norm(move) == 0) break;
    uv -= move;
  }
  return best;
}

double triangle_gap(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto on_segment = [&](const Vec3& s, const Vec3& t) {
    const Vec3 d = t - s;
    const double square = dot(d, d);
    const double at = square > 0 ? std::clamp(dot(p - s, d) / square, 0.0, 1.0) : 0;
    return distance(p, s + at * d);
  };
  const Vec3 n = cross(b - a, c - a);
  const bool over = dot(n, cross(b - a, p - a)) >= 0 && dot(n, cross(c - b, p - b)) >= 0 &&
                    dot(n, cross(a - c, p - c)) >= 0;
  if (over && norm(n) > 0) return std::abs(dot(n, p - a)) / norm(n);
  return std::min({on_segment(a, b), on_segment(b, c), on_segment(c, a)});
}

}  // namespace

FacetMesh our_mesh(const TopoDS_Shape& shape, const FacetOptions& options) {
  const double start = processor_seconds();
  const occt::ShapeTessellation made = occt::tessellation(shape, options);
  FacetMesh mesh;
  mesh.seconds = processor_seconds() - start;
  mesh.points = made.facets.points;
  mesh.proven = made.facets.distance;
  mesh.triangles = occt::triangles_of(made, &mesh.face);
  for (std::size_t f = 0; f < made.facets.faces.size(); ++f) {
    const MeshedFace& face = made.facets.faces[f];
    mesh.folded += face.folded;
    mesh.of_face.push_back(face.distance);
    mesh.refused += !face.obstacle.empty();
    for (std::array<int, 3> corner : face.triangles) {
      if (made.reversed[f]) std::swap(corner[1], corner[2]);
      mesh.uv.push_back(
          {face.uv[index(corner[0])], face.uv[index(corner[1])], face.uv[index(corner[2])]});
    }
  }
  return mesh;
}

FacetMesh occt_mesh(const TopoDS_Shape& shape, double deflection, double angle) {
  BRepTools::Clean(shape);
  FacetMesh mesh;
  const double start = processor_seconds();
  const BRepMesh_IncrementalMesh mesher(shape, deflection, Standard_False, angle);
  mesh.seconds = processor_seconds() - start;
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  OcctNodes nodes(mesh);
  for (int k = 1; k <= faces.Extent(); ++k) nodes.add(TopoDS::Face(faces(k)), k - 1);
  BRepTools::Clean(shape);
  return mesh;
}

double measured_distance(const TopoDS_Shape& shape, const FacetMesh& mesh, int samples) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  std::vector<BRepAdaptor_Surface> surfaces;
  for (int k = 1; k <= faces.Extent(); ++k) surfaces.emplace_back(TopoDS::Face(faces(k)), false);
  std::vector<Box> boxes;
  for (const auto& triangle : mesh.triangles) {
    Box box;
    for (const int corner : triangle)
      box = joined(box, {mesh.points[index(corner)], mesh.points[index(corner)]});
    boxes.push_back(box);
  }
  const BoxTree tree(boxes);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  const int each = std::max(1, samples / std::max(1, static_cast<int>(mesh.triangles.size())));
  double most = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < each; ++k) {
      double a = uniform(random), b = uniform(random);
      if (a + b > 1) a = 1 - a, b = 1 - b;
      if (k < 3) a = b = 0.5, (k == 1 ? a : k == 2 ? b : a) = k == 0 ? 0.5 : 0;
      if (k == 3) a = b = 1.0 / 3;
      const auto mixed = [&](const auto& p0, const auto& p1, const auto& p2) {
        return p0 + a * (p1 - p0) + b * (p2 - p0);
      };
      const auto& [i, j, l] = mesh.triangles[t];
      const Vec3 p = mixed(mesh.points[index(i)], mesh.points[index(j)], mesh.points[index(l)]);
      const Vec2 uv = mixed(mesh.uv[t][0], mesh.uv[t][1], mesh.uv[t][2]);
      const BRepAdaptor_Surface& surface = surfaces[index(mesh.face[t])];
      most = std::max(most, surface_distance(surface, p, uv));
      const Vec3 q = vec(surface.Value(uv[0], uv[1]).XYZ());
      double near = std::numeric_limits<double>::infinity();
      tree.for_each_near(q, near, [&](int other) {
        const auto& [x, y, z] = mesh.triangles[index(other)];
        const double gap =
            triangle_gap(q, mesh.points[index(x)], mesh.points[index(y)], mesh.points[index(z)]);
        near = std::min(near, gap * gap);
        return near;
      });
      most = std::max(most, std::sqrt(near));
    }
  return most;
}

}  // namespace blossom::bench
