// SPDX-License-Identifier: LGPL-2.1-or-later
// What a strip gives to the fill of a corner in which it ends.

#pragma once

#include <cstddef>

#include "adapters/occt/blending/strips/rolled_strip.h"
#include "core/blending/fills/fill_side.h"

namespace blossom::occt {

/// The section of a strip as a side of a hole: exact where it is a circle's arc of a cylinder,
/// cone, torus or sphere, or lies in one span across; else fitted by polynomials.
///
/// t          of the section
/// ahead      whether the strip lies at larger t, the hole at smaller
/// from       the contact at which the side begins, 0 or 1
/// tolerance  of the fit: model units, and radians times the width of the section
/// throws     Failure if no polynomial is near enough
FillSide section_side(const RolledStrip& strip, double t, bool ahead, std::size_t from,
                      double tolerance);

}  // namespace blossom::occt
