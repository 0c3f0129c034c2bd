// SPDX-License-Identifier: LGPL-2.1-or-later
// How far beside a common edge two surfaces may meet.
//
// From a point of one surface a path leads in it to a common edge, then along the edge, and on into
// the other surface. Its steps across the edge are positive multiples of known directions, that
// along it is of either sign. Where some vector m is at an acute angle with all steps across, and
// nearly square to the edge, nothing of the path cancels out: if its ends are one point, it has no
// steps but those that jumps between borders, which agree only within a tolerance, make up for.
// That holds for faces at any angle but that of a closed fold, for smooth ones above all.

#pragma once

#include <span>

#include "core/cells/cell_tree.h"
#include "core/math/vec.h"

namespace blossom {

/// The factor K of a proof that |sum of steps| <= d means that both ends are no farther than K d
/// from the edge.
///
///   c = least cosine of m with a direction across,  s = largest one with a direction along the
///   edge p = least cosine of m with a direction across as seen along the edge K = (1 + s) / (p - s
///   / c) (1 + t / c),  t = tangent of the angle by which the edge turns
///
/// across    bounds of directions: each step is a positive multiple of a vector in the convex cone
///           of one of them
/// along     a step along the edge is a multiple, of either sign, of a vector in their convex cone
/// returns   infinity where nothing is proven: p c <= s, or something may be 0
///
/// Derivation: let A be the lengths of the steps across, seen along the edge, added up. They are no
/// longer than A / c, the step along no longer than d + A / c, so p A <= m . (steps across) <=
/// d + s (d + A / c). From where a step across ends on the edge its other end is no farther along
/// than A / c, where the edge is off its tangent by A t / c.
double path_reach(std::span<const VectorBounds> across, std::span<const Vec3> along);

}  // namespace blossom
