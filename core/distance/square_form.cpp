// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/distance/square_form.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/base/unbounded.h"
#include "core/cells/net_ranges.h"
#include "core/math/binomial.h"

namespace blossom {
namespace {

// (2 n + 1) (2 m + 1) < 4 (n + 1) (m + 1)
constexpr std::size_t kMax = 4 * kMaxSquarePoints;

// N = f w^2 and W = w^2 as Bernstein forms of degrees n and m.
struct Squares {
  int n = 0, m = 0;
  std::array<double, kMax> numerator, weight;
  double error = 0;  // of a coefficient of N - c W, where f reaches c

  std::size_t index(int i, int j) const { return static_cast<std::size_t>(i * (m + 1) + j); }
};

// Each point is off by the margin and by roundings of the difference, 2 in a product; sums of at
// most 121 products round relative to the largest one.
double error_of_square(double farthest, double margin, double scale) {
  return 4 * farthest * (margin + 0x1p-50 * scale) + 0x1p-45 * farthest * farthest;
}

Squares squares_of(const Cell& cell, const NetShape& shape, const Centre& centre, double& farthest,
                   double& most_weight) {
  const int columns = shape.columns, size = shape.plane_size();
  const int n = shape.rows - 1, m = columns - 1;
  const auto weight = [&](int i) {
    return shape.planes == 4 ? cell.homogeneous[3 * size + i] : 1.0;
  };
  std::array<Vec3, kMaxSquarePoints> x;
  for (int i = 0; i < size; ++i) {
    Vec3& at = x[static_cast<std::size_t>(i)];
    at = Vec3{cell.homogeneous[i], cell.homogeneous[i + size], cell.homogeneous[i + 2 * size]} -
         weight(i) * centre.point;
    farthest = std::max(farthest, norm(at) / weight(i));
    most_weight = std::max(most_weight, weight(i));
    at -= dot(at, centre.axis) * centre.axis;
  }
  Squares f;
  f.n = 2 * n;
  f.m = 2 * m;
  for (int r = 0; r <= f.n; ++r)
    for (int c = 0; c <= f.m; ++c) {
      double square = 0, weights = 0;
      for (int i = std::max(0, r - n); i <= std::min(n, r); ++i)
        for (int j = std::max(0, c - m); j <= std::min(m, c); ++j) {
          const int a = i * columns + j, b = (r - i) * columns + (c - j);
          const double part =
              binomial(n, i) * binomial(n, r - i) * binomial(m, j) * binomial(m, c - j);
          square += part * dot(x[static_cast<std::size_t>(a)], x[static_cast<std::size_t>(b)]);
          weights += part * weight(a) * weight(b);
        }
      const double whole = binomial(f.n, r) * binomial(f.m, c);
      f.numerator[f.index(r, c)] = square / whole;
      f.weight[f.index(r, c)] = weights / whole;
    }
  return f;
}

// Coefficients of the derivatives of a form, raised to its own degrees:
//   i (a_i - a_(i-1)) + (n - i) (a_(i+1) - a_i)
struct Slopes {
  std::array<double, kMax> u, v;
};

Slopes slopes_of(const Squares& f, const std::array<double, kMax>& a) {
  Slopes s;
  for (int i = 0; i <= f.n; ++i)
    for (int j = 0; j <= f.m; ++j) {
      const double own = a[f.index(i, j)];
      double by_u = 0, by_v = 0;
      if (i > 0) by_u += i * (own - a[f.index(i - 1, j)]);
      if (i < f.n) by_u += (f.n - i) * (a[f.index(i + 1, j)] - own);
      if (j > 0) by_v += j * (own - a[f.index(i, j - 1)]);
      if (j < f.m) by_v += (f.m - j) * (a[f.index(i, j + 1)] - own);
      s.u[f.index(i, j)] = by_u;
      s.v[f.index(i, j)] = by_v;
    }
  return s;
}

// How much a form changes from one end of a direction to the other, summed over the other one.
double growth(const Squares& f, const std::array<double, kMax>& a, bool along_u) {
  double sum = 0;
  for (int k = 0; k <= (along_u ? f.m : f.n); ++k)
    sum += along_u ? a[f.index(f.n, k)] - a[f.index(0, k)] : a[f.index(k, f.m)] - a[f.index(k, 0)];
  return sum;
}

// With M = N - c W for a value c that f is within `reach` of, f_u W = M_u - (f - c) W_u. So f_u has
// one sign if M_u has it by more than |W_u| reach; so does f_u - k f_v.
class SlopeTest {
 public:
  SlopeTest(const Squares& f, double low, double high)
      : f_(f),
        reach_(0.5 * (high - low)),
        of_weight_(slopes_of(f, f.weight)),
        error_(2 * std::max(f.n, f.m) * f.error) {
    const double c = 0.5 * (low + high);
    std::array<double, kMax> rest;
    for (std::size_t i = 0; i <= f.index(f.n, f.m); ++i) rest[i] = f.numerator[i] - c * f.weight[i];
    of_rest_ = slopes_of(f, rest);
  }

