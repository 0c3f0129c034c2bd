// SPDX-License-Identifier: LGPL-2.1-or-later
// How far a polynomial surface is from a quadratic form over a rectangle of its parameters.
//
// With Q the quadratic form of the surface's mean second derivatives, A an affine one and S - Q - A
// within E by each coordinate, a flat facet with its corners on S is off S by what it is off for Q,
// and by 2 E at most: what interpolates S - Q - A at the corners is within E, too. The control
// points of S - Q - A bound E. A surface that waves a little has large second derivatives, and a
// small E.

#pragma once

#include <vector>

#include "core/forms/patch.h"
#include "core/math/interval.h"
#include "core/tessellation/charts/jet_enclosure.h"

namespace blossom {

/// A part of a surface: the net over a rectangle of the surface's own parameters.
struct PlacedNet {
  BezierPatch net;
  Interval u, v;
};

/// parts   one or more, that fill a rectangle
QuadraticRest quadratic_rest(const std::vector<PlacedNet>& parts);

}  // namespace blossom
