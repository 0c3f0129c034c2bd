// SPDX-License-Identifier: LGPL-2.1-or-later
// Where a function of one variable is extreme.

#pragma once

#include <algorithm>
#include <cmath>

#include "core/math/interval.h"

namespace blossom {

/// Where f is extreme in a range in which it bends to one side, by golden section; where f is flat
/// to rounding, it is not told apart any more.
///
/// sign   1 for a least value, -1 for a largest
/// part   of the range: how far off the place may be, but no less than a few roundings
template <class Function>
double extremum(const Function& f, Interval range, double sign, double part) {
  constexpr double kGolden = 0.38196601125010515;
  const double ulp = 0x1p-52 * std::max(std::abs(range.from), std::abs(range.to));
  const double stop = std::max(part * length(range), 4 * ulp);
  double p = at(range, kGolden), q = at(range, 1 - kGolden);
  double fp = sign * f(p), fq = sign * f(q);
  while (length(range) > stop) {
    if (fp < fq) {
      range.to = q;
      q = p, fq = fp;
      p = at(range, kGolden), fp = sign * f(p);
    } else {
      range.from = p;
      p = q, fp = fq;
      q = at(range, 1 - kGolden), fq = sign * f(q);
    }
  }
  return fp < fq ? p : q;
}

}  // namespace blossom
