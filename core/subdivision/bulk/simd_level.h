// SPDX-License-Identifier: LGPL-2.1-or-later
// The vector instructions that bulk subdivision may use, chosen at run time.

#pragma once

namespace blossom {

/// Avx2 and Avx512 use fused multiply-adds in one and the same order, so their results are the
/// same bit for bit. Plain rounds each product: its results differ from theirs within the stated
/// error bounds.
enum class SimdLevel { Plain, Avx2, Avx512 };

/// Whether this program, on this machine, has the level. Plain is always there.
bool is_available(SimdLevel level);

/// The widest level there is.
SimdLevel best_simd_level();

}  // namespace blossom
