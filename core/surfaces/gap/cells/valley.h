// SPDX-License-Identifier: LGPL-2.1-or-later
// What a cell holds in which the gap is strictly convex in one direction.
//
// Let z be that direction and w the other one. On each line w = const the gap has one least
// value m(w), along the valley, and so at most two zeros, a lower and an upper one. All there is
// to know is where m changes its sign, and how branches and valley cross the border of the cell.
// A sweep along w then gives every branch with its ends. Where |m| stays within tolerance the
// surfaces are in contact: a piece of valley instead of two branches.
//
// Source: `core/surfaces/README.md`, "Contacts".

#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/base/tolerances.h"
#include "core/cells/points.h"
#include "core/surfaces/gap/gap_model.h"

namespace blossom {

/// A branch of the intersection inside a cell, as points on both patches in order.
struct CellBranch {
  std::vector<Point4> path;
  std::array<int, 2> contact{-1, -1};  ///< by end: the contact it runs into, if any
};

/// A piece of valley along which the surfaces stay within tolerance.
struct CellContact {
  std::vector<Point4> path;
  std::vector<double> gaps;      ///< along the path, model units
  std::array<bool, 2> leaves{};  ///< by end: it goes on in the neighbouring cell
  bool crosses = false;          ///< the surfaces also cross along it
};

struct ValleyCell {
  std::vector<CellBranch> branches;
  std::vector<CellContact> contacts;
};

struct ValleyOptions {
  double tolerance = Tolerances{}.point;  ///< model units
  double size = 1;                        ///< of the surfaces, model units
};

/// Reads a cell of surface a by its gap model.
///
/// returns   nothing if the gap is not convex in one direction or some sign stays undecided
std::optional<ValleyCell> valley_cell(const RationalBezierPatch& patch_a, const Cell& a,
                                      const RationalBezierPatch& patch_b, const GapModel& model,
                                      const ValleyOptions& options);

}  // namespace blossom
