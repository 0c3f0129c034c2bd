// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves on two faces as cubic pieces with given values and first derivatives.

#pragma once

#include <vector>

#include "core/math/interval.h"
#include "core/results/result.h"

namespace blossom {

/// A point of a curve with its places on both surfaces, and how they change with the parameter.
struct HermiteJet {
  SurfacePoint value, rate;
};

/// The curve through jets at even steps of its parameter over a range, and its curves in both
/// charts. The samples are the jets' values; length, deviation and ends are not set.
/// jets   two or more
IntersectionCurve hermite_curve(const std::vector<HermiteJet>& jets, const Interval& range);

/// Makes deviations from both surfaces, and between them, no less than others.
void raise(Deviation& most, const Deviation& least);

}  // namespace blossom
