// SPDX-License-Identifier: LGPL-2.1-or-later
// Kernels for triangles cut out of one net: lanes are triangles.
//
// T4 averages the blossom of the tensor product over all ways to give n of the N = n + m points
// to u; T1 shifts the polynomial to the corner c and builds differences along A = a - c and
// B = b - c. `V` as in bulk_products.h.

#pragma once

#include "core/subdivision/bulk/detail/bulk_kernels.h"
#include "core/subdivision/bulk/detail/bulk_matrix_kernels.h"
#include "core/subdivision/bulk/detail/bulk_patch_kernels.h"

namespace blossom::detail {

BLOSSOM_PART constexpr int triangle_count(int degree) { return (degree + 1) * (degree + 2) / 2; }

/// The rows A^i B^j C^k with i + j + k = n of products of factors, i first, then j: each a
/// polynomial of n + 1 coefficients, kWidth lanes each.
template <class V, NetForm kForm>
void corner_rows(int n, const double* const* corners, int piece, double* rows) {
  using Lanes = typename V::type;
  const Factor<V, kForm> a(V::load(corners[0] + piece)), b(V::load(corners[1] + piece)),
      c(V::load(corners[2] + piece));
  Lanes with_a[kMaxSize], with_b[kMaxSize], row[kMaxSize];
  with_a[0] = V::all(1);
  for (int i = 0; i <= n; ++i) {
    if (i > 0) multiply<V, kForm>(with_a, i, a);
    for (int k = 0; k <= i; ++k) with_b[k] = with_a[k];
    for (int j = 0; i + j <= n; ++j) {
      if (j > 0) multiply<V, kForm>(with_b, i + j, b);
      for (int k = 0; k <= i + j; ++k) row[k] = with_b[k];
      for (int d = i + j + 1; d <= n; ++d) multiply<V, kForm>(row, d, c);
      for (int k = 0; k <= n; ++k, rows += V::kWidth) {
        if constexpr (kForm == NetForm::Monomial) row[k] = row[k] * V::all(polar_scale(n, k));
        V::store(rows, row[k]);
      }
    }
  }
}

/// q += weight * (half . row of sigma) for every sigma, for one tau and one plane.
template <class V>
BLOSSOM_PART void add_values(int columns, int count, const double* half, const double* rows,
                             const double* weights, const int* targets, double* sums) {
  using Lanes = typename V::type;
  for (int sigma = 0; sigma < count; ++sigma, rows += columns * V::kWidth) {
    Lanes value = V::load(half) * V::load(rows);
#pragma GCC unroll 6
    for (int j = 1; j < columns; ++j)
      value = V::fma(V::load(half + j * V::kWidth), V::load(rows + j * V::kWidth), value);
    double* sum = sums + targets[sigma] * V::kWidth;
    V::store(sum, V::fma(V::all(weights[sigma]), value, V::load(sum)));
  }
}

/// T4 for the lanes of one vector. kSize is that of a square net, or 0; kHighest bounds the
/// degrees, and with them the stack.
template <class V, NetForm kForm, int kSize, int kHighest>
[[gnu::noinline]] void t4_lanes(const TrianglePlanView& plan, int planes, const double* net,
                                const CornersView& corners, int piece, double* out) {
  constexpr int kRows = triangle_count(kHighest), kBound = kHighest + 1;
  alignas(64) double along_u[kRows * kBound * V::kWidth], along_v[kRows * kBound * V::kWidth];
  alignas(64) double half[kBound * V::kWidth], sums[triangle_count(2 * kHighest) * V::kWidth];
  const int rows = kSize > 0 ? kSize : plan.degree_u + 1;
  const int columns = kSize > 0 ? kSize : plan.degree_v + 1;
  const int count_u = triangle_count(rows - 1), count_v = triangle_count(columns - 1);
  const int count = triangle_count(rows + columns - 2);
  corner_rows<V, kForm>(rows - 1, corners.u, piece, along_u);
  corner_rows<V, kForm>(columns - 1, corners.v, piece, along_v);
  for (int plane = 0; plane < planes; ++plane, net += rows * columns) {
    for (int k = 0; k < count; ++k) V::store(sums + k * V::kWidth, V::all(0));
    for (int tau = 0; tau < count_u; ++tau) {
      product_in_line<V, Entries::Single, kSize>(
          columns, 1, rows, Places{net, Fixed<1>{}, distance_of<kSize, 1>(columns)},
          Places{static_cast<const double*>(along_u + tau * rows * V::kWidth), Fixed<V::kWidth>{},
                 Fixed<0>{}},
          Places{&half[0], Fixed<V::kWidth>{}, Fixed<0>{}});
      add_values<V>(columns, count_v, half, along_v, plan.weights + tau * count_v,
                    plan.targets + tau * count_v, sums);
    }
    for (int k = 0; k < count; ++k)
      V::store(out + (plane * count + k) * kLanes, V::load(sums + k * V::kWidth));
  }
}

template <class V, NetForm kForm>
void triangles_t4_in_form(const TrianglePlanView& plan, int planes, const double* net,
                          const CornersView& corners, int blocks, double* out) {
  constexpr int kUsual = 9;
  const int highest = std::max(plan.degree_u, plan.degree_v);
  const std::ptrdiff_t size = planes * triangle_count(plan.degree_u + plan.degree_v) * kLanes;
  const auto lanes = [&](int piece, double* place) {
    switch (plan.degree_u == plan.degree_v ? plan.degree_u : 0) {
      case 2: return t4_lanes<V, kForm, 3, 2>(plan, planes, net, corners, piece, place);
      case 3: return t4_lanes<V, kForm, 4, 3>(plan, planes, net, corners, piece, place);
      case 5: return t4_lanes<V, kForm, 6, 5>(plan, planes, net, corners, piece, place);
    }
    if (highest <= kUsual)
      t4_lanes<V, kForm, 0, kUsual>(plan, planes, net, corners, piece, place);
    else
      t4_lanes<V, kForm, 0, kMaxDegree>(plan, planes, net, corners, piece, place);
  };
  for (int block = 0; block < blocks; ++block)
    for (int lane = 0; lane < kLanes; lane += V::kWidth)
      lanes(block * kLanes + lane, out + block * size + lane);
}

template <class V>
void triangles_t4(NetForm form, const TrianglePlanView& plan, int planes, const double* net,
                  const CornersView& corners, int blocks, double* out) {
  if (form == NetForm::Bezier)
    triangles_t4_in_form<V, NetForm::Bezier>(plan, planes, net, corners, blocks, out);
  else
    triangles_t4_in_form<V, NetForm::Monomial>(plan, planes, net, corners, blocks, out);
}

/// The sides A and B of a triangle in the directions (1, 2) that its lanes have chosen, so that
/// A_1 is the largest of their four coordinates: A = A_1 (1, alpha), B = rho A + (0, delta).
template <class V>
struct Pivot {
  using Lanes = typename V::type;
  Lanes shift[2];
  Lanes turned;   ///< 1 where the two parameters changed places
  Lanes swapped;  ///< 1 where A and B changed places
  Lanes first, alpha, rho, delta;

