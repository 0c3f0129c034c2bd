// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/balls/chart_cell.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace blossom {
namespace {

constexpr double kAway = 0.1;  // of the smaller span
// Jets of one function from two of its pieces, relative to the sizes of their derivatives by spans:
// splitting rounds some 10 n times, derivatives of degree 25 grow by 50 and 2400.
constexpr double kOnePiece = 1e-11;

const std::vector<double>& knots_of(const BezierSurface& surface, int direction) {
  return direction == 0 ? surface.u_knots : surface.v_knots;
}

bool is_closed(const BezierSurface& surface, int direction) {
  return direction == 0 ? surface.closed_u : surface.closed_v;
}

double size_of(const Vec3& a, const Vec3& b) { return std::max(max_norm(a), max_norm(b)); }

}  // namespace

ChartCell cell_at(const BezierSurface& surface, const Vec2& uv) {
  ChartCell cell;
  for (int k = 0; k < 2; ++k) {
    const std::vector<double>& knots = knots_of(surface, k);
    double x = uv[k];
    if (is_closed(surface, k)) {
      const double period = knots.back() - knots.front();
      cell.shift[k] = period * std::floor((x - knots.front()) / period);
      x -= cell.shift[k];
    }
    const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, x);
    cell.span[static_cast<std::size_t>(k)] = static_cast<int>(above - knots.begin()) - 1;
  }
  return cell;
}

Interval range_of(const BezierSurface& surface, const ChartCell& cell, int direction) {
  const std::vector<double>& knots = knots_of(surface, direction);
  const auto i = static_cast<std::size_t>(cell.span[static_cast<std::size_t>(direction)]);
  return {knots[i] + cell.shift[direction], knots[i + 1] + cell.shift[direction]};
}

std::optional<ChartCell> cell_beside(const BezierSurface& surface, const ChartCell& cell,
                                     int direction, int step) {
  const std::vector<double>& knots = knots_of(surface, direction);
  const int spans = static_cast<int>(knots.size()) - 1;
  ChartCell next = cell;
  int& span = next.span[static_cast<std::size_t>(direction)];
  span += step;
  if (span >= 0 && span < spans) return next;
  if (!is_closed(surface, direction)) return std::nullopt;
  next.shift[direction] += step * (knots.back() - knots.front());
  span = span < 0 ? spans - 1 : 0;
  return next;
}

PatchJet chart_jet(const BezierSurface& surface, const ChartCell& cell, const Vec2& uv, int order) {
  const std::array<ParameterLaw, 2> laws{surface.u_law, surface.v_law};
  Vec2 t, d, dd;  // local parameters, and derivatives of own parameters by them
  for (int k = 0; k < 2; ++k) {
    const ParameterLaw law = laws[static_cast<std::size_t>(k)];
    const Interval span = range_of(surface, cell, k);
    t[k] = local_parameter(law, span, uv[k]);
    d[k] = 1 / parameter_derivative(law, span, t[k]);
    dd[k] = parameter_second_derivative(law, span, t[k]);
  }
  PatchJet jet = jet_at(surface.patches(cell.span[0], cell.span[1]), t[0], t[1], order);
  jet.u *= d[0];
  jet.v *= d[1];
  if (order < 2) return jet;
  // X_uu = (X_tt - u_tt X_u) / u_t^2.
  jet.uu = (jet.uu - dd[0] * jet.u) * (d[0] * d[0]);
  jet.uv *= d[0] * d[1];
  jet.vv = (jet.vv - dd[1] * jet.v) * (d[1] * d[1]);
  return jet;
}

bool are_one_piece(const BezierSurface& surface, const ChartCell& a, const ChartCell& b,
                   const Vec2& uv, int direction) {
  const double span =
      std::min(length(range_of(surface, a, direction)), length(range_of(surface, b, direction)));
  for (const double side : {-kAway, kAway}) {
    Vec2 beside = uv;
    beside[direction] += side * span;
    const PatchJet p = chart_jet(surface, a, beside, 2), q = chart_jet(surface, b, beside, 2);
    const Vec3 first_p = direction == 0 ? p.u : p.v, first_q = direction == 0 ? q.u : q.v;
    const Vec3 second_p = direction == 0 ? p.uu : p.vv, second_q = direction == 0 ? q.uu : q.vv;
    const double most =
        kOnePiece * std::max({size_of(p.point, q.point), span * size_of(first_p, first_q)});
    if (max_norm(p.point - q.point) > most || span * max_norm(first_p - first_q) > most ||
        span * span * max_norm(second_p - second_q) > 10 * most)
      return false;
  }
  return true;
}

}  // namespace blossom
