// SPDX-License-Identifier: LGPL-2.1-or-later
// What several readers of the gap decide in the same way.

#pragma once

namespace blossom {

/// Pieces of the path of a contact, of even width in w. A choice: the path is polished later, and
/// its ends are exact already.
inline constexpr int kContactSteps = 4;

/// Of the tolerance: the most error of a gap that is called a contact. A choice: with it a contact
/// keeps three quarters of the tolerance for the gap itself.
inline constexpr double kErrorShare = 0.25;

/// Fraction of a patch: how far Newton's method may go from a point that is near the one sought. A
/// choice: farther off it is another one.
inline constexpr double kNewtonReach = 0.75;

}  // namespace blossom
