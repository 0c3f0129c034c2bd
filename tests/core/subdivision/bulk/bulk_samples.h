// SPDX-License-Identifier: LGPL-2.1-or-later
// Nets and levels for the tests of bulk subdivision.

#pragma once

#include <cmath>
#include <vector>

#include "core/math/binomial.h"
#include "core/subdivision/bulk/bulk_matrices.h"
#include "core/subdivision/bulk/bulk_storage.h"
#include "core/subdivision/bulk/simd_level.h"
#include "core/subdivision/cell_nets.h"
#include "tests/support/exact.h"
#include "tests/support/random.h"

namespace blossom::testing {

/// The levels of this machine, Plain first.
inline std::vector<SimdLevel> all_levels() {
  std::vector<SimdLevel> levels;
  for (SimdLevel level : {SimdLevel::Plain, SimdLevel::Avx2, SimdLevel::Avx512})
    if (is_available(level)) levels.push_back(level);
  return levels;
}

inline const char* level_name(SimdLevel level) {
  return level == SimdLevel::Plain ? "plain" : level == SimdLevel::Avx2 ? "AVX2" : "AVX-512";
}

/// Values in [-1, 1), so that errors relative to the largest are absolute ones.
inline LaneVector random_net(Random& random, const NetShape& shape) {
  LaneVector net(static_cast<std::size_t>(shape.size()));
  for (double& value : net) value = uniform(random, -1, 1);
  return net;
}

/// A value of a plane, exactly.
inline Rational exact_value(const NetShape& shape, const LaneVector& net, int plane, int i, int j) {
  const int place = plane * shape.plane_size() + i * shape.columns + j;
  return Rational(net[static_cast<std::size_t>(place)]);
}

/// The blossom of each basis function at the parameters: coefficients of prod (1 - t + t x), or
/// those of prod (1 + (2t - 1) x) over binom(n, i).
inline std::vector<Rational> exact_row(NetForm form, const std::vector<double>& parameters) {
  std::vector<Rational> row{Rational(1)};
  const int n = static_cast<int>(parameters.size());
  for (double t : parameters) {
    const Rational slope = form == NetForm::Bezier ? Rational(t) : Rational(2 * Rational(t) - 1);
    const Rational rest = form == NetForm::Bezier ? Rational(1 - Rational(t)) : Rational(1);
    row.push_back(0);
    for (std::size_t i = row.size() - 1; i > 0; --i)
      row[i] = Rational(rest * row[i] + slope * row[i - 1]);
    row[0] *= rest;
  }
  for (int i = 0; form == NetForm::Monomial && i <= n; ++i)
    row[static_cast<std::size_t>(i)] /= Rational(binomial(n, i));
  return row;
}

/// The blossom of a plane at n parameters of u and m of v.
inline Rational exact_blossom(NetForm form, const NetShape& shape, const LaneVector& net, int plane,
                              const std::vector<double>& u, const std::vector<double>& v) {
  const std::vector<Rational> along_u = exact_row(form, u), along_v = exact_row(form, v);
  Rational sum = 0;
  for (int i = 0; i < shape.rows; ++i) {
    Rational row = 0;
    for (int j = 0; j < shape.columns; ++j)
      row += exact_value(shape, net, plane, i, j) * along_v[static_cast<std::size_t>(j)];
    sum += along_u[static_cast<std::size_t>(i)] * row;
  }
  return sum;
}

/// A multiple of 2^-bits in [0, 1], so that exact values stay short.
inline double dyadic(Random& random, int bits) {
  return std::ldexp(std::floor(std::ldexp(uniform(random, 0, 1), bits)), -bits);
}

inline double sum_of_plane(const NetShape& shape, const LaneVector& net, int plane) {
  double sum = 0;
  for (int k = 0; k < shape.plane_size(); ++k)
    sum += std::abs(net[static_cast<std::size_t>(plane * shape.plane_size() + k)]);
  return sum;
}

}  // namespace blossom::testing
