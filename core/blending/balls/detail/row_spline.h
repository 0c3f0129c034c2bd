// SPDX-License-Identifier: LGPL-2.1-or-later
// Least-squares splines with many columns: all rows of a strip at once.

#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace blossom {

inline constexpr int kRowDegree = 5;

/// A clamped spline of degree 5 whose values have `columns` coordinates.
struct RowSpline {
  std::vector<double> knots;        ///< increasing
  std::vector<int> multiplicities;  ///< 6 at both ends, 1..5 inside
  std::size_t columns = 0;
  std::vector<double> poles;   ///< pole by pole
  std::vector<double> flat{};  ///< knots as often as they count

  std::size_t pole_count() const { return flat.size() - kRowDegree - 1; }
};

/// What a spline is fitted to.
struct RowSamples {
  std::vector<double> parameters;              ///< not decreasing, in the knots' range
  std::vector<double> values;                  ///< sample by sample
  std::array<std::vector<double>, 2> ends;     ///< values at both ends: taken exactly
  std::array<std::vector<double>, 2> rates{};  ///< derivatives there; empty: free
};

/// The spline that minimises the sum of squares at the samples, with the ends as given.
///
/// throws    InvalidInput if a span has so few samples that the spline is not determined
/// cost      linear in samples and poles
///
/// Source: de Boor 1978, A Practical Guide to Splines, chapter 14, with one step of refinement.
RowSpline least_squares_rows(const std::vector<double>& knots,
                             const std::vector<int>& multiplicities, const RowSamples& samples);

/// Value and derivative in a span, into `columns` numbers each.
///
/// span      0 for that after the first knot
void evaluate(const RowSpline& spline, std::size_t span, double t, std::span<double> value,
              std::span<double> rate);

/// The six Bezier points of a span, one after the other.
///
/// Source: Ramshaw 1989, Proposition 9.1: blossoms at the span's ends.
std::vector<double> bezier_points(const RowSpline& spline, std::size_t span);

}  // namespace blossom
