// SPDX-License-Identifier: LGPL-2.1-or-later
// Every path in double against the same values in extended precision, at random.
//
// A path's slack is the largest error seen over its stated bound: above 1 the bound is wrong, far
// below 1 it is loose. BLOSSOM_TRIALS sets the number of random inputs for each path; the full
// tests take a million and print the slacks.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>

#include "core/blossom/composition.h"
#include "core/blossom/detail/closed_form.h"
#include "core/blossom/detail/composition.h"
#include "core/blossom/detail/normal_net.h"
#include "core/blossom/detail/triangle_conversion.h"
#include "core/blossom/normal_net.h"
#include "core/blossom/patch_blossom.h"
#include "core/blossom/triangle_blossom.h"
#include "core/blossom/triangle_conversion.h"
#include "core/forms/algebra/conversion.h"
#include "core/forms/algebra/de_casteljau.h"
#include "core/forms/algebra/degree.h"
#include "core/forms/algebra/derivatives.h"
#include "core/forms/algebra/detail/sign.h"
#include "core/forms/algebra/products.h"
#include "core/subdivision/bulk/bulk.h"
#include "core/subdivision/bulk/bulk_triangles.h"
#include "core/subdivision/cell_nets.h"
#include "core/subdivision/curve_subdivision.h"
#include "core/subdivision/detail/triangle.h"
#include "core/subdivision/patch_subdivision.h"
#include "core/subdivision/triangle_subdivision.h"
#include "tests/core/blossom/error_trials.h"
#include "tests/support/shapes.h"

