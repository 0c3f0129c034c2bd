// SPDX-License-Identifier: LGPL-2.1-or-later
// What the steps of smooth neighbours decide in the same way.

#pragma once

namespace blossom {

/// Of the largest coordinate: what rounding makes of the distance of two evaluated points, 16 unit
/// roundoffs. A choice: their bound (`evaluation_error`) is 22 at degree 3 and 58 at degree 9, if
/// all roundings fell out alike.
inline constexpr double kPointRounding = 0x1p-49;

}  // namespace blossom
