// SPDX-License-Identifier: LGPL-2.1-or-later
// Where a function of one variable is extreme.

#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math/interval.h"

namespace blossom {

/// Two places between which a function is least, with its values there.
struct LeastBracket {
  Interval places;
  double at_from;
  double at_to;

  double place() const { return at_from < at_to ? places.from : places.to; }
  double value() const { return std::min(at_from, at_to); }
};

/// Narrows a range in which f bends upwards round its least value, by golden section: one value a
/// step, after two. The lesser value of the bracket is the least of all that were asked for.
///
/// is_done(range, bracket)   whether to stop; asked before every step. `range` is what is left; one
///                           of its ends may be a place where f was not asked for
template <class Function, class IsDone>
LeastBracket least_bracket(const Function& f, Interval range, const IsDone& is_done) {
  constexpr double kGolden = 2 - std::numbers::phi;
  LeastBracket b{{at(range, kGolden), at(range, 1 - kGolden)}, 0, 0};
  b.at_from = f(b.places.from), b.at_to = f(b.places.to);
  while (!is_done(range, b)) {
    if (b.at_from < b.at_to) {
      range.to = b.places.to;
      b.places.to = b.places.from, b.at_to = b.at_from;
      b.places.from = at(range, kGolden), b.at_from = f(b.places.from);
    } else {
      range.from = b.places.from;
      b.places.from = b.places.to, b.at_from = b.at_to;
      b.places.to = at(range, 1 - kGolden), b.at_to = f(b.places.to);
    }
  }
  return b;
}

/// An extreme value, and where it is.
struct ExtremePoint {
  double place;
  double value;
};

/// Where f is extreme in a range in which it bends to one side; where f is flat to rounding, it is
/// not told apart any more.
///
/// sign   1 for a least value, -1 for a largest
/// part   of the range: how far off the place may be, but no less than a few roundings
template <class Function>
ExtremePoint extremum(const Function& f, const Interval& range, double sign, double part) {
  const double ulp = 0x1p-52 * std::max(std::abs(range.from), std::abs(range.to));
  const double stop = std::max(part * std::abs(length(range)), 4 * ulp);
  const LeastBracket b = least_bracket(
      [&](double x) { return sign * f(x); }, range,
      [&](const Interval& left, const LeastBracket&) { return std::abs(length(left)) <= stop; });
  return {b.place(), sign * b.value()};
}

}  // namespace blossom
