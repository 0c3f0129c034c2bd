// SPDX-License-Identifier: LGPL-2.1-or-later
// Bezier curves and patches through points at Chebyshev's extreme points, ends included.
//
// The ends of the range are nodes, so neighbouring interpolants meet; the error is at most 2 to 3
// times that of the best polynomial.

#pragma once

#include <vector>

#include "core/forms/curve.h"
#include "core/math/grid.h"
#include "core/math/vec.h"

namespace blossom {

/// (1 - cos(k pi / n)) / 2, k = 0..n; 0 and 1 exactly.
/// degree   n, at least 1
std::vector<double> extreme_points(int degree);

/// The polynomial curve of degree n through n + 1 points at extreme_points(n). Its ends are the
/// first and the last of them, bit for bit.
template <class Point>
BezierCurveOf<Point> bezier_through(const std::vector<Point>& points);

/// The same in both directions: (n + 1) x (m + 1) values to a net. Each border depends on its own
/// values alone.
Grid<Vec3> bezier_through(const Grid<Vec3>& points);

/// Bound on the error where |f^(n + 1)| <= size on a range of the given length:
/// size h^(n + 1) / (n + 1)! / 2^(n - 1), h half of the length.
/// Source: Davis 1963; the product of the differences to the nodes is (1 - x^2) U_(n-1) / 2^(n-1).
double interpolation_error(double size, double length, int degree);

/// Bound on how much larger than its values such an interpolant can be, for degrees up to 10.
inline constexpr double kLebesgue = 2.5;

}  // namespace blossom
