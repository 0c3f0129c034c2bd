// SPDX-License-Identifier: LGPL-2.1-or-later
// Products of linear factors, which are the rows of the subdivision matrices.
//
// A row is built factor by factor in a fixed order, so that rows that belong to the same
// parameters are the same bit for bit, whether lanes are rows of one matrix or pieces. `V` as in
// bulk_products.h.

#pragma once

#include "core/math/binomial.h"
#include "core/subdivision/bulk/bulk_matrices.h"
#include "core/subdivision/bulk/detail/bulk_kernels.h"
#include "core/subdivision/bulk/detail/bulk_products.h"

namespace blossom::detail {

/// One linear factor: rest + slope x, where rest is 1 for the monomial form.
template <class V, NetForm kForm>
struct Factor {
  using Lanes = typename V::type;
  Lanes slope;
  Lanes rest;

  BLOSSOM_PART explicit Factor(Lanes parameter) {
    if constexpr (kForm == NetForm::Bezier) {
      slope = parameter;
      rest = V::all(1) - parameter;
    } else {
      slope = (parameter + parameter) - V::all(1);
      rest = V::all(1);
    }
  }
  BLOSSOM_PART Factor(Lanes given_slope, Lanes given_rest) : slope(given_slope), rest(given_rest) {}
};

/// Multiplies a polynomial of degree `degree - 1` by the factor.
template <class V, NetForm kForm, class Polynomial>
BLOSSOM_PART void multiply(Polynomial& polynomial, int degree, const Factor<V, kForm>& factor) {
  polynomial[degree] = factor.slope * polynomial[degree - 1];
#pragma GCC unroll 10
  for (int i = degree - 1; i > 0; --i) {
    if constexpr (kForm == NetForm::Bezier)
      polynomial[i] = V::fma(factor.slope, polynomial[i - 1], factor.rest * polynomial[i]);
    else
      polynomial[i] = V::fma(factor.slope, polynomial[i - 1], polynomial[i]);
  }
  if constexpr (kForm == NetForm::Bezier) polynomial[0] = factor.rest * polynomial[0];
}

/// 1 / binom(n, i), which the monomial form owes each coefficient.
BLOSSOM_PART double polar_scale(int n, int i) { return 1 / binomial(n, i); }

/// The matrix of each lane's piece: entry (k, i) at (k (n + 1) + i) kWidth. N is the degree, or
/// -1 if only `degree` knows it.
template <class V, NetForm kForm, int N>
BLOSSOM_PART void lane_matrix_of_degree(int degree, typename V::type from, typename V::type to,
                                        double* out) {
  using Lanes = typename V::type;
  constexpr int kSize = N >= 0 ? N + 1 : kMaxDegree + 1;
  const int n = N >= 0 ? N : degree;
  const Factor<V, kForm> low(from), high(to);
  Lanes prefix[kSize], row[kSize];
  prefix[0] = V::all(1);
#pragma GCC unroll 10
  for (int k = 0; k <= n; ++k) {
    if (k > 0) multiply<V, kForm>(prefix, k, high);
#pragma GCC unroll 10
    for (int i = 0; i <= k; ++i) row[i] = prefix[i];
#pragma GCC unroll 10
    for (int d = k + 1; d <= n; ++d) multiply<V, kForm>(row, d, low);
#pragma GCC unroll 10
    for (int i = 0; i <= n; ++i) {
      if constexpr (kForm == NetForm::Monomial) row[i] = row[i] * V::all(polar_scale(n, i));
      V::store(out + (k * (n + 1) + i) * V::kWidth, row[i]);
    }
  }
}

template <class V, NetForm kForm>
[[gnu::noinline]] void lane_matrix(int degree, const double* from, const double* to, double* out) {
  const typename V::type a = V::load(from), b = V::load(to);
  switch (degree) {
    case 1: return lane_matrix_of_degree<V, kForm, 1>(degree, a, b, out);
    case 2: return lane_matrix_of_degree<V, kForm, 2>(degree, a, b, out);
    case 3: return lane_matrix_of_degree<V, kForm, 3>(degree, a, b, out);
    case 4: return lane_matrix_of_degree<V, kForm, 4>(degree, a, b, out);
    case 5: return lane_matrix_of_degree<V, kForm, 5>(degree, a, b, out);
    case 9: return lane_matrix_of_degree<V, kForm, 9>(degree, a, b, out);
    default: return lane_matrix_of_degree<V, kForm, -1>(degree, a, b, out);
  }
}

/// In line where the degree is the constant N, else by the choice above.
template <class V, NetForm kForm, int N>
BLOSSOM_PART void lane_matrix_in_line(int degree, const double* from, const double* to,
                                      double* out) {
  if constexpr (N >= 0)
    lane_matrix_of_degree<V, kForm, N>(N, V::load(from), V::load(to), out);
  else
    lane_matrix<V, kForm>(degree, from, to, out);
}

/// The matrix of one piece with its rows as lanes: entry (k, i) at i * kMatrixStride + k. Lanes
/// beyond the last row hold further products of the same kind.
template <class V, NetForm kForm, int N>
BLOSSOM_PART void single_matrix_of_degree(int degree, double from, double to, double* transposed) {
  using Lanes = typename V::type;
  const int n = N >= 0 ? N : degree;
  const Factor<V, kForm> low(V::all(from)), high(V::all(to));
  Lanes polynomial[N >= 0 ? N + 1 : kMaxDegree + 1];
  for (int first = 0; first <= n; first += V::kWidth) {
    const Lanes row = V::lane_numbers() + V::all(first);
    polynomial[0] = V::all(1);
#pragma GCC unroll 10
    for (int d = 1; d <= n; ++d) {
      const Lanes step = V::all(d);
      const Factor<V, kForm> factor(step <= row ? high.slope : low.slope,
                                    step <= row ? high.rest : low.rest);
      multiply<V, kForm>(polynomial, d, factor);
    }
#pragma GCC unroll 10
    for (int i = 0; i <= n; ++i) {
      if constexpr (kForm == NetForm::Monomial)
        polynomial[i] = polynomial[i] * V::all(polar_scale(n, i));
      V::store(transposed + i * kMatrixStride + first, polynomial[i]);
    }
  }
}

template <class V, int N>
BLOSSOM_PART void single_matrix_in_line(NetForm form, int degree, double from, double to,
                                        double* transposed) {
  if (form == NetForm::Bezier)
    single_matrix_of_degree<V, NetForm::Bezier, N>(degree, from, to, transposed);
  else
    single_matrix_of_degree<V, NetForm::Monomial, N>(degree, from, to, transposed);
}

template <class V>
[[gnu::noinline]] void single_matrix(NetForm form, int degree, double from, double to,
                                     double* transposed) {
  single_matrix_in_line<V, -1>(form, degree, from, to, transposed);
}

}  // namespace blossom::detail
