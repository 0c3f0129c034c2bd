// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's constrained Delaunay triangulation judges ours.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "core/regions/delaunay/constrained_delaunay.h"

namespace blossom {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Corner = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Side = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Peer =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel,
                                               CGAL::Triangulation_data_structure_2<Corner, Side>,
                                               CGAL::No_constraint_intersection_tag>;
using Triangle = std::array<int, 3>;

Kernel::Point_2 point(const Vec2& p) { return {p[0], p[1]}; }

/// A star with the origin in its kernel, then points in it.
struct Region {
  std::vector<Vec2> points;
  int border = 0;                          ///< the first points, in their order, are the border
  std::vector<std::pair<int, int>> fixed;  ///< sides of the border, and spokes in it

  void close() {
    for (int i = 0; i < border; ++i) fixed.emplace_back(i, (i + 1) % border);
  }
};

/// The origin is the first point in the region: spokes go there from some corners.
Region random_star(std::mt19937& random, int border, int inner) {
  std::uniform_real_distribution<double> radius(0.4, 1), part(0, 0.3);
  Region star;
  star.border = border;
  for (int i = 0; i < border; ++i) {
    const double angle = 2 * std::numbers::pi * i / border, r = radius(random);
    star.points.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  star.points.push_back({0, 0});
  for (int i = 0; i < inner; ++i) {
    const double angle = 2 * std::numbers::pi * part(random) / 0.3, r = part(random);
    star.points.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  star.close();
  for (int i = 0; i < border; i += 3) star.fixed.emplace_back(i, border);
  return star;
}

/// All corners of a square grid: as many circles as there are cells go through four points.
Region grid(int cells) {
  Region square;
  for (int i = 0; i < cells; ++i) square.points.push_back({1. * i, 0});
  for (int i = 0; i < cells; ++i) square.points.push_back({1. * cells, 1. * i});
  for (int i = cells; i > 0; --i) square.points.push_back({1. * i, 1. * cells});
  for (int i = cells; i > 0; --i) square.points.push_back({0, 1. * i});
  square.border = static_cast<int>(square.points.size());
  for (int i = 1; i < cells; ++i)
    for (int j = 1; j < cells; ++j) square.points.push_back({1. * i, 1. * j});
  square.close();
  return square;
}

/// Sorted, so that the same triangle is the same triple.
Triangle sorted(Triangle triangle) {
  std::ranges::sort(triangle);
  return triangle;
}

ConstrainedDelaunay ours(const Region& region) {
  const auto inner = region.points.begin() + region.border;
  ConstrainedDelaunay mesh(std::vector<Vec2>(region.points.begin(), inner));
  // What comes later is numbered after three far corners.
  std::map<int, int> numbers;
  for (int i = 0; i < region.border; ++i) numbers[i] = i;
  for (std::size_t i = static_cast<std::size_t>(region.border); i < region.points.size(); ++i)
    numbers[static_cast<int>(i)] = mesh.insert(region.points[i], mesh.locate(region.points[i]));
  SideWindings windings;
  for (const auto& [from, to] : region.fixed) {
    std::pair<int, int> obstacle;
    EXPECT_TRUE(mesh.fix(numbers[from], numbers[to], obstacle));
    if (from >= region.border || to >= region.border) {
      windings[{numbers[from], numbers[to]}] = windings[{numbers[to], numbers[from]}] = 0;
      continue;
    }
    ++windings[{numbers[from], numbers[to]}];
    --windings[{numbers[to], numbers[from]}];
  }
  EXPECT_TRUE(mesh.mark_region(windings));
  return mesh;
}

/// Triangles of the region by the places of their corners in it.
std::set<Triangle> triangles_of(const ConstrainedDelaunay& mesh, const Region& region) {
  std::map<std::pair<double, double>, int> names;
  for (std::size_t i = 0; i < region.points.size(); ++i)
    names[{region.points[i][0], region.points[i][1]}] = static_cast<int>(i);
  std::set<Triangle> found;
  for (const ConstrainedDelaunay::Face& face : mesh.faces()) {
    if (!face.inside) continue;
    Triangle triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2& corner = mesh.point(face.corner[k]);
      triangle[k] = names.at({corner[0], corner[1]});
    }
    EXPECT_TRUE(found.insert(sorted(triangle)).second);
  }
  return found;
}

/// CGAL's triangles with a centre in the region: all of a star that see the origin past its border.
std::set<Triangle> peers_triangles(const Region& region) {
  Peer peer;
  std::vector<Peer::Vertex_handle> corners;
  for (std::size_t i = 0; i < region.points.size(); ++i) {
    corners.push_back(peer.insert(point(region.points[i])));
    corners.back()->info() = static_cast<int>(i);
  }
  for (const auto& [from, to] : region.fixed)
    peer.insert_constraint(corners[static_cast<std::size_t>(from)],
                           corners[static_cast<std::size_t>(to)]);
  std::set<Peer::Face_handle> outside{peer.infinite_face()};
  std::vector<Peer::Face_handle> next{peer.infinite_face()};
  while (!next.empty()) {
    const Peer::Face_handle face = next.back();
    next.pop_back();
    for (int k = 0; k < 3; ++k)
      if (!face->is_constrained(k) && outside.insert(face->neighbor(k)).second)
        next.push_back(face->neighbor(k));
  }
  std::set<Triangle> found;
  for (const Peer::Face_handle face : peer.finite_face_handles())
    if (!outside.contains(face))
      found.insert(
          sorted({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()}));
  return found;
}

/// Sides that are not fixed and have the corner across them inside their triangle's circle.
int wrong_sides(const ConstrainedDelaunay& mesh) {
  int wrong = 0;
  for (const ConstrainedDelaunay::Face& face : mesh.faces()) {
    if (!face.inside) continue;
    const auto corner = [&](std::size_t k) { return point(mesh.point(face.corner[k])); };
    EXPECT_EQ(CGAL::orientation(corner(0), corner(1), corner(2)), CGAL::LEFT_TURN);
    for (std::size_t k = 0; k < 3; ++k) {
      if (face.fixed[k]) continue;
      const auto& across = mesh.faces()[static_cast<std::size_t>(face.beside[k])];
      for (const int other : across.corner)
        wrong += CGAL::side_of_oriented_circle(corner(0), corner(1), corner(2),
                                               point(mesh.point(other))) == CGAL::ON_POSITIVE_SIDE;
    }
  }
  return wrong;
}

TEST(ConstrainedDelaunayByCgal, HasTheSameTrianglesWhereNoFourPointsAreOnACircle) {
  std::mt19937 random(11);
  for (int round = 0; round < 60; ++round) {
    const Region star = random_star(random, 5 + 4 * round, 3 * round);
    const ConstrainedDelaunay mesh = ours(star);
    EXPECT_EQ(triangles_of(mesh, star), peers_triangles(star)) << "round " << round;
    EXPECT_EQ(wrong_sides(mesh), 0) << "round " << round;
  }
}

TEST(ConstrainedDelaunayByCgal, HasAsManyTrianglesAndNoWrongSideOnAGrid) {
  for (const int cells : {1, 2, 7, 30}) {
    const Region square = grid(cells);
    const ConstrainedDelaunay mesh = ours(square);
    EXPECT_EQ(triangles_of(mesh, square).size(), peers_triangles(square).size());
    EXPECT_EQ(wrong_sides(mesh), 0);
  }
}

}  // namespace
}  // namespace blossom
