// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/watertight/orientation_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/base/errors.h"
#include "core/blossom/detail/scaled_forms.h"
#include "core/forms/algebra/degree.h"
#include "core/forms/detail/checks.h"
#include "core/math/binomial.h"
#include "core/math/roundoff.h"
#include "core/subdivision/triangle_subdivision.h"

namespace blossom {
namespace {

using detail::ScaledForm;

constexpr double kPointRounding =
    256 * kUnitRoundoff;          // of given points, of the largest coordinate
constexpr int kMaxParts = 400;    // of one triangle
constexpr int kMaxHalvings = 40;  // in depth: a part of a million in length

// Of a patch, on both sides of its diagonal.
constexpr std::array<TriangleCorners, 2> kHalves{
    TriangleCorners{Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}},
    TriangleCorners{Vec2{1, 1}, Vec2{0, 1}, Vec2{1, 0}}};

// Differences of neighbouring control points along two sides, and the net of their cross product.
struct Tangents {
  BezierTriangle x, y;
  double largest_x = 0, largest_y = 0;
};

BezierTriangle differences(const BezierTriangle& triangle, bool of_x) {
  BezierTriangle result{triangle.degree - 1, {}};
  for (int nu = 0; nu < triangle.degree; ++nu)
    for (int mu = 0; nu + mu < triangle.degree; ++mu)
      result.points.push_back(triangle(nu + (of_x ? 1 : 0), mu + (of_x ? 0 : 1)) -
                              triangle(nu, mu));
  return result;
}

double largest(const BezierTriangle& net) {
  double most = 0;
  for (const Vec3& p : net.points) most = std::max(most, norm(p));
  return most;
}

double largest_difference(const BezierTriangle& a, const BezierTriangle& b) {
  double most = 0;
  for (std::size_t k = 0; k < a.points.size(); ++k)
    most = std::max(most, norm(a.points[k] - b.points[k]));
  return most;
}

Tangents tangents_of(const BezierTriangle& triangle) {
  Tangents result{differences(triangle, true), differences(triangle, false)};
  result.largest_x = largest(result.x);
  result.largest_y = largest(result.y);
  return result;
}

// binom(n, nu) binom(n - nu, mu) to rounding, for degrees beyond those of `trinomial`, too.
ScaledForm trinomials(int degree) {
  ScaledForm result = detail::zero_form(degree);
  double first = 1;
  for (int nu = 0; nu <= degree; first *= double(degree - nu) / (nu + 1), ++nu) {
    double value = first;
    for (int mu = 0; nu + mu <= degree; value *= double(degree - nu - mu) / (mu + 1), ++mu)
      result(nu, mu) = value;
  }
  return result;
}

using Components = std::array<ScaledForm, 3>;

Components scaled(const BezierTriangle& net) {
  Components result;
  for (int k = 0; k < 3; ++k) {
    ScaledForm& form = result[static_cast<std::size_t>(k)] = detail::zero_form(net.degree);
    for (int nu = 0; nu <= net.degree; ++nu)
      for (int mu = 0; nu + mu <= net.degree; ++mu)
        form(nu, mu) = trinomial(net.degree, nu, mu) * net(nu, mu)[k];
  }
  return result;
}

// The net of the normal, its components scaled.
Components normal_of(const Tangents& tangents) {
  const Components x = scaled(tangents.x), y = scaled(tangents.y);
  Components result;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    result[k] = detail::form_product(x[i], y[j]);
    detail::add_multiple(detail::form_product(x[j], y[i]), -1, result[k]);
  }
  return result;
}

// The points of a normal's net.
struct Directions {
  std::vector<Vec3> points;
  Vec3 mean;           // of unit length, or 0
  double longest = 0;  // of the points

  double least_along(const Vec3& direction) const {
    double least = HUGE_VAL;
    for (const Vec3& p : points) least = std::min(least, dot(p, direction));
    return least;
  }
};

Directions directions_of(const Components& normal) {
  const int degree = normal[0].degree;
  Directions result;
  for (int nu = 0; nu <= degree; ++nu)
    for (int mu = 0; nu + mu <= degree; ++mu) {
      const Vec3 scaled{normal[0](nu, mu), normal[1](nu, mu), normal[2](nu, mu)};
      result.points.push_back((1 / trinomial(degree, nu, mu)) * scaled);
      result.mean += result.points.back();
      result.longest = std::max(result.longest, norm(result.points.back()));
    }
  if (const double length = norm(result.mean); length > 0) result.mean = (1 / length) * result.mean;
  return result;
}

