// SPDX-License-Identifier: LGPL-2.1-or-later
// Proof that the loops of a face bound it: none meets itself or another, and one runs round all.
//
// Loops are cut into pieces that go on in one direction, so that none of them meets itself. Two
// pieces that share no corner are halved until a line parts them. Two that do lie in cones that
// open from their ends at the corner; where these ends are a gap apart and the cones an angle, what
// they have in common is no farther off than the gap by the sine of the angle.

#pragma once

#include "core/topology/face_trims.h"

namespace blossom {

/// How loops lie to each other.
enum class Nesting {
  Sound,       ///< exactly one runs round all others, counter-clockwise; these run clockwise, none
               ///< within another
  HoleAstray,  ///< one runs counter-clockwise, but another one not within it, or within a third
  InDoubt      ///< also where no loop runs counter-clockwise, or several do
};

/// How the loops lie, if they are proven to pass no point twice but within the tolerances of the
/// vertices between their coedges. The straight ways over gaps between coedges are part of them.
///
/// What a vertex covers in the chart follows from the surface's derivatives, which are taken in
/// five places round it: that is by samples.
///
/// margin    chart coordinates: by more than it, and the largest gap, pieces that share no corner
///           are apart
/// returns   in doubt also where 1000 tests of two pieces for each span do not do
/// cost      about 50 ns for each two spans whose boxes meet, and 5 ns for all others; of spans
///           that run beside each other no more than those tests, some 0.3 ms for each span
Nesting nesting_of(const FaceTrims& trims, double margin);

}  // namespace blossom
