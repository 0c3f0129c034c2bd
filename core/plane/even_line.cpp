// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/plane/even_line.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace blossom {

bool is_even_line(const Spline2& spline) {
  const Interval domain = spline.domain();
  const Vec2 from = spline.points.front(), whole = spline.points.back() - from;
  Vec2 allowed;
  for (const Vec2& point : spline.points)
    for (int d = 0; d < 2; ++d) allowed[d] = std::max(allowed[d], kEvenLine * std::abs(point[d]));
  std::vector<double> knots;
  for (std::size_t i = 0; i < spline.knots.size(); ++i)
    knots.insert(knots.end(), static_cast<std::size_t>(spline.multiplicities[i]), spline.knots[i]);
  // The control points of an even line lie at the means of their knots (Greville's abscissae).
  for (std::size_t i = 0; i < spline.points.size(); ++i) {
    double mean = 0;
    for (int k = 1; k <= spline.degree; ++k)
      mean += knots[i + static_cast<std::size_t>(k)] / spline.degree;
    const Vec2 off = spline.points[i] - (from + (mean - domain.from) / length(domain) * whole);
    if (!(std::abs(off[0]) <= allowed[0] && std::abs(off[1]) <= allowed[1])) return false;
  }
  return true;
}

PlanarCurve simplest_curve(const Spline2& spline) {
  if (!is_even_line(spline)) return planar_curve(spline);
  return planar_line(spline.points.front(), spline.points.back(), spline.domain());
}

}  // namespace blossom
