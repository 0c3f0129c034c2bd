// SPDX-License-Identifier: LGPL-2.1-or-later
// The rivals in 256-bit vectors.
#include <cstring>

#include "tests/bench/subdivision_rivals.h"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)

#pragma GCC push_options
#pragma GCC target("avx2,fma")
namespace blossom::bench {
namespace {
typedef double Wide __attribute__((vector_size(32)));
}
#include "tests/bench/subdivision_rivals.inc"
Rivals rivals_avx2() { return {split_pieces, multiply_adds}; }
}  // namespace blossom::bench
#pragma GCC pop_options

#else

blossom::bench::Rivals blossom::bench::rivals_avx2() { return rivals_plain(); }

#endif
