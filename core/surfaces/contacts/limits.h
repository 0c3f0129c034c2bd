// SPDX-License-Identifier: LGPL-2.1-or-later
// What several steps of the contacts decide in the same way. Parts of a patch are of its
// parameters, which run over [0, 1].

#pragma once

namespace blossom {

/// Of a patch: a place this near its border is on it. Newton's method leaves 1e-14, and 1e-8 at a
/// double root, where places are found by other means: a choice between the two.
inline constexpr double kOnBorder = 1e-9;

/// Of a patch: how far a contact point may move when it is polished. A choice: a cell in which a
/// contact is found is narrower, and the next contact of a chain lies farther off.
inline constexpr double kPolishReach = 0.02;

}  // namespace blossom
