// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/spline.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

#include "core/base/errors.h"
#include "core/forms/curve.h"

namespace blossom {
namespace {

std::vector<double> flat_knots(const std::vector<double>& knots,
                               const std::vector<int>& multiplicities) {
  std::vector<double> flat;
  for (std::size_t i = 0; i < knots.size(); ++i)
    flat.insert(flat.end(), static_cast<std::size_t>(multiplicities[i]), knots[i]);
  return flat;
}

// The blossom of the polynomial of a span at p parameters: de Boor's triangle with one parameter a
// level.
//
// points   the p + 1 control points of the span
// knots    the 2 p flat knots round the span, which lies between knots[p - 1] and knots[p]
template <class Point>
Point blossom_of_span(const Point* points, const double* knots, std::size_t p,
                      const double* parameters) {
  std::array<Point, kMaxDegree + 1> d;
  std::copy_n(points, p + 1, d.begin());
  for (std::size_t r = 1; r <= p; ++r)
    for (std::size_t j = p; j >= r; --j) {
      const double low = knots[j - 1], high = knots[j + p - r];
      const double s = (parameters[r - 1] - low) / (high - low);
      d[j] = (1 - s) * d[j - 1] + s * d[j];
    }
  return d[p];
}

// n times the difference of the blossoms at one end of the span and the other, t elsewhere.
template <class Point>
Point de_boor(const SplineOf<Point>& spline, double parameter, bool derivative) {
  const auto p = static_cast<std::size_t>(spline.degree);
  assert(spline.degree <= kMaxDegree);
  const double t = std::clamp(parameter, spline.knots.front(), spline.knots.back());
  const auto above = std::upper_bound(spline.knots.begin() + 1, spline.knots.end() - 1, t);
  const auto knot = static_cast<std::size_t>(above - spline.knots.begin()) - 1;
  std::array<double, 2 * kMaxDegree> knots;
  std::size_t left = 0, right = 0, past = 0;
  for (std::size_t i = 0; i <= knot; ++i)
    past += static_cast<std::size_t>(spline.multiplicities[i]);
  for (std::size_t i = knot + 1; left < p && i-- > 0;)
    for (int k = 0; k < spline.multiplicities[i] && left < p; ++k)
      knots[p - 1 - left++] = spline.knots[i];
  for (std::size_t i = knot + 1; right < p && i < spline.knots.size(); ++i)
    for (int k = 0; k < spline.multiplicities[i] && right < p; ++k)
      knots[p + right++] = spline.knots[i];

  std::array<double, kMaxDegree> parameters;
  std::fill_n(parameters.begin(), p, t);
  const Point* points = spline.points.data() + (past - 1 - p);
  if (!derivative) return blossom_of_span(points, knots.data(), p, parameters.data());
  parameters[p - 1] = spline.knots[knot + 1];
  const Point high = blossom_of_span(points, knots.data(), p, parameters.data());
  parameters[p - 1] = spline.knots[knot];
  const Point low = blossom_of_span(points, knots.data(), p, parameters.data());
  return (static_cast<double>(p) / (spline.knots[knot + 1] - spline.knots[knot])) * (high - low);
}

// The spline from a parameter on. Of the new control points p are blossoms at 1..p times the start
// and the knots that follow, which de Boor's triangle for the start has on its lower side: convex
// combinations, however long or short the spans are. All others are the old ones.
//
// domain   of the parameters, for their rounding
template <class Point>
SplineOf<Point> without_start(const SplineOf<Point>& spline, double from, const Interval& domain) {
  const auto p = static_cast<std::size_t>(spline.degree);
  const std::vector<double> flat = flat_knots(spline.knots, spline.multiplicities);
  std::size_t kept = 1;
  while (kept + 1 < spline.knots.size() && !is_span({from, spline.knots[kept]}, domain)) ++kept;
  std::size_t last = 0;  // the last point that the first kept span needs
  for (std::size_t i = 0; i < kept; ++i) last += static_cast<std::size_t>(spline.multiplicities[i]);
  last -= 1;

  const auto tail = static_cast<std::ptrdiff_t>(kept);
  SplineOf<Point> result{spline.degree, {from}, {spline.degree + 1}, std::vector<Point>(p)};
  result.knots.insert(result.knots.end(), spline.knots.begin() + tail, spline.knots.end());
  result.multiplicities.insert(result.multiplicities.end(), spline.multiplicities.begin() + tail,
                               spline.multiplicities.end());
  std::vector<Point> d(spline.points.begin() + static_cast<std::ptrdiff_t>(last - p),
                       spline.points.begin() + static_cast<std::ptrdiff_t>(last + 1));
  for (std::size_t r = 1; r <= p; ++r) {
    for (std::size_t j = p; j >= r; --j) {
      const double low = flat[last - p + j], high = flat[last + j - r + 1];
      const double s = (from - low) / (high - low);
      d[j] = (1 - s) * d[j - 1] + s * d[j];
    }
    result.points[p - r] = d[p];
  }
  result.points.insert(result.points.end(),
                       spline.points.begin() + static_cast<std::ptrdiff_t>(last),
                       spline.points.end());
  return result;
}

// The same curve, walked the other way by the negative of its parameter.
template <class Point>
SplineOf<Point> mirrored(SplineOf<Point> spline) {
  std::reverse(spline.knots.begin(), spline.knots.end());
  for (double& knot : spline.knots) knot = -knot;
  std::reverse(spline.multiplicities.begin(), spline.multiplicities.end());
  std::reverse(spline.points.begin(), spline.points.end());
  return spline;
}

template <class Point>
SplineOf<Point> part_of(const SplineOf<Point>& spline, const Interval& part) {
  const Interval domain = spline.domain();
  if (!(part.from < part.to) || part.from < domain.from || part.to > domain.to)
    throw InvalidInput("restricted: the part [" + std::to_string(part.from) + ", " +
                       std::to_string(part.to) + "] is empty or outside the domain");
  SplineOf<Point> result = spline;
  if (part.from > domain.from) result = without_start(result, part.from, domain);
  if (part.to < domain.to) result = mirrored(without_start(mirrored(result), -part.to, domain));
  return result;
}

template <class Point>
SplineOf<Point> appended(SplineOf<Point> first, const SplineOf<Point>& second) {
  if (first.degree != second.degree) throw InvalidInput("joined: the degrees differ");
  const double shift = first.knots.back() - second.knots.front();
  first.multiplicities.back() = first.degree;
  for (std::size_t i = 1; i < second.knots.size(); ++i) {
    first.knots.push_back(second.knots[i] + shift);
    first.multiplicities.push_back(second.multiplicities[i]);
  }
  first.points.insert(first.points.end(), second.points.begin() + 1, second.points.end());
  return first;
}

// Two Bezier pieces, on [z, a] and [a, b], whose control points follow one another.
template <class Point>
struct PiecePair {
  const Point* left;  // degree + 1 each, the last of the left ones is the first of the right ones
  const Point* right;
  double z, a, b;
  std::size_t degree;

