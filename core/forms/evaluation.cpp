// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/evaluation.h"

#include <array>

namespace blossom {
namespace {

using Row = std::array<double, kMaxDegree + 1>;

// B_i^n(t), i = 0..n, by the triangle of convex combinations.
void bernstein(int n, double t, Row& b) {
  b[0] = 1;
  for (int k = 1; k <= n; ++k) {
    double carried = 0;
    for (int i = 0; i < k; ++i) {
      const double value = b[static_cast<std::size_t>(i)];
      b[static_cast<std::size_t>(i)] = carried + (1 - t) * value;
      carried = t * value;
    }
    b[static_cast<std::size_t>(k)] = carried;
  }
}

// The derivative of sum_i p_i B_i^n from the Bernstein polynomials of the degree below:
// weight i is n (b_{i-1} - b_i).
void differentiate(int n, const Row& lower, Row& d) {
  for (int i = 0; i <= n; ++i) {
    const double left = i > 0 ? lower[static_cast<std::size_t>(i - 1)] : 0;
    const double right = i < n ? lower[static_cast<std::size_t>(i)] : 0;
    d[static_cast<std::size_t>(i)] = n * (left - right);
  }
}

// Weights of value, first and second derivative for degree n at t.
struct Weights {
  std::array<Row, 3> order;

  Weights(int n, double t, int highest) {
    bernstein(n, t, order[0]);
    Row lower;
    bernstein(n > 0 ? n - 1 : 0, t, lower);
    differentiate(n, lower, order[1]);
    if (highest < 2) return;
    order[2].fill(0);
    if (n < 2) return;
    Row lowest;
    bernstein(n - 2, t, lowest);
    Row first;
    differentiate(n - 1, lowest, first);
    differentiate(n, first, order[2]);
  }
};

// (X / w) differentiated: the quotient rule, lower derivatives of the quotient known.
Vec3 quotient(const Vec4& h, const Vec3& correction, double w) {
  return {(h[0] - correction[0]) / w, (h[1] - correction[1]) / w, (h[2] - correction[2]) / w};
}

}  // namespace

PatchJet jet_at(const RationalBezierPatch& patch, double u, double v, int order) {
  const int n = patch.degree_u(), m = patch.degree_v();
  const Weights bu(n, u, order), bv(m, v, order);
  Vec4 h00, h10, h01, h20, h11, h02;
  for (int i = 0; i <= n; ++i) {
    const auto r = static_cast<std::size_t>(i);
    Vec4 s0, s1, s2;
    for (int j = 0; j <= m; ++j) {
      const auto c = static_cast<std::size_t>(j);
      const Vec4& p = patch.points(i, j);
      s0 += bv.order[0][c] * p;
      s1 += bv.order[1][c] * p;
      if (order > 1) s2 += bv.order[2][c] * p;
    }
    h00 += bu.order[0][r] * s0;
    h10 += bu.order[1][r] * s0;
    h01 += bu.order[0][r] * s1;
    if (order < 2) continue;
    h20 += bu.order[2][r] * s0;
    h11 += bu.order[1][r] * s1;
    h02 += bu.order[0][r] * s2;
  }
  const double w = h00[3];
  PatchJet jet;
  jet.point = quotient(h00, Vec3{}, w);
  jet.u = quotient(h10, h10[3] * jet.point, w);
  jet.v = quotient(h01, h01[3] * jet.point, w);
  if (order < 2) return jet;
  jet.uu = quotient(h20, 2 * h10[3] * jet.u + h20[3] * jet.point, w);
  jet.uv = quotient(h11, h10[3] * jet.v + h01[3] * jet.u + h11[3] * jet.point, w);
  jet.vv = quotient(h02, 2 * h01[3] * jet.v + h02[3] * jet.point, w);
  return jet;
}

}  // namespace blossom
