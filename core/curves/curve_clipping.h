// SPDX-License-Identifier: LGPL-2.1-or-later
// What fat lines leave of curve cells: the parts in which they may be near each other or a point.
//
// Along a normal the value of a cell less a bound is a polynomial in Bernstein form. It is not
// above 0 only where the convex hull of its control points is not, so a crossing leaves little of
// both cells after a step or two where halving takes many.
//
// Source: Sederberg and Nishita 1990.

#pragma once

#include <array>
#include <optional>

#include "core/curves/curve_pair.h"
#include "core/forms/curve.h"

namespace blossom {

/// Parts of two cells, of [0, 1] each.
struct CellParts {
  Interval a{0, 1};
  Interval b{0, 1};
};

/// The values of two directed cells along the normals of their fat lines; in space, of fat planes,
/// and along the common normal of the chords. Nothing is known of cells without a chord.
class FatLines {
 public:
  FatLines(const CurvePair& pair, double tolerance);

  /// True if the distance of all points of the cells is above the tolerance, rounding included.
  bool separated() const { return separated_; }

  /// True if both cells lie in a strip (a rod, in space) no wider than `width`.
  bool within_strip(double width) const;

  /// The parts outside of which no point of a cell is within the tolerance of the other cell;
  /// nothing: there is no such point.
  std::optional<CellParts> parts() const;

 private:
  // Values along a normal and their ranges, margins included; of a cell along its own fat line the
  // range is enough.
  struct Line {
    ValueRange a, b;
    bool has_a = false, has_b = false;
    std::array<double, kMaxDegree + 1> on_a, on_b;
  };

  bool add(const Vec3& normal, bool with_a, bool with_b);

  CurvePair pair_;
  double tolerance_;
  bool separated_ = false;
  int count_ = 0;
  std::array<Line, 3> lines_;
};

/// The part of a directed cell outside of which it is farther from a point than the tolerance;
/// nothing if all of it is.
std::optional<Interval> part_near(const CurveTree& tree, const CurveCell& cell, const Vec3& point,
                                  double tolerance);

}  // namespace blossom
