// SPDX-License-Identifier: LGPL-2.1-or-later
// Normal and curvature of a surface along an edge, in the frame of the edge.
//
// Formulas are templates on the scalar: double for a point, TaylorModel for a piece of the edge
// with bounds.
//
// Notation: S(u, v) surface, N = S_u x S_v, E, F, G first fundamental form, L, M, K second one
// times |N|; T = S_u du + S_v dv along the edge. C = N x T lies in the tangent plane, square to the
// edge and to its left:
//   C = a S_u + b S_v,   a = -(F du + G dv),   b = E du + F dv,   |C| = |N| |T|

#pragma once

#include <array>
#include <cmath>

#include "core/math/series/taylor_model.h"
#include "core/math/vec.h"

namespace blossom {

/// A point of a surface with its first and second partial derivatives, and the direction of an edge
/// through it, in the same parameters.
template <class Scalar>
struct EdgeJet {
  Vec<Scalar, 3> point, u, v, uu, uv, vv;
  Vec<Scalar, 2> along;
};

/// The frame of an edge: t along it, d across it, n = t x d.
template <class Scalar>
struct EdgeFrame {
  Vec<Scalar, 3> point;
  Vec<Scalar, 3> normal;
  /// The shape operator, II(t, t), II(t, d), II(d, d) by n; 1 / model unit.
  std::array<Scalar, 3> shape;
};

inline double reciprocal(double x) { return 1 / x; }

/// The frame with d to the left of the edge for `side` 1, to its right for -1; left as seen against
/// N. N and T have to be other than 0.
template <class Scalar>
EdgeFrame<Scalar> edge_frame(const EdgeJet<Scalar>& jet, double side) {
  using std::sqrt;
  const Scalar& du = jet.along[0];
  const Scalar& dv = jet.along[1];
  const Vec<Scalar, 3> normal = cross(jet.u, jet.v);
  const Scalar e = dot(jet.u, jet.u), f = dot(jet.u, jet.v), g = dot(jet.v, jet.v);
  const Scalar l = dot(jet.uu, normal), m = dot(jet.uv, normal), k = dot(jet.vv, normal);
  const Scalar a = -(f * du + g * dv), b = e * du + f * dv;

  const Scalar square = dot(normal, normal);
  const Scalar per_square = reciprocal(square);
  const Scalar per_normal = sqrt(square) * per_square * Scalar(side);
  const Scalar per_along = reciprocal(e * du * du + (f + f) * du * dv + g * dv * dv);

  EdgeFrame<Scalar> frame;
  frame.point = jet.point;
  frame.normal = normal * per_normal;
  frame.shape[0] = (l * du * du + (m + m) * du * dv + k * dv * dv) * per_normal * per_along;
  frame.shape[1] = (l * du * a + m * (du * b + dv * a) + k * dv * b) * per_square * per_along;
  frame.shape[2] = (l * a * a + (m + m) * a * b + k * b * b) * per_normal * per_square * per_along;
  return frame;
}

/// The largest absolute eigenvalue of the symmetric matrix (x, y; y, z).
inline double spectral_norm(double x, double y, double z) {
  const double mean = (x + z) / 2, half = (x - z) / 2;
  return std::abs(mean) + std::hypot(half, y);
}

}  // namespace blossom
