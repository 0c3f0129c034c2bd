// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/watertight_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include <BRepBndLib.hxx>
#include <BRepTools.hxx>
#include <Bnd_Box.hxx>
#include <Standard_Failure.hxx>

#include "adapters/occt/intersection.h"
#include "tests/support/incremental_mesh.h"
#include "tests/support/watertight_mesh.h"

namespace blossom::bench {
namespace {

constexpr int kMostDoublings = 3;     // of parts of a side, where facets cross
constexpr double kDeflection = 1e-3;  // of Open CASCADE's mesh, of the diagonal, at first
constexpr double kFiner = 0.2;        // where that is not right
constexpr int kMostFiner = 2;

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

bool meet(const TopoDS_Face& a, const TopoDS_Face& b) {
  for (const occt::FaceIntersection& pair : occt::intersect({a}, {b}).pairs)
    if (!pair.found.curves.empty() || !pair.found.points.empty() || !pair.found.overlaps.empty())
      return true;
  return false;
}

void sort_out(const WatertightPieces& pieces, const std::map<FacePair, int>& crossings,
              const std::vector<TopoDS_Face>& given, WatertightMeshes& result) {
  const std::set<FacePair> beside = neighbours(pieces);
  for (const auto& [faces, count] : crossings)
    (beside.contains(faces)                                        ? result.at_edges
     : meet(given[index(faces.first)], given[index(faces.second)]) ? result.of_model
                                                                   : result.others) += count;
}

void check_samples(const occt::WatertightShape& made, const std::vector<TopoDS_Face>& given,
                   int parts, WatertightMeshes& result) {
  const WatertightPieces& pieces = made.pieces;
  std::vector<bool> reversed;
  for (const auto& faces : made.faces)
    reversed.push_back(!faces.empty() && faces.front().Orientation() == TopAbs_REVERSED);
  std::vector<int> parts_of(pieces.pieces.size(), parts);
  std::map<FacePair, int> crossings;
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
      ++crossings[faces];
    }
    if (doubling == kMostDoublings) break;
    for (const int piece : coarse) parts_of[index(piece)] *= 2;
  }
  sort_out(pieces, crossings, given, result);
}

// Finer where it is no manifold, as where two curved sides with the same ends have no node between.
void check_occt(const TopoDS_Shape& shape, WatertightMeshes& result) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box, false);  // of control points: good enough, and fast
  result.deflection = kDeflection;
  for (int finer = 0;; ++finer, result.deflection *= kFiner) {
    try {
      BRepTools::Clean(shape);
      const testing::IncrementalMesh made(shape, result.deflection * std::sqrt(box.SquareExtent()));
      result.occt = cgal::check_mesh(made.mesh().points, made.mesh().triangles);
      result.meshed = true;
    } catch (const std::runtime_error&) {
      result.meshed = false;
    } catch (const Standard_Failure&) {
      result.meshed = false;
    }
    const bool right = result.meshed && result.occt.manifold;
    if (right || finer == kMostFiner) return;
  }
}

}  // namespace

WatertightMeshes watertight_meshes(const occt::WatertightShape& made,
                                   const std::vector<TopoDS_Face>& given, int parts) {
  WatertightMeshes result;
  check_samples(made, given, parts, result);
  check_occt(made.shape, result);
  return result;
}

}  // namespace blossom::bench
