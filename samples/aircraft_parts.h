// SPDX-License-Identifier: LGPL-2.1-or-later
// The geometry of the sample whose wing roots are rounded: a fuselage, turned about its axis, and
// two wings that reach into it. Millimetres; x runs aft, y to starboard, z up.

#pragma once

#include <TopoDS_Solid.hxx>

namespace blossom::samples {

/// A cubic B-spline turned about the axis x, with a flat end.
TopoDS_Solid fuselage();

/// From a root inside of the fuselage to a tip: the skin is ruled between two cubic B-splines of
/// one kind, round the leading edge from the upper side of a blunt trailing edge to the lower one.
/// side   1: starboard, -1: port
TopoDS_Solid wing(int side);

}  // namespace blossom::samples
