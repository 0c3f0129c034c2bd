// SPDX-License-Identifier: LGPL-2.1-or-later
// The kernels of bulk subdivision: one table of functions for each vector width.
//
// The tables are filled by simd_plain.cpp, simd_avx2.cpp and simd_avx512.cpp, all from the same
// templates (bulk_products.h, bulk_matrix_kernels.h, bulk_pyramid_kernels.h,
// bulk_triangle_kernels.h). Kernels check nothing and allocate nothing. "Lanes" are kLanes values
// side by side, one for each of kLanes pieces or patches.

#pragma once

#include "core/subdivision/bulk/bulk_matrices.h"
#include "core/subdivision/bulk/simd_level.h"
#include "core/subdivision/cell_nets.h"

namespace blossom::detail {

/// Matrices of one direction, as MatrixStack keeps them.
struct StackView {
  int size = 0;  ///< degree + 1
  int pieces = 0;
  const double* rows = nullptr;     ///< (pieces * size) x size
  const double* columns = nullptr;  ///< size x stride, the transpose
  int stride = 0;
};

/// Ends of the pieces, one value a piece; kLanes of them belong to a block.
struct EndsView {
  const double* u_from;
  const double* u_to;
  const double* v_from;
  const double* v_to;
};

/// The coordinates of the corners a, b, c, one value a triangle.
struct CornersView {
  const double* u[3];
  const double* v[3];
};

/// How nets go into a kernel: one for all lanes, or a block of kLanes nets for each block.
enum class LaneNets { Shared, Blocks };

/// What triangles of one pair of degrees have in common.
struct TrianglePlanView {
  int degree_u = 0;
  int degree_v = 0;
  const double* weights = nullptr;   ///< T4: for each (tau, sigma)
  const int* targets = nullptr;      ///< T4: the point each (tau, sigma) adds to
  const double* inverses = nullptr;  ///< T1: 1 / multinomial at layer k, place j: k (k + 1) / 2 + j
};

struct BulkKernels {
  /// The matrix of one piece, transposed: entry (i, k) at i * kMatrixStride + k.
  void (*matrix)(NetForm form, int degree, double from, double to, double* transposed);

  void (*grid)(const NetShape& shape, const double* net, const StackView& u, const StackView& v,
               double* sheet);
  void (*grid_of_blocks)(const NetShape& shape, const double* nets, int blocks, const StackView& u,
                         const StackView& v, double* sheets);
  void (*pieces)(NetForm form, LaneNets source, const NetShape& shape, const double* nets,
                 const EndsView& ends, int blocks, double* out);
  void (*pyramid)(LaneNets source, const NetShape& shape, const double* nets, const EndsView& ends,
                  int blocks, double* out);
  void (*piece)(NetForm form, const NetShape& shape, const double* net, const Interval& u,
                const Interval& v, double* out);
  void (*triangles_t4)(NetForm form, const TrianglePlanView& plan, int planes, const double* net,
                       const CornersView& corners, int blocks, double* out);
  void (*triangles_t1)(const TrianglePlanView& plan, int planes, const double* coefficients,
                       const CornersView& corners, int blocks, double* out);
};

/// Row length of a matrix made by a kernel: the highest degree plus one, in whole lanes.
inline constexpr int kMatrixStride = 32;

/// Null where the compiler or the processor family does not have the instructions.
const BulkKernels* avx512_kernels();
const BulkKernels* avx2_kernels();
const BulkKernels& plain_kernels();

/// The kernels of an available level.
const BulkKernels& kernels(SimdLevel level);

}  // namespace blossom::detail