namespace blossom {
namespace {

using testing::centred;
using testing::extended;
using testing::gap;
using testing::kReferenceError;
using testing::Long;
using testing::LongPoint;
using testing::pick;
using testing::Random;
using testing::random_corners;
using testing::random_curve;
using testing::random_interval;
using testing::random_monomial_curve;
using testing::random_monomial_patch;
using testing::random_patch;
using testing::random_piece;
using testing::random_triangle;
using testing::Trial;
using testing::uniform;

// ---- Forms.

Trial point_of_patch(Random& random) {
  const int n = pick(random, 0, 6), m = pick(random, 0, 6);
  const BezierPatch patch = random_patch(random, n, m);
  const double u = uniform(random, 0, 1), v = uniform(random, 0, 1);
  Vec3 expected;
  double error = 0;
  const Vec3 computed = point_at(patch, u, v);
  for (int x = 0; x < 3; ++x) {
    Grid<Long> plane(n + 1, m + 1);
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= m; ++j) plane(i, j) = patch.points(i, j)[x];
    const Long value = detail::homogeneous_value<Long>(plane, u, 1, v, 1);
    error = std::max(error, static_cast<double>(std::abs(computed[x] - value)));
  }
  return {error, de_casteljau_error(n + m)};
}

Trial monomial_form_of_curve(Random& random) {
  const int n = pick(random, 0, 12);
  const Origin origin = pick(random, 0, 1) == 0 ? Origin::Start : Origin::Middle;
  const BezierCurve curve = random_curve(random, n);
  const std::vector<Vec3> computed = monomial_form(curve, origin).coefficients;
  const auto expected = detail::monomial_line(extended(curve.points), origin);
  LongPoint<3> sum;
  for (std::size_t k = 0; k < computed.size(); ++k)
    for (int x = 0; x < 3; ++x) sum[x] += std::abs(computed[k][x] - expected[k][x]);
  return {gap(Vec3{}, sum), monomial_error(n, 0, origin)};
}

Trial elevation_of_curve(Random& random) {
  const int n = pick(random, 0, 10), degree = n + pick(random, 0, 10);
  const BezierCurve curve = random_curve(random, n);
  const auto expected =
      detail::elevated_net(detail::one_row(extended(curve.points)), 0, degree - n);
  return {gap(elevated(curve, degree).points, detail::only_row(expected)), elevation_error(degree)};
}

Trial elevation_of_triangle(Random& random) {
  const BezierTriangle triangle = random_triangle(random, pick(random, 0, 6));
  const auto expected = detail::elevated_once(extended(triangle));
  return {gap(elevated(triangle, triangle.degree + 1).points, expected.points),
          triangle_elevation_error(triangle.degree, triangle.degree + 1)};
}

Trial derivative_of_patch(Random& random) {
  const int n = pick(random, 0, 6), m = pick(random, 0, 6);
  const int k = pick(random, 0, 2), l = pick(random, 0, 2);
  const BezierPatch patch = random_patch(random, n, m);
  return {gap(derivative(patch, k, l).points, detail::derivative_net(extended(patch.points), k, l)),
          derivative_error(n, m, k, l)};
}

Trial derivative_of_rational_patch(Random& random) {
  const int n = pick(random, 1, 3), m = pick(random, 1, 3);
  const RationalBezierPatch patch = random_patch<Vec4>(random, n, m);
  return {gap(rational_derivative(patch, 1, 0).points,
              detail::rational_derivative(extended(patch.points), 1, 0)),
          rational_derivative_error(n, m, 1)};
}

Trial derivative_of_rational_triangle(Random& random) {
  const int n = pick(random, 1, 5);
  const int last = static_cast<int>(BezierTriangle::count(n)) - 1;
  const RationalBezierTriangle triangle{n, random_curve<Vec4>(random, last).points};
  const BezierTriangleOf<LongPoint<4>> reference{n, extended(triangle.points)};
  return {gap(rational_derivative(triangle, 1, 1).points,
              detail::rational_derivative(reference, 1, 1).points),
          rational_triangle_derivative_error(n, 2)};
}

Trial cross_product_of_curves(Random& random) {
  const int n = pick(random, 0, 10), m = pick(random, 0, 10);
  const BezierCurve f = random_curve(random, n), g = random_curve(random, m);
  const auto expected = detail::cross_product(detail::one_row(extended(f.points)),
                                              detail::one_row(extended(g.points)));
  return {gap(cross_product(f, g).points, detail::only_row(expected)),
          2 * (product_error(0, std::min(n, m)) + 0x1p-53)};
}

// ---- Blossoms.

Trial theorem_one(Random& random) {
  const int n = pick(random, 0, 10);
  const MonomialCurve curve = centred(random_monomial_curve(random, n), random);
  const Interval interval = random_interval(random);
  const MonomialCurveOf<LongPoint<3>> reference{extended(curve.coefficients), curve.centre,
                                                curve.scale};
  return {gap(bezier_points(curve, interval).points,
              detail::bezier_line(reference, extended(interval))),
          blossom_error(n) * blossom_scale(curve, interval)};
}

Trial theorem_two(Random& random) {
  const int n = pick(random, 0, 5), m = pick(random, 0, 5);
  const MonomialPatch patch = random_monomial_patch(random, n, m);
  const Interval u = random_interval(random), v = random_interval(random);
  const MonomialPatchOf<LongPoint<3>> reference{extended(patch.coefficients)};
  return {gap(bezier_points(patch, u, v).points,
              detail::bezier_net(reference, extended(u), extended(v))),
          blossom_error(n + m) * blossom_scale(patch, u, v)};
}

Trial theorem_three(Random& random) {
  const int n = pick(random, 0, 2), m = pick(random, 0, 2);
  const MonomialPatch patch = random_monomial_patch(random, n, m);
  const TriangleCorners corners = random_corners(random);
  return {gap(bezier_points(patch, corners).points,
              detail::triangle_points(extended(patch.coefficients), extended(corners), n + m)),
          triangle_blossom_error(n + m, n, m) * triangle_scale(patch, corners, n + m)};
}

Trial patch_on_curve(Random& random) {
  const int n = pick(random, 0, 3), m = pick(random, 0, 3), d = pick(random, 0, 3);
  const RationalBezierPatch patch = random_patch<Vec4>(random, n, m);
  BezierCurve2 curve = random_curve<Vec2>(random, d);
  if (pick(random, 0, 3) > 0)
    for (Vec2& point : curve.points) point = {std::abs(point[0]), std::abs(point[1])};
  return {gap(composition(patch, curve).points,
              detail::composition(extended(patch.points),
                                  detail::parameter_forms(extended(curve.points)))),
          composition_error(n, m, d) * composition_growth(n, m, curve)};
}

Trial normals_of_patch(Random& random) {
  const int n = pick(random, 1, 3), m = pick(random, 1, 3);
  const BezierPatch patch = random_patch(random, n, m);
  return {gap(normal_net(patch).points, detail::normal_net(extended(patch.points))),
          normal_net_error(n, m)};
}

Trial normals_of_rational_patch(Random& random) {
  const int n = pick(random, 1, 2), m = pick(random, 1, 2);
  const RationalBezierPatch patch = random_patch<Vec4>(random, n, m);
  return {gap(normal_net(patch).points, detail::normal_net(extended(patch.points))),
          rational_normal_net_error(n, m)};
}

Trial quads_of_triangle(Random& random) {
  const BezierTriangle triangle = random_triangle(random, pick(random, 0, 3));
  const Long half = 0.5L, third = 1 / 3.0L;
  const auto expected =
      detail::quad_net(extended(triangle), {{{1, 0}, {half, 0}, {half, half}, {third, third}}});
  return {gap(three_quads(triangle)[0].points, expected), three_quads_error(triangle.degree)};
}

// ---- Subdivision.

Trial piece_of_curve(Random& random) {
  const int n = pick(random, 0, 12);
  const BezierCurve curve = random_curve(random, n);
  const Interval piece = random_piece(random);
  return {gap(sub_curve(curve, piece).points,
              product(detail::subdivision_matrix(n, extended(piece)), extended(curve.points))),
          curve_subdivision_error(n)};
}

Grid<LongPoint<3>> exact_piece(const BezierPatch& patch, const Interval& u, const Interval& v) {
  return product_transposed(
      product(detail::subdivision_matrix(patch.degree_u(), extended(u)), extended(patch.points)),
      detail::subdivision_matrix(patch.degree_v(), extended(v)));
}

Trial piece_of_patch(Random& random) {
  const int n = pick(random, 0, 5), m = pick(random, 0, 5);
  const BezierPatch patch = random_patch(random, n, m);
  const Interval u = random_piece(random), v = random_piece(random);
  return {gap(sub_patch(patch, u, v).points, exact_piece(patch, u, v)),
          subdivision_error(std::max(n, m))};
}

Trial triangle_of_patch(Random& random) {
  const int n = pick(random, 0, 3), m = pick(random, 0, 3);
  const BezierPatch patch = random_patch(random, n, m);
  const TriangleCorners corners = random_corners(random);
  return {gap(sub_triangle(patch, corners).points,
              detail::triangle_from_net(extended(patch.points), extended(corners))),
          sub_triangle_error(n, m)};
}

// ---- Subdivision in bulk; the planes are the coordinates.

LaneVector planes_of(const Grid<Vec3>& net) {
  LaneVector planes;
  for (int x = 0; x < 3; ++x)
    for (const Vec3& point : net.values()) planes.push_back(point[x]);
  return planes;
}

NetShape shape_of(const Grid<Vec3>& net) { return {net.rows(), net.columns(), 3}; }

// Net number `lane` of a block with `lanes` nets side by side.
std::vector<Vec3> points_of(const LaneVector& values, int size, int lanes, int lane) {
  std::vector<Vec3> points(static_cast<std::size_t>(size));
  for (int x = 0; x < 3; ++x)
    for (int k = 0; k < size; ++k)
      points[static_cast<std::size_t>(k)][x] =
          values[static_cast<std::size_t>((x * size + k) * lanes + lane)];
  return points;
}

template <class T>
std::vector<T> values_of(const Grid<T>& net) {
  return {net.values().begin(), net.values().end()};
}

// The re-centred coefficients' net on a piece.
Grid<LongPoint<3>> exact_from_coefficients(const Grid<Vec3>& coefficients, const Interval& u,
                                           const Interval& v) {
  const MonomialPatchOf<LongPoint<3>> form{extended(coefficients), 0.5, 0.5, 0.5, 0.5};
  return detail::bezier_net(form, extended(u), extended(v));
}

// The largest sum of absolute values of a plane.
double largest_sum(const Grid<Vec3>& coefficients) {
  Vec3 sum;
  for (const Vec3& c : coefficients.values())
    for (int x = 0; x < 3; ++x) sum[x] += std::abs(c[x]);
  return max_norm(sum);
}

Trial bulk_piece(Random& random, NetForm form) {
  const int n = pick(random, 0, 5), m = pick(random, 0, 5);
  const Grid<Vec3> net = random_patch(random, n, m).points;
  const Interval u = random_piece(random), v = random_piece(random);
  LaneVector out(static_cast<std::size_t>(shape_of(net).size()));
  subdivide_piece(form, shape_of(net), planes_of(net), u, v, out);
  const bool bezier = form == NetForm::Bezier;
  const auto expected =
      bezier ? exact_piece(BezierPatch{net}, u, v) : exact_from_coefficients(net, u, v);
  return {gap(points_of(out, shape_of(net).plane_size(), 1, 0), values_of(expected)),
          bezier ? bulk_bezier_error(n, m) : bulk_monomial_error(n, m) * largest_sum(net)};
}

Trial bulk_bezier_piece(Random& random) { return bulk_piece(random, NetForm::Bezier); }
Trial bulk_monomial_piece(Random& random) { return bulk_piece(random, NetForm::Monomial); }

// The worst of kLanes trials.
Trial bulk_pyramid_pieces(Random& random) {
  const int n = pick(random, 0, 5), m = pick(random, 0, 5);
  const Grid<Vec3> net = random_patch(random, n, m).points;
  LaneVector ends[4];
  for (int lane = 0; lane < kLanes; ++lane) {
    const Interval u = random_piece(random), v = random_piece(random);
    const double values[] = {u.from, u.to, v.from, v.to};
    for (std::size_t e = 0; e < 4; ++e) ends[e].push_back(values[e]);
  }
  LaneVector out(block_size(shape_of(net)));
  subdivide_pieces_by_pyramid(shape_of(net), planes_of(net), {ends[0], ends[1], ends[2], ends[3]},
                              out);
  Trial worst{0, 1};
  for (int lane = 0; lane < kLanes; ++lane) {
    const auto at = static_cast<std::size_t>(lane);
    const Interval u{ends[0][at], ends[1][at]}, v{ends[2][at], ends[3][at]};
    const double bound =
        bulk_pyramid_error(n, m) * largest_sum(net) * pyramid_growth(n, u) * pyramid_growth(m, v);
    const double error = gap(points_of(out, shape_of(net).plane_size(), kLanes, lane),
                             values_of(exact_from_coefficients(net, u, v)));
    if (error * worst.bound > worst.error * bound) worst = {error, bound};
  }
  return worst;
}

enum class TriangleWay { BezierT4, MonomialT4, MonomialT1 };

double triangle_bound(TriangleWay way, const Grid<Vec3>& net, const TriangleCorners& corners) {
  const int n = net.rows() - 1, m = net.columns() - 1;
  if (way == TriangleWay::BezierT4) return bulk_t4_error(n, m);
  if (way == TriangleWay::MonomialT4) return bulk_t4_monomial_error(n, m) * largest_sum(net);
  return bulk_t1_error(n, m) * largest_sum(net) * t1_growth(n, m, corners);
}

Trial bulk_triangles(Random& random, TriangleWay way) {
  const int n = pick(random, 0, 3), m = pick(random, 0, 3);
  const Grid<Vec3> net = random_patch(random, n, m).points;
  const TrianglePlan plan(n, m);
  std::vector<TriangleCorners> triangles;
  LaneVector lists[6];
  for (int lane = 0; lane < kLanes; ++lane) {
    triangles.push_back(random_corners(random));
    for (std::size_t x = 0; x < 6; ++x)
      lists[x].push_back(triangles.back()[x / 2][static_cast<int>(x % 2)]);
  }
  const TriangleLists spans{lists[0], lists[1], lists[2], lists[3], lists[4], lists[5]};
  LaneVector out(static_cast<std::size_t>(3 * plan.points() * kLanes));
  const NetForm form = way == TriangleWay::BezierT4 ? NetForm::Bezier : NetForm::Monomial;
  if (way == TriangleWay::MonomialT1)
    subdivide_triangles_by_differences(plan, 3, planes_of(net), spans, out);
  else
    subdivide_triangles(form, plan, 3, planes_of(net), spans, out);
  const auto reference =
      form == NetForm::Bezier ? extended(net) : exact_from_coefficients(net, {0, 1}, {0, 1});
  Trial worst{0, 1};
  for (int lane = 0; lane < kLanes; ++lane) {
    const TriangleCorners& corners = triangles[static_cast<std::size_t>(lane)];
    const double error = gap(points_of(out, plan.points(), kLanes, lane),
                             detail::triangle_from_net(reference, extended(corners)));
    const double bound = triangle_bound(way, net, corners);
    if (error * worst.bound > worst.error * bound) worst = {error, bound};
  }
  return worst;
}

Trial bulk_t4_from_bezier(Random& random) { return bulk_triangles(random, TriangleWay::BezierT4); }
Trial bulk_t4_from_coefficients(Random& random) {
  return bulk_triangles(random, TriangleWay::MonomialT4);
}
Trial bulk_t1(Random& random) { return bulk_triangles(random, TriangleWay::MonomialT1); }

// A few halvings one after the other, each along u or v and to the low or the high side.
Trial halved_net(Random& random) {
  const int n = pick(random, 0, 5), m = pick(random, 0, 5), depth = pick(random, 1, 8);
  const Grid<Vec3> net = random_patch(random, n, m).points;
  LaneVector cell = planes_of(net), low(cell.size()), high(cell.size());
  IntervalOf<Long> u, v;
  for (int step = 0; step < depth; ++step) {
    const double cut = uniform(random, 0.25, 0.75);
    const bool along_u = pick(random, 0, 1) == 0, is_low = pick(random, 0, 1) == 0;
    (along_u ? halve_bezier_u : halve_bezier_v)(shape_of(net), cell.data(), cut, low.data(),
                                                high.data());
    cell = is_low ? low : high;
    IntervalOf<Long>& side = along_u ? u : v;
    const Long middle = side.from + (side.to - side.from) * cut;
    (is_low ? side.to : side.from) = middle;
  }
  const auto expected = product_transposed(product(detail::subdivision_matrix(n, u), extended(net)),
                                           detail::subdivision_matrix(m, v));
  return {gap(points_of(cell, shape_of(net).plane_size(), 1, 0), values_of(expected)),
          halving_error(std::max(n, m), depth)};
}

Trial net_from_coefficients(Random& random) {
  const int n = pick(random, 0, 6), m = pick(random, 0, 6);
  const Grid<Vec3> net = random_patch(random, n, m).points;
  LaneVector out(static_cast<std::size_t>(shape_of(net).size()));
  bezier_from_monomial(shape_of(net), planes_of(net).data(), out.data());
  return {gap(points_of(out, shape_of(net).plane_size(), 1, 0),
              values_of(exact_from_coefficients(net, {0, 1}, {0, 1}))),
          bezier_from_monomial_error(n, m) * largest_sum(net)};
}

// ---- All of them.

struct Path {
  const char* name;
  Trial (*trial)(Random&);
};

constexpr Path kPaths[] = {
    {"PointOfPatch", point_of_patch},
    {"MonomialFormOfCurve", monomial_form_of_curve},
    {"ElevationOfCurve", elevation_of_curve},
    {"ElevationOfTriangle", elevation_of_triangle},
    {"DerivativeOfPatch", derivative_of_patch},
    {"DerivativeOfRationalPatch", derivative_of_rational_patch},
    {"DerivativeOfRationalTriangle", derivative_of_rational_triangle},
    {"CrossProductOfCurves", cross_product_of_curves},
    {"TheoremOne", theorem_one},
    {"TheoremTwo", theorem_two},
    {"TheoremThree", theorem_three},
    {"PatchOnCurve", patch_on_curve},
    {"NormalsOfPatch", normals_of_patch},
    {"NormalsOfRationalPatch", normals_of_rational_patch},
    {"QuadsOfTriangle", quads_of_triangle},
    {"PieceOfCurve", piece_of_curve},
    {"PieceOfPatch", piece_of_patch},
    {"TriangleOfPatch", triangle_of_patch},
    {"BulkBezierPiece", bulk_bezier_piece},
    {"BulkMonomialPiece", bulk_monomial_piece},
    {"BulkPyramidPieces", bulk_pyramid_pieces},
    {"BulkT4FromBezier", bulk_t4_from_bezier},
    {"BulkT4FromCoefficients", bulk_t4_from_coefficients},
    {"BulkT1", bulk_t1},
    {"HalvedNet", halved_net},
    {"NetFromCoefficients", net_from_coefficients},
};

int trials() {
  const char* wanted = std::getenv("BLOSSOM_TRIALS");
  return wanted != nullptr ? std::max(1, std::atoi(wanted)) : 2000;
}

class ErrorBounds : public ::testing::TestWithParam<Path> {
 protected:
  void SetUp() override {
    if (std::numeric_limits<Long>::digits < 64) GTEST_SKIP() << "no extended precision here";
  }
};

TEST_P(ErrorBounds, HoldForRandomInputs) {
  Random random = testing::seeded(0);
  double slack = 0;
  for (int k = 0; k < trials(); ++k) {
    const Trial trial = GetParam().trial(random);
    ASSERT_LE(trial.error, trial.bound * (1 + kReferenceError)) << "trial " << k;
    if (trial.bound > 0) slack = std::max(slack, trial.error / trial.bound);
  }
  if (trials() > 100000) std::printf("%-30s slack %.3f\n", GetParam().name, slack);
}

TEST_P(ErrorBounds, AreNotEmpty) {
  Random random = testing::seeded(1);
  double slack = 0;
  for (int k = 0; k < 200; ++k) {
    const Trial trial = GetParam().trial(random);
    if (trial.bound > 0) slack = std::max(slack, trial.error / trial.bound);
  }
  EXPECT_GT(slack, 1e-4);  // a path that shows no error at all compares nothing
}

INSTANTIATE_TEST_SUITE_P(Paths, ErrorBounds, ::testing::ValuesIn(kPaths),
                         [](const auto& path) { return std::string(path.param.name); });

}  // namespace
}  // namespace blossom
