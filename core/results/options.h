// SPDX-License-Identifier: LGPL-2.1-or-later
// What a caller may ask of an intersection.

#pragma once

#include <functional>
#include <vector>

#include "core/base/tolerances.h"
#include "core/math/interval.h"
#include "core/math/vec.h"

namespace blossom {

/// The form that the nets of cells are made from.
enum class CellForm {
  Auto,      ///< whichever has the smaller error bound
  Monomial,  ///< re-centred monomial coefficients
  Bezier,    ///< Bezier nets, halved
};

/// A curve along which the surfaces are known to touch, as where faces go on smoothly across a
/// common edge.
struct KnownCurve {
  std::vector<Vec3> points;  ///< a polygon along it, model units
  double radius = 0;         ///< what lies so near to the polygon belongs to it, model units
  double gap = 0;            ///< largest distance of the surfaces along it, model units
};

/// How a rectangle of a surface's own parameters lies to the part of the surface that counts, a
/// trimmed face, say. A test is asked by several threads at once.
enum class PartSide : char {
  Mixed,    ///< not known, or on both sides
  Inside,   ///< all of it, its border too
  Outside,  ///< nothing of it, nor of its border
};
using PartTest = std::function<PartSide(const Interval& u, const Interval& v)>;

struct IntersectionOptions {
  Tolerances tolerances{};
  CellForm form = CellForm::Auto;

  /// Pairs of cells examined before giving up with Status::Stopped.
  long budget = 2'000'000;

  /// Cells examined for contacts of surfaces that nearly touch, over all patches, before giving up
  /// likewise; 0 means no limit but those of pairs of patches.
  long contact_budget = 0;

  /// Seconds before giving up with Status::Stopped; 0 means no limit. To write down what was found
  /// by then may take a quarter longer.
  double time_limit = 0;

  /// How many may work at the same time; 0 is one a core. The result does not depend on it.
  int threads = 0;

  /// The parts of both surfaces that count; empty: everything. What is outside is not searched;
  /// curves end somewhere in it.
  PartTest part_a{}, part_b{};

  /// What lies within them is not searched, but a listed place.
  std::vector<KnownCurve> known{};

  /// Asked now and then; true stops the work with Status::Stopped.
  std::function<bool()> cancelled{};
};

}  // namespace blossom
