// SPDX-License-Identifier: LGPL-2.1-or-later
// How much larger errors of Bezier nets are for pieces that reach beyond the unit interval.

#pragma once

#include <algorithm>
#include <cmath>

#include "core/math/interval.h"

namespace blossom {

/// |1 - t| + |t|: the sum of the absolute weights of one step of de Casteljau.
inline double bezier_norm(double t) { return std::abs(1 - t) + std::abs(t); }

/// max over the ends t of (|1 - t| + |t|)^n: 1 inside [0, 1]. Outside, the errors of Bezier nets
/// are these times as large.
inline double bezier_growth(int degree, const Interval& piece) {
  const double norm = std::max(bezier_norm(piece.from), bezier_norm(piece.to));
  double growth = 1;
  for (int k = 0; k < degree; ++k) growth *= norm;
  return growth;
}

}  // namespace blossom
