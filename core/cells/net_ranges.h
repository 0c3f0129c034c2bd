// SPDX-License-Identifier: LGPL-2.1-or-later
// Ranges of control points, and of differences between neighbouring ones, one coordinate at a time.
//
// A plane holds rows x columns values, row-major; both at least 2. Rows go with u.

#pragma once

#include "core/math/functions/quadratic.h"
#include "core/math/vec.h"

namespace blossom {

struct Range {
  double low = 0;
  double high = 0;
};

/// Of numbers, at least one.
Range value_range(const double* values, int count);

/// Of the heights normal . p of points, given as three planes of `count` coordinates.
Range height_range(const double* points, int count, const Vec3& normal);

/// Of what is left of such heights, as a polynomial's Bernstein coefficients, when those of another
/// one are taken away; its x and y are in [-1/2, 1/2] over the net.
Range height_range(const double* points, int rows, int columns, const Vec3& normal,
                   const Quadratic& less);

/// Of the differences between neighbours along u (in one column) or v (in one row).
Range difference_range_u(const double* plane, int rows, int columns);
Range difference_range_v(const double* plane, int rows, int columns);

/// Of second differences, 0 where there are none.
struct SecondRanges {
  Range uu{}, uv{}, vv{};
};
SecondRanges second_difference_ranges(const double* plane, int rows, int columns);

/// Largest absolute second differences, 0 where there are none.
struct SecondDifferences {
  double uu = 0, uv = 0, vv = 0;
};
SecondDifferences largest_second_differences(const double* plane, int rows, int columns);

}  // namespace blossom
