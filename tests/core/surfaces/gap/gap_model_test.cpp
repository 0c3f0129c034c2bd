// SPDX-License-Identifier: LGPL-2.1-or-later
// The gap between two patches far from the origin, beside the same in more digits.

#include "core/surfaces/gap/gap_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/support/quadric_patches.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::Random;
using testing::uniform;

using Long = long double;
using LongVec = std::array<Long, 3>;

struct LongJet {
  LongVec point, u, v;
};

std::vector<std::array<Long, 2>> bernstein(int degree, Long t) {
  std::vector<std::array<Long, 2>> basis;  // value and derivative
  for (int k = 0; k <= degree; ++k) {
    const Long binomial = std::round(std::tgamma(degree + 1.0L) / std::tgamma(k + 1.0L) /
                                     std::tgamma(degree - k + 1.0L));
    const Long low = std::pow(t, static_cast<Long>(k)),
               high = std::pow(1 - t, static_cast<Long>(degree - k));
    const Long slope = (k > 0 ? k * std::pow(t, k - 1.0L) * high : 0) -
                       (k < degree ? (degree - k) * std::pow(1 - t, degree - k - 1.0L) * low : 0);
    basis.push_back({binomial * low * high, binomial * slope});
  }
  return basis;
}

// A point relative to `origin`; the points of the patch are not.
LongJet jet(const RationalBezierPatch& patch, const Vec3& origin, Long u, Long v) {
  const auto bu = bernstein(patch.degree_u(), u), bv = bernstein(patch.degree_v(), v);
  std::array<std::array<Long, 4>, 3> sum{};  // value, by u, by v
  for (int i = 0; i <= patch.degree_u(); ++i)
    for (int j = 0; j <= patch.degree_v(); ++j) {
      const auto &x = bu[static_cast<std::size_t>(i)], &y = bv[static_cast<std::size_t>(j)];
      const std::array<Long, 3> factor{x[0] * y[0], x[1] * y[0], x[0] * y[1]};
      const Vec4& p = patch.points(i, j);
      for (std::size_t d = 0; d < 3; ++d) {
        for (int k = 0; k < 3; ++k)
          sum[d][static_cast<std::size_t>(k)] +=
              factor[d] * (Long(p[k]) - Long(p[3]) * Long(origin[k]));
        sum[d][3] += factor[d] * p[3];
      }
    }
  LongJet result;
  for (std::size_t k = 0; k < 3; ++k) {
    const Long x = sum[0][k] / sum[0][3];
    result.point[k] = x;
    result.u[k] = (sum[1][k] - x * sum[1][3]) / sum[0][3];
    result.v[k] = (sum[2][k] - x * sum[2][3]) / sum[0][3];
  }
  return result;
}

Long along(const Vec3& direction, const LongVec& x) {
  return direction[0] * x[0] + direction[1] * x[1] + direction[2] * x[2];
}

// The height of a point over b along the chart's normal, by Newton's method.
Long height_over(const LongVec& point, const RationalBezierPatch& b, const Vec3& origin,
                 const GraphChart& chart, Long s, Long t) {
  LongVec gap{};
  for (int step = 0; step < 20; ++step) {
    const LongJet foot = jet(b, origin, s, t);
    for (std::size_t k = 0; k < 3; ++k) gap[k] = point[k] - foot.point[k];
    const Long x = along(chart.e1, gap), y = along(chart.e2, gap);
    const Long a11 = along(chart.e1, foot.u), a12 = along(chart.e1, foot.v);
    const Long a21 = along(chart.e2, foot.u), a22 = along(chart.e2, foot.v);
    const Long determinant = a11 * a22 - a12 * a21;
    s += (a22 * x - a12 * y) / determinant;
    t += (a11 * y - a21 * x) / determinant;
  }
  return along(chart.normal, gap);
}

RationalBezierPatch moved(RationalBezierPatch patch, const Vec3& shift, Random& random) {
  const double weight = uniform(random, 0.5, 2);
  for (Vec4& p : patch.points.values()) {
    for (int k = 0; k < 3; ++k) p[k] += p[3] * (shift[k] + uniform(random, -1e-3, 1e-3));
    p = p * weight;
  }
  return patch;
}

class FarPatches : public ::testing::TestWithParam<double> {};

TEST_P(FarPatches, TheGapsErrorHoldsTheRoundingOfTheirCoordinates) {
  Random random = testing::seeded(7);
  const Vec3 origin{0.7 * GetParam(), -0.9 * GetParam(), GetParam()};
  int models = 0;
  double least_error = 1e300;
  for (int trial = 0; trial < 40; ++trial) {
    const RationalBezierPatch whole = testing::torus_quarter(1, uniform(random, 0.2, 0.6));
    const RationalBezierPatch a = moved(whole, origin, random), b = moved(whole, origin, random);
    CellTree tree_a(a, true, origin, CellForm::Auto, 0.4865);
    const CellTree tree_b(b, true, origin, CellForm::Auto, 0.4865);
    int index = 0;
    for (int halving = 0; halving < 8 + trial % 8; ++halving)
      index = tree_a.split(index) + testing::pick(random, 0, 1);
    const Cell cell = tree_a[index];
    const auto wider = [](const Interval& x) {
      return Interval{std::max(0.0, x.from - 2 * length(x)), std::min(1.0, x.to + 2 * length(x))};
    };
    const auto chart = graph_chart(tree_b, wider(cell.u), wider(cell.v), 0.2);
    if (!chart) continue;
    const auto model = gap_model(tree_a, cell, tree_b, *chart);
    if (!model) continue;
    ++models;
    for (int sample = 0; sample < 8; ++sample) {
      const double x = uniform(random, -1, 1), y = uniform(random, -1, 1);
      const auto place = [](const Interval& side, double t) {
        return side.from + (Long(side.to) - side.from) * (1 + Long(t)) / 2;
      };
      const Long u = place(cell.u, x), v = place(cell.v, y);
      const Long exact = height_over(jet(a, origin, u, v).point, b, origin, *chart, u, v);
      EXPECT_LE(std::abs(static_cast<double>(exact - value(model->gap, x, y))),
                model->gap_error[0]);
    }
    least_error = std::min(least_error, model->gap_error[0]);
  }
  EXPECT_GT(models, 20);
  EXPECT_LT(least_error, 1e-12 + 1e-14 * GetParam());
}

INSTANTIATE_TEST_SUITE_P(Distances, FarPatches, ::testing::Values(1, 1e4, 1e7));

}  // namespace
}  // namespace blossom