  bool may_vanish(const std::array<bool, 2>& across) const {
    if (across[0] && has_sign(1, 0)) return false;
    if (across[1] && has_sign(0, 1)) return false;
    if (!across[0] || !across[1]) return true;
    const auto quotient = [](double a, double b) { return std::abs(b) > std::abs(a) ? a / b : 0; };
    const double by_v = quotient(growth(f_, of_rest_.u, false), growth(f_, of_rest_.v, false));
    const double by_u = quotient(growth(f_, of_rest_.v, true), growth(f_, of_rest_.u, true));
    return !(by_v != 0 && has_sign(1, -by_v)) && !(by_u != 0 && has_sign(-by_u, 1));
  }

 private:
  // Whether a f_u + b f_v has one sign.
  bool has_sign(double a, double b) const {
    const double margin = error_ * (std::abs(a) + std::abs(b));
    bool up = true, down = true;
    for (std::size_t i = 0; i <= f_.index(f_.n, f_.m) && (up || down); ++i) {
      const double slope = a * of_rest_.u[i] + b * of_rest_.v[i];
      const double spread = reach_ * std::abs(a * of_weight_.u[i] + b * of_weight_.v[i]) + margin;
      up = up && slope > spread;
      down = down && slope < -spread;
    }
    return up || down;
  }

