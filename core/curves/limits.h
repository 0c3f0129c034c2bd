// SPDX-License-Identifier: LGPL-2.1-or-later
// What several searches of curves decide in the same way.

#pragma once

namespace blossom {

/// Of a span's parameter: a place this far outside of a cell is on its border. Four operations
/// round a parameter below 1 by less than 5e-16; a choice of some twenty times that, since both
/// cells may claim a place, and only one of them has to.
inline constexpr double kParameterSlack = 1e-14;

/// Likewise of a place on a surface, which three equations in three unknowns give: their condition
/// takes another digit.
inline constexpr double kSurfaceParameterSlack = 1e-13;

/// How far outside of its cells, in their lengths, Newton's method may go on. A choice that decides
/// only how soon it gives up: a place that is found counts where it lies.
inline constexpr double kNewtonReach = 0.5;

/// Of parameters: steps below this that shrink no more are rounding, as where curves are nearly
/// parallel. A choice between what rounding leaves of a simple root, 1e-16, and of a double one,
/// 1e-8.
inline constexpr double kNewtonStalled = 1e-12;

/// Of Newton's method for a foot that starts beside it: it squares, from 1e-1 to 1e-16 in 4, and
/// halves where derivatives vanish. A choice that decides only when it gives up.
inline constexpr int kFootSteps = 12;

}  // namespace blossom
