// SPDX-License-Identifier: LGPL-2.1-or-later
// The rivals in 512-bit vectors.
#include <cstring>

#include "tests/bench/subdivision_rivals.h"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)

#pragma GCC push_options
#pragma GCC target("avx512f,avx512dq,avx512vl,avx2,fma,prefer-vector-width=512")
namespace blossom::bench {
namespace {
typedef double Wide __attribute__((vector_size(64)));
}
#include "tests/bench/subdivision_rivals.inc"
Rivals rivals_avx512() { return {split_pieces, multiply_adds}; }
}  // namespace blossom::bench
#pragma GCC pop_options

#else

blossom::bench::Rivals blossom::bench::rivals_avx512() { return rivals_plain(); }

#endif
