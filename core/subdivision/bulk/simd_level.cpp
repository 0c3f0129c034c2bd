// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/subdivision/bulk/simd_level.h"

#include "core/subdivision/bulk/detail/bulk_kernels.h"

namespace blossom {
namespace {

bool has_instructions(SimdLevel level) {
#if defined(__x86_64__) && defined(__GNUC__)
  if (level == SimdLevel::Avx512)
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("fma");
  if (level == SimdLevel::Avx2)
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#endif
  return level == SimdLevel::Plain;
}

const detail::BulkKernels* kernels_if_built(SimdLevel level) {
  switch (level) {
    case SimdLevel::Avx512: return detail::avx512_kernels();
    case SimdLevel::Avx2: return detail::avx2_kernels();
    case SimdLevel::Plain: break;
  }
  return &detail::plain_kernels();
}

}  // namespace

bool is_available(SimdLevel level) {
  return has_instructions(level) && kernels_if_built(level) != nullptr;
}

SimdLevel best_simd_level() {
  static const SimdLevel best = is_available(SimdLevel::Avx512) ? SimdLevel::Avx512
                                : is_available(SimdLevel::Avx2) ? SimdLevel::Avx2
                                                                : SimdLevel::Plain;
  return best;
}

const detail::BulkKernels& detail::kernels(SimdLevel level) { return *kernels_if_built(level); }

}  // namespace blossom
