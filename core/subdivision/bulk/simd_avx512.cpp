// SPDX-License-Identifier: LGPL-2.1-or-later
// The kernels in 512-bit vectors. Everything but the kernel templates is included before the
// instructions are switched on, so that no function shared with other files is compiled for them.
#include <algorithm>
#include <cstring>
#include <type_traits>

#include "core/math/binomial.h"
#include "core/math/interval.h"
#include "core/subdivision/bulk/detail/bulk_kernels.h"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)

#include <immintrin.h>

#pragma GCC push_options
#pragma GCC target("avx512f,avx512dq,avx512vl,avx2,fma,prefer-vector-width=512")
#include "core/subdivision/bulk/detail/bulk_table.h"

namespace blossom::detail {
namespace {

struct Wide {
  using type = __m512d;
  static constexpr int kWidth = 8;
  static constexpr int kTileColumns = 4;

  BLOSSOM_PART static type load(const double* from) { return _mm512_loadu_pd(from); }
  BLOSSOM_PART static void store(double* to, type x) { _mm512_storeu_pd(to, x); }
  BLOSSOM_PART static type all(double x) { return _mm512_set1_pd(x); }
  BLOSSOM_PART static type fma(type a, type b, type c) { return _mm512_fmadd_pd(a, b, c); }
  BLOSSOM_PART static type lane_numbers() { return _mm512_setr_pd(0, 1, 2, 3, 4, 5, 6, 7); }
};

}  // namespace

const BulkKernels* avx512_kernels() { return &kKernelsOf<Wide>; }

}  // namespace blossom::detail
#pragma GCC pop_options

#else

const blossom::detail::BulkKernels* blossom::detail::avx512_kernels() { return nullptr; }

#endif