  // The blossom at z, at a as often as degree - 2, and at b, if both pieces have it.
  std::optional<Point> shared(double rounding) const {
    const Point &before = left[degree - 2], &after = right[2];
    const Point from_left = before + ((b - z) / (a - z)) * (left[degree - 1] - before);
    const Point from_right = after + ((b - z) / (b - a)) * (right[1] - after);
    const Point both = 0.5 * (from_left + from_right);
    const double s = (a - z) / (b - z);
    const Point last = before + s * (both - before), first = both + s * (after - both);
    const Point middle = last + s * (first - last);
    const bool same = distance(last, left[degree - 1]) <= rounding &&
                      distance(first, right[1]) <= rounding &&
                      distance(middle, right[0]) <= rounding;
    return same ? std::optional(both) : std::nullopt;
  }
};

template <class Point>
SplineOf<Point> sparse(const SplineOf<Point>& spline) {
  const auto p = static_cast<std::size_t>(spline.degree);
  const auto& knots = spline.knots;
  const auto is_full = [&](int times) { return times == spline.degree; };
  if (p < 3 ||
      !std::all_of(spline.multiplicities.begin() + 1, spline.multiplicities.end() - 1, is_full))
    return spline;
  double largest = 0;
  for (const Point& point : spline.points) largest = std::max(largest, max_norm(point));
  SplineOf<Point> made{spline.degree, knots, spline.multiplicities, {}};
  made.points.assign(spline.points.begin(), spline.points.begin() + 2);
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const Point *left = &spline.points[p * i], *right = left + p;
    made.points.insert(made.points.end(), left + 2, left + p - 1);
    if (i + 2 == knots.size()) break;
    const PiecePair<Point> pieces{left, right, knots[i], knots[i + 1], knots[i + 2], p};
    if (const auto point = pieces.shared(kSmoothJoin * largest)) {
      made.multiplicities[i + 1] -= 2;
      made.points.push_back(*point);
    } else {
      made.points.insert(made.points.end(), {left[p - 1], right[0], right[1]});
    }
  }
  made.points.insert(made.points.end(), spline.points.end() - 2, spline.points.end());
  return made;
}

}  // namespace

bool is_span(const Interval& part, const Interval& domain) {
  return part.to - part.from > kSameKnot * std::max(std::abs(domain.from), std::abs(domain.to));
}

Vec3 point_at(const Spline& spline, double t) { return de_boor(spline, t, false); }
Vec2 point_at(const Spline2& spline, double t) { return de_boor(spline, t, false); }
Vec3 derivative_at(const Spline& spline, double t) { return de_boor(spline, t, true); }
Vec2 derivative_at(const Spline2& spline, double t) { return de_boor(spline, t, true); }

Spline restricted(const Spline& spline, const Interval& part) { return part_of(spline, part); }
Spline2 restricted(const Spline2& spline, const Interval& part) { return part_of(spline, part); }

Spline joined(const Spline& first, const Spline& second) { return appended(first, second); }
Spline2 joined(const Spline2& first, const Spline2& second) { return appended(first, second); }

Spline without_idle_knots(const Spline& spline) { return sparse(spline); }
Spline2 without_idle_knots(const Spline2& spline) { return sparse(spline); }

}  // namespace blossom
