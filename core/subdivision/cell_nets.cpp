// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/subdivision/cell_nets.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

#include "core/forms/curve.h"
#include "core/forms/function.h"
#include "core/math/binomial.h"
#include "core/math/four.h"

// A kernel takes the instructions and, where they are constants, the sizes of its caller.
#define BLOSSOM_KERNEL [[gnu::always_inline]] inline

namespace blossom {
namespace {

constexpr int kMaxSide = kMaxDegree + 1;
constexpr int kMaxPlane = kMaxSide * kMaxSide;
constexpr int kMaxProductPlane = (kMaxProductDegree + 1) * (kMaxProductDegree + 1);

using Matrix = std::array<std::array<double, kMaxSide>, kMaxSide>;

constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Entry (k, i): binom(i, k) 2^-i, the upper half of a re-centred cell cut in the middle. Exact.
constexpr Matrix kMiddle = [] {
  Matrix middle{};
  double power = 1;
  for (int i = 0; i < kMaxSide; ++i, power /= 2)
    for (int k = 0; k <= i; ++k) middle[at(k)][at(i)] = binomial(i, k) * power;
  return middle;
}();

// K(nu, i) of `bezier_from_monomial` for every degree. The integers before the division follow
// from (1 - x) g_(nu + 1) = (1 + x) g_nu.
constexpr std::array<Matrix, kMaxSide> kBezierFromMonomial = [] {
  std::array<Matrix, kMaxSide> tables{};
  for (int n = 0; n < kMaxSide; ++n) {
    Matrix& table = tables[at(n)];
    for (int i = 0; i <= n; ++i) table[0][at(i)] = (i % 2 == 0 ? 1 : -1) * binomial(n, i);
    for (int nu = 1; nu <= n; ++nu) {
      table[at(nu)][0] = 1;
      for (int i = 1; i <= n; ++i)
        table[at(nu)][at(i)] =
            table[at(nu)][at(i - 1)] + table[at(nu - 1)][at(i)] + table[at(nu - 1)][at(i - 1)];
    }
    for (int nu = 0; nu <= n; ++nu)
      for (int i = 0; i <= n; ++i) table[at(nu)][at(i)] /= binomial(n, i);
  }
  return tables;
}();

BLOSSOM_KERNEL void transpose(int rows, int columns, const double* from, double* to) {
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) to[j * rows + i] = from[i * columns + j];
}

// Operations along the rows of one plane; the inner loops run along contiguous memory.

// The triangular scheme: `high` goes in as the net and comes out as its upper half.
BLOSSOM_KERNEL void casteljau(int rows, int columns, double cut, double* __restrict high,
                              double* __restrict low) {
  const double rest = 1 - cut;
  for (int level = 1; level < rows; ++level) {
    for (int j = 0; j < columns; ++j) low[(level - 1) * columns + j] = high[j];
    for (int i = 0; i < rows - level; ++i) {
      double* row = high + i * columns;
      for (int j = 0; j < columns; ++j) row[j] = rest * row[j] + cut * row[j + columns];
    }
  }
  for (int j = 0; j < columns; ++j) low[(rows - 1) * columns + j] = high[j];
}

// The same for one column.
BLOSSOM_KERNEL void casteljau_line(int rows, double cut, double* __restrict high,
                                   double* __restrict low) {
  const double rest = 1 - cut;
  for (int level = 1; level < rows; ++level) {
    low[level - 1] = high[0];
    const int count = rows - level;
    int i = 0;
    for (; i + 4 <= count; i += 4) {
      Four here, next;
      std::memcpy(&here, high + i, sizeof here);
      std::memcpy(&next, high + i + 1, sizeof next);
      here = rest * here + cut * next;
      std::memcpy(high + i, &here, sizeof here);
    }
    for (; i < count; ++i) high[i] = rest * high[i] + cut * high[i + 1];
  }
  low[rows - 1] = high[0];
}

// c'_k of both halves for the cut in the middle: they differ in the signs of odd i - k alone.
BLOSSOM_KERNEL void middle_shift(int rows, int columns, const double* __restrict net,
                                 double* __restrict low, double* __restrict high) {
  for (int k = 0; k < rows; ++k) {
    double even[kMaxSide], odd[kMaxSide];
    for (int j = 0; j < columns; ++j) even[j] = kMiddle[at(k)][at(k)] * net[k * columns + j];
    for (int j = 0; j < columns; ++j) odd[j] = 0;
    for (int i = k + 1; i < rows; ++i) {
      double* sum = (i - k) % 2 == 0 ? even : odd;
      for (int j = 0; j < columns; ++j) sum[j] += kMiddle[at(k)][at(i)] * net[i * columns + j];
    }
    for (int j = 0; j < columns; ++j) low[k * columns + j] = even[j] - odd[j];
    for (int j = 0; j < columns; ++j) high[k * columns + j] = even[j] + odd[j];
  }
}

// c'_k = sum_i matrix(k, i) c_i with an upper triangular matrix.
BLOSSOM_KERNEL void upper_product(int rows, int columns, const Matrix& matrix,
                                  const double* __restrict net, double* __restrict out) {
  for (int k = 0; k < rows; ++k) {
    double sum[kMaxSide];
    for (int j = 0; j < columns; ++j) sum[j] = matrix[at(k)][at(k)] * net[k * columns + j];
    for (int i = k + 1; i < rows; ++i)
      for (int j = 0; j < columns; ++j) sum[j] += matrix[at(k)][at(i)] * net[i * columns + j];
    for (int j = 0; j < columns; ++j) out[k * columns + j] = sum[j];
  }
}

// binom(i, k) h^k m^(i - k), the substitution x = h y + m.
BLOSSOM_KERNEL void shift_matrix(int rows, double h, double m, Matrix& matrix) {
  std::array<double, kMaxSide> h_power, m_power;
  h_power[0] = m_power[0] = 1;
  for (int i = 1; i < rows; ++i) {
    h_power[at(i)] = h_power[at(i - 1)] * h;
    m_power[at(i)] = m_power[at(i - 1)] * m;
  }
  for (int k = 0; k < rows; ++k)
    for (int i = k; i < rows; ++i)
      matrix[at(k)][at(i)] = binomial(i, k) * (h_power[at(k)] * m_power[at(i - k)]);
}

BLOSSOM_KERNEL void shift(int rows, int columns, double cut, const double* __restrict net,
                          double* __restrict low, double* __restrict high) {
  if (cut == 0.5) return middle_shift(rows, columns, net, low, high);
  Matrix matrix;
  shift_matrix(rows, cut, cut - 1, matrix);
  upper_product(rows, columns, matrix, net, low);
  shift_matrix(rows, 1 - cut, cut, matrix);
  upper_product(rows, columns, matrix, net, high);
}

// w_nu and w_(n - nu) together: sum over even i plus and minus sum over odd i. In the middle of
// an even degree K vanishes for odd i.
BLOSSOM_KERNEL void to_bezier(int rows, int columns, const double* __restrict coefficients,
                              double* __restrict net) {
  const Matrix& kernel = kBezierFromMonomial[at(rows - 1)];
  for (int nu = 0; 2 * nu < rows; ++nu) {
    double even[kMaxSide], odd[kMaxSide];
    for (int j = 0; j < columns; ++j) even[j] = coefficients[j];
    for (int j = 0; j < columns; ++j) odd[j] = 0;
    for (int i = 1; i < rows; ++i) {
      double* sum = i % 2 == 0 ? even : odd;
      for (int j = 0; j < columns; ++j)
        sum[j] += kernel[at(nu)][at(i)] * coefficients[i * columns + j];
    }
    for (int j = 0; j < columns; ++j) net[nu * columns + j] = even[j] + odd[j];
    for (int j = 0; j < columns; ++j) net[(rows - 1 - nu) * columns + j] = even[j] - odd[j];
  }
}

// Row i of differences, then averaged down to one row. `net` is used up.
BLOSSOM_KERNEL void to_monomial(int rows, int columns, double* __restrict net,
                                double* __restrict coefficients) {
  double averages[kMaxPlane];
  double power = 1;
  for (int i = 0; i < rows; ++i, power /= 2) {
    const int left = rows - i;
    std::copy_n(net, left * columns, averages);
    for (int level = 1; level < left; ++level)
      for (int k = 0; k < (left - level) * columns; ++k)
        averages[k] = 0.5 * (averages[k] + averages[k + columns]);
    const double factor = binomial(rows - 1, i) * power;
    for (int j = 0; j < columns; ++j) coefficients[i * columns + j] = factor * averages[j];
    for (int k = 0; k < (left - 1) * columns; ++k) net[k] = net[k + columns] - net[k];
  }
}

// The operations on all planes. Along v a plane is transposed, so that the arithmetic is one.

BLOSSOM_KERNEL void bezier_u(int rows, int columns, int planes, const double* net, double cut,
                             double* low, double* high) {
  const int size = rows * columns;
  std::copy_n(net, size * planes, high);
  for (int k = 0; k < planes; ++k) {
    if (columns == 1)
      casteljau_line(rows, cut, high + k * size, low + k * size);
    else
      casteljau(rows, columns, cut, high + k * size, low + k * size);
  }
}

BLOSSOM_KERNEL void bezier_v(int rows, int columns, int planes, const double* net, double cut,
                             double* low, double* high) {
  const int size = rows * columns;
  double turned_low[kMaxProductPlane], turned_high[kMaxProductPlane];
  for (int k = 0; k < planes; ++k) {
    transpose(rows, columns, net + k * size, turned_high);
    casteljau(columns, rows, cut, turned_high, turned_low);
    transpose(columns, rows, turned_low, low + k * size);
    transpose(columns, rows, turned_high, high + k * size);
  }
}

BLOSSOM_KERNEL void monomial_u(int rows, int columns, int planes, const double* net, double cut,
                               double* low, double* high) {
  const int size = rows * columns;
  for (int k = 0; k < planes; ++k)
    shift(rows, columns, cut, net + k * size, low + k * size, high + k * size);
}

BLOSSOM_KERNEL void monomial_v(int rows, int columns, int planes, const double* net, double cut,
                               double* low, double* high) {
  const int size = rows * columns;
  double turned[kMaxPlane], turned_low[kMaxPlane], turned_high[kMaxPlane];
  for (int k = 0; k < planes; ++k) {
    transpose(rows, columns, net + k * size, turned);
    shift(columns, rows, cut, turned, turned_low, turned_high);
    transpose(columns, rows, turned_low, low + k * size);
    transpose(columns, rows, turned_high, high + k * size);
  }
}

BLOSSOM_KERNEL void all_to_bezier(int rows, int columns, int planes, const double* coefficients,
                                  double* net) {
  const int size = rows * columns;
  double half[kMaxPlane], turned[kMaxPlane];
  for (int k = 0; k < planes; ++k) {
    to_bezier(rows, columns, coefficients + k * size, half);
    transpose(rows, columns, half, turned);
    to_bezier(columns, rows, turned, half);
    transpose(columns, rows, half, net + k * size);
  }
}

BLOSSOM_KERNEL void all_to_monomial(int rows, int columns, int planes, const double* net,
                                    double* coefficients) {
  const int size = rows * columns;
  double work[kMaxPlane], half[kMaxPlane];
  for (int k = 0; k < planes; ++k) {
    std::copy_n(net + k * size, size, work);
    to_monomial(rows, columns, work, half);
    transpose(rows, columns, half, work);
    to_monomial(columns, rows, work, half);
    transpose(columns, rows, half, coefficients + k * size);
  }
}

}  // namespace

