// SPDX-License-Identifier: LGPL-2.1-or-later
// The search over pairs of pieces of two curves, or of one curve with itself.
//
// Each pair ends as excluded (boxes or fat lines apart), as certified (directions apart, or a
// convex gap: what it holds is found by Newton's method), as a contact (both pieces within
// tolerance of each other all over), or is halved.

#pragma once

#include <utility>
#include <vector>

#include "core/curves/curve_clipping.h"
#include "core/curves/curve_valley.h"
#include "core/curves/shared_curve.h"
#include "core/results/options.h"

namespace blossom {

/// A common part of two spans.
struct SharedSpans {
  int span_a = 0;
  int span_b = 0;
  SharedCurve shared;
};

/// Two pieces that stay within tolerance of each other.
struct CurveContact {
  Interval a;  ///< parameters of the curves, increasing
  Interval b;
  bool reversed = false;    ///< the directions are opposite
  bool neighbours = false;  ///< of one curve, and they share an end: a cusp
};

struct CurveFindings {
  std::vector<ValleyPoint> points;
  std::vector<CurveContact> contacts;
  std::vector<CurveContact> open;  ///< not examined when the search was stopped
  long excluded = 0;
  long certified = 0;
  const char* stopped = nullptr;  ///< why
};

class CurveSearch {
 public:
  /// `a` and `b` may be the same tree; then common points of different pieces are sought.
  CurveSearch(CurveTree& a, CurveTree& b, const IntersectionOptions& options, double tolerance)
      : a_(a), b_(b), options_(options), tolerance_(tolerance), itself_(&a == &b) {}

  /// shared   common parts; they are not searched
  CurveFindings run(const std::vector<SharedSpans>& shared);

 private:
  void add_spans();
  void examine(int index_a, int index_b);
  bool is_shared(const CurvePair& pair) const;
  bool are_neighbours(const CurveCell& a, const CurveCell& b) const;
  CurveFoot at_common_end(const CurvePair& pair, const CurveFoot& foot, double rounding) const;
  void add_points(const CurvePair& pair, const ValleyPoints& points);
  bool settle(const CurvePair& pair, double sine);
  bool settle_outside(const CurvePair& pair, CurveFoot foot);
  void add_contact(const CurvePair& pair, std::vector<CurveContact>& list);
  void add_contact(const CurvePair& pair, const Interval& a, const Interval& b,
                   std::vector<CurveContact>& list);
  bool clip(int index_a, int index_b, const FatLines& lines);
  void halve(int index_a, int index_b, bool first);

  CurveTree& a_;
  CurveTree& b_;
  const IntersectionOptions& options_;
  double tolerance_;
  bool itself_;
  double longest_valley_ = 0;
  const std::vector<SharedSpans>* shared_ = nullptr;
  std::vector<std::pair<int, int>> pairs_;
  CurveFindings found_;
};

/// The places of a curve that are within the tolerance of a point.
///
/// Cells are followed down to where their directions lie in a narrow cone; there the component
/// along its axis leaves one candidate.
std::vector<SpanPoint> feet_near(CurveTree& tree, const Vec3& point, double tolerance);

/// The foot of a point near a parameter of the curve, followed over the joins of spans.
SpanPoint foot_along(const CurveTree& tree, const Vec3& point, double parameter);

}  // namespace blossom
