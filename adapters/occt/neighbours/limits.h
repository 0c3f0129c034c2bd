// SPDX-License-Identifier: LGPL-2.1-or-later
// What several proofs about neighbours decide in the same way.

#pragma once

namespace blossom::occt {

/// Halvings of a span of a wire to see whether it meets a rectangle. A choice: 2^-40 of a span is
/// below what its parameter is worth, and what is still open then counts as meeting.
inline constexpr int kMaxHalvings = 40;

}  // namespace blossom::occt
