// SPDX-License-Identifier: LGPL-2.1-or-later
// What bulk subdivision is measured against: the printed sums, de Casteljau's algorithm, plain and
// vectorised, and the multiply-add peak of each vector width.

#pragma once

#include "core/forms/patch.h"
#include "core/subdivision/bulk/bulk.h"

namespace blossom::bench {

/// The Bezier points on a rectangle by formula (9) of Vlachkova 2025, sum by sum. For coefficients
/// with centre 0 and scale 1.
BezierPatch printed_points(const MonomialPatch& patch, const Interval& u, const Interval& v);

/// The net on a sub-rectangle by two splits in each direction, value by value.
void plain_de_casteljau(const NetShape& shape, const double* net, const Interval& u,
                        const Interval& v, double* out);

/// The same for kLanes pieces side by side, with the care of the bulk kernels: columns in
/// registers, degrees 3, 5 and 9 as constants, fused multiply-adds. Ends not 0.
using LaneRival = void (*)(const NetShape& shape, const double* net, const PieceEnds& ends,
                           double* out);

/// Runs `count` rounds of independent multiply-adds in registers; returns their number.
using Peak = long (*)(long rounds);

struct Rivals {
  LaneRival de_casteljau;
  Peak peak;
};

/// Those of an available level; Plain is not vectorised wider than the compiler's default.
Rivals rivals(SimdLevel level);
Rivals rivals_avx512();
Rivals rivals_avx2();
Rivals rivals_plain();

}  // namespace blossom::bench
