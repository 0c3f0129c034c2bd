// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/intersection/cells/net_ranges.h"

#include <algorithm>
#include <cstring>

#include "core/math/four.h"

namespace blossom {
namespace {

struct Ranges {
  Four low, high;

  explicit Ranges(double value) : low{value, value, value, value}, high(low) {}

  Range joined() const {
    return {std::min(std::min(low[0], low[1]), std::min(low[2], low[3])),
            std::max(std::max(high[0], high[1]), std::max(high[2], high[3]))};
  }
};

// The values p[i + at[0]] w[0] + p[i + at[1]] w[1] + ... for i below count, for the weights of a
// first or second difference. The last four overlap the ones before.
template <int kTerms>
[[gnu::always_inline]] inline void include(const double* p, int count, const int (&at)[kTerms],
                                           const double (&w)[kTerms], Ranges& ranges) {
  const auto add = [&](const Four& d) {
    ranges.low = d < ranges.low ? d : ranges.low;
    ranges.high = d > ranges.high ? d : ranges.high;
  };
  if (count < 4) {
    for (int i = 0; i < count; ++i) {
      double sum = 0;
      for (int k = 0; k < kTerms; ++k) sum += w[k] * p[i + at[k]];
      add(Four{sum, sum, sum, sum});
    }
    return;
  }
  for (int i = 0; i < count; i += 4) {
    const double* from = p + std::min(i, count - 4);
    Four sum{};
    for (int k = 0; k < kTerms; ++k) {
      Four x;
      std::memcpy(&x, from + at[k], sizeof x);
      sum += w[k] * x;
    }
    add(sum);
  }
}

double largest(const Range& range) { return std::max(-range.low, range.high); }

}  // namespace

BLOSSOM_HOT Range difference_range_u(const double* plane, int rows, int columns) {
  Ranges ranges(plane[columns] - plane[0]);
  include(plane, (rows - 1) * columns, {0, columns}, {-1, 1}, ranges);
  return ranges.joined();
}

BLOSSOM_HOT Range difference_range_v(const double* plane, int rows, int columns) {
  Ranges ranges(plane[1] - plane[0]);
  for (int i = 0; i < rows; ++i) include(plane + i * columns, columns - 1, {0, 1}, {-1, 1}, ranges);
  return ranges.joined();
}

BLOSSOM_HOT SecondRanges second_difference_ranges(const double* plane, int rows, int columns) {
  const double* p = plane;
  Ranges uu(rows > 2 ? p[0] - 2 * p[columns] + p[2 * columns] : 0);
  Ranges uv(p[0] - p[1] - p[columns] + p[columns + 1]);
  Ranges vv(columns > 2 ? p[0] - 2 * p[1] + p[2] : 0);
  include(plane, (rows - 2) * columns, {0, columns, 2 * columns}, {1, -2, 1}, uu);
  for (int i = 0; i < rows; ++i) {
    const double* row = plane + i * columns;
    include(row, columns - 2, {0, 1, 2}, {1, -2, 1}, vv);
    if (i + 1 < rows) include(row, columns - 1, {0, 1, columns, columns + 1}, {1, -1, -1, 1}, uv);
  }
  return {uu.joined(), uv.joined(), vv.joined()};
}

SecondDifferences largest_second_differences(const double* plane, int rows, int columns) {
  const SecondRanges ranges = second_difference_ranges(plane, rows, columns);
  return {largest(ranges.uu), largest(ranges.uv), largest(ranges.vv)};
}

}  // namespace blossom