  const Squares& f_;
  double reach_;
  Slopes of_weight_;
  Slopes of_rest_;
  double error_;
};

// Coefficients of degrees n and m as they enter products: times their binomials.
struct Scaled {
  int n, m;
  std::array<double, kMax> values;
};

Scaled scaled(const Squares& of, const std::array<double, kMax>& form) {
  Scaled result{of.n, of.m, {}};
  for (int i = 0; i <= of.n; ++i)
    for (int j = 0; j <= of.m; ++j)
      result.values[of.index(i, j)] = form[of.index(i, j)] * binomial(of.n, i) * binomial(of.m, j);
  return result;
}

// Coefficient (r, c) of a product, times its binomials.
double product_at(const Scaled& a, const Scaled& b, int r, int c) {
  double sum = 0;
  for (int i = std::max(0, r - a.n); i <= std::min(a.n, r); ++i)
    for (int j = std::max(0, c - a.m); j <= std::min(a.m, c); ++j)
      sum += a.values[static_cast<std::size_t>(i * (a.m + 1) + j)] *
             b.values[static_cast<std::size_t>((r - i) * (a.m + 1) + c - j)];
  return sum;
}

// Least and largest quotient of coefficients, widened.
Interval quotients(const Squares& of, const std::array<double, kMax>& form, double error) {
  Interval range{kInfinity, -kInfinity};
  for (std::size_t i = 0; i <= of.index(of.n, of.m); ++i) {
    range.from = std::min(range.from, form[i] / of.weight[i]);
    range.to = std::max(range.to, form[i] / of.weight[i]);
  }
  return {range.from - error, range.to + error};
}

// Least and largest value of (Q^2 - 4 R^2 P W) / W^2.
Interval torus_values(const Squares& q, const Squares& p, double radius) {
  const Scaled square = scaled(q, q.numerator), axial = scaled(p, p.numerator);
  const Scaled weight = scaled(p, p.weight);
  Interval range{kInfinity, -kInfinity};
  for (int r = 0; r <= 2 * q.n; ++r)
    for (int c = 0; c <= 2 * q.m; ++c) {
      const double g =
          product_at(square, square, r, c) - 4 * radius * radius * product_at(axial, weight, r, c);
      const double value = g / product_at(weight, weight, r, c);
      range.from = std::min(range.from, value);
      range.to = std::max(range.to, value);
    }
  return range;
}

double distance_from(const Vec3& point, const Centre& circle) {
  const Vec3 x = point - circle.point;
  const double height = dot(x, circle.axis);
  return std::hypot(norm(x - height * circle.axis) - circle.radius, height);
}

}  // namespace

SquareForm square_form(const Cell& cell, const NetShape& shape, const Centre& centre,
                       const std::array<bool, 2>& across) {
  double farthest = 0, most_weight = 0;
  Squares f = squares_of(cell, shape, centre, farthest, most_weight);
  const double error = error_of_square(farthest, cell.margin, max_norm(centre.point));
  // Sums of |N| and c |W|, and the rounding of a difference of them.
  f.error = 4 * error * most_weight * most_weight;
  std::array<double, kMax> ratio;
  double low = kInfinity, high = 0;
  for (std::size_t i = 0; i <= f.index(f.n, f.m); ++i) {
    ratio[i] = f.numerator[i] / f.weight[i];
    low = std::min(low, ratio[i]);
    high = std::max(high, ratio[i]);
  }
  const SecondDifferences bend = largest_second_differences(ratio.data(), f.n + 1, f.m + 1);
  SquareForm result{std::sqrt(std::max(0.0, low - error)) * (1 - 0x1p-50),
                    std::sqrt(high + error) * (1 + 0x1p-50), 0.25 * f.n * f.n * bend.uu,
                    0.25 * f.m * f.m * bend.vv};
  if (across[0] || across[1])
    result.may_be_stationary = SlopeTest(f, low - error, high + error).may_vanish(across);
  return result;
}

// Of |X|^2 + R^2 - r^2, rho^2 and g by their coefficients.
DistanceRange circle_distance(const Cell& cell, const NetShape& shape, const Centre& centre) {
  if (std::max(shape.rows, shape.columns) > kMaxCircleDegree + 1) return {0, kInfinity};
  const int size = shape.plane_size();
  const double radius = centre.radius;
  const double r = distance_from({cell.hull[0], cell.hull[size], cell.hull[2 * size]}, centre);
  double farthest = 0, most_weight = 0;
  Squares q = squares_of(cell, shape, {centre.point}, farthest, most_weight);
  const Squares p = squares_of(cell, shape, {centre.point, centre.axis}, farthest, most_weight);
  for (std::size_t i = 0; i <= q.index(q.n, q.m); ++i)
    q.numerator[i] += (radius * radius - r * r) * q.weight[i];
  const double most = farthest * farthest + radius * radius + r * r;
  const double error =
      error_of_square(farthest, cell.margin, max_norm(centre.point)) + 0x1p-50 * most;
  const Interval sum = quotients(q, q.numerator, error);
  const Interval rho = quotients(p, p.numerator, error);
  const double low = sum.from + 2 * radius * std::sqrt(std::max(0.0, rho.from));
  const double high = sum.to + 2 * radius * std::sqrt(std::max(0.0, rho.to));
  if (!(low > 0)) return {0, kInfinity};
  // Both squares are off by the error, of at most `most`; sums of 121 products.
  const double off = 6 * most * error + 0x1p-41 * most * most;
  Interval g = torus_values(q, p, radius);
  g = {g.from - off, g.to + off};
  const double nearest = r * r + g.from / (g.from < 0 ? low : high);
  const double outmost = r * r + g.to / (g.to > 0 ? low : high);
  return {std::sqrt(std::max(0.0, nearest)) * (1 - 0x1p-50),
          std::sqrt(std::max(0.0, outmost)) * (1 + 0x1p-50)};
}

}  // namespace blossom
