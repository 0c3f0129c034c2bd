// SPDX-License-Identifier: LGPL-2.1-or-later
// Kernels for nets: a piece is S_u P S_v^T, always along v first.
//
// The order of operations is the same in all of them, so a piece is the same bit for bit whether
// it is cut alone, in a grid or side by side with others. `V` as in bulk_products.h.

#pragma once

#include <algorithm>
#include <cstring>
#include <type_traits>

#include "core/subdivision/bulk/detail/bulk_kernels.h"
#include "core/subdivision/bulk/detail/bulk_matrix_kernels.h"
#include "core/subdivision/bulk/detail/bulk_products.h"

namespace blossom::detail {

inline constexpr int kMaxSize = kMaxDegree + 1;
inline constexpr int kMaxPlanes = 4;

/// Rows at any distance, their entries side by side.
template <class Value, int kColumn>
using LinePlaces = Places<Value, std::ptrdiff_t, Fixed<kColumn>>;

/// Calls work(std::integral_constant<int, Size>) with the size of a square net where it has a
/// version of its own (degrees 1 to 5, and 9), else with 0.
template <class Work>
BLOSSOM_PART void with_square_size(const NetShape& shape, const Work& work) {
  switch (shape.rows == shape.columns ? shape.rows : 0) {
    case 2: return work(std::integral_constant<int, 2>{});
    case 3: return work(std::integral_constant<int, 3>{});
    case 4: return work(std::integral_constant<int, 4>{});
    case 5: return work(std::integral_constant<int, 5>{});
    case 6: return work(std::integral_constant<int, 6>{});
    case 10: return work(std::integral_constant<int, 10>{});
    default: return work(std::integral_constant<int, 0>{});
  }
}

/// Grid of one net: lanes run along the columns of the sheet. A panel of columns is cut along v
/// once, for all pieces along u.
template <class V>
void grid(const NetShape& shape, const double* net, const StackView& u, const StackView& v,
          double* sheet) {
  constexpr int kPanel = 256;
  alignas(64) double half[kMaxSize * kPanel];
  const std::ptrdiff_t rows = u.pieces * u.size;
  for (int plane = 0; plane < shape.planes; ++plane)
    for (int from = 0; from < v.stride; from += kPanel) {
      const int columns = std::min(kPanel, v.stride - from) / V::kWidth;
      product_of_size<V, Entries::Single>(
          shape.rows, columns, shape.columns,
          LinePlaces<const double, 1>{net + plane * shape.plane_size(), shape.columns, {}},
          LinePlaces<const double, V::kWidth>{v.columns + from, v.stride, {}},
          LinePlaces<double, V::kWidth>{half, kPanel, {}});
      product_of_size<V, Entries::Single>(
          static_cast<int>(rows), columns, shape.rows,
          LinePlaces<const double, 1>{u.rows, shape.rows, {}},
          LinePlaces<const double, V::kWidth>{half, kPanel, {}},
          LinePlaces<double, V::kWidth>{sheet + plane * rows * v.stride + from, v.stride, {}});
    }
}

/// Grids of nets side by side: lanes are nets. kSize is that of a square net, or 0.
template <class V, int kSize>
[[gnu::noinline]] void grid_of_blocks_of_size(const NetShape& shape, const double* nets, int blocks,
                                              const StackView& u, const StackView& v,
                                              double* sheets) {
  constexpr int kBound = kSize > 0 ? kSize : kMaxSize;
  alignas(64) double half[kBound * kBound * V::kWidth];
  const int rows = kSize > 0 ? kSize : shape.rows, columns = kSize > 0 ? kSize : shape.columns;
  const auto size = distance_of<kSize, 1>(columns);
  const auto size_lanes = distance_of<kSize, kLanes>(columns);
  const auto row = distance_of<kSize, V::kWidth>(columns);
  const std::ptrdiff_t sheet_row = static_cast<std::ptrdiff_t>(v.pieces) * columns * kLanes;
  const std::ptrdiff_t plane_size = rows * columns * kLanes, piece_size = rows * sheet_row;
  for (int plane = 0; plane < blocks * shape.planes; ++plane)
    for (int lane = 0; lane < kLanes; lane += V::kWidth)
      for (int j = 0; j < v.pieces; ++j) {
        product_in_line<V, Entries::Single, kSize>(
            columns, rows, columns, Places{v.rows + j * columns * columns, size, Fixed<1>{}},
            Places{nets + plane * plane_size + lane, Fixed<kLanes>{}, size_lanes},
            Places{&half[0], Fixed<V::kWidth>{}, row});
        double* sheet = sheets + plane * u.pieces * piece_size + j * columns * kLanes + lane;
        for (int i = 0; i < u.pieces; ++i)
          product_in_line<V, Entries::Single, kSize>(
              rows, columns, rows,
              Places{u.rows + i * rows * rows, distance_of<kSize, 1>(rows), Fixed<1>{}},
              Places{static_cast<const double*>(half), row, Fixed<V::kWidth>{}},
              Places{sheet + i * piece_size, sheet_row, Fixed<kLanes>{}});
      }
}

template <class V>
void grid_of_blocks(const NetShape& shape, const double* nets, int blocks, const StackView& u,
                    const StackView& v, double* sheets) {
  with_square_size(shape, [&](auto size) {
    grid_of_blocks_of_size<V, size()>(shape, nets, blocks, u, v, sheets);
  });
}

/// Pieces with ends of their own: lanes are pieces, and matrices are made for each. kSize is that
/// of a square net, or 0.
template <class V, NetForm kForm, LaneNets kSource, int kSize>
[[gnu::noinline]] void pieces_of_size(const NetShape& shape, const double* nets,
                                      const EndsView& ends, int blocks, double* out) {
  constexpr int kBound = kSize > 0 ? kSize : kMaxSize;
  constexpr int kArea = kBound * kBound * V::kWidth;
  constexpr bool kShared = kSource == LaneNets::Shared;
  constexpr int kStep = kShared ? 1 : kLanes;
  alignas(64) double along_u[kArea], along_v[kArea], half[kArea];
  const int rows = kSize > 0 ? kSize : shape.rows, columns = kSize > 0 ? kSize : shape.columns;
  const auto row_u = distance_of<kSize, V::kWidth>(rows);
  const auto row_v = distance_of<kSize, V::kWidth>(columns);
  const auto row_in = distance_of<kSize, kStep>(columns);
  const auto row_out = distance_of<kSize, kLanes>(columns);
  const int plane_size = rows * columns;
  const std::ptrdiff_t block_values = static_cast<std::ptrdiff_t>(shape.size()) * kLanes;
  for (int block = 0; block < blocks; ++block)
    for (int lane = 0; lane < kLanes; lane += V::kWidth) {
      const int piece = block * kLanes + lane;
      const double* net = kShared ? nets : nets + block * block_values + lane;
      lane_matrix_in_line<V, kForm, kSize - 1>(rows - 1, ends.u_from + piece, ends.u_to + piece,
                                               along_u);
      lane_matrix_in_line<V, kForm, kSize - 1>(columns - 1, ends.v_from + piece, ends.v_to + piece,
                                               along_v);
      double* piece_out = out + block * block_values + lane;
      for (int plane = 0; plane < shape.planes; ++plane) {
        product_in_line<V, kShared ? Entries::Single : Entries::Vectors, kSize>(
            rows, columns, columns,
            Places{net + plane * plane_size * kStep, row_in, Fixed<kStep>{}},
            Places{static_cast<const double*>(along_v), Fixed<V::kWidth>{}, row_v},
            Places{&half[0], row_v, Fixed<V::kWidth>{}});
        product_in_line<V, Entries::Vectors, kSize>(
            rows, columns, rows,
            Places{static_cast<const double*>(along_u), row_u, Fixed<V::kWidth>{}},
            Places{static_cast<const double*>(half), row_v, Fixed<V::kWidth>{}},
            Places{piece_out + plane * plane_size * kLanes, row_out, Fixed<kLanes>{}});
      }
    }
}

template <class V, NetForm kForm, LaneNets kSource>
void pieces_of(const NetShape& shape, const double* nets, const EndsView& ends, int blocks,
               double* out) {
  with_square_size(shape, [&](auto size) {
    pieces_of_size<V, kForm, kSource, size()>(shape, nets, ends, blocks, out);
  });
}

template <class V>
void pieces(NetForm form, LaneNets source, const NetShape& shape, const double* nets,
            const EndsView& ends, int blocks, double* out) {
  constexpr LaneNets kShared = LaneNets::Shared, kBlocks = LaneNets::Blocks;
  if (form == NetForm::Bezier)
    source == kShared ? pieces_of<V, NetForm::Bezier, kShared>(shape, nets, ends, blocks, out)
                      : pieces_of<V, NetForm::Bezier, kBlocks>(shape, nets, ends, blocks, out);
  else
    source == kShared ? pieces_of<V, NetForm::Monomial, kShared>(shape, nets, ends, blocks, out)
                      : pieces_of<V, NetForm::Monomial, kBlocks>(shape, nets, ends, blocks, out);
}

/// One piece of one net, kept short for a single call: lanes are rows of matrices and columns.
template <class V, int kSize>
[[gnu::noinline]] void piece_of_size(NetForm form, const NetShape& shape, const double* net,
                                     const Interval& u, const Interval& v, double* out) {
  constexpr int kBound = kSize > 0 ? kSize : kMaxSize;
  constexpr int kHalfRow = (kBound + V::kWidth - 1) / V::kWidth * V::kWidth;
  alignas(64) double along_u[kBound * kMatrixStride], along_v[kBound * kMatrixStride];
  alignas(64) double half[kMaxPlanes * kBound * kHalfRow], whole[kMaxPlanes * kBound * kHalfRow];
  const int rows = kSize > 0 ? kSize : shape.rows, columns = kSize > 0 ? kSize : shape.columns;
  const int vectors = (columns + V::kWidth - 1) / V::kWidth;
  const auto row = distance_of<(kSize > 0 ? kHalfRow : 0), 1>(vectors * V::kWidth);
  single_matrix_in_line<V, kSize - 1>(form, rows - 1, u.from, u.to, along_u);
  single_matrix_in_line<V, kSize - 1>(form, columns - 1, v.from, v.to, along_v);
  const double *const matrix_u = along_u, *const matrix_v = along_v, *const cut_once = half;
  product_in_line<V, Entries::Single, kSize>(
      rows * shape.planes, vectors, columns,
      Places{net, distance_of<kSize, 1>(columns), Fixed<1>{}},
      Places{matrix_v, Fixed<kMatrixStride>{}, Fixed<V::kWidth>{}},
      Places{&half[0], row, Fixed<V::kWidth>{}});
  for (int plane = 0; plane < shape.planes; ++plane)
    product_in_line<V, Entries::Single, kSize>(
        rows, vectors, rows, Places{matrix_u, Fixed<1>{}, Fixed<kMatrixStride>{}},
        Places{cut_once + plane * rows * row, row, Fixed<V::kWidth>{}},
        Places{&whole[plane * rows * row], row, Fixed<V::kWidth>{}});
  for (int k = 0; k < rows * shape.planes; ++k, out += columns)
    std::memcpy(out, whole + k * row, static_cast<std::size_t>(columns) * sizeof(double));
}

template <class V>
void piece(NetForm form, const NetShape& shape, const double* net, const Interval& u,
           const Interval& v, double* out) {
  with_square_size(shape,
                   [&](auto size) { piece_of_size<V, size()>(form, shape, net, u, v, out); });
}

}  // namespace blossom::detail
