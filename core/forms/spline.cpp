// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/spline.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "core/base/errors.h"

namespace blossom {
namespace {

std::vector<double> flat_knots(const std::vector<double>& knots,
                               const std::vector<int>& multiplicities) {
  std::vector<double> flat;
  for (std::size_t i = 0; i < knots.size(); ++i)
    flat.insert(flat.end(), static_cast<std::size_t>(multiplicities[i]), knots[i]);
  return flat;
}

// Index into the flat knots of the span that holds `t`; the last span takes the end.
std::size_t span_of(const std::vector<double>& flat, std::size_t degree, std::size_t points,
                    double t) {
  const auto first = flat.begin() + static_cast<std::ptrdiff_t>(degree);
  const auto last = flat.begin() + static_cast<std::ptrdiff_t>(points);
  const auto above = std::upper_bound(first + 1, last, t);
  return static_cast<std::size_t>(above - flat.begin()) - 1;
}

// The blossom of the polynomial of a span at `degree` parameters: de Boor's triangle with one
// parameter a level.
template <class Point>
Point blossom_of_span(const SplineOf<Point>& spline, const std::vector<double>& flat,
                      std::size_t span, const double* parameters) {
  const auto p = static_cast<std::size_t>(spline.degree);
  const std::size_t first = span - p;
  std::vector<Point> d(spline.points.begin() + static_cast<std::ptrdiff_t>(first),
                       spline.points.begin() + static_cast<std::ptrdiff_t>(first + p + 1));
  for (std::size_t r = 1; r <= p; ++r)
    for (std::size_t j = p; j >= r; --j) {
      const double low = flat[j + first];
      const double high = flat[j + 1 + span - r];
      const double s = (parameters[r - 1] - low) / (high - low);
      d[j] = (1 - s) * d[j - 1] + s * d[j];
    }
  return d[p];
}

// n times the difference of the blossoms at one end of the span and the other, t elsewhere.
template <class Point>
Point de_boor(const SplineOf<Point>& spline, double parameter, bool derivative) {
  const auto p = static_cast<std::size_t>(spline.degree);
  const std::vector<double> flat = flat_knots(spline.knots, spline.multiplicities);
  const double t = std::clamp(parameter, spline.knots.front(), spline.knots.back());
  const std::size_t span = span_of(flat, p, spline.points.size(), t);
  std::vector<double> parameters(p, t);
  if (!derivative) return blossom_of_span(spline, flat, span, parameters.data());
  parameters.back() = flat[span + 1];
  const Point high = blossom_of_span(spline, flat, span, parameters.data());
  parameters.back() = flat[span];
  const Point low = blossom_of_span(spline, flat, span, parameters.data());
  return (static_cast<double>(p) / (flat[span + 1] - flat[span])) * (high - low);
}

template <class Point>
SplineOf<Point> part_of(const SplineOf<Point>& spline, const Interval& part) {
  const Interval domain = spline.domain();
  if (!(part.from < part.to) || part.from < domain.from || part.to > domain.to)
    throw InvalidInput("restricted: the part [" + std::to_string(part.from) + ", " +
                       std::to_string(part.to) + "] is empty or outside the domain");
  SplineOf<Point> result{spline.degree, {part.from}, {spline.degree + 1}, {}};
  for (std::size_t i = 0; i < spline.knots.size(); ++i)
    if (spline.knots[i] > part.from && spline.knots[i] < part.to) {
      result.knots.push_back(spline.knots[i]);
      result.multiplicities.push_back(spline.multiplicities[i]);
    }
  result.knots.push_back(part.to);
  result.multiplicities.push_back(spline.degree + 1);

  const auto p = static_cast<std::size_t>(spline.degree);
  const std::vector<double> old_flat = flat_knots(spline.knots, spline.multiplicities);
  const std::vector<double> flat = flat_knots(result.knots, result.multiplicities);
  for (std::size_t i = 0; i + p + 1 < flat.size(); ++i) {
    // Any span that control point i reaches has the same blossom at its knots.
    std::size_t reached = i;
    while (!(flat[reached] < flat[reached + 1])) ++reached;
    const double middle = 0.5 * (flat[reached] + flat[reached + 1]);
    const std::size_t span = span_of(old_flat, p, spline.points.size(), middle);
    result.points.push_back(blossom_of_span(spline, old_flat, span, flat.data() + i + 1));
  }
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

}  // namespace

Vec3 point_at(const Spline& spline, double t) { return de_boor(spline, t, false); }
Vec2 point_at(const Spline2& spline, double t) { return de_boor(spline, t, false); }
Vec3 derivative_at(const Spline& spline, double t) { return de_boor(spline, t, true); }
Vec2 derivative_at(const Spline2& spline, double t) { return de_boor(spline, t, true); }

Spline restricted(const Spline& spline, const Interval& part) { return part_of(spline, part); }
Spline2 restricted(const Spline2& spline, const Interval& part) { return part_of(spline, part); }

Spline joined(const Spline& first, const Spline& second) { return appended(first, second); }
Spline2 joined(const Spline2& first, const Spline2& second) { return appended(first, second); }

}  // namespace blossom
