// SPDX-License-Identifier: LGPL-2.1-or-later
// The polar pyramid: control points from re-centred coefficients without a matrix.
//
//   f_i = c_i / binom(n, i)
//   for r = 1..n, i = 0..n - r:     f_i += a f_(i + 1)       F_k = (1 + a E)^(n - k) E^k f
//   for k = 1..n:                   f_k *= h^k               differences of the control points
//   for r = 1..n, i = n..r:         f_i += f_(i - 1)         control points
//
// with x in [a, a + h]. All of a column stays in registers. `V` as in bulk_products.h.
//
// Source: Vlachkova 2025, Theorem 1, with 1 + b E = (1 + a E) + h E.

#pragma once

#include "core/subdivision/bulk/detail/bulk_kernels.h"
#include "core/subdivision/bulk/detail/bulk_matrix_kernels.h"
#include "core/subdivision/bulk/detail/bulk_patch_kernels.h"
#include "core/subdivision/bulk/detail/bulk_products.h"

namespace blossom::detail {

/// The pieces of one direction: start, and powers of the width.
template <class V>
struct PyramidEnds {
  using Lanes = typename V::type;
  Lanes start;
  Lanes power[kMaxSize];

  BLOSSOM_PART PyramidEnds(int degree, const double* from, const double* to) {
    const Lanes a = V::load(from), b = V::load(to);
    start = (a + a) - V::all(1);
    const Lanes width = (b - a) + (b - a);
    power[0] = V::all(1);
    for (int k = 1; k <= degree; ++k) power[k] = power[k - 1] * width;
  }
};

/// The three passes over one column in place.
template <class V, int N>
BLOSSOM_PART void pyramid_passes(int degree, const PyramidEnds<V>& ends, typename V::type* f) {
  const int n = N >= 0 ? N : degree;
  const typename V::type a = ends.start;
#pragma GCC unroll 10
  for (int r = 1; r <= n; ++r)
#pragma GCC unroll 10
    for (int i = 0; i <= n - r; ++i) f[i] = V::fma(a, f[i + 1], f[i]);
#pragma GCC unroll 10
  for (int k = 1; k <= n; ++k) f[k] = f[k] * ends.power[k];
#pragma GCC unroll 10
  for (int r = 1; r <= n; ++r)
#pragma GCC unroll 10
    for (int i = n; i >= r; --i) f[i] = f[i] + f[i - 1];
}

/// `count` columns of degree N: value i of a column at i * step, columns at distances of stride.
template <class V, Entries kEntries, int N, class In, class Out>
BLOSSOM_PART void pyramid_columns(int degree, int count, const PyramidEnds<V>& ends, const In& in,
                                  const Out& out) {
  const int n = N >= 0 ? N : degree;
  typename V::type f[N >= 0 ? N + 1 : kMaxSize];
  for (int column = 0; column < count; ++column) {
#pragma GCC unroll 10
    for (int i = 0; i <= n; ++i) f[i] = entry<V, kEntries>(in.at(column, i));
    pyramid_passes<V, N>(degree, ends, f);
#pragma GCC unroll 10
    for (int i = 0; i <= n; ++i) V::store(out.at(column, i), f[i]);
  }
}

template <class V, Entries kEntries>
[[gnu::noinline]] void pyramid_pass(int degree, int count, const PyramidEnds<V>& ends,
                                    const FreePlaces<const double>& in,
                                    const FreePlaces<double>& out) {
  switch (degree) {
    case 1: return pyramid_columns<V, kEntries, 1>(degree, count, ends, in, out);
    case 2: return pyramid_columns<V, kEntries, 2>(degree, count, ends, in, out);
    case 3: return pyramid_columns<V, kEntries, 3>(degree, count, ends, in, out);
    case 4: return pyramid_columns<V, kEntries, 4>(degree, count, ends, in, out);
    case 5: return pyramid_columns<V, kEntries, 5>(degree, count, ends, in, out);
    case 9: return pyramid_columns<V, kEntries, 9>(degree, count, ends, in, out);
    default: return pyramid_columns<V, kEntries, -1>(degree, count, ends, in, out);
  }
}

/// In line where the degree is the constant N, else by the choice above.
template <class V, Entries kEntries, int N, class In, class Out>
BLOSSOM_PART void pyramid_in_line(int degree, int count, const PyramidEnds<V>& ends, const In& in,
                                  const Out& out) {
  if constexpr (N >= 0)
    pyramid_columns<V, kEntries, N>(N, count, ends, in, out);
  else
    pyramid_pass<V, kEntries>(degree, count, ends, {in.from, in.row, in.column},
                              {out.from, out.row, out.column});
}

/// c_ij / (binom(n, i) binom(m, j)), `step` values at each place.
template <class V>
void polar_net(const NetShape& shape, const double* coefficients, int step, double* polar) {
  double scale[kMaxSize];
  for (int j = 0; j < shape.columns; ++j) scale[j] = polar_scale(shape.columns - 1, j);
  for (int row = 0; row < shape.planes * shape.rows; ++row) {
    const double row_scale = polar_scale(shape.rows - 1, row % shape.rows);
    for (int j = 0; j < shape.columns; ++j)
      for (int lane = 0; lane < step; ++lane) *polar++ = row_scale * scale[j] * *coefficients++;
  }
}

/// kSize is that of a square net, or 0.
template <class V, LaneNets kSource, int kSize>
[[gnu::noinline]] void pyramid_of_size(const NetShape& shape, const double* nets,
                                       const EndsView& ends, int blocks, double* out) {
  constexpr bool kShared = kSource == LaneNets::Shared;
  constexpr int kStep = kShared ? 1 : kLanes;
  constexpr int kBound = kSize > 0 ? kSize : kMaxSize;
  alignas(64) double polar[kMaxPlanes * kBound * kBound * kStep];
  alignas(64) double half[kBound * kBound * V::kWidth];
  const int rows = kSize > 0 ? kSize : shape.rows, columns = kSize > 0 ? kSize : shape.columns;
  const auto row = distance_of<kSize, V::kWidth>(columns);
  if (kShared) polar_net<V>(shape, nets, kStep, polar);
  for (int block = 0; block < blocks; ++block) {
    const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(block) * shape.size() * kLanes;
    if (!kShared) polar_net<V>(shape, nets + offset, kStep, polar);
    for (int lane = 0; lane < kLanes; lane += V::kWidth) {
      const int piece = block * kLanes + lane;
      const PyramidEnds<V> u(rows - 1, ends.u_from + piece, ends.u_to + piece);
      const PyramidEnds<V> v(columns - 1, ends.v_from + piece, ends.v_to + piece);
      const double* polar_start = polar + (kShared ? 0 : lane);
      for (int plane = 0; plane < shape.planes; ++plane) {
        const int start = plane * rows * columns;
        pyramid_in_line<V, kShared ? Entries::Single : Entries::Vectors, kSize - 1>(
            columns - 1, rows, v,
            Places{polar_start + start * kStep, distance_of<kSize, kStep>(columns), Fixed<kStep>{}},
            Places{&half[0], row, Fixed<V::kWidth>{}});
        pyramid_in_line<V, Entries::Vectors, kSize - 1>(
            rows - 1, columns, u, Places{static_cast<const double*>(half), Fixed<V::kWidth>{}, row},
            Places{out + offset + start * kLanes + lane, Fixed<kLanes>{},
                   distance_of<kSize, kLanes>(columns)});
      }
    }
  }
}

template <class V, LaneNets kSource>
void pyramid_of(const NetShape& shape, const double* nets, const EndsView& ends, int blocks,
                double* out) {
  with_square_size(shape, [&](auto size) {
    pyramid_of_size<V, kSource, size()>(shape, nets, ends, blocks, out);
  });
}

template <class V>
void pyramid(LaneNets source, const NetShape& shape, const double* nets, const EndsView& ends,
             int blocks, double* out) {
  if (source == LaneNets::Shared)
    pyramid_of<V, LaneNets::Shared>(shape, nets, ends, blocks, out);
  else
    pyramid_of<V, LaneNets::Blocks>(shape, nets, ends, blocks, out);
}

}  // namespace blossom::detail
