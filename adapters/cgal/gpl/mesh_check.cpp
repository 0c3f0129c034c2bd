// SPDX-License-Identifier: GPL-3.0-or-later
#include "adapters/cgal/gpl/mesh_check.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/base/errors.h"

namespace blossom::cgal {
namespace {

namespace mesh_processing = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

std::vector<Kernel::Point_3> from_core(std::span<const Vec3> points) {
  std::vector<Kernel::Point_3> result;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec3& p = points[k];
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      throw InvalidInput("check_mesh: point " + std::to_string(k) + " is not finite");
    result.emplace_back(p[0], p[1], p[2]);
  }
  return result;
}

std::vector<std::vector<std::size_t>> from_core(std::span<const std::array<int, 3>> triangles,
                                                std::size_t points) {
  std::vector<std::vector<std::size_t>> result;
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const auto [a, b, c] = triangles[k];
    for (const int corner : triangles[k])
      if (corner < 0 || static_cast<std::size_t>(corner) >= points)
        throw InvalidInput("check_mesh: triangle " + std::to_string(k) + " has corner " +
                           std::to_string(corner) + ", but there are " + std::to_string(points) +
                           " points");
    if (a == b || b == c || c == a)
      throw InvalidInput("check_mesh: triangle " + std::to_string(k) + " repeats a corner");
    result.push_back(
        {static_cast<std::size_t>(a), static_cast<std::size_t>(b), static_cast<std::size_t>(c)});
  }
  return result;
}

std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> crossings(const Mesh& mesh) {
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
  mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
  return pairs;
}

}  // namespace

MeshCheck check_mesh(std::span<const Vec3> points, std::span<const std::array<int, 3>> triangles) {
  const std::vector<Kernel::Point_3> soup_points = from_core(points);
  const auto soup = from_core(triangles, points.size());
  MeshCheck check;
  check.manifold = mesh_processing::is_polygon_soup_a_polygon_mesh(soup);
  if (!check.manifold) return check;

  Mesh mesh;
  mesh_processing::polygon_soup_to_polygon_mesh(soup_points, soup, mesh);
  check.closed = CGAL::is_closed(mesh);
  if (check.closed) check.volume = CGAL::to_double(mesh_processing::volume(mesh));
  for (const auto face : faces(mesh))
    if (mesh_processing::is_degenerate_triangle_face(face, mesh)) ++check.degenerate_triangles;
  check.self_intersections = static_cast<int>(crossings(mesh).size());
  return check;
}

std::vector<std::array<int, 2>> crossing_triangles(std::span<const Vec3> points,
                                                   std::span<const std::array<int, 3>> triangles) {
  const auto soup = from_core(triangles, points.size());
  std::vector<std::array<int, 2>> result;
  if (!mesh_processing::is_polygon_soup_a_polygon_mesh(soup)) return result;
  Mesh mesh;  // its faces are numbered as the triangles
  mesh_processing::polygon_soup_to_polygon_mesh(from_core(points), soup, mesh);
  for (const auto& [a, b] : crossings(mesh))
    result.push_back({static_cast<int>(a.idx()), static_cast<int>(b.idx())});
  return result;
}

}  // namespace blossom::cgal
