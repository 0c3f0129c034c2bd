// SPDX-License-Identifier: LGPL-2.1-or-later
// The loops of a face as curves on its surface.

#pragma once

#include <optional>
#include <vector>

#include "core/forms/curve.h"
#include "core/forms/surface.h"
#include "core/topology/face_trims.h"

namespace blossom {

/// S(p(t)) for all coedges p of the loops, each cut at the knots of S, to 1e-12 of a span: where p
/// has too high a degree or a parameter of S is an angle, short pieces have polynomials instead
/// (core/tracing/local_form.h).
///
/// surface   of the trims, in its own parameters
/// returns   nothing where no such form is found; of rational p where a parameter is an angle
std::optional<std::vector<RationalBezierCurve>> border_curves(const FaceTrims& trims,
                                                              const BezierSurface& surface);

}  // namespace blossom
