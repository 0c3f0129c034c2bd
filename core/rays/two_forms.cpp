// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/rays/two_forms.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/forms/curve.h"
#include "core/forms/function.h"
#include "core/math/roundoff.h"

namespace blossom {
namespace {

// Derivative by u or v: degree times the differences of neighbours.
ValueRange slope_u(const double* net, int rows, int columns) {
  const double degree = rows - 1;
  ValueRange range{net[columns] - net[0], net[columns] - net[0]};
  for (int i = 0; i < (rows - 1) * columns; ++i) {
    const double d = net[i + columns] - net[i];
    range.low = d < range.low ? d : range.low;
    range.high = d > range.high ? d : range.high;
  }
  return {degree * range.low, degree * range.high};
}

ValueRange slope_v(const double* net, int rows, int columns) {
  const double degree = columns - 1;
  ValueRange range{net[1] - net[0], net[1] - net[0]};
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j + 1 < columns; ++j) {
      const double d = net[i * columns + j + 1] - net[i * columns + j];
      range.low = d < range.low ? d : range.low;
      range.high = d > range.high ? d : range.high;
    }
  return {degree * range.low, degree * range.high};
}

double middle(const ValueRange& range) { return 0.5 * (range.low + range.high); }
double radius(const ValueRange& range) { return 0.5 * (range.high - range.low); }

// Bernstein polynomials of a degree at t.
void bernstein(int degree, double t, double* b) {
  b[0] = 1;
  for (int k = 1; k <= degree; ++k) {
    double carried = 0;
    for (int i = 0; i < k; ++i) {
      const double value = b[i];
      b[i] = carried + (1 - t) * value;
      carried = t * value;
    }
    b[k] = carried;
  }
}

// (I - E)^-1 r for a contraction E: bounds the distance of a root from a point with value r.
Vec2 root_distance(const Matrix2& e, const Vec2& r) {
  const double a = 1 - e[0][0], d = 1 - e[1][1];
  const double determinant = a * d - e[0][1] * e[1][0];
  return Vec2{d * r[0] + e[0][1] * r[1], e[1][0] * r[0] + a * r[1]} * (1 / determinant);
}

}  // namespace

ValueRange range_of(const double* values, int count) {
  ValueRange range{values[0], values[0]};
  for (int i = 1; i < count; ++i) {
    range.low = values[i] < range.low ? values[i] : range.low;
    range.high = values[i] > range.high ? values[i] : range.high;
  }
  return range;
}

bool is_contraction(const Matrix2& e) {
  constexpr double kLimit = 1 - 1e-9;  // leaves room for the roundings of these four numbers
  return e[0][0] < kLimit && e[1][1] < kLimit &&
         e[0][1] * e[1][0] < kLimit * (1 - e[0][0]) * (1 - e[1][1]);
}

// From p a root x has x - p = -G(p) to within E |x - p|; that must not lead out of the region.
bool leads_outside(const Matrix2& e, const Vec2& offset, const Vec2& rounding,
                   const Vec2& outside) {
  constexpr double kRoundingOfDrift =
      1e-9;  // part of the drift: many times what few products round
  Vec2 size;
  for (int k = 0; k < 2; ++k) size[k] = std::abs(offset[k]) + rounding[k];
  const Vec2 reach = root_distance(e, size);
  for (std::size_t i = 0; i < 2; ++i) {
    const int k = static_cast<int>(i);
    const double drift = e[i][0] * reach[0] + e[i][1] * reach[1];
    if (-offset[k] * outside[k] > (drift + rounding[k]) * (1 + kRoundingOfDrift)) return true;
  }
  return false;
}

TwoForms two_forms(const NetShape& shape, const double* net, double margin) {
  const int rows = shape.rows, columns = shape.columns;
  const double* const second = net + rows * columns;
  TwoForms forms;
  forms.f = range_of(net, rows * columns);
  forms.g = range_of(second, rows * columns);
  forms.slopes = {{{slope_u(net, rows, columns), slope_v(net, rows, columns)},
                   {slope_u(second, rows, columns), slope_v(second, rows, columns)}}};
  Matrix2 m;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) m[i][j] = middle(forms.slopes[i][j]);
  const double per_area = 1 / (m[0][0] * m[1][1] - m[0][1] * m[1][0]);
  if (!std::isfinite(per_area)) return forms;
  forms.regular = true;
  const Matrix2& c = forms.inverse = {
      {{m[1][1] * per_area, -m[0][1] * per_area}, {-m[1][0] * per_area, m[0][0] * per_area}}};
  const int degree = std::max(rows, columns) - 1;
  const double size = std::max(largest_of(forms.f), largest_of(forms.g));
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j)
      for (std::size_t l = 0; l < 2; ++l)
        forms.spread[i][j] +=
            std::abs(c[i][l]) * (radius(forms.slopes[l][j]) + 2 * degree * margin +
                                 8 * kUnitRoundoff * std::abs(m[l][j]));
    forms.rounding[static_cast<int>(i)] = 2 * (std::abs(c[i][0]) + std::abs(c[i][1])) *
                                          (margin + (8 * degree + 8) * kUnitRoundoff * size);
  }
  return forms;
}

Vec2 values_at(const NetShape& shape, const double* net, double s, double t) {
  std::array<double, kMaxProductDegree + 1> in_u, in_v;
  bernstein(shape.rows - 1, s, in_u.data());
  bernstein(shape.columns - 1, t, in_v.data());
  Vec2 value;
  for (int k = 0; k < 2; ++k)
    for (int i = 0; i < shape.rows; ++i) {
      double row = 0;
      for (int j = 0; j < shape.columns; ++j)
        row += in_v[static_cast<std::size_t>(j)] * net[(k * shape.rows + i) * shape.columns + j];
      value[k] += in_u[static_cast<std::size_t>(i)] * row;
    }
  return value;
}

}  // namespace blossom
