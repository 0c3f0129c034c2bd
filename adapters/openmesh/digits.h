// SPDX-License-Identifier: LGPL-2.1-or-later

#pragma once

namespace blossom::openmesh {

/// Decimal digits that give every float of a file back.
inline constexpr int kAllDigits = 9;

}  // namespace blossom::openmesh
