// SPDX-License-Identifier: LGPL-2.1-or-later
// Splines of degree 5 through points with given first and second derivatives.

#pragma once

#include <optional>
#include <vector>

#include "core/forms/spline.h"

namespace blossom {

/// A point of a curve with its derivatives by the parameter.
template <class Point>
struct QuinticJet {
  Point value, rate;
  std::optional<Point> bend;  ///< may be unknown at the first and at the last one
};

/// The spline of degree 5 through jets at its knots, twice continuously differentiable. A piece at
/// an end of unknown second derivative is of degree 4.
///
/// accuracy   a circle in pieces of the angle h: h^6 / 46080 of its radius, rounding aside
/// knots      strictly increasing, three or more, as many as jets
///
/// Source: the control points are the blossom f of a piece at five knots. Round a knot with value
/// p, first derivative d and second derivative e
///   f(t, t, t, t + x, t + y) = p + (x + y) / 5 d + x y / 20 e
/// and a Bezier piece b of degree 5 is of degree 4 where
///   b0 - 5 b1 + 10 b2 - 10 b3 + 5 b4 - b5 = 0
template <class Point>
SplineOf<Point> quintic_through(const std::vector<double>& knots,
                                const std::vector<QuinticJet<Point>>& jets) {
  const auto blossom_at = [&](std::size_t i, double x, double y) {
    const QuinticJet<Point>& jet = jets[i];
    Point value = jet.value + ((x + y) / 5) * jet.rate;
    if (jet.bend) value = value + (x * y / 20) * *jet.bend;
    return value;
  };
  const std::size_t last = knots.size() - 1;
  SplineOf<Point> made{5, knots, std::vector<int>(knots.size(), 3), {}};
  made.multiplicities.front() = made.multiplicities.back() = 6;
  for (std::size_t i = 0; i <= last; ++i) {
    const double before = i > 0 ? knots[i - 1] - knots[i] : knots[1] - knots[0];
    const double after = i < last ? knots[i + 1] - knots[i] : before;
    if (i > 0) made.points.push_back(blossom_at(i, before, before));
    if (i == 0 || i == last) made.points.push_back(blossom_at(i, 0, i == 0 ? 0 : before));
    if (i == 0) made.points.push_back(blossom_at(i, 0, after));
    if (i > 0 && i < last) made.points.push_back(blossom_at(i, before, after));
    if (i == last) made.points.push_back(jets[i].value);
    if (i < last) made.points.push_back(blossom_at(i, after, after));
  }
  const auto lower = [&](std::size_t from, std::size_t to, bool unknown, auto point) {
    if (!unknown) return;
    // Bezier points of the end piece, counted from its end.
    const double h = knots[to] - knots[from];
    const Point &p = jets[from].value, &q = jets[to].value;
    const Point b1 = p + (h / 5) * jets[from].rate, b4 = q - (h / 5) * jets[to].rate;
    const Point b3 = blossom_at(to, -h, -h);
    *point = 0.1 * (5.0 * b1 - p + 10.0 * b3 - 5.0 * b4 + q);
  };
  lower(0, 1, !jets.front().bend, made.points.begin() + 2);
  lower(last, last - 1, !jets.back().bend, made.points.end() - 3);
  return made;
}

}  // namespace blossom
