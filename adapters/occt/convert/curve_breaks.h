// SPDX-License-Identifier: LGPL-2.1-or-later
// Where curves of Open CASCADE are less than smooth.

#pragma once

#include <vector>

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>

#include "core/math/interval.h"

namespace blossom::occt {

/// The parameters inside of a range, increasing, between which a curve is smooth: the knots of a
/// B-spline, of other curves what Open CASCADE's adaptors say. Those see no knot of a periodic
/// B-spline if the range is longer than its period by rounding.
std::vector<double> breaks_of(const Handle(Geom_Curve) & curve, const Interval& range);
std::vector<double> breaks_of(const Handle(Geom2d_Curve) & curve, const Interval& range);

}  // namespace blossom::occt