// Halved across the side from a to b at its middle m: the corners (c, a, m) and (b, c, m), so that
// the next halves are across the sides that are longest then.
template <class Point>
std::pair<BezierTriangleOf<Point>, BezierTriangleOf<Point>> halves(
    const BezierTriangleOf<Point>& form) {
  const int n = form.degree;
  BezierTriangleOf<Point> first{n, std::vector<Point>(form.points.size())}, second = first;
  std::vector<Point> row;
  for (int c = 0; c <= n; ++c) {
    row.clear();
    for (int a = 0; a <= n - c; ++a) row.push_back(form(a, n - c - a));
    for (int left = n - c;; --left) {
      first(c, left) = row[static_cast<std::size_t>(left)];
      second(left, c) = row.front();
      if (left == 0) break;
      for (int i = 0; i < left; ++i) {
        Point& x = row[static_cast<std::size_t>(i)];
        x = 0.5 * (x + row[static_cast<std::size_t>(i) + 1]);
      }
    }
  }
  return {std::move(first), std::move(second)};
}

// How far control points are from the line through the two corners that are farthest apart.
double width(const BezierTriangle& triangle) {
  const int n = triangle.degree;
  const std::array<Vec3, 3> corners{triangle(n, 0), triangle(0, n), triangle(0, 0)};
  Vec3 from = corners[0], along;
  for (std::size_t k = 0; k < 3; ++k)
    if (const Vec3 side = corners[(k + 1) % 3] - corners[k]; norm(side) > norm(along)) {
      from = corners[k];
      along = side;
    }
  const double square = dot(along, along);
  double most = 0;
  for (const Vec3& p : triangle.points) {
    const Vec3 way = p - from;
    most = std::max(most, norm(square > 0 ? way - (dot(way, along) / square) * along : way));
  }
  return most;
}

// A bound on |N' - N|.
double largest_turn(const Tangents& given, const Tangents& moved) {
  return largest_difference(given.x, moved.x) * moved.largest_y +
         given.largest_x * largest_difference(given.y, moved.y);
}

// Halves both until the coefficients are positive or they are narrow.
class Proof {
 public:
  Proof(double noise, double within) : noise_(noise), within_(within) {}

  bool holds(const BezierTriangle& given, const BezierTriangle& moved, int depth = 0) {
    if (++parts_ > kMaxParts) return false;
    if (is_below_right_angle(given, moved)) return true;
    if (std::max(width(given), width(moved)) <= within_) return true;
    if (depth == kMaxHalvings) return false;
    const auto [given_first, given_second] = halves(given);
    const auto [moved_first, moved_second] = halves(moved);
    return holds(given_first, moved_first, depth + 1) &&
           holds(given_second, moved_second, depth + 1);
  }

 private:
  // |N' - N| may be below |N|, all N' on the side of the mean of N, or N . N' positive: by their
  // coefficients, each a mean of products of differences of points, rounded as these are.
  bool is_below_right_angle(const BezierTriangle& given, const BezierTriangle& moved) const {
    const Tangents from = tangents_of(given), to = tangents_of(moved);
    const double terms = static_cast<double>(BezierTriangle::count(given.degree)) + 32;
    const double of_given = 2 * noise_ * (from.largest_x + from.largest_y) +
                            2 * terms * kUnitRoundoff * from.largest_x * from.largest_y;
    const Components normal = normal_of(from);
    const Directions before = directions_of(normal);
    if (before.least_along(before.mean) > largest_turn(from, to) + of_given) return true;

    const Components moved_normal = normal_of(to);
    const Directions after = directions_of(moved_normal);
    const double of_moved = 2 * terms * kUnitRoundoff * to.largest_x * to.largest_y;
    if (norm(before.mean) > 0 && after.least_along(before.mean) >= -of_moved) return true;

    const double rounding = of_given * after.longest + of_moved * before.longest +
                            4 * terms * kUnitRoundoff * before.longest * after.longest;
    const ScaledForm product = dot_product(normal, moved_normal);
    const ScaledForm weights = trinomials(product.degree);
    for (std::size_t k = 0; k < product.points.size(); ++k)
      if (product.points[k] < -rounding * weights.points[k]) return false;
    return true;
  }

  static ScaledForm dot_product(const Components& a, const Components& b) {
    ScaledForm product = detail::zero_form(a[0].degree + b[0].degree);
    for (std::size_t k = 0; k < 3; ++k) detail::add_form_product(a[k], b[k], product);
    return product;
  }

  double noise_;  // of the given points
  double within_;
  int parts_ = 0;
};

void check(const BezierTriangle& triangle) {
  detail::check_triangle("turns_nowhere", triangle, kMaxDegree);
  if (triangle.degree == 0) throw InvalidInput("turns_nowhere: the degree is 0");
}

}  // namespace

bool turns_nowhere(const BezierTriangle& given, const BezierTriangle& moved, double within) {
  check(given);
  check(moved);
  const int degree = std::max(given.degree, moved.degree);
  return Proof(kPointRounding * largest(given), within)
      .holds(elevated(given, degree), elevated(moved, degree));
}

bool turns_nowhere(const BezierPatch& given, const BezierPatch& moved, double within) {
  if (given.degree_u() + given.degree_v() > kMaxDegree) return false;
  return std::ranges::all_of(kHalves, [&](const TriangleCorners& half) {
    return turns_nowhere(sub_triangle(given, half), sub_triangle(moved, half), within);
  });
}

}  // namespace blossom
