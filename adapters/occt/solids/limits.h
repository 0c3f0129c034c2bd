// SPDX-License-Identifier: LGPL-2.1-or-later
// What several steps of two solids decide in the same way.

#pragma once

namespace blossom::occt {

/// Rays that have to agree about where a point lies. A choice: one that grazes an edge may count a
/// crossing wrongly, and that two more do so in the same sense is not seen.
inline constexpr int kAgreeing = 3;

}  // namespace blossom::occt
