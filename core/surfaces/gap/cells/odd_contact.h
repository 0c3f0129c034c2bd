// SPDX-License-Identifier: LGPL-2.1-or-later
// What a cell holds in which the surfaces touch along a line and cross there: contact of odd order.
//
// Let z be a direction in which the third derivative of the gap has one sign. On each line
// w = const the slope of the gap is least at one place, where the gap has no bend; call the line of
// these places the valley of the slope. If gap and slope are small enough along it, the gap grows
// everywhere else on the line, but for what is within the tolerance. So all zeros in the cell lie
// within a band round the valley in which the surfaces are within tolerance of each other.
//
// Source: `core/surfaces/README.md`, "Contacts".

#pragma once

#include <optional>

#include "core/surfaces/gap/cells/valley.h"

namespace blossom {

struct OddContact {
  std::optional<CellContact> contact;  ///< nothing: the line passes beside the cell
  Point4 closest{};                    ///< then: about where the gap in the cell is least
};

/// Reads a cell of surface a by its gap model.
///
/// tolerance   model units
/// returns     nothing if there may be zeros of the gap that are not in such a band
std::optional<OddContact> crossing_contact(const RationalBezierPatch& patch_a, const Cell& a,
                                           const RationalBezierPatch& patch_b,
                                           const GapModel& model, double tolerance);

}  // namespace blossom
