// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/regions/triangle_lowering.h"

#include <algorithm>
#include <numbers>

#include "core/base/unbounded.h"
#include "core/math/roundoff.h"

namespace blossom {
namespace {

// Relative to the largest coordinate: a product and a sum on the way to local coordinates and back.
constexpr double kShiftError = 8 * kUnitRoundoff;

bool is_polynomial(const RationalBezierTriangle& triangle) {
  return std::ranges::all_of(triangle.points, [](const Vec4& p) { return p[3] == 1; });
}

// Homogeneous points as seen from one of them, with weights as large as the rest.
struct LocalPoints {
  explicit LocalPoints(const RationalBezierTriangle& triangle)
      : centre(projected(triangle.points.front())) {
    for (const Vec4& p : triangle.points) {
      const Vec3 place = projected(p);
      radius = std::max(radius, norm(place - centre));
      largest = std::max(largest, max_norm(place));
      least_weight = std::min(least_weight, p[3]);
    }
    if (radius == 0) radius = 1;  // a point in space
    form.degree = triangle.degree;
    for (const Vec4& p : triangle.points)
      form.points.push_back({p[0] - p[3] * centre[0], p[1] - p[3] * centre[1],
                             p[2] - p[3] * centre[2], p[3] * radius});
  }

  RationalBezierTriangle in_space(const RationalBezierTriangle& local) const {
    RationalBezierTriangle result{local.degree, {}};
    for (const Vec4& p : local.points) {
      const double w = p[3] / radius;
      result.points.push_back(
          {p[0] + w * centre[0], p[1] + w * centre[1], p[2] + w * centre[2], w});
    }
    return result;
  }

  // Bound in space of what is off by this much in four coordinates.
  double bound(double error) const {
    const double weight = least_weight - error / radius;
    if (!(weight > 0)) return kInfinity;
    return std::numbers::sqrt2 * error / weight + kShiftError * largest;
  }

  // The largest error in four coordinates whose bound in space is this.
  double error_within(double tolerance) const {
    const double left = tolerance - kShiftError * largest;
    return left > 0 ? left * least_weight / (std::numbers::sqrt2 + left / radius) : 0;
  }

  Vec3 centre;
  double radius = 0;
  double largest = 0;
  double least_weight = kInfinity;
  RationalBezierTriangle form;
};

}  // namespace

ReducedOf<BezierTriangle> TriangleLowering::operator()(const BezierTriangle& triangle, int lowest,
                                                       int highest, double tolerance) {
  return lowered(triangle, lowest, highest, tolerance);
}

ReducedOf<RationalBezierTriangle> TriangleLowering::operator()(
    const RationalBezierTriangle& triangle, int lowest, int highest, double tolerance) {
  if (is_polynomial(triangle)) {
    BezierTriangle plain{triangle.degree, {}};
    for (const Vec4& p : triangle.points) plain.points.push_back({p[0], p[1], p[2]});
    const auto made = lowered(plain, lowest, highest, tolerance);
    ReducedOf<RationalBezierTriangle> result{{made.form.degree, {}}, made.error};
    for (const Vec3& p : made.form.points) result.form.points.push_back({p[0], p[1], p[2], 1});
    return result;
  }
  const LocalPoints local(triangle);
  const auto made = lowered(local.form, lowest, highest, local.error_within(tolerance));
  if (made.form.degree == triangle.degree) return {triangle, 0};
  return {local.in_space(made.form), local.bound(made.error)};
}

template <class Point>
ReducedOf<BezierTriangleOf<Point>> TriangleLowering::lowered(
    const BezierTriangleOf<Point>& triangle, int lowest, int highest, double tolerance) {
  ReducedOf<BezierTriangleOf<Point>> result{triangle, 0};
  if (triangle.degree > highest) result = reduction(triangle.degree, highest)(triangle);
  for (int degree = lowest; degree < result.form.degree; ++degree) {
    auto lower = reduction(result.form.degree, degree)(result.form);
    if (lower.error > tolerance) continue;
    lower.error += result.error;
    return lower;
  }
  return result;
}

const TriangleReduction& TriangleLowering::reduction(int from, int to) {
  const auto known = reductions_.find({from, to});
  if (known != reductions_.end()) return known->second;
  return reductions_.emplace(std::pair(from, to), TriangleReduction(from, to)).first->second;
}

}  // namespace blossom
