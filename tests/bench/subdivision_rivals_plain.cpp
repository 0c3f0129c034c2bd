// SPDX-License-Identifier: LGPL-2.1-or-later
// The rivals without wide vectors, and the choice among the widths.
#include <algorithm>
#include <cstring>

#include "core/forms/curve.h"
#include "tests/bench/subdivision_rivals.h"

namespace blossom::bench {
namespace {
typedef double Wide __attribute__((vector_size(16)));
}
#include "tests/bench/subdivision_rivals.inc"

namespace {

// Points 0, step, 2 step .. of a column, in place.
void split_values(int degree, const Interval& piece, double* values, int step) {
  for (int r = 1; r <= degree; ++r)
    for (int i = degree; i >= r; --i)
      values[i * step] = (1 - piece.to) * values[(i - 1) * step] + piece.to * values[i * step];
  const double t = piece.from / piece.to;
  for (int r = 1; r <= degree; ++r)
    for (int i = 0; i <= degree - r; ++i)
      values[i * step] = (1 - t) * values[i * step] + t * values[(i + 1) * step];
}

}  // namespace

void plain_de_casteljau(const NetShape& shape, const double* net, const Interval& u,
                        const Interval& v, double* out) {
  std::copy_n(net, shape.size(), out);
  for (int plane = 0; plane < shape.planes; ++plane, out += shape.plane_size()) {
    for (int i = 0; i < shape.rows; ++i)
      split_values(shape.columns - 1, v, out + i * shape.columns, 1);
    for (int j = 0; j < shape.columns; ++j) split_values(shape.rows - 1, u, out + j, shape.columns);
  }
}

Rivals rivals_plain() { return {split_pieces, multiply_adds}; }

Rivals rivals(SimdLevel level) {
  switch (level) {
    case SimdLevel::Avx512: return rivals_avx512();
    case SimdLevel::Avx2: return rivals_avx2();
    case SimdLevel::Plain: break;
  }
  return rivals_plain();
}

}  // namespace blossom::bench
