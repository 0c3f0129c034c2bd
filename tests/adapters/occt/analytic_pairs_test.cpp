// SPDX-License-Identifier: LGPL-2.1-or-later
// Planes, cylinders, cones, spheres and tori against each other, in general and in special
// position, with lengths by closed formulas. Each pair in both orders, with the seams where
// contacts and symmetry planes are, and turned away from there.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/adapters/occt/analytic_faces.h"

namespace blossom::occt::analytic {
namespace {

void add_planes(std::vector<Row>& rows) {
  const double s = std::tan(kPi / 6);
  rows.insert(
      rows.end(),
      {{"plane_and_parallel_plane", plane(O, Z), plane({0, 0, 1e-4}, Z)},
       {"plane_across_cylinder", plane({0, 0, 1}, Z), cylinder(O, Z, 2), 4 * kPi},
       {"plane_oblique_to_cylinder", plane({0.3, 0, 0.2}, tilted(45)), cylinder(O, Z, 2),
        perimeter(2, 2 * std::numbers::sqrt2)},
       {"plane_almost_along_cylinder", plane(O, tilted(88), 70), cylinder(O, Z, 1, 40),
        perimeter(1, 1 / std::cos(88 * kPi / 180))},
       {"plane_through_axis", plane(O, X), cylinder(O, Z, 2), 40},
       {"plane_beside_axis", plane({1.3, 0, 0}, X), cylinder(O, Z, 2), 40},
       {"plane_almost_on_cylinder", plane({2 - 1e-4, 0, 0}, X), cylinder(O, Z, 2), 40},
       {"plane_on_cylinder", plane({2, 0, 0}, X), cylinder(O, Z, 2), 20, 0, 0, 0, true},
       {"plane_beside_cylinder", plane({2 + 1e-4, 0, 0}, X), cylinder(O, Z, 2)},
       {"plane_across_cone", plane({0, 0, 3}, Z), cone(O, Z, 10), 6 * kPi * s},
       {"plane_on_apex", plane(O, Z), cone(O, Z, 10), 0, 0, 1},
       {"plane_oblique_on_apex", plane(O, tilted(20)), cone(O, Z, 10), 0, 0, 1},
       {"plane_on_apex_of_both_nappes", plane(O, tilted(20)), cone(O, Z, 10, -10), 0, 0, 1},
       {"plane_in_sphere", plane({0, 0, 0.5}, Z), sphere(O, 2), 2 * kPi * std::sqrt(3.75)},
       {"plane_oblique_in_sphere", plane({0, 0, 0.5}, tilted(60)), sphere(O, 2),
        2 * kPi * std::sqrt(4 - 0.0625)},
       {"plane_on_equator", plane(O, Z), sphere(O, 2), 4 * kPi},
       {"plane_through_poles", plane(O, X, 10), sphere(O, 2), 4 * kPi},
       {"plane_on_sphere", plane({2, 0, 0}, X), sphere(O, 2), 0, 0, 1},
       {"plane_on_pole", plane({0, 0, 2}, Z), sphere(O, 2), 0, 0, 1},
       {"plane_in_middle_of_torus", plane(O, Z), torus(O, 5, 2), 20 * kPi},
       {"plane_across_torus", plane({0, 0, 1}, Z), torus(O, 5, 2), 20 * kPi},
       {"plane_on_torus", plane({0, 0, 2}, Z), torus(O, 5, 2), 10 * kPi, 0, 0, 0, true},
       {"plane_through_axis_of_torus", plane(O, {1, 0.4, 0}), torus(O, 5, 2), 8 * kPi},
       {"plane_of_villarceau", plane(O, {0.4, 0, std::sqrt(0.84)}), torus(O, 5, 2), 20 * kPi, 2},
       {"plane_outside_on_torus", plane({7, 0, 0}, X), torus(O, 5, 2), 0, 0, 1}});
}

void add_cylinders(std::vector<Row>& rows) {
  for (const double degrees : {90, 60, 30, 10}) {
    const double half = degrees * kPi / 360, long_axis = 2 / std::sin(half);
    rows.push_back({"equal_cylinders_at_" + std::to_string(static_cast<int>(degrees)),
                    cylinder(O, Z, 2, 1.2 * long_axis + 2),
                    cylinder(O, tilted(degrees), 2, 1.2 * long_axis + 2),
                    perimeter(2, long_axis) + perimeter(2, 2 / std::cos(half)), 2});
  }
  rows.insert(
      rows.end(),
      {{"coaxial_cylinders", cylinder(O, Z, 2), cylinder(O, Z, 1.9)},
       {"coaxial_cylinders_almost_equal", cylinder(O, Z, 2), cylinder(O, Z, 2 - 1e-5)},
       {"equal_cylinders_side_by_side", cylinder(O, Z, 2), cylinder({1e-3, 0, 0}, Z, 2), 40},
       {"equal_cylinders_farther_apart", cylinder(O, Z, 2), cylinder({0, 1e-2, 0}, Z, 2), 40},
       {"one_cylinder_twice", cylinder(O, Z, 2), cylinder(O, Z, 2, 5), 0, 0, 0, 1},
       {"parallel_cylinders", cylinder(O, Z, 2), cylinder({2.5, 0, 0}, Z, 1), 40},
       {"cylinders_side_by_side", cylinder(O, Z, 2), cylinder({3, 0, 0}, Z, 1), 20, 0, 0, 0, true},
       {"cylinders_side_by_side_in_y", cylinder(O, Z, 2), cylinder({0, 3, 0}, Z, 1), 20, 0, 0, 0,
        true},
       {"cylinder_in_cylinder", cylinder(O, Z, 2), cylinder({1, 0, 0}, Z, 1), 20, 0, 0, 0, true},
       {"cylinder_in_opposite_cylinder", cylinder(O, Z, 2), cylinder({0, 1, 0}, {0, 0, -1}, 1), 20,
        0, 0, 0, true},
       {"cylinders_hardly_crossing", cylinder(O, Z, 2), cylinder({3 - 1e-4, 0, 0}, Z, 1), 40},
       {"cylinders_touching_crosswise", cylinder(O, Z, 2), cylinder({0, 3, 0}, X, 1), 0, 0, 1},
       {"cylinder_and_cone_of_one_axis", cylinder(O, Z, 2), cone(O, Z, 10), 4 * kPi},
       {"cylinder_along_cone",
        cylinder({std::cos(kPi / 6) + 4.5 * std::sin(kPi / 6), 0,
                  4.5 * std::cos(kPi / 6) - std::sin(kPi / 6)},
                 {std::sin(kPi / 6), 0, std::cos(kPi / 6)}, 1, 3.5),
        cone(O, Z, 10), 7, 0, 0, 0, true},
       {"cylinder_through_centre_of_sphere", cylinder(O, Z, 1), sphere(O, 2), 4 * kPi},
       {"sphere_in_cylinder", cylinder(O, Z, 2), sphere(O, 2), 4 * kPi, 0, 0, 0, true},
       {"sphere_in_oblique_cylinder", cylinder(O, {1, 2, 3}, 2), sphere(O, 2), 4 * kPi, 0, 0, 0,
        true},
       {"cylinder_hardly_in_sphere", cylinder(O, Z, 2 - 1e-5), sphere(O, 2), 8 * kPi * (1 - 5e-6)},
       {"cylinder_on_sphere", cylinder({3, 0, 0}, Z, 1), sphere(O, 2), 0, 0, 1},
       {"cylinder_through_torus", cylinder(O, Z, 5), torus(O, 5, 2), 20 * kPi},
       {"cylinder_round_torus", cylinder(O, Z, 7), torus(O, 5, 2), 14 * kPi, 0, 0, 0, true},
       {"cylinder_in_torus", cylinder(O, Z, 3), torus(O, 5, 2), 6 * kPi, 0, 0, 0, true},
       {"cylinder_on_torus", cylinder({8, 0, 0}, Z, 1), torus(O, 5, 2), 0, 0, 1}});
}

void add_round_ones(std::vector<Row>& rows) {
  const double s = std::tan(kPi / 6), c = std::cos(kPi / 6);
  const double circle = 2 * kPi * 5 * (1 - 2 / std::sqrt(41.0));
  rows.insert(
      rows.end(),
      {{"opposite_cones_of_one_axis", cone(O, Z, 10), cone({0, 0, 6}, {0, 0, -1}, 10), 6 * kPi * s},
       {"cones_apex_to_apex", cone(O, Z, 10), cone(O, {0, 0, -1}, 10), 0, 0, 1},
       {"apex_on_cone", cone(O, Z, 10), cone({6 * s, 0, 6}, {1, 0, 0}, 10), 0, 0, 1},
       {"sphere_in_cone", cone(O, Z, 10), sphere({0, 0, 4}, 2), 4 * kPi * c, 0, 0, 0, true},
       {"sphere_round_apex", cone(O, Z, 10), sphere(O, 2), 2 * kPi},
       {"spheres", sphere(O, 2), sphere({1, 1, 1}, 1.5),
        2 * kPi * std::sqrt(4 - std::pow((4 + 3 - 2.25) / (2 * std::sqrt(3.0)), 2))},
       {"concentric_spheres", sphere(O, 2), sphere(O, 2 - 1e-5, {1, 2, 3})},
       {"spheres_side_by_side", sphere(O, 2), sphere({3.5, 0, 0}, 1.5), 0, 0, 1},
       {"spheres_pole_to_pole", sphere(O, 2), sphere({0, 0, 3.5}, 1.5), 0, 0, 1},
       {"sphere_in_sphere", sphere(O, 2), sphere({0.5, 0, 0}, 1.5), 0, 0, 1},
       {"sphere_round_torus", sphere(O, 7), torus(O, 5, 2), 14 * kPi, 0, 0, 0, true},
       {"sphere_in_torus", sphere(O, 3), torus(O, 5, 2), 6 * kPi, 0, 0, 0, true},
       {"sphere_on_torus", sphere({0, 0, 4}, std::sqrt(41.0) - 2), torus(O, 5, 2), circle, 0, 0, 0,
        true},
       {"sphere_in_tube", sphere({5 * std::cos(1), 5 * std::sin(1), 0}, 2, {1, 2, 3}),
        torus(O, 5, 2), 4 * kPi, 0, 0, 0, true},
       {"small_sphere_in_tube", sphere({5, 0, 0}, 2 - 1e-4), torus(O, 5, 2)},
       {"sphere_beside_torus", sphere({8, 0, 0}, 1), torus(O, 5, 2), 0, 0, 1},
       {"tori_one_above_the_other", torus({0, 0, 1}, 5, 2), torus(O, 5, 2), 20 * kPi},
       {"one_torus_twice_turned_over", torus(O, 5, 2), torus(O, 5, 2, {0, 0, -1}), 0, 0, 0, 1},
       {"one_sphere_twice", sphere(O, 2), sphere(O, 2), 0, 0, 0, 1},
       {"one_sphere_twice_turned", sphere(O, 2), sphere(O, 2, {1, 2, 3}), 0, 0, 0, 1},
       {"one_sphere_twice_almost", sphere({2e-8, 0, 0}, 2), sphere(O, 2, X), 0, 0, 0, 1},
       {"torus_on_torus", torus({0, 0, 4}, 5, 2), torus(O, 5, 2), 10 * kPi, 0, 0, 0, true},
       {"torus_round_torus", torus(O, 8, 1), torus(O, 5, 2), 14 * kPi, 0, 0, 0, true},
       {"tori_crossing_on_one_axis", torus(O, 6, 2), torus(O, 5, 2), 22 * kPi},
       {"thin_torus_in_torus", torus(O, 5, 1), torus(O, 5, 2)},
       {"linked_tori", torus(O, 5, 1), torus({5, 0, 0}, 5, 1, Y)},
       {"tori_side_by_side", torus(O, 5, 2), torus({14, 0, 0}, 5, 2), 0, 0, 1}});
}

const std::vector<Row>& rows() {
  static const std::vector<Row> all = [] {
    std::vector<Row> made;
    add_planes(made);
    add_cylinders(made);
    add_round_ones(made);
    return made;
  }();
  return all;
}

class AnalyticPairs : public ::testing::TestWithParam<int> {};

TEST_P(AnalyticPairs, HaveTheirCurvesInBothOrders) {
  const Row& row = rows()[static_cast<std::size_t>(GetParam())];
  const TopoDS_Face a = row.a(0), b = row.b(0);
  expect_row(row, a, b);
  expect_row(row, b, a);
}

TEST_P(AnalyticPairs, HaveTheirCurvesWithTheSeamsElsewhere) {
  const Row& row = rows()[static_cast<std::size_t>(GetParam())];
  expect_row(row, row.a(kSpin), row.b(kSpin));
}

INSTANTIATE_TEST_SUITE_P(Rows, AnalyticPairs, ::testing::Range(0, static_cast<int>(rows().size())),
                         [](const auto& which) {
                           return rows()[static_cast<std::size_t>(which.param)].name;
                         });

// At the distance of the torus's circle of centres the plane's curve keeps near the circles in
// which the torus is highest and lowest, as z = r - x^4 / (8 R^2 r): there lies a line between
// patches.
TEST(PlanesAcrossTori, TouchNothingWhereTheirCurvesTouchLinesBetweenPatches) {
  for (const TopoDS_Face& across : {plane({0, 2, 0}, Y)(0), plane({-2, 0, 0}, X)(0)}) {
    const ShapeIntersection found = intersect({torus(O, 2, 1)(0)}, {across});
    EXPECT_EQ(found.status, Status::Complete);
    ASSERT_EQ(found.pairs.size(), 1U);
    EXPECT_TRUE(found.pairs.front().found.nodes.empty());
    EXPECT_TRUE(found.pairs.front().found.places.empty());
  }
}

}  // namespace
}  // namespace blossom::occt::analytic
