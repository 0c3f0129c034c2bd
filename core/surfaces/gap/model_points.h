// SPDX-License-Identifier: LGPL-2.1-or-later
// Points of a gap model on the original patches.

#pragma once

#include <optional>

#include "core/surfaces/gap/contact_points.h"
#include "core/surfaces/gap/gap_model.h"
#include "core/surfaces/gap/turned_axes.h"

namespace blossom {

/// The points over a cell of surface a, by turned axes. What it is made from has to
/// outlive it.
class ModelPoints {
 public:
  ModelPoints(const RationalBezierPatch& patch_a, const Cell& a, const RationalBezierPatch& patch_b,
              const GapModel& model, const TurnedAxes& axes)
      : patch_a_(patch_a), a_(a), patch_b_(patch_b), model_(model), axes_(axes) {}

  /// As the model says.
  Point4 at(double w, double z) const;

  /// w of a point.
  double w_of(const Point4& x) const;

  /// The gap of a solution, model units.
  double gap(const Point4& x) const;

  /// How far a parameter may move from what the model says.
  double reach() const;

  /// w = const in the four parameters.
  Point4 line() const;

  /// The direction z in the parameters of a.
  Vec2 across() const;

  /// Puts a point on an edge of the cell and returns the plane of that edge.
  Point4 fix_edge(int edge, Point4& x) const;

  /// The point near (w, z) on the line w = const where the surfaces touch; see TouchLine.
  std::optional<Point4> on_touch(double w, double z, bool cross) const;

  /// The same on an edge, exactly.
  std::optional<Point4> on_touch_at(int edge, double w, double z, bool cross) const;

 private:
  const RationalBezierPatch& patch_a_;
  const Cell& a_;
  const RationalBezierPatch& patch_b_;
  const GapModel& model_;
  const TurnedAxes& axes_;
};

}  // namespace blossom
