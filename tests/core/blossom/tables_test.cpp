// SPDX-License-Identifier: LGPL-2.1-or-later
// Tables 1 and 2 of Vlachkova 2025, entry by entry.

#include <gtest/gtest.h>

#include "core/blossom/detail/closed_form.h"
#include "core/blossom/patch_blossom.h"
#include "core/blossom/triangle_blossom.h"
#include "tests/support/golden.h"

namespace blossom {
namespace {

using testing::corners;
using testing::exact_gap;
using testing::ExactPoint;
using testing::Json;
using testing::number;
using testing::read_golden;
using testing::rounded;

constexpr double kPrecision = 1e-13;

const Json& tables() {
  static const Json data = read_golden("vlachkova_tables.json");
  return data;
}

MonomialPatch surface() { return {rounded(testing::net(tables().at("coefficients")))}; }

class Table1 : public ::testing::TestWithParam<const char*> {};

TEST_P(Table1, HasTheNetOfTheoremTwo) {
  const Json& patch = tables().at(GetParam());
  const Interval u{rounded(number(patch.at("a"))), rounded(number(patch.at("b")))};
  const Interval v{rounded(number(patch.at("c"))), rounded(number(patch.at("d")))};
  const Grid<ExactPoint> printed = testing::net(patch.at("control_points"));

  const BezierPatch computed = bezier_points(surface(), u, v);

  ASSERT_EQ(printed.rows(), 4);
  ASSERT_EQ(printed.columns(), 3);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_LE(exact_gap(computed.points(i, j), printed(i, j)), kPrecision) << i << ", " << j;
}

TEST_P(Table1, IsExactInRationals) {
  const Json& patch = tables().at(GetParam());

  EXPECT_EQ(
      detail::bezier_net(MonomialPatchOf<ExactPoint>{testing::net(tables().at("coefficients"))},
                         {number(patch.at("a")), number(patch.at("b"))},
                         {number(patch.at("c")), number(patch.at("d"))}),
      testing::net(patch.at("control_points")));
}

INSTANTIATE_TEST_SUITE_P(Surfaces, Table1, ::testing::Values("S1", "S2"));

TEST(Table1, HasThisCornerAndThisPointOfTheMiddleNet) {
  const BezierPatch whole = bezier_points(surface(), {0, 1}, {0, 1});
  const BezierPatch middle = bezier_points(surface(), {1.0 / 3, 2.0 / 3}, {0.25, 0.75});

  EXPECT_LE(max_norm(whole.points(3, 2) - Vec3{4, 3, 3.0 / 4}), kPrecision);
  EXPECT_LE(max_norm(whole.points(1, 1) - Vec3{1, 1, 0}), kPrecision);
  EXPECT_LE(max_norm(middle.points(2, 1) - Vec3{49.0 / 27, 451.0 / 432, 431.0 / 720}), kPrecision);
}

class Table2 : public ::testing::TestWithParam<const char*> {};

TEST_P(Table2, HasTheNetOfTheoremThree) {
  const Json& triangle = tables().at(GetParam());
  const int degree = triangle.at("N").get<int>();

  const BezierTriangle computed = bezier_points(surface(), rounded(corners(triangle)), degree);

  ASSERT_EQ(triangle.at("control_points").size(), 21u);
  for (const Json& entry : triangle.at("control_points"))
    EXPECT_LE(exact_gap(computed(entry.at("nu").get<int>(), entry.at("mu").get<int>()),
                        testing::point(entry.at("value"))),
              kPrecision);
}

TEST_P(Table2, PrintsItsIndicesForTheOrderOfCornersCAB) {
  const Json& triangle = tables().at(GetParam());
  const auto [a, b, c] = rounded(corners(triangle));

  const BezierTriangle turned = bezier_points(surface(), TriangleCorners{c, a, b});

  for (const Json& entry : triangle.at("control_points")) {
    const int i = entry.at("printed_index").at(0).get<int>();
    const int j = entry.at("printed_index").at(1).get<int>();
    EXPECT_LE(exact_gap(turned(i, j), testing::point(entry.at("value"))), kPrecision);
  }
}

TEST_P(Table2, IsExactInRationals) {
  const Json& triangle = tables().at(GetParam());
  const auto points =
      detail::triangle_points(testing::net(tables().at("coefficients")), corners(triangle), 5);

  for (const Json& entry : triangle.at("control_points"))
    EXPECT_EQ(
        points[BezierTriangle::index(5, entry.at("nu").get<int>(), entry.at("mu").get<int>())],
        testing::point(entry.at("value")));
}

INSTANTIATE_TEST_SUITE_P(Surfaces, Table2, ::testing::Values("S3", "S4"));

TEST(Table2, HasTheseCornersInTheConventionOfTheoremThree) {
  const BezierTriangle triangle =
      bezier_points(surface(), TriangleCorners{{{0, 0}, {1, 0}, {0, 1}}});

  EXPECT_LE(max_norm(triangle(5, 0) - Vec3{0, 0, 0}), kPrecision);
  EXPECT_LE(max_norm(triangle(0, 5) - Vec3{4, 0, 1.0 / 5}), kPrecision);
  EXPECT_LE(max_norm(triangle(0, 0) - Vec3{0, 2, -4.0 / 5}), kPrecision);
}

}  // namespace
}  // namespace blossom
