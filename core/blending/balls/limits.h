// SPDX-License-Identifier: LGPL-2.1-or-later
// Thresholds of several sources of this room.

#pragma once

namespace blossom {

/// Parameters beyond the end of a range by less than this part of it are at the end: what is
/// computed from surfaces of ten digits is off by rounding of that size.
inline constexpr double kRangeSlack = 1e-9;

}  // namespace blossom
