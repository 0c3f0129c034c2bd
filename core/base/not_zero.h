// SPDX-License-Identifier: LGPL-2.1-or-later

#pragma once

namespace blossom {

/// Added to a divisor or its least value, so that quotients of nothing are finite: smaller than any
/// size that means something, and its reciprocal is finite. In the unit of the divisor.
inline constexpr double kNotZero = 1e-300;

}  // namespace blossom
