// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tessellation/charts/thin_spans.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/tessellation/charts/spline_chart.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::seeded;
using testing::uniform;

constexpr double kNoise = 1e-8;

// The cylinder-like graph (u, v, v^2 / 2), of degree 3 in v, with noise in the spans that are
// shorter than 1e-6; weights are uneven by 1e-10 there.
BezierSurface noisy_graph(const std::vector<double>& v_knots, bool rational) {
  auto generator = seeded(35);
  BezierSurface surface;
  surface.u_knots = {0, 1};
  surface.v_knots = v_knots;
  surface.rational = rational;
  const int spans = static_cast<int>(v_knots.size()) - 1;
  surface.patches = Grid<RationalBezierPatch>(1, spans);
  for (int j = 0; j < spans; ++j) {
    const double a = v_knots[static_cast<std::size_t>(j)];
    const double h = v_knots[static_cast<std::size_t>(j) + 1] - a;
    RationalBezierPatch& patch = surface.patches(0, j);
    patch.points = Grid<Vec4>(2, 4);
    for (int i = 0; i < 2; ++i)
      for (int k = 0; k < 4; ++k) {
        const double square = a * a + 2 * a * h * k / 3 + h * h * k * (k - 1) / 6;
        Vec4 p{static_cast<double>(i), a + h * k / 3, 0.5 * square, 1};
        const bool inner = k > 0 && k < 3;
        if (h < 1e-6 && inner) {
          for (int c = 0; c < 3; ++c) p[c] += uniform(generator, -kNoise, kNoise);
          if (rational) p = (1 + uniform(generator, 0, 1e-10)) * p;
        }
        patch.points(i, k) = p;
      }
  }
  return surface;
}

std::vector<double> with_thin_run() {
  std::vector<double> knots{0, 0.4};
  for (int k = 1; k <= 40; ++k) knots.push_back(0.4 + k * 1e-9);
  knots.push_back(1);
  return knots;
}

// Of the two surfaces at the same parameters, clamped to the second one's.
double sampled_gap(const BezierSurface& a, const BezierSurface& b) {
  double most = 0;
  for (int i = 0; i <= 4; ++i)
    for (int k = 0; k <= 4000; ++k) {
      const double v = k <= 2000 ? k / 2000.0 : 0.4 - 1e-8 + (k - 2000) * 6e-8 / 2000;
      most = std::max(most, distance(point_at(a, {i / 4.0, v}), point_at(b, {i / 4.0, v})));
    }
  return most;
}

double largest_facet_distance(const BezierSurface& surface, double low, double high) {
  const SplineChart chart(surface, 0.01);
  const Vec3 normal = chart.frame_at({0.5, 0.5 * (low + high)}).normal;
  return chart.facet_distance({Vec2{0, low}, Vec2{1, low}, Vec2{0.5, high}}, normal, 0.01);
}

class ThinSpans : public ::testing::TestWithParam<bool> {};

TEST_P(ThinSpans, AtTheStartAreCutOff) {
  const BezierSurface given = noisy_graph({-1e-8, 0, 1}, GetParam());
  BezierSurface surface = given;
  drop_thin_spans(surface, 1e-6);
  EXPECT_EQ(surface.v_knots, (std::vector<double>{0, 1}));
  EXPECT_LE(sampled_gap(given, surface), surface.error);
  EXPECT_LT(surface.error, 1e-6);
}

TEST_P(ThinSpans, InsideAreReachedOver) {
  const BezierSurface given = noisy_graph(with_thin_run(), GetParam());
  BezierSurface surface = given;
  drop_thin_spans(surface, 1e-6);
  ASSERT_EQ(surface.v_knots.size(), 3u);
  EXPECT_EQ(surface.v_knots[1], with_thin_run()[41]);
  EXPECT_LE(sampled_gap(given, surface), surface.error);
  EXPECT_LT(surface.error, 1e-6);
  EXPECT_LT(norm(surface.patches(0, 0).points(0, 3) - surface.patches(0, 1).points(0, 0)), 1e-15);
}

TEST_P(ThinSpans, StayWhereTheyMoveMoreThanIsWanted) {
  BezierSurface surface = noisy_graph(with_thin_run(), GetParam());
  drop_thin_spans(surface, 1e-11);
  EXPECT_EQ(surface.v_knots, with_thin_run());
  EXPECT_EQ(surface.error, 0);
}

TEST_P(ThinSpans, OfUAreFoundLikeThoseOfV) {
  const BezierSurface given = noisy_graph(with_thin_run(), GetParam());
  BezierSurface turned = given;
  std::swap(turned.u_knots, turned.v_knots);
  turned.patches = Grid<RationalBezierPatch>(given.patches.columns(), 1);
  for (int j = 0; j < given.patches.columns(); ++j) {
    turned.patches(j, 0).points = Grid<Vec4>(4, 2);
    for (int i = 0; i < 2; ++i)
      for (int k = 0; k < 4; ++k)
        turned.patches(j, 0).points(k, i) = given.patches(0, j).points(i, k);
  }
  drop_thin_spans(turned, 1e-6);
  EXPECT_EQ(turned.u_knots.size(), 3u);
  EXPECT_EQ(turned.v_knots, given.u_knots);
}

// Derivatives in such spans are 1e-8 over 1e-18, and a bound of facets that follows from them is of
// the size of the universe.
TEST_P(ThinSpans, SayNothingOfFacets) {
  EXPECT_LT(largest_facet_distance(noisy_graph({-1e-8, 0, 1}, GetParam()), -1e-8, 0.2), 0.01);
  EXPECT_LT(largest_facet_distance(noisy_graph(with_thin_run(), GetParam()), 0.3, 0.5), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Weights, ThinSpans, ::testing::Bool());

}  // namespace
}  // namespace blossom
