// SPDX-License-Identifier: LGPL-2.1-or-later
// A model cut by many planes, part by part, for which it is made ready once.

#pragma once

#include <functional>
#include <vector>

#include "adapters/occt/shapes.h"
#include "core/results/options.h"
#include "plugin/reports/models/input.h"
#include "plugin/reports/queries/section.h"

namespace blossom::reports {

/// Asked for every part and plane.
struct CutControl {
  double tolerance = 0;                         ///< what counts as one point, model units
  std::function<IntersectionOptions()> engine;  ///< options with what is left of the limits
  std::function<void()> stop;                   ///< ends the work by an exception
};

/// The parts that each plane meets, their closed wires turned as `orient_wires` does.
/// throws   BadModel if a face cannot be used, and what `stop` throws
SectionsAnswer sections_of(const Input& input, const std::vector<NamedPlane>& planes,
                           const CutControl& control);

/// An assembly for each plane, in it the wires and points of each of its parts; no shape if there
/// are none.
occt::Model model_of(const SectionsAnswer& answer);

}  // namespace blossom::reports
