// SPDX-License-Identifier: LGPL-2.1-or-later
// The weights of control points in the values and derivatives of curves and patches. For this
// folder only.

#pragma once

#include "core/forms/curve.h"
#include "core/math/binomial.h"
#include "core/math/four.h"

namespace blossom::detail {

// Weights of the control points in the value and its derivatives.
struct Weights {
  double value[kMaxDegree + 1];
  double first[kMaxDegree + 1];
  double second[kMaxDegree + 1];
};

// The Bernstein polynomials of degree k <= n from the powers t^i and (1 - t)^(n - i).
[[gnu::always_inline]] inline void bernstein(int k, int n, const double* up, const double* down,
                                             double* b) {
  const auto& c = kBinomials[static_cast<std::size_t>(k)];
  for (int i = 0; i <= k; ++i) b[i] = c[static_cast<std::size_t>(i)] * (up[i] * down[n - k + i]);
}

// The weights of a derivative from those of the degree below: n (b_(i-1) - b_i). Of degree 0 there
// is none below.
[[gnu::always_inline]] inline void differentiate(int n, const double* lower, double* d) {
  if (n == 0) {
    d[0] = 0;
    return;
  }
  d[0] = -n * lower[0];
  for (int i = 1; i < n; ++i) d[i] = n * (lower[i - 1] - lower[i]);
  d[n] = n * lower[n - 1];
}

template <int kOrder>
[[gnu::always_inline]] inline void make_weights(int n, double t, Weights& w) {
  double up[kMaxDegree + 1], down[kMaxDegree + 1], below[kMaxDegree + 1];
  const double s = 1 - t;
  double power_t = 1, power_s = 1;
  for (int i = 0; i <= n; ++i, power_t *= t, power_s *= s) {
    up[i] = power_t;
    down[n - i] = power_s;
  }
  bernstein(n, n, up, down, w.value);
  if (kOrder > 0) {
    below[0] = 0;  // of degree 0 there are none
    if (n > 0) bernstein(n - 1, n, up, down, below);
    differentiate(n, below, w.first);
  }
  if (kOrder > 1) {
    for (int i = 0; i <= n; ++i) w.second[i] = 0;
    if (n < 2) return;
    double lower[kMaxDegree + 1];
    bernstein(n - 2, n, up, down, lower);
    differentiate(n - 1, lower, below);
    differentiate(n, below, w.second);
  }
}

inline Vec3 head(const Four& h) { return {h[0], h[1], h[2]}; }

}  // namespace blossom::detail
