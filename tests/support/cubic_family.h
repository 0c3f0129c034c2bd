// SPDX-License-Identifier: LGPL-2.1-or-later
// Pairs of bicubic patches whose intersection is known in closed form.
//
// With c(x, y) a fixed cubic,
//   A(u, v) = (u, v, c(u, v) + h(u, v))
//   B(p, q) = the graph of c over a turned and enlarged square that covers A's
// meet exactly where h = 0, in A's own parameters. c and h have total degree at most 3.

#pragma once

#include <array>
#include <cmath>

#include "core/forms/surface.h"

namespace blossom::testing {

/// A polynomial in x, y of total degree at most 3: coefficient [i][j] belongs to x^i y^j.
struct Cubic {
  std::array<std::array<double, 4>, 4> coefficient{};

  double operator()(double x, double y) const {
    double sum = 0;
    for (std::size_t i = 4; i-- > 0;) {
      double row = 0;
      for (std::size_t j = 4; j-- > 0;) row = row * y + coefficient[i][j];
      sum = sum * x + row;
    }
    return sum;
  }

  friend Cubic operator+(Cubic a, const Cubic& b) {
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) a.coefficient[i][j] += b.coefficient[i][j];
    return a;
  }
  friend Cubic operator*(double s, Cubic a) {
    for (auto& row : a.coefficient)
      for (double& c : row) c *= s;
    return a;
  }
  friend Cubic operator*(const Cubic& a, const Cubic& b) {
    Cubic product;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t k = 0; i + k < 4; ++k)
          for (std::size_t l = 0; j + l < 4; ++l)
            product.coefficient[i + k][j + l] += a.coefficient[i][j] * b.coefficient[k][l];
    return product;
  }
};

/// k0 + kx x + ky y.
inline Cubic linear(double k0, double kx, double ky) {
  Cubic p;
  p.coefficient[0][0] = k0;
  p.coefficient[1][0] = kx;
  p.coefficient[0][1] = ky;
  return p;
}

inline Cubic constant(double k) { return linear(k, 0, 0); }

/// 0.3x^3 - 0.25xy^2 + 0.2xy - 0.15y^2 + 0.1x - 0.05y + 0.12x^2 y
inline Cubic base_cubic() {
  Cubic c;
  c.coefficient[3][0] = 0.3;
  c.coefficient[1][2] = -0.25;
  c.coefficient[1][1] = 0.2;
  c.coefficient[0][2] = -0.15;
  c.coefficient[1][0] = 0.1;
  c.coefficient[0][1] = -0.05;
  c.coefficient[2][1] = 0.12;
  return c;
}

/// The bicubic graph of z over the parallelogram origin + u e + v f, (u, v) in [0, 1]^2. The
/// control points come from interpolation, so the net is independent of the code under test.
inline BezierSurface graph(const Cubic& z, const std::array<double, 2>& origin,
                           const std::array<double, 2>& e, const std::array<double, 2>& f) {
  // Values at thirds to Bezier points of a cubic.
  constexpr double kInverse[4][4] = {
      {1, 0, 0, 0}, {-5.0 / 6, 3, -1.5, 1.0 / 3}, {1.0 / 3, -1.5, 3, -5.0 / 6}, {0, 0, 0, 1}};
  Grid<Vec4> values(4, 4), half(4, 4), net(4, 4);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const double u = i / 3.0, v = j / 3.0;
      const double x = origin[0] + u * e[0] + v * f[0], y = origin[1] + u * e[1] + v * f[1];
      values(i, j) = {x, y, z(x, y), 1};
    }
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < 4; ++k) half(i, j) += kInverse[i][k] * values(k, j);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      for (int k = 0; k < 4; ++k) net(i, j) += kInverse[j][k] * half(i, k);
      net(i, j)[3] = 1;
    }
  BezierSurface surface{{0, 1}, {0, 1}};
  surface.patches = Grid<RationalBezierPatch>(1, 1, RationalBezierPatch{net});
  return surface;
}

struct CubicPair {
  BezierSurface a;
  BezierSurface b;
};

/// The pair that meets where h = 0 over the unit square.
inline CubicPair cubic_pair(const Cubic& h, const Cubic& base = base_cubic()) {
  const double c = 1.6 * std::cos(0.4), s = 1.6 * std::sin(0.4);
  return {graph(base + h, {0, 0}, {1, 0}, {0, 1}),
          graph(base, {0.5 - 0.5 * (c - s), 0.5 - 0.5 * (s + c)}, {c, s}, {-s, c})};
}

/// scale ((x - a)^2 + (y - b)^2 - r^2): a loop of radius r, scale r^2 deep.
inline Cubic loop(double a, double b, double r, double scale = 1) {
  return scale * (linear(-a, 1, 0) * linear(-a, 1, 0) + linear(-b, 0, 1) * linear(-b, 0, 1) +
                  constant(-r * r));
}

/// (y - 0.57)^2 - (x - from) (x - to) (x - branch): an oval over [from, to] and a branch beside it.
inline Cubic oval(double from, double to, double branch) {
  const Cubic y = linear(-0.57, 0, 1);
  return y * y + -1.0 * (linear(-from, 1, 0) * linear(-to, 1, 0) * linear(-branch, 1, 0));
}

}  // namespace blossom::testing
