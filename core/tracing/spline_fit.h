// SPDX-License-Identifier: LGPL-2.1-or-later
// Quintic splines through an intersection curve: its image in space and in both charts at once.
//
// The curve is one function of arc length with seven coordinates, (x, y, z, u_a, v_a, u_b, v_b).
// It is known by quintic Hermite pieces between traced points. A least-squares spline with simple
// knots takes about half their coefficients for the same accuracy, since neighbouring pieces then
// share four derivatives instead of two.

#pragma once

#include <array>
#include <vector>

#include "core/math/interval.h"
#include "core/math/vec.h"

namespace blossom {

using Vec7 = Vec<double, 7>;

inline constexpr int kFitDegree = 5;

/// Bezier points of a polynomial of degree 5.
using QuinticPoints = std::array<Vec7, 6>;

/// Such a polynomial over an interval of arc length.
struct QuinticPiece {
  Interval place;
  QuinticPoints points{};
};

/// The Bezier points of the polynomial of degree 5 over a width that takes position and two
/// derivatives from both ends (Hermite).
template <class Point>
std::array<Point, 6> hermite_points(const std::array<Point, 3>& start,
                                    const std::array<Point, 3>& stop, double width) {
  std::array<Point, 6> c;
  c[0] = start[0];
  c[1] = c[0] + start[1] * (width / 5);
  c[2] = 2 * c[1] - c[0] + start[2] * (width * width / 20);
  c[5] = stop[0];
  c[4] = c[5] - stop[1] * (width / 5);
  c[3] = 2 * c[4] - c[5] + stop[2] * (width * width / 20);
  return c;
}

/// The value at parameter `t` in 0..1.
Vec7 value_at(const QuinticPoints& points, double t);

/// A spline over one smooth run, and how it was made: simple knots inside, end points of
/// multiplicity 6.
struct RunSpline {
  std::vector<double> knots;  ///< spans + 1 of them, increasing
  std::vector<Vec7> poles;    ///< spans + 5
  std::vector<Vec7> values;   ///< at kJudgedChecks of every span, in order
};

/// Where in a span the pieces are sampled, and the spline with them.
inline constexpr std::array kFitChecks{0.1, 0.3, 0.5, 0.7, 0.9};
/// Those of them by which a spline is judged: all five told hardly more of its largest errors.
inline constexpr std::array<std::size_t, 3> kJudgedChecks{0, 2, 4};

/// The least-squares spline with given simple knots. Position and two derivatives at both ends
/// are those of the pieces, exactly; the rest minimises the sum of squares of the distances to the
/// pieces at kFitChecks of every span.
///
/// pieces    contiguous, at least one
/// knots     increasing, at least 2, from the start of the first piece to the end of the last
/// returns   one span: the Hermite polynomial of both ends
/// throws    InvalidInput if there is no piece, or the knots do not increase
/// cost      linear in spans and pieces
///
/// Source: de Boor 1978, A Practical Guide to Splines, chapter 14.
RunSpline least_squares_spline(const std::vector<QuinticPiece>& pieces,
                               const std::vector<double>& knots);

}  // namespace blossom
