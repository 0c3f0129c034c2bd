// SPDX-License-Identifier: LGPL-2.1-or-later
// What sources of this room decide by.

#pragma once

namespace blossom::occt {

/// How near is on a vertex, an edge or a surface of the other shape, in tolerances: each of the two
/// may be off by one. What the intersection of faces tells apart, which is more than one tolerance,
/// is not to lie on each other.
inline constexpr double kLiesReach = 2;

/// The same for shapes that are worse than they state. A choice.
inline constexpr double kLooseReach = 10;

}  // namespace blossom::occt
