// SPDX-License-Identifier: LGPL-2.1-or-later
// A whole contact of two surfaces: a point, a node or a tangential curve.

#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/bounds/box_tree.h"
#include "core/surfaces/contacts/critical_places.h"
#include "core/surfaces/pairs/pair_search_result.h"

namespace blossom {

/// An end of a found arc: 2 * arc for `from`, 2 * arc + 1 for `to`.
using ArcEnd = std::size_t;

inline const Point4& end_of(const PairSearchResult& found, ArcEnd end) {
  const CellArc& arc = found.arcs[end / 2].arc;
  return end % 2 == 0 ? arc.from : arc.to;
}

/// Why a result with such a contact is no better.
inline constexpr const char* kEndsBesideNode =
    "branches end on the border of a region in which several meet, or nearly";

/// A larger cluster is more than a point. Of the size.
inline constexpr double kPointCluster = 1e-2;

struct ContactPoint {
  int patch_a = 0;
  int patch_b = 0;
  Point4 x{};
  double gap = 0;        ///< distance of the surfaces there, model units
  bool crosses = false;  ///< the surfaces also cross along the contact
};

/// A connected contact: a path along which the surfaces stay within tolerance.
struct ContactChain {
  std::vector<ContactPoint> path;
  std::array<std::vector<ArcEnd>, 2> arms;  ///< branches that begin at either end of it
  std::array<bool, 2> leaves{};  ///< by end: on its cell's border, without a contact beyond
  bool closed = false;
  bool curve = false;       ///< a tangential curve; else a point: a touch, a node, a fold or a cusp
  bool pole = false;        ///< a point that one of the surfaces has under many parameters
  bool parted = false;      ///< its two arms do not go on into each other, at a pole perhaps
  bool straight = false;    ///< its two arms go straight on into each other
  bool passed = false;      ///< likewise, and they are tangential curves
  bool high_order = false;  ///< a node in which the surfaces agree up to the second order or more
  bool passed_by = false;   ///< likewise, and a branch ends beside it
  bool regular = false;     ///< a point in which the surfaces cross, see crosses_regularly
  ContactPoint centre;      ///< of a point
  double length = 0;        ///< model units
  Box box;                  ///< of the path, relative to the origin

  std::size_t arm_count() const { return arms[0].size() + arms[1].size(); }

  /// Near a border a node of a high order may have but two arms.
  bool is_node() const { return arm_count() > 2 || (high_order && parted); }

  /// Of one that is no curve.
  PlaceKind kind_of_point() const {
    if (arm_count() == 0) return PlaceKind::Touch;
    if (is_node()) return PlaceKind::Node;
    if (straight) return PlaceKind::Tangential;
    return pole ? PlaceKind::Pole : arm_count() == 2 ? PlaceKind::Cusp : PlaceKind::Node;
  }
};

}  // namespace blossom
