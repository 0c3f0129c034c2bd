// SPDX-License-Identifier: LGPL-2.1-or-later
// All kernels of one vector width.

#pragma once

#include "core/subdivision/bulk/detail/bulk_kernels.h"
#include "core/subdivision/bulk/detail/bulk_matrix_kernels.h"
#include "core/subdivision/bulk/detail/bulk_patch_kernels.h"
#include "core/subdivision/bulk/detail/bulk_pyramid_kernels.h"
#include "core/subdivision/bulk/detail/bulk_triangle_kernels.h"

namespace blossom::detail {

template <class V>
inline constexpr BulkKernels kKernelsOf{
    .matrix = single_matrix<V>,
    .grid = grid<V>,
    .grid_of_blocks = grid_of_blocks<V>,
    .pieces = pieces<V>,
    .pyramid = pyramid<V>,
    .piece = piece<V>,
    .triangles_t4 = triangles_t4<V>,
    .triangles_t1 = triangles_t1<V>,
};

}  // namespace blossom::detail