// Frequent sizes get a version of their own, in which the compiler knows them.
#define BLOSSOM_SIZE(r, c, work, ...) \
  if (shape.rows == (r) && shape.columns == (c)) return work(r, c, shape.planes, __VA_ARGS__)
#define BLOSSOM_FOR_SIZES(work, ...)     \
  BLOSSOM_SIZE(4, 4, work, __VA_ARGS__); \
  BLOSSOM_SIZE(3, 3, work, __VA_ARGS__); \
  BLOSSOM_SIZE(6, 6, work, __VA_ARGS__); \
  BLOSSOM_SIZE(2, 2, work, __VA_ARGS__); \
  BLOSSOM_SIZE(3, 2, work, __VA_ARGS__); \
  BLOSSOM_SIZE(2, 3, work, __VA_ARGS__); \
  return work(shape.rows, shape.columns, shape.planes, __VA_ARGS__)

BLOSSOM_HOT void halve_bezier_u(const NetShape& shape, const double* net, double cut, double* low,
                                double* high) {
  if (shape.columns == 1) {  // curves
    BLOSSOM_SIZE(3, 1, bezier_u, net, cut, low, high);
    BLOSSOM_SIZE(4, 1, bezier_u, net, cut, low, high);
    BLOSSOM_SIZE(6, 1, bezier_u, net, cut, low, high);
    return bezier_u(shape.rows, 1, shape.planes, net, cut, low, high);
  }
  BLOSSOM_FOR_SIZES(bezier_u, net, cut, low, high);
}

BLOSSOM_HOT void halve_bezier_v(const NetShape& shape, const double* net, double cut, double* low,
                                double* high) {
  BLOSSOM_FOR_SIZES(bezier_v, net, cut, low, high);
}

BLOSSOM_HOT void halve_monomial_u(const NetShape& shape, const double* coefficients, double cut,
                                  double* low, double* high) {
  BLOSSOM_FOR_SIZES(monomial_u, coefficients, cut, low, high);
}

BLOSSOM_HOT void halve_monomial_v(const NetShape& shape, const double* coefficients, double cut,
                                  double* low, double* high) {
  BLOSSOM_FOR_SIZES(monomial_v, coefficients, cut, low, high);
}

BLOSSOM_HOT void bezier_from_monomial(const NetShape& shape, const double* coefficients,
                                      double* net) {
  BLOSSOM_FOR_SIZES(all_to_bezier, coefficients, net);
}

BLOSSOM_HOT void monomial_from_bezier(const NetShape& shape, const double* net,
                                      double* coefficients) {
  BLOSSOM_FOR_SIZES(all_to_monomial, net, coefficients);
}

}  // namespace blossom
