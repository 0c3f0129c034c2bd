// SPDX-License-Identifier: LGPL-2.1-or-later
// What error bounds are counted in.

#pragma once

namespace blossom {

/// The largest relative error of one rounded operation, half the distance of 1 and the next double.
inline constexpr double kUnitRoundoff = 0x1p-53;

}  // namespace blossom
