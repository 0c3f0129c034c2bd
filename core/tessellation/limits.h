// SPDX-License-Identifier: LGPL-2.1-or-later
// Where borders and facets are divided no further.

#pragma once

namespace blossom {

/// Of a face's box in its chart: sides and facets that are no larger than this in both directions
/// are divided no further. A choice: far below what a deviation asks for, except beside poles and
/// tips, where facets of any size are alike in space.
inline constexpr double kSmallestPart = 1e-6;

}  // namespace blossom
