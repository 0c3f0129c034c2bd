// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/watertight_meshes.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Standard_Failure.hxx>

#include "adapters/occt/intersection.h"
#include "core/bounds/box_tree.h"
#include "tests/support/incremental_mesh.h"
#include "tests/support/watertight_mesh.h"

namespace blossom::bench {
namespace {

constexpr int kMaxDoublings = 3;      // of parts of a side, where facets cross
constexpr double kDeflection = 1e-3;  // of Open CASCADE's mesh, of the diagonal, at first
constexpr double kFiner = 0.2;        // where that is not right
constexpr int kMaxFiner = 2;
constexpr double kOffFaces = 0.1;  // of their size: how far facets are from the faces they are of

std::size_t index(int i) { return static_cast<std::size_t>(i); }

using FacePair = std::pair<int, int>;

// Faces whose pieces have a vertex in common are neighbours.
std::set<FacePair> neighbours(const WatertightPieces& pieces) {
  std::map<int, std::set<int>> faces_at;
  for (const WatertightPiece& piece : pieces.pieces)
    for (const int vertex : piece.vertices) faces_at[vertex].insert(piece.face);
  std::set<FacePair> result;
  for (const auto& [vertex, faces] : faces_at)
    for (const int a : faces)
      for (const int b : faces)
        if (a <= b) result.insert({a, b});
  return result;
}

// Where facets cross: the box of both.
using Crossings = std::map<FacePair, std::vector<Box>>;

Box at(const Vec3& point) { return {point, point}; }

// Boxes of what two faces have in common: of the steps of curves, of points, of whole regions.
std::vector<Box> common_places(const TopoDS_Face& a, const TopoDS_Face& b) {
  std::vector<Box> places;
  for (const occt::FaceIntersection& pair : occt::intersect({a}, {b}).pairs) {
    for (const IntersectionCurve& curve : pair.found.curves)
      for (std::size_t k = 0; k + 1 < curve.samples.size(); ++k)
        places.push_back(joined(at(curve.samples[k].point), at(curve.samples[k + 1].point)));
    for (const SurfacePoint& point : pair.found.points) places.push_back(at(point.point));
    for (const Overlap& overlap : pair.found.overlaps) {
      places.emplace_back();
      for (const SurfacePoint& point : overlap.boundary)
        places.back() = joined(places.back(), at(point.point));
    }
  }
  return places;
}

void sort_out(const WatertightPieces& pieces, const Crossings& crossings,
              const std::vector<TopoDS_Face>& given, WatertightMeshes& result) {
  const std::set<FacePair> beside = neighbours(pieces);
  for (const auto& [faces, boxes] : crossings) {
    if (beside.contains(faces)) {
      result.at_edges += static_cast<int>(boxes.size());
      continue;
    }
    const std::vector<Box> places =
        common_places(given[index(faces.first)], given[index(faces.second)]);
    for (const Box& box : boxes)
      ++(std::ranges::any_of(places, [&](const Box& place) { return meet(place, box); })
             ? result.of_model
             : result.others);
  }
}

void check_samples(const occt::WatertightShape& made, const std::vector<TopoDS_Face>& given,
                   int parts, WatertightMeshes& result) {
  const WatertightPieces& pieces = made.pieces;
  std::vector<bool> reversed;
  for (const auto& faces : made.faces)
    reversed.push_back(!faces.empty() && faces.front().Orientation() == TopAbs_REVERSED);
  std::vector<int> parts_of(pieces.pieces.size(), parts);
  Crossings crossings;
  for (int doubling = 0;; ++doubling) {
    const testing::WatertightSampler sampler(pieces, reversed, parts_of);
    const testing::Mesh& mesh = sampler.mesh();
    result.refined = cgal::check_mesh(mesh.points, mesh.triangles);
    result.finest = *std::ranges::max_element(parts_of);
    if (doubling == 0) result.even = result.refined;
    if (result.refined.self_intersections == 0) return;
    std::set<int> coarse;
    crossings.clear();
    for (const auto& [a, b] : cgal::crossing_triangles(mesh.points, mesh.triangles)) {
      const int p = mesh.piece[index(a)], q = mesh.piece[index(b)];
      coarse.insert({p, q});
      const std::pair<int, int> faces =
          std::minmax({pieces.pieces[index(p)].face, pieces.pieces[index(q)].face});
      Box box;
      for (const int facet : {a, b})
        for (const int corner : mesh.triangles[index(facet)])
          box = joined(box, at(mesh.points[index(corner)]));
      crossings[faces].push_back(widened(box, kOffFaces * diagonal(box)));
    }
    if (doubling == kMaxDoublings) break;
    for (const int piece : coarse) parts_of[index(piece)] *= 2;
  }
  sort_out(pieces, crossings, given, result);
}

OcctMesh occt_mesh(const TopoDS_Shape& shape, double diagonal, double deflection) {
  OcctMesh result;
  result.deflection = deflection;
  try {
    BRepTools::Clean(shape);
    const testing::Mesh made = testing::incremental_mesh(shape, deflection * diagonal);
    result.check = cgal::check_mesh(made.points, made.triangles);
    result.meshed = true;
  } catch (const std::runtime_error&) {
  } catch (const Standard_Failure&) {
  }
  return result;
}

// Finer where two curved sides with the same ends have no node between, or walls are nearer to each
// other than the deflection.
void check_occt(const occt::WatertightShape& made, const std::vector<TopoDS_Face>& given,
                WatertightMeshes& result) {
  const TopoDS_Shape& shape = made.shape;
  Box box;  // quicker than that of the shape, and near enough
  for (const Vec3& vertex : made.pieces.vertices) box = joined(box, at(vertex));
  const double diagonal = blossom::diagonal(box);
  TopoDS_Compound faces;
  BRep_Builder builder;
  builder.MakeCompound(faces);
  for (const TopoDS_Face& face : given) builder.Add(faces, face);
  result.given = occt_mesh(faces, diagonal, kDeflection);
  result.first = result.last = occt_mesh(shape, diagonal, kDeflection);
  for (int finer = 0; finer < kMaxFiner; ++finer) {
    const OcctMesh& mesh = result.last;
    if (mesh.meshed && mesh.check.manifold && mesh.check.self_intersections == 0) return;
    result.last = occt_mesh(shape, diagonal, kFiner * mesh.deflection);
  }
}

}  // namespace

WatertightMeshes watertight_meshes(const occt::WatertightShape& made,
                                   const std::vector<TopoDS_Face>& given, int parts) {
  WatertightMeshes result;
  check_samples(made, given, parts, result);
  check_occt(made, given, result);
  return result;
}

}  // namespace blossom::bench
