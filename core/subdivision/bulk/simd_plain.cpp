// SPDX-License-Identifier: LGPL-2.1-or-later
// The kernels for any processor: two lanes where the compiler has vector types, else one.
#include <algorithm>
#include <cstring>
#include <type_traits>

#include "core/math/binomial.h"
#include "core/math/interval.h"
#include "core/subdivision/bulk/detail/bulk_kernels.h"
#include "core/subdivision/bulk/detail/bulk_table.h"

namespace blossom::detail {
namespace {

struct Wide {
#if defined(__GNUC__)
  typedef double type __attribute__((vector_size(16)));
  static constexpr int kWidth = 2;
  BLOSSOM_PART static type all(double x) { return type{x, x}; }
  BLOSSOM_PART static type lane_numbers() { return type{0, 1}; }
#else
  using type = double;
  static constexpr int kWidth = 1;
  BLOSSOM_PART static type all(double x) { return x; }
  BLOSSOM_PART static type lane_numbers() { return 0; }
#endif
  static constexpr int kTileColumns = 2;

  BLOSSOM_PART static type load(const double* from) {
    type x;
    std::memcpy(&x, from, sizeof x);
    return x;
  }
  BLOSSOM_PART static void store(double* to, type x) { std::memcpy(to, &x, sizeof x); }
  BLOSSOM_PART static type fma(type a, type b, type c) { return a * b + c; }
};

}  // namespace

const BulkKernels& plain_kernels() { return kKernelsOf<Wide>; }

}  // namespace blossom::detail
