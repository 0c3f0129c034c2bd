// SPDX-License-Identifier: LGPL-2.1-or-later
// What several steps of a sheet decide in the same way.

#pragma once

namespace blossom::occt {

/// Tolerances: what meets at one place may be so far apart. A choice: each of some three curves
/// that end there keeps to its surfaces within one tolerance, and their ends are cut at small
/// angles.
inline constexpr double kSamePlace = 10;

}  // namespace blossom::occt
