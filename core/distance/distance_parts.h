// SPDX-License-Identifier: LGPL-2.1-or-later
// The parts of a set whose distance is asked for, and the patches that they are made of.
//
// A part is a point, a curve, a surface, or whatever is made when a question comes near its box.
// Its items are single patches; a curve is a patch without width, a point one without any extent.

#pragma once

#include <array>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "core/bounds/box_tree.h"
#include "core/cells/cell_tree.h"
#include "core/distance.h"
#include "core/forms/patch.h"
#include "core/forms/surface.h"

namespace blossom {

/// A point, a curve or a patch of a surface, all as patches.
struct DistanceItem {
  DistanceEnd::Kind kind = DistanceEnd::Kind::Point;
  int index = 0;  ///< of the point, curve or surface
  Interval u, v;  ///< its place in the surface's own parameters
  ParameterLaw u_law = ParameterLaw::Linear, v_law = ParameterLaw::Linear;
  RationalBezierPatch patch;
  bool rational = false;
  Box box;
  /// By direction, at the low and the high border: the surface goes on there, but with a kink.
  std::array<std::array<bool, 2>, 2> kinked{};

  int dimension() const { return static_cast<int>(kind); }
  /// Of a local place in [0, 1]^2: the surface's own parameters, (t, 0) of a curve.
  Vec2 parameters(const Vec2& local) const;
  /// Whether a line that is nearest within a cell must be across its derivatives.
  std::array<bool, 2> across(const Cell& cell) const;
};

class DistanceParts {
 public:
  /// throws   InvalidInput if the set is empty or a form is not sound
  explicit DistanceParts(DistanceOperand set);
  explicit DistanceParts(OperandParts parts);

  int size() const { return static_cast<int>(parts_.size()); }
  const Box& box(int part) const { return parts_[static_cast<std::size_t>(part)].box; }
  /// Of the boxes of all parts; made when it is asked for first.
  const BoxTree& tree() const;
  const Box& bounds() const { return bounds_; }
  /// Of a part's hull, else of its box, along a direction no longer than 1.
  Interval heights(int part, const Vec3& direction) const;
  /// As its hull has it.
  double border_gap(int part) const {
    return hulls_.empty() || is_point(part)
               ? 0
               : hulls_[static_cast<std::size_t>(part - points())].border_gap;
  }
  /// No point of the border is outside of it.
  std::optional<Box> border_box(int part) const;
  struct Border {
    std::vector<DistanceItem> items;  ///< curves; empty if the border is not known any better
    double gap = 0;                   ///< how far it may be from them
  };
  /// Made when it is asked for first.
  const Border& border(int part) const;
  /// Largest absolute coordinate of a box.
  double scale() const { return scale_; }
  /// The first parts are the points that were there from the beginning.
  int points() const { return static_cast<int>(set_.points.size()); }
  bool is_point(int part) const { return part < points(); }

  /// Made when they are asked for first.
  const std::vector<DistanceItem>& items(int part) const { return made(part).items; }
  const BoxTree& item_tree(int part) const { return made(part).tree; }

  const DistanceOperand& set() const { return set_; }
  /// What a part that was asked for is made of; counted without the points.
  const DistanceOperand& own_set(int part) const;
  /// Whether none of the part's surfaces is approximated.
  bool is_exact(int part) const;

  /// Of a rectangle of an item's local parameters.
  TrimSide side(int part, const DistanceItem& item, const Vec2& low, const Vec2& high) const;
  /// Of trimmed surfaces it is not known where they have points.
  bool is_whole(const DistanceItem& item) const { return !set_.trims || item.dimension() < 2; }
  DistanceEnd end(int part, const DistanceItem& item, const Vec2& local, const Vec3& point) const;

 private:
  struct Made {
    DistanceOperand own;
    std::vector<DistanceItem> items;
    BoxTree tree{{}};
  };
  struct Part {
    Box box;
    std::once_flag once{};
    std::unique_ptr<Made> made{};
    std::once_flag border_once{};
    Border border{};
  };

  const Made& made(int part) const;
  std::unique_ptr<Made> make(int part) const;
  void finish();

  std::vector<HullBound> hulls_;  // of the parts behind the points
  DistanceOperand set_;           // all of it, or the points and trims of a set in parts
  std::function<DistanceOperand(int)> make_;
  std::function<std::optional<BorderCurves>(int)> borders_;
  mutable std::vector<Part> parts_;  // behind the points: curves and surfaces, or parts
  Box bounds_;
  double scale_ = 0;
  mutable std::once_flag tree_once_;
  mutable BoxTree tree_{{}};
};

}  // namespace blossom
