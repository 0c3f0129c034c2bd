// SPDX-License-Identifier: LGPL-2.1-or-later
// Thresholds of several sources of this room.

#pragma once

namespace blossom::occt {

/// Parts of a range of parameters that count as rounding: files write about ten digits of them.
inline constexpr double kRangeRounding = 1e-9;

}  // namespace blossom::occt
