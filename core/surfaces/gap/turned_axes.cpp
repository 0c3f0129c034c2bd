// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/gap/turned_axes.h"

#include <algorithm>
#include <cmath>

#include "core/base/unbounded.h"

namespace blossom {

TurnedAxes::TurnedAxes(const Vec2& direction)
    : z_axis(unit(direction)), reach(std::abs(z_axis[0]) + std::abs(z_axis[1])) {
  w_axis = {z_axis[1], -z_axis[0]};
}

TaylorPolynomial TurnedAxes::turned(const TaylorPolynomial& p) const {
  return blossom::turned(p, w_axis, z_axis);
}

Vec2 TurnedAxes::on_edge(int edge, double t) const {
  const double end = edge % 2 == 0 ? -1 : 1;
  const Vec2 xy = edge < 2 ? Vec2{end, t} : Vec2{t, end};
  return {dot(w_axis, xy), dot(z_axis, xy)};
}

Polynomial TurnedAxes::along_edge(const TaylorPolynomial& p, int edge) const {
  const Vec2 middle = on_edge(edge, 0), end = on_edge(edge, 1);
  return along_line(p, middle, end - middle);
}

double TurnedAxes::chord_end(double w, int side) const {
  constexpr double kAlongChord = 1e-9;  // radians: a side so nearly along the chord does not end it
  constexpr double kBeyondChord = 0.02;  // part of half a cell: neighbours overlap by so much
  double end = kUnbounded;
  for (int k = 0; k < 2; ++k) {
    const double rate = side == 0 ? -z_axis[k] : z_axis[k];
    const double start = w_axis[k] * w;
    if (std::abs(rate) > kAlongChord) end = std::min(end, ((rate > 0 ? 1 : -1) - start) / rate);
  }
  end += kBeyondChord;
  return side == 0 ? -end : end;
}

}  // namespace blossom
