// SPDX-License-Identifier: LGPL-2.1-or-later
// Bicubic B-splines of many spans: curves run from patch to patch and are counted as a whole.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "core/forms/spline.h"
#include "core/surface_intersection.h"
#include "tests/support/components.h"
#include "tests/support/intersection_checks.h"
#include "tests/support/surface_changes.h"

namespace blossom {
namespace {

using testing::Components;
using testing::components;
using testing::total_projected_length;

using Height = std::function<double(double, double)>;

// The Bezier points of all spans of a clamped cubic with uniform knots, 4 to a span.
std::vector<Vec3> bezier_points_of(const std::vector<Vec3>& poles) {
  const int spans = static_cast<int>(poles.size()) - 3;
  Spline spline{3, {}, {}, poles};
  for (int k = 0; k <= spans; ++k) {
    spline.knots.push_back(k);
    spline.multiplicities.push_back(k == 0 || k == spans ? 4 : 1);
  }
  std::vector<Vec3> points;
  for (int k = 0; k < spans; ++k) {
    const Spline span = restricted(spline, {double(k), double(k + 1)});
    points.insert(points.end(), span.points.begin(), span.points.end());
  }
  return points;
}

// The clamped uniform bicubic B-spline with count x count poles (i, j, z(i, j)).
BezierSurface spline_surface(int count, const Height& z) {
  const int spans = count - 3;
  std::vector<std::vector<Vec3>> rows;
  for (int i = 0; i < count; ++i) {
    std::vector<Vec3> poles;
    for (int j = 0; j < count; ++j) poles.push_back({double(i), double(j), z(i, j)});
    rows.push_back(bezier_points_of(poles));
  }
  BezierSurface surface;
  for (int k = 0; k <= spans; ++k) {
    surface.u_knots.push_back(k);
    surface.v_knots.push_back(k);
  }
  surface.patches = Grid<RationalBezierPatch>(spans, spans, {Grid<Vec4>(4, 4)});
  for (std::size_t j = 0; j < rows[0].size(); ++j) {
    std::vector<Vec3> poles;
    for (const auto& row : rows) poles.push_back(row[j]);
    const std::vector<Vec3> column = bezier_points_of(poles);
    for (std::size_t i = 0; i < column.size(); ++i) {
      const int u = static_cast<int>(i), v = static_cast<int>(j);
      surface.patches(u / 4, v / 4).points(u % 4, v % 4) = {column[i][0], column[i][1],
                                                            column[i][2], 1};
    }
  }
  return surface;
}

struct Pair {
  BezierSurface a, b;
};

struct SplineRow {
  const char* name;
  int count;  ///< poles in each direction
  Height a, b;
  Components expected;
  double length;    ///< in the plane
  double relative;  ///< of its printed digits
};

// The smallest is the pair of the benchmark of geomcore 0.37.0, marching_intersection.rs. Lengths
// are those of level lines of z1 - z2 on fine grids.
const std::vector<SplineRow> kSplineRows{
    {"poles_6",
     6,
     [](double i, double j) { return std::sin(0.7 * i * j); },
     [](double i, double j) { return 0.5 * std::cos(1.3 * i) * std::cos(1.1 * j); },
     {.open = 5, .closed = 1},
     18.41413,
     1e-6},
    {"poles_12",
     12,
     [](double i, double j) { return std::sin(1.3 * i) * std::cos(0.9 * j); },
     [](double i, double j) { return 0.4 * std::cos(1.7 * i + 0.3 * j); },
     {.open = 7},
     66.899,
     1e-5},
    {"poles_24",
     24,
     [](double i, double j) { return std::sin(1.3 * i) * std::cos(0.9 * j); },
     [](double i, double j) { return 0.4 * std::cos(1.7 * i + 0.3 * j); },
     {.open = 16},
     299.84,
     2e-5},
};

Pair pair_of(const SplineRow& row) {
  return {spline_surface(row.count, row.a), spline_surface(row.count, row.b)};
}

void expect_on_both(const SurfaceIntersection& found, const Pair& pair, double rounding) {
  for (const IntersectionCurve& curve : found.curves)
    for (const SurfacePoint& sample : curve.samples) {
      EXPECT_LE(distance(point_at(pair.a, sample.uv_a), sample.point), rounding);
      EXPECT_LE(distance(point_at(pair.b, sample.uv_b), sample.point), rounding);
    }
}

class SplinePairs : public ::testing::TestWithParam<int> {
 protected:
  const SplineRow& row() const { return kSplineRows[static_cast<std::size_t>(GetParam())]; }
};

TEST_P(SplinePairs, AreFoundCompletely) {
  const Pair pair = pair_of(row());

  const SurfaceIntersection found = intersect(pair.a, pair.b);

  EXPECT_EQ(found.status, Status::Complete);
  EXPECT_EQ(components(found), row().expected);
  EXPECT_TRUE(found.places.empty());
  EXPECT_NEAR(total_projected_length(found), row().length, row().relative * row().length);
  expect_on_both(found, pair, 1e-10);
}

struct SplineChange {
  const char* name;
  std::function<Pair(const Pair&)> apply;
  double scale = 1;
};

const std::vector<SplineChange>& changes() {
  const auto motion = [](int seed, double scale) {
    return [=](const Pair& p) {
      testing::Random random = testing::seeded(seed);
      testing::Motion m = testing::random_motion(random);
      m.scale = scale;
      return Pair{moved(p.a, m), moved(p.b, m)};
    };
  };
  const auto both = [](const auto& change) {
    return [=](const Pair& p) { return Pair{change(p.a), change(p.b)}; };
  };
  static const std::vector<SplineChange> all{
      {"swapped",
       [](const Pair& p) {
         return Pair{p.b, p.a};
       }},
      {"exchanged", both([](const BezierSurface& s) { return testing::exchanged(s); })},
      {"reversed", both([](const BezierSurface& s) { return testing::reversed(s); })},
      {"elevated", both([](const BezierSurface& s) { return testing::elevated(s, 4); })},
      {"rotated", motion(0, 1)},
      {"rotated_and_small", motion(1, 1e-3), 1e-3},
      {"rotated_and_large", motion(2, 1e3), 1e3},
  };
  return all;
}

TEST_P(SplinePairs, AreTheSameInEveryPositionAndForm) {
  const Pair pair = pair_of(row());
  const std::vector<double> before = testing::sorted_lengths(intersect(pair.a, pair.b), 1);
  for (const SplineChange& change : changes()) {
    SCOPED_TRACE(change.name);
    const Pair changed = change.apply(pair);

    const SurfaceIntersection found = intersect(
        changed.a, changed.b, {.tolerances = {.point = Tolerances{}.point * change.scale}});

    EXPECT_EQ(found.status, Status::Complete);
    EXPECT_EQ(components(found), row().expected);
    const std::vector<double> after = testing::sorted_lengths(found, change.scale);
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t i = 0; i < after.size(); ++i)
      EXPECT_NEAR(after[i], before[i], 1e-6 * before[i]);
    expect_on_both(found, changed, 1e-10 * std::max(1.0, change.scale));
  }
}

INSTANTIATE_TEST_SUITE_P(Rows, SplinePairs,
                         ::testing::Range(0, static_cast<int>(kSplineRows.size())),
                         [](const auto& row) {
                           return std::string(
                               kSplineRows[static_cast<std::size_t>(row.param)].name);
                         });

}  // namespace
}  // namespace blossom
