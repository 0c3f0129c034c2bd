// SPDX-License-Identifier: LGPL-2.1-or-later
// What several proofs about neighbours decide in the same way.

#pragma once

namespace blossom {

/// Halvings of a span of a wire to see whether it meets a rectangle. A choice: 2^-40 of a span is
/// below what its parameter is worth, and what is still open then counts as meeting.
inline constexpr int kMaxHalvings = 40;

/// Of the smaller face's size: so near a common edge, faces that go on nearly in one direction are
/// one. A choice: at an angle of a degree, borders that are a tolerance of 1e-7 apart make surfaces
/// of size 1 cross 6e-6 beside the edge, and at an angle of 5e-5 as far as this.
inline constexpr double kEdgeStrip = 2e-3;

}  // namespace blossom
