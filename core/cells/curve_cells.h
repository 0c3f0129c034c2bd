// SPDX-License-Identifier: LGPL-2.1-or-later
// The cells of a curve: a binary tree of pieces for each span, made when asked for and kept.
//
// A cell carries its control points (from `core/subdivision`, nothing else), a box and a cone that
// holds all its directions. Every bound contains the rounding of the net it was made from.

#pragma once

#include <array>
#include <cstddef>
#include <memory_resource>

#include "core/forms/curve_spans.h"
#include "core/forms/evaluation.h"
#include "core/math/interval.h"
#include "core/math/value_range.h"
#include "core/math/vec.h"
#include "core/subdivision/cell_nets.h"

namespace blossom {

struct CurveCell {
  int span = 0;
  int depth = 0;   ///< cuts since the whole span
  int child = -1;  ///< index of the lower half, the upper one follows; -1: none
  Interval local;  ///< place in the span's [0, 1]
  int points = 0;  ///< degree + 1
  const double* homogeneous = nullptr;  ///< Bezier net, `dimension` planes and one of weights
  const double* hull = nullptr;         ///< control points in space, `dimension` planes
  double margin = 0;                    ///< rounding of a hull coordinate, model units
  Vec3 low, high;                       ///< box of the hull, margin included
  double extent = 0;                    ///< longest side of the box
  Vec3 axis;                            ///< direction of the chord; zero: none
  /// Of half the cone round `axis` that holds all directions; -1: no cone.
  double cosine = -1;
  // In the plane; the second is there if the cosine is above 0.
  ValueRange across;      ///< of the fat line along the chord; margin included
  Vec3 right, left;       ///< between these directions of length 1 are all of the cell
  bool directed = false;  ///< axis, cone and fat line are known; see `direct`
};

/// Where a parameter of the whole curve lies.
struct SpanPoint {
  int span = 0;
  double t = 0;  ///< local, in [0, 1]
};

class CurveTree {
 public:
  /// curve      its points are taken relative to `origin`, to keep digits far from zero
  /// dimension  2 leaves out z, which has to be 0 everywhere
  /// curve      has to live as long as the tree
  CurveTree(const CurveSpans& curve, const Vec3& origin, int dimension);
  CurveTree(const CurveTree&) = delete;
  CurveTree& operator=(const CurveTree&) = delete;

  const CurveCell& operator[](int index) const { return cells_[static_cast<std::size_t>(index)]; }

  /// Cell i is span i.
  int spans() const { return static_cast<int>(curve_.spans.size()); }

  /// Makes the axis, the cone and the fat line of a cell, if they are not there: most cells are
  /// excluded by their boxes before anyone asks.
  void direct(int index) {
    CurveCell& cell = cells_[static_cast<std::size_t>(index)];
    if (!cell.directed) bound_directions(cell);
  }

  /// Index of the lower half of a cell, made if it is not there. Invalidates references.
  int split(int index);

  /// Index of a part of a cell, of [0, 1]; made each time, unless it is the whole. Invalidates
  /// references.
  int part(int index, const Interval& part);

  /// ValueRange of the first (second) derivative's component along a direction over a cell, by the
  /// cell's own parameter in [0, 1]; rounding included.
  std::array<ValueRange, 2> derivative_ranges(const CurveCell& cell, const Vec3& direction) const;

  /// Value and derivatives on a span, relative to the origin.
  CurveJet jet(const SpanPoint& at) const {
    return jet_at(curve_.spans[static_cast<std::size_t>(at.span)].curve, at.t);
  }

  /// The same point for t = 0 or 1, bit for bit: a control point.
  Vec3 end_point(const SpanPoint& at) const;

  /// Bound on the error of a coordinate of such a point, model units.
  double evaluation_margin() const { return evaluation_margin_; }

  /// Bound on the length of the second derivative by the span's local parameter, over the smallest
  /// cell made so far that holds all of the span within `reach` of a place.
  double bend_near(const SpanPoint& at, double reach) const;

  /// Makes smaller cells there, down to a few times the reach. Invalidates references.
  void split_near(const SpanPoint& at, double reach);

  double parameter(const SpanPoint& at) const;
  SpanPoint place(double parameter) const;

  /// The neighbour's place at the same point of the curve, for t = 0 or 1; the place itself at an
  /// end of the curve.
  SpanPoint across_join(const SpanPoint& at) const;
  bool is_free_end(const SpanPoint& at) const;

  /// The curve stays within twice `reach` of its points at two parameters between those; for a
  /// closed curve perhaps over its seam.
  bool stays_near(double p, double q, double reach) const;

  /// Longest side of the box of the whole curve.
  double size() const;

  const CurveSpans& curve() const { return curve_; }  ///< relative to the origin
  int dimension() const { return dimension_; }
  bool closed() const { return closed_; }  ///< the last point is the first one, bit for bit
  double largest_margin() const { return largest_margin_; }
  int depth() const { return depth_; }

 private:
  static constexpr std::size_t kFirstRoom = 12 << 10;

  double* allocate(int count);
  void add_span(int span);
  void finish(CurveCell& cell);
  int cell_near(const SpanPoint& at, double reach) const;
  int add_cell(const CurveCell& parent, int cuts, const Interval& local, const double* net);
  void bound_directions(CurveCell& cell) const;
  void bound_in_plane(CurveCell& cell) const;

  CurveSpans moved_;  // relative to the origin, if that is not 0
  const CurveSpans& curve_;
  int dimension_;
  bool closed_ = false;
  double hull_scale_ = 0;  // largest absolute coordinate of a control point in space, or origin
  double evaluation_margin_ = 0;
  double largest_margin_ = 0;
  int depth_ = 0;
  // Most searches need no more room than this.
  alignas(std::max_align_t) std::array<std::byte, kFirstRoom> first_room_;
  std::pmr::monotonic_buffer_resource room_{first_room_.data(), first_room_.size()};
  std::pmr::vector<CurveCell> cells_{&room_};
};

/// ValueRange of the components of the control points along a direction of length 1; margin
/// included.
ValueRange range_along(const CurveCell& cell, int dimension, const Vec3& direction);

}  // namespace blossom
