// SPDX-License-Identifier: LGPL-2.1-or-later
// What a search over pairs of cells has found: arcs, contacts, and the pairs it left critical.

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/cells/points.h"
#include "core/results/result.h"
#include "core/surfaces/gap/cells/valley.h"
#include "core/surfaces/pairs/border_roots.h"

namespace blossom {

/// The contact of a branch that runs into one in another pair of patches.
inline constexpr int kContactElsewhere = -2;

/// Of arcs between known points that no pair of cells holds.
inline constexpr Box4 kNoBox{Interval{0, 0}, Interval{0, 0}, Interval{0, 0}, Interval{0, 0}};

/// An arc of the intersection in a pair of patches.
struct FoundArc {
  int patch_a = 0;
  int patch_b = 0;
  Box4 box;  ///< the certified pair it lies in, or kNoBox
  CellArc arc;
  std::array<int, 2> contact{-1,
                             -1};  ///< by end: the contact it runs into, kContactElsewhere, or -1
  bool dropped = false;            ///< it is part of a contact
  bool to_pole = false;            ///< it ends at a pole
};

/// A piece of contact in a pair of patches.
struct FoundContact {
  int patch_a = 0;
  int patch_b = 0;
  CellContact contact;
};

/// A point where the intersection passes a corner of a pair without entering it.
struct CornerContact {
  int patch_a = 0;
  int patch_b = 0;
  Point4 x;
};

/// A pair of cells that could be neither excluded nor certified.
struct CriticalPair {
  int patch_a = 0;
  int patch_b = 0;
  Box4 box;
  Vec3 low, high;                  ///< the common part of their boxes, relative to the origin
  bool within_tolerance = false;   ///< the surfaces stay within tolerance of each other in it
  std::optional<Point4> beside{};  ///< near a contact outside of it there may be zeros, else none
  bool singular = false;  ///< of a surface with itself: cells that touch where it is singular
  bool shared = false;    ///< the patches are proven to be parts of one surface
};

struct PairSearchResult {
  std::vector<FoundArc> arcs;
  std::vector<std::array<std::size_t, 2>> joins;  ///< ends of arcs, 2 * arc + side, that are one
  std::vector<std::size_t> swapped;               ///< ends, as above: see `agree_on_sides`
  std::vector<CornerContact> corner_contacts;
  std::vector<FoundContact> contacts;
  std::vector<CriticalPair> critical;
  std::vector<CriticalPair> slow;  ///< where surfaces that cross slowly stay within tolerance
  Certificate certificate;
  bool cut_by_samples = false;  ///< branches were cut at a border by points, not by proof
  bool along_border = false;    ///< an arc runs along a border, not proven; see PairArcs
  bool beside_known = false;    ///< something near a known curve was not searched
  bool stopped = false;
  bool cancelled = false;  ///< stopped by the user
  long contact_cells = 0;  ///< examined by searches for contacts
};

}  // namespace blossom
