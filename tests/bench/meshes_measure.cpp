// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/meshes_measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <utility>

#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Cone.hxx>
#include <gp_Sphere.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/tessellation.h"
#include "core/bounds/box_tree.h"
#include "core/math/index.h"
#include "core/math/segment.h"
#include "tests/bench/apart.h"
#include "tests/support/incremental_mesh.h"

namespace blossom::bench {
namespace {

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

// The largest of many distances is looked for: what is `enough` or less needs not be known better.

// From a surface, by Newton's method from parameters that are about right.
double surface_distance(const BRepAdaptor_Surface& surface, const Vec3& p, Vec2 uv, double enough) {
  if (const auto distance = closed_distance(surface, p)) return *distance;
  double best = std::numeric_limits<double>::infinity();
  for (int step = 0; step < 8 && best > enough; ++step) {
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

// Newton's method may end beside the nearest point, at poles above all; what is too far is asked
// again from all starts that Open CASCADE takes.
double checked_distance(const BRepAdaptor_Surface& surface, const TopoDS_Face& face, const Vec3& p,
                        const Vec2& uv, double suspect, double enough) {
  const double found = surface_distance(surface, p, uv, enough);
  if (found <= suspect) return found;
  const GeomAPI_ProjectPointOnSurf feet(gp_Pnt(p[0], p[1], p[2]), BRep_Tool::Surface(face));
  return feet.NbPoints() > 0 ? std::min(found, feet.LowerDistance()) : found;
}

double triangle_gap(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = cross(b - a, c - a);
  const bool over = dot(n, cross(b - a, p - a)) >= 0 && dot(n, cross(c - b, p - b)) >= 0 &&
                    dot(n, cross(a - c, p - c)) >= 0;
  if (over && norm(n) > 0) return std::abs(dot(n, p - a)) / norm(n);
  return std::min({segment_gap(p, a, b), segment_gap(p, b, c), segment_gap(p, c, a)});
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
  testing::SharedNodes nodes(mesh.points);
  for (int k = 1; k <= faces.Extent(); ++k) {
    const auto take = [&](const std::array<int, 3>& corners, const std::array<int, 3>& own,
                          const Poly_Triangulation& of) {
      if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) return;
      mesh.triangles.push_back(corners);
      mesh.face.push_back(k - 1);
      std::array<Vec2, 3>& uv = mesh.uv.emplace_back();
      for (std::size_t c = 0; c < 3; ++c) uv[c] = {of.UVNode(own[c]).X(), of.UVNode(own[c]).Y()};
    };
    if (!nodes.for_each_triangle(TopoDS::Face(faces(k)), take)) ++mesh.refused;
  }
  BRepTools::Clean(shape);
  return mesh;
}

namespace {

// The triangles of each face of a mesh, to be asked for the nearest one.
class FaceTriangles {
 public:
  FaceTriangles(const FacetMesh& mesh, int faces) : mesh_(mesh), numbers_(index(faces)) {
    std::vector<std::vector<Box>> boxes(numbers_.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      Box box;
      for (const int corner : mesh.triangles[t])
        box = joined(box, {mesh.points[index(corner)], mesh.points[index(corner)]});
      boxes[index(mesh.face[t])].push_back(box);
      numbers_[index(mesh.face[t])].push_back(t);
    }
    for (const std::vector<Box>& of_face : boxes) trees_.emplace_back(of_face);
  }

  // Infinite if the face has none.
  double distance(int face, const Vec3& p, double enough) const {
    double near = std::numeric_limits<double>::infinity();  // its square
    trees_[index(face)].for_each_near(p, near, [&](int other) {
      const auto& [x, y, z] = mesh_.triangles[numbers_[index(face)][index(other)]];
      const double gap =
          triangle_gap(p, mesh_.points[index(x)], mesh_.points[index(y)], mesh_.points[index(z)]);
      near = std::min(near, gap * gap);
      return gap <= enough ? 0 : near;
    });
    return std::sqrt(near);
  }

 private:
  const FacetMesh& mesh_;
  std::vector<std::vector<std::size_t>> numbers_;
  std::vector<BoxTree> trees_;
};

// So much finer is the mesh that stands for the faces.
constexpr double kFiner = 1.0 / 16;

// Of the facets, from their faces: from the surfaces, and from the finer mesh, which ends where
// the faces end.
double facets_off(const TopTools_IndexedMapOfShape& faces, const FacetMesh& mesh,
                  const FacetMesh& finer, int each) {
  std::vector<BRepAdaptor_Surface> surfaces;
  for (int k = 1; k <= faces.Extent(); ++k) surfaces.emplace_back(TopoDS::Face(faces(k)), false);
  const FaceTriangles near(finer, faces.Extent());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  const double suspect = mesh.proven > 0 ? mesh.proven : std::numeric_limits<double>::infinity();
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
      const int face = mesh.face[t];
      most = std::max(most, checked_distance(surfaces[index(face)], TopoDS::Face(faces(face + 1)),
                                             p, uv, suspect, most));
      const double of_finer = near.distance(face, p, most + finer.proven);
      if (std::isfinite(of_finer)) most = std::max(most, of_finer - finer.proven);
    }
  return most;
}

// Of so many corners of equilateral triangles that cover as much as the mesh: each has the area
// of two of them.
double spacing(const FacetMesh& mesh, int samples) {
  double twice_area = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3& from = mesh.points[index(a)];
    twice_area += norm(cross(mesh.points[index(b)] - from, mesh.points[index(c)] - from));
  }
  return std::sqrt(twice_area / (std::sqrt(3.0) * samples));
}

}  // namespace

double measured_distance(const TopoDS_Shape& shape, const FacetMesh& mesh, int samples) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  const int count = std::max(1, static_cast<int>(mesh.triangles.size()));
  const int each = std::max(4, samples / count);
  Bnd_Box box;
  BRepBndLib::Add(shape, box, Standard_False);
  const double coarse = mesh.proven > 0 ? mesh.proven : 1e-3 * std::sqrt(box.SquareExtent());
  const FacetMesh finer = our_mesh(
      shape, {.deviation = kFiner * coarse, .angle = 0.1, .edge_length = spacing(mesh, samples)});
  double most = facets_off(faces, mesh, finer, each);
  const FaceTriangles near(mesh, faces.Extent());
  // Triangles of a face follow each other: each point is asked about once for each of its faces.
  std::vector<int> asked(finer.points.size(), -1);
  for (std::size_t t = 0; t < finer.triangles.size(); ++t)
    for (const int corner : finer.triangles[t]) {
      if (std::exchange(asked[index(corner)], finer.face[t]) == finer.face[t]) continue;
      const double gap = near.distance(finer.face[t], finer.points[index(corner)], most);
      if (std::isfinite(gap)) most = std::max(most, gap);
    }
  return most;
}

}  // namespace blossom::bench
