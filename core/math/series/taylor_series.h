// SPDX-License-Identifier: LGPL-2.1-or-later
// Functions of two variables on [-1, 1]^2 as a polynomial of low total degree and a bound on the
// rest.
//
// A series f = sum c_ij x^i y^j is carried as its terms of total degree up to kTaylorDegree and
// as its majorant f^(z) = sum_k |f|_k z^k, where |f|_k is the sum of |c_ij| over i + j = k: the
// low coefficients of f^, and the values of f^ and its derivatives at z = 1. Products, sums and
// reciprocals of majorants bound those of the series, so what the truncation leaves out is
// bounded without interval arithmetic. Directions of derivatives have largest entry 1.

#pragma once

#include <array>

#include "core/math/functions/polynomial.h"
#include "core/math/vec.h"

namespace blossom {

inline constexpr int kTaylorDegree = 6;
inline constexpr int kTaylorTerms = (kTaylorDegree + 1) * (kTaylorDegree + 2) / 2;

/// Position of x^i y^j: by total degree, then by j.
constexpr std::size_t taylor_index(int i, int j) {
  return static_cast<std::size_t>((i + j) * (i + j + 1) / 2 + j);
}

/// A polynomial of total degree kTaylorDegree.
using TaylorPolynomial = std::array<double, kTaylorTerms>;

/// Not initialised unless by braces.
struct TaylorSeries {
  TaylorPolynomial terms;
  std::array<double, kTaylorDegree + 1> low;  ///< majorant coefficients up to kTaylorDegree
  std::array<double, 4> total;                ///< f^(1), f^'(1), f^''(1), f^'''(1)

  /// Bound on the d-th directional derivative, d = 0..3, of the terms left out.
  double tail(int d) const;
};

/// The series of sum c(i, j) x^i y^j; c holds rows x columns values, row-major.
TaylorSeries taylor_series(const double* c, int rows, int columns);

/// The polynomial as a series without a tail.
TaylorSeries taylor_series(const TaylorPolynomial& polynomial);

TaylorSeries operator+(TaylorSeries a, const TaylorSeries& b);
TaylorSeries operator-(TaylorSeries a, const TaylorSeries& b);
TaylorSeries operator*(double s, TaylorSeries a);
TaylorSeries operator*(const TaylorSeries& a, const TaylorSeries& b);

/// 1 / f. `exists` becomes false unless |f - f(0)| < |f(0)| is proven on the whole square.
TaylorSeries reciprocal(const TaylorSeries& f, bool& exists);

/// The powers x^i y^j, i + j <= kTaylorDegree, of the x, y without constant terms that solve
///
///   x + p(x, y) = u,   y + q(x, y) = v
///
/// up to total degree kTaylorDegree for p, q without constant and linear terms; such terms, and
/// the constant ones of u, v, are left aside. So with p = q = 0 the powers of u, v themselves.
class TaylorPowers {
 public:
  TaylorPowers(const TaylorPolynomial& u, const TaylorPolynomial& v, const TaylorPolynomial& p = {},
               const TaylorPolynomial& q = {});

  const TaylorSeries& x() const { return powers_[taylor_index(1, 0)]; }
  const TaylorSeries& y() const { return powers_[taylor_index(0, 1)]; }

  /// f(x, y) with its tail. Holds for |x|, |y| <= 1 on the whole square.
  TaylorSeries compose(const TaylorSeries& f) const;

 private:
  std::array<TaylorSeries, kTaylorTerms> powers_;  // terms and `low` from their own degree on
};

/// Value and partial derivatives.
double value(const TaylorPolynomial& p, double x, double y);
TaylorPolynomial derivative_x(const TaylorPolynomial& p);
TaylorPolynomial derivative_y(const TaylorPolynomial& p);

/// p(x, y) with (x, y) = s s_axis + t t_axis, as a polynomial in s, t.
TaylorPolynomial turned(const TaylorPolynomial& p, const Vec2& s_axis, const Vec2& t_axis);

/// p(x + by[0], y + by[1]), as a polynomial in x, y.
TaylorPolynomial moved(const TaylorPolynomial& p, const Vec2& by);

/// p(x, y) with (x, y) = begin + t step, as a polynomial in t.
Polynomial along_line(const TaylorPolynomial& p, const Vec2& begin, const Vec2& step);

/// p(x, y) at one x, as a polynomial in y.
Polynomial along_y(const TaylorPolynomial& p, double x);

/// Range of p over |x| <= rx, |y| <= ry, by its Bernstein coefficients.
struct TaylorRange {
  double low;
  double high;
};
TaylorRange range(const TaylorPolynomial& p, double rx, double ry);

/// The same on [-1, 1]^2, and no wider than what its quadratic part takes exactly and the size of
/// the rest: Bernstein coefficients know little of where a quadratic is least.
TaylorRange close_range(const TaylorPolynomial& p);

}  // namespace blossom