  BLOSSOM_PART static Lanes absolute(Lanes x) { return x < V::all(0) ? -x : x; }

  BLOSSOM_PART Pivot(const CornersView& corners, int piece) {
    Lanes side[2][2];  // [A or B][parameter]
    const Lanes one = V::all(1), zero = V::all(0);
    for (int p = 0; p < 2; ++p) {
      const double* const* from = p == 0 ? corners.u : corners.v;
      const Lanes c = V::load(from[2] + piece);
      shift[p] = (c + c) - one;
      for (int k = 0; k < 2; ++k) {
        const Lanes d = V::load(from[k] + piece) - c;
        side[k][p] = d + d;
      }
    }
    const Lanes a1 = absolute(side[0][0]), a2 = absolute(side[0][1]);
    const Lanes b1 = absolute(side[1][0]), b2 = absolute(side[1][1]);
    const Lanes a_largest = a1 < a2 ? a2 : a1, b_largest = b1 < b2 ? b2 : b1;
    swapped = a_largest < b_largest ? one : zero;
    const Lanes x1 = swapped > zero ? side[1][0] : side[0][0];
    const Lanes x2 = swapped > zero ? side[1][1] : side[0][1];
    const Lanes y1 = swapped > zero ? side[0][0] : side[1][0];
    const Lanes y2 = swapped > zero ? side[0][1] : side[1][1];
    turned = absolute(x1) < absolute(x2) ? one : zero;
    first = turned > zero ? x2 : x1;
    const Lanes second = turned > zero ? x1 : x2;
    const Lanes divisor = first == zero ? one : first;
    alpha = second / divisor;
    rho = (turned > zero ? y2 : y1) / divisor;
    delta = (turned > zero ? y1 : y2) - rho * second;
  }
};

/// A chosen reading of a sequence: reversed where the lane's mark is 1.
template <class V>
BLOSSOM_PART void reverse_where(typename V::type mark, int count, typename V::type* values) {
  using Lanes = typename V::type;
  const Lanes zero = V::all(0);
  for (int i = 0, j = count - 1; i < j; ++i, --j) {
    const Lanes x = values[i], y = values[j];
    values[i] = mark > zero ? y : x;
    values[j] = mark > zero ? x : y;
  }
}

/// Coefficients at the corner c: synthetic division along both parameters.
template <class V>
void shift_to_corner(int n, int m, const double* coefficients, const Pivot<V>& pivot,
                     typename V::type* shifted) {
  const int columns = m + 1;
  for (int k = 0; k < (n + 1) * columns; ++k) shifted[k] = V::all(coefficients[k]);
  for (int r = 0; r < n; ++r)
    for (int i = n - 1; i >= r; --i)
      for (int j = 0; j <= m; ++j)
        shifted[i * columns + j] =
            V::fma(pivot.shift[0], shifted[(i + 1) * columns + j], shifted[i * columns + j]);
  for (int r = 0; r < m; ++r)
    for (int j = m - 1; j >= r; --j)
      for (int i = 0; i <= n; ++i)
        shifted[i * columns + j] =
            V::fma(pivot.shift[1], shifted[i * columns + j + 1], shifted[i * columns + j]);
}

/// The layer of total degree k: in goes g_j = E1^(k - j) E2^j f, out comes A^(k - r) B^r f.
template <class V>
BLOSSOM_PART void layer_differences(int k, const Pivot<V>& pivot, typename V::type* g) {
  using Lanes = typename V::type;
  reverse_where<V>(pivot.turned, k + 1, g);
  for (int r = 1; r <= k; ++r)
    for (int s = 0; s <= k - r; ++s) g[s] = V::fma(pivot.alpha, g[s + 1], g[s]);
  Lanes power = pivot.first;
  for (int s = k - 1; s >= 0; --s, power = power * pivot.first) g[s] = g[s] * power;
  power = pivot.delta;
  for (int s = 1; s <= k; ++s, power = power * pivot.delta) g[s] = g[s] * power;
  for (int r = 1; r <= k; ++r)
    for (int s = k; s >= r; --s) g[s] = V::fma(pivot.rho, g[s - 1], g[s]);
  reverse_where<V>(pivot.swapped, k + 1, g);
}

/// T1 for the lanes of one vector and one plane. kDegree is that of both directions, or 0 if only
/// the plan knows them.
template <class V, int kDegree>
[[gnu::noinline]] void t1_lanes(const TrianglePlanView& plan, const double* coefficients,
                                const Pivot<V>& pivot, double* out) {
  using Lanes = typename V::type;
  constexpr int kSize = kDegree > 0 ? kDegree + 1 : kMaxSize, kTotalSize = 2 * kSize - 1;
  const int n = kDegree > 0 ? kDegree : plan.degree_u, m = kDegree > 0 ? kDegree : plan.degree_v;
  const int degree = n + m, size = degree + 1;
  Lanes shifted[kSize * kSize], layer[kTotalSize];
  Lanes table[kTotalSize * kTotalSize];  // difference (p, r) of A^p B^r at p * size + r
  shift_to_corner<V>(n, m, coefficients, pivot, shifted);
  const double* inverse = plan.inverses;
  for (int k = 0; k <= degree; ++k, inverse += k) {
    for (int j = 0; j <= k; ++j)
      layer[j] =
          k - j <= n && j <= m ? shifted[(k - j) * (m + 1) + j] * V::all(inverse[j]) : V::all(0);
    layer_differences<V>(k, pivot, layer);
    for (int r = 0; r <= k; ++r) table[(k - r) * size + r] = layer[r];
  }
  for (int t = 1; t <= degree; ++t)
    for (int p = degree; p >= t; --p)
      for (int r = 0; r <= degree - p; ++r)
        table[p * size + r] = table[p * size + r] + table[(p - 1) * size + r];
  for (int nu = 0; nu <= degree; ++nu) {
    Lanes* row = table + nu * size;
    for (int t = 1; t <= degree - nu; ++t)
      for (int r = degree - nu; r >= t; --r) row[r] = row[r] + row[r - 1];
    for (int mu = 0; mu <= degree - nu; ++mu, out += kLanes) V::store(out, row[mu]);
  }
}

template <class V>
void triangles_t1(const TrianglePlanView& plan, int planes, const double* coefficients,
                  const CornersView& corners, int blocks, double* out) {
  const std::ptrdiff_t plane_size = triangle_count(plan.degree_u + plan.degree_v) * kLanes;
  const int net_size = (plan.degree_u + 1) * (plan.degree_v + 1);
  const auto lanes = [&](const double* plane, const Pivot<V>& pivot, double* place) {
    switch (plan.degree_u == plan.degree_v ? plan.degree_u : 0) {
      case 2: return t1_lanes<V, 2>(plan, plane, pivot, place);
      case 3: return t1_lanes<V, 3>(plan, plane, pivot, place);
      case 5: return t1_lanes<V, 5>(plan, plane, pivot, place);
      default: return t1_lanes<V, 0>(plan, plane, pivot, place);
    }
  };
  for (int block = 0; block < blocks; ++block)
    for (int lane = 0; lane < kLanes; lane += V::kWidth) {
      const Pivot<V> pivot(corners, block * kLanes + lane);
      for (int plane = 0; plane < planes; ++plane)
        lanes(coefficients + plane * net_size, pivot,
              out + (block * planes + plane) * plane_size + lane);
    }
}

}  // namespace blossom::detail
