// SPDX-License-Identifier: LGPL-2.1-or-later
// Small vectors: points of curves and surfaces, in two, three or four coordinates.
//
// The scalar is double except where a formula also runs in exact arithmetic.

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace blossom {

template <class Scalar, int Dim>
struct Vec {
  using scalar_type = Scalar;
  static constexpr int kDimension = Dim;

  std::array<Scalar, Dim> coordinates{};

  constexpr Scalar& operator[](int i) { return coordinates[static_cast<std::size_t>(i)]; }
  constexpr const Scalar& operator[](int i) const {
    return coordinates[static_cast<std::size_t>(i)];
  }
  friend bool operator==(const Vec&, const Vec&) = default;

  Vec& operator+=(const Vec& b) {
    for (int i = 0; i < Dim; ++i) (*this)[i] += b[i];
    return *this;
  }
  Vec& operator-=(const Vec& b) {
    for (int i = 0; i < Dim; ++i) (*this)[i] -= b[i];
    return *this;
  }
  Vec& operator*=(const Scalar& s) {
    for (int i = 0; i < Dim; ++i) (*this)[i] *= s;
    return *this;
  }
  friend Vec operator+(Vec a, const Vec& b) { return a += b; }
  friend Vec operator-(Vec a, const Vec& b) { return a -= b; }
  friend Vec operator*(Vec a, const Scalar& s) { return a *= s; }
  friend Vec operator*(const Scalar& s, Vec a) { return a *= s; }
  friend Vec operator-(Vec a) {
    for (int i = 0; i < Dim; ++i) a[i] = -a[i];
    return a;
  }
};

using Vec2 = Vec<double, 2>;
using Vec3 = Vec<double, 3>;
/// Homogeneous point (wx, wy, wz, w).
using Vec4 = Vec<double, 4>;

inline Vec3 head(const Vec4& p) { return {p[0], p[1], p[2]}; }

/// The point in space of a homogeneous one; its weight must not be 0.
inline Vec3 projected(const Vec4& p) { return Vec3{p[0], p[1], p[2]} * (1 / p[3]); }

template <class Scalar, int Dim>
Scalar dot(const Vec<Scalar, Dim>& a, const Vec<Scalar, Dim>& b) {
  Scalar sum = a[0] * b[0];
  for (int i = 1; i < Dim; ++i) sum += a[i] * b[i];
  return sum;
}

template <class Scalar>
Vec<Scalar, 3> cross(const Vec<Scalar, 3>& a, const Vec<Scalar, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double cross(const Vec2& a, const Vec2& b) { return a[0] * b[1] - a[1] * b[0]; }

/// The last coordinate of the vector product.
inline double cross_z(const Vec3& a, const Vec3& b) { return a[0] * b[1] - a[1] * b[0]; }

template <int Dim>
double norm(const Vec<double, Dim>& a) {
  return std::sqrt(dot(a, a));
}

template <int Dim>
double distance(const Vec<double, Dim>& a, const Vec<double, Dim>& b) {
  return norm(a - b);
}

/// In [0, pi].
inline double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

inline bool is_finite(const Vec3& v) {
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

/// The absolute values of the coordinates.
template <int Dim>
Vec<double, Dim> absolute(Vec<double, Dim> a) {
  for (double& x : a.coordinates) x = std::abs(x);
  return a;
}

/// Largest absolute coordinate.
template <int Dim>
double max_norm(const Vec<double, Dim>& a) {
  double largest = 0;
  for (int i = 0; i < Dim; ++i) largest = std::max(largest, std::abs(a[i]));
  return largest;
}

/// The direction of `a`; the zero vector stays zero.
template <int Dim>
Vec<double, Dim> unit(const Vec<double, Dim>& a) {
  const double length = norm(a);
  return length > 0 ? a * (1 / length) : a;
}

/// A unit vector perpendicular to one that is not 0: its product with the coordinate axis farthest
/// from it, so that its direction is known to rounding.
inline Vec3 any_across(const Vec3& direction) {
  int least = 0;
  for (int k = 1; k < 3; ++k)
    if (std::abs(direction[k]) < std::abs(direction[least])) least = k;
  Vec3 axis;
  axis[least] = 1;
  return unit(cross(direction, axis));
}

}  // namespace blossom
