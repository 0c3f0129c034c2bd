// SPDX-License-Identifier: LGPL-2.1-or-later
// Where a continuous function changes its sign.

#pragma once

#include <algorithm>
#include <cmath>

namespace blossom {

/// The ends of an interval, in either order.
struct SignChange {
  double below;  ///< the function is negative here
  double above;  ///< and not here
};

/// Narrows a change of sign until its ends are at most `width` apart. A step is the secant's, moved
/// towards the middle so that both ends follow, and no farther from it than leaves all steps one
/// more than by halving alone.
///
/// f_below, f_above   the function at the ends
///
/// Source: Oliveira, Takahashi 2020 (the ITP method), with their kappa_2 = 2 and n_0 = 1.
template <class Function>
SignChange narrowed(const Function& f, SignChange at, double f_below, double f_above,
                    double width) {
  const double whole = std::abs(at.above - at.below);
  const double truncation = 0.2 / whole;
  double widest = width;  // twice what a step may leave
  while (widest < 2 * whole) widest *= 2;
  for (double size = whole; size > width; size = std::abs(at.above - at.below)) {
    const double middle = 0.5 * (at.below + at.above);
    const double secant = at.below - f_below * ((at.above - at.below) / (f_above - f_below));
    const double inwards = secant < middle ? 1 : -1;
    const double off = std::abs(middle - secant) - truncation * size * size;
    // An end that is the zero itself must not hold up the other one.
    const double most = std::max(0.5 * (std::min(widest, 2 * size - width) - size), 0.0);
    const auto is_end = [&](double x) { return x == at.below || x == at.above; };
    double x = middle - inwards * std::clamp(off, 0.0, most);
    if (is_end(x)) x = middle;  // few doubles are left on this side; there may be many on the other
    if (is_end(x)) break;
    const double y = f(x);
    (y < 0 ? at.below : at.above) = x;
    (y < 0 ? f_below : f_above) = y;
    widest *= 0.5;
  }
  return at;
}

}  // namespace blossom
