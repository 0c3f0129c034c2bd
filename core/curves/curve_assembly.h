// SPDX-License-Identifier: LGPL-2.1-or-later
// From what a search over pairs of pieces found to the intersection of two curves: the same point
// once, contacts as points or runs, and a proof or a place for each.

#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/curves/curve_search.h"
#include "core/math/interval.h"
#include "core/results/curve_result.h"

namespace blossom {

class CurveAssembly {
 public:
  CurveAssembly(CurveTree& a, CurveTree& b, double tolerance);

  /// Ends of spans that are within the tolerance of the other curve, both ways.
  void find_ends();

  /// Common parts that start or end at one of these.
  std::vector<SharedSpans> shared_parts() const;

  CurveIntersection finish(const std::vector<SharedSpans>& shared, const CurveFindings& found);

 private:
  static constexpr int kSamples = 33;  // of a run

  struct Candidate {
    SpanPoint a, b;
    double at_a = 0, at_b = 0;  // parameters of the curves
    CurveFoot foot;
    ValueRange gap;
    double half_length = 0;
    bool touch = false;
    bool proven = false;
    bool crosses = false;  // not proven, but the curves change sides
    Interval box_a, box_b;
    double sine = 0;
  };

  Candidate candidate(const SpanPoint& a, const SpanPoint& b) const;
  Candidate candidate(const CurveFoot& foot) const;
  void add_ends(bool of_a);
  bool is_kink(const CurveTree& tree, const SpanPoint& at) const;
  void prove(Candidate& point) const;
  bool prove_at_border(Candidate& point, double reach_a, double reach_b) const;
  bool same(const Candidate& p, const Candidate& q) const;
  bool connected(const Candidate& p, double at_a, double at_b) const;
  bool are_one(const Candidate& p, double at_a, double at_b) const;
  void add(Candidate point);
  void add_overlaps(const std::vector<SharedSpans>& shared);
  bool is_on(const CurveOverlap& run, const Candidate& point) const;
  bool on_overlap(const Candidate& point) const;
  bool beside_overlap(const Candidate& point) const;
  void add_contacts(std::vector<CurveContact> contacts);
  void add_run(const CurveContact& run);
  CurveFoot foot_of(const CurveOverlap& run, double part) const;
  Interval reach_of(const CurveOverlap& run) const;
  bool is_at_end(const CurveFoot& foot) const;
  std::array<double, kSamples> gaps_in(const CurveOverlap& run, const Interval& reach) const;
  bool is_common(const CurveOverlap& run) const;
  std::vector<std::array<double, 2>> stops_along(const CurveOverlap& run) const;
  bool is_near(const CurveOverlap& run, double most) const;
  bool is_near(const Interval& on_a, const Interval& on_b, double most, int depth) const;
  std::optional<CurveOverlap> end_to_end(const CurveOverlap& run) const;
  bool is_part_of_one(const CurveOverlap& run, const std::vector<CurveOverlap>& of) const;
  void join_overlaps();
  Candidate nearest_in(const CurveOverlap& run, double sample) const;
  void add_cusp(const CurveContact& run);
  CurveOverlap trimmed(const CurveContact& run) const;
  void write(CurveIntersection& result) const;
  CurvePlace place_of(const Candidate& point) const;

  CurveTree& a_;
  CurveTree& b_;
  double tolerance_;
  bool itself_;
  double margin_;
  double touch_length_;
  std::vector<Candidate> ends_;
  std::vector<Candidate> points_;
  std::vector<CurveOverlap> overlaps_;
  std::vector<CurvePlace> places_;
};

}  // namespace blossom
