// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/regions/trimmed_chart.h"

#include <algorithm>
#include <cmath>

namespace blossom {

namespace {

double coordinate(const std::vector<double>& knots, ParameterLaw law, double parameter,
                  double near) {
  const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, parameter);
  const auto i = static_cast<std::size_t>(above - knots.begin()) - 1;
  const Interval span{knots[i], knots[i + 1]};
  const auto whole = static_cast<double>(i);
  if (std::abs(parameter - span.from) <= near) return whole;
  if (std::abs(parameter - span.to) <= near) return whole + 1;
  return whole + local_parameter(law, span, parameter);
}

}  // namespace

double grid_coordinate(const std::vector<double>& knots, ParameterLaw law, double parameter) {
  return coordinate(knots, law, parameter, kOnLine * (knots.back() - knots.front()));
}

double unrounded_grid_coordinate(const std::vector<double>& knots, ParameterLaw law,
                                 double parameter) {
  return coordinate(knots, law, parameter, 0);
}

Vec2 grid_point(const BezierSurface& surface, const Vec2& uv) {
  return {grid_coordinate(surface.u_knots, surface.u_law, uv[0]),
          grid_coordinate(surface.v_knots, surface.v_law, uv[1])};
}

Vec2 unrounded_grid_point(const BezierSurface& surface, const Vec2& uv) {
  return {unrounded_grid_coordinate(surface.u_knots, surface.u_law, uv[0]),
          unrounded_grid_coordinate(surface.v_knots, surface.v_law, uv[1])};
}

}  // namespace blossom
