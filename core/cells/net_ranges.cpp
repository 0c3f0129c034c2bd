// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/cells/net_ranges.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "core/base/unbounded.h"
#include "core/forms/curve.h"
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

[[gnu::always_inline]] inline void include(const Four& d, Ranges& ranges) {
  ranges.low = d < ranges.low ? d : ranges.low;
  ranges.high = d > ranges.high ? d : ranges.high;
}

// The values p[i + at[0]] w[0] + p[i + at[1]] w[1] + ... for i below count, for the weights of a
// first or second difference. The last four overlap the ones before.
template <int kTerms>
[[gnu::always_inline]] inline void include(const double* p, int count, const int (&at)[kTerms],
                                           const double (&w)[kTerms], Ranges& ranges) {
  if (count < 4) {
    for (int i = 0; i < count; ++i) {
      double sum = 0;
      for (int k = 0; k < kTerms; ++k) sum += w[k] * p[i + at[k]];
      include(Four{sum, sum, sum, sum}, ranges);
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
    include(sum, ranges);
  }
}

// The same for nets of 4 x 4 points, by far the most frequent: a row is a vector.
[[gnu::always_inline]] inline void include_rows(const double* plane, Ranges& v) {
  for (int i = 0; i < 4; ++i) {
    Four x;
    std::memcpy(&x, plane + 4 * i, sizeof x);
    include(__builtin_shufflevector(x, x, 1, 2, 3, 3) - __builtin_shufflevector(x, x, 0, 1, 2, 2),
            v);
  }
}

[[gnu::always_inline]] inline void include_rows(const double* plane, Ranges& uu, Ranges& uv,
                                                Ranges& vv) {
  Four row[4];
  std::memcpy(row, plane, sizeof row);
  for (int i = 0; i < 2; ++i) include(row[i] - 2 * row[i + 1] + row[i + 2], uu);
  for (int i = 0; i < 4; ++i) {
    const Four x = row[i];
    include(__builtin_shufflevector(x, x, 0, 1, 0, 1) -
                2 * __builtin_shufflevector(x, x, 1, 2, 1, 2) +
                __builtin_shufflevector(x, x, 2, 3, 2, 3),
            vv);
  }
  for (int i = 0; i < 3; ++i) {
    const Four x = row[i], y = row[i + 1];
    include(__builtin_shufflevector(x, x, 0, 1, 2, 2) - __builtin_shufflevector(x, x, 1, 2, 3, 3) -
                __builtin_shufflevector(y, y, 0, 1, 2, 2) +
                __builtin_shufflevector(y, y, 1, 2, 3, 3),
            uv);
  }
}

// Bernstein coefficient number i, by this degree, of x and of x^2 for x in [-1/2, 1/2].
double first_power(int i, int degree) { return static_cast<double>(i) / degree - 0.5; }

double second_power(int i, int degree) {
  const double square = degree > 1 ? i * (i - 1.0) / (degree * (degree - 1.0)) : 0;
  return square - static_cast<double>(i) / degree + 0.25;
}

double largest(const Range& range) { return std::max(-range.low, range.high); }

}  // namespace

BLOSSOM_HOT Range value_range(const double* values, int count) {
  Ranges ranges(values[0]);
  include(values, count, {0}, {1}, ranges);
  return ranges.joined();
}

BLOSSOM_HOT Range height_range(const double* points, int count, const Vec3& normal) {
  Ranges ranges(normal[0] * points[0] + normal[1] * points[count] + normal[2] * points[2 * count]);
  include(points, count, {0, count, 2 * count}, {normal[0], normal[1], normal[2]}, ranges);
  return ranges.joined();
}

BLOSSOM_HOT Range height_range(const double* points, int rows, int columns, const Vec3& normal,
                               const Quadratic& less) {
  std::array<double, kMaxDegree + 1> y, only_y;  // by columns: y, and what does not go with x
  for (int j = 0; j < columns; ++j) {
    const auto at = static_cast<std::size_t>(j);
    y[at] = first_power(j, columns - 1);
    only_y[at] = less.constant + less.y * y[at] + less.yy * second_power(j, columns - 1);
  }
  const int size = rows * columns;
  const auto rest = [&](int row, int column, double by_x, double x) {
    const double* p = points + row * columns + column;
    const auto at = static_cast<std::size_t>(column);
    return normal[0] * p[0] + normal[1] * p[size] + normal[2] * p[2 * size] -
           (only_y[at] + by_x + less.xy * x * y[at]);
  };
  Range all{kUnbounded, -kUnbounded};
  for (int i = 0; i < rows; ++i) {
    const double x = first_power(i, rows - 1);
    const double by_x = less.x * x + less.xx * second_power(i, rows - 1);
    for (int j = 0; j < columns; ++j) {
      const double h = rest(i, j, by_x, x);
      all = {std::min(all.low, h), std::max(all.high, h)};
    }
  }
  return all;
}

BLOSSOM_HOT Range difference_range_u(const double* plane, int rows, int columns) {
  Ranges ranges(plane[columns] - plane[0]);
  include(plane, (rows - 1) * columns, {0, columns}, {-1, 1}, ranges);
  return ranges.joined();
}

BLOSSOM_HOT Range difference_range_v(const double* plane, int rows, int columns) {
  Ranges ranges(plane[1] - plane[0]);
  if (rows == 4 && columns == 4) {
    include_rows(plane, ranges);
    return ranges.joined();
  }
  for (int i = 0; i < rows; ++i) include(plane + i * columns, columns - 1, {0, 1}, {-1, 1}, ranges);
  return ranges.joined();
}

BLOSSOM_HOT SecondRanges second_difference_ranges(const double* plane, int rows, int columns) {
  const double* p = plane;
  Ranges uu(rows > 2 ? p[0] - 2 * p[columns] + p[2 * columns] : 0);
  Ranges uv(p[0] - p[1] - p[columns] + p[columns + 1]);
  Ranges vv(columns > 2 ? p[0] - 2 * p[1] + p[2] : 0);
  if (rows == 4 && columns == 4) {
    include_rows(plane, uu, uv, vv);
    return {uu.joined(), uv.joined(), vv.joined()};
  }
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
