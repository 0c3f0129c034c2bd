// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces whose patches are short where a search left something open.
//
// Cells are halved down to 2^-30 of a patch, and ends of arcs are one within 1e-9 of it. On a patch
// of a hundred units both are above a tolerance of 1e-7: what touches there stays open. The answer
// does not depend on how a surface is cut into patches, so a surface with more knots round such a
// place may settle it.

#pragma once

#include <optional>

#include "core/forms/surface.h"
#include "core/results/result.h"

namespace blossom {

/// The length of a span, model units, up to which all that counts as one on it is shorter than the
/// tolerance.
double longest_span(double tolerance);

/// Which surface of an answer is meant.
enum class OpenOn { First, Second };

/// The surface with spans halved round the open places of an answer, until none that meets them is
/// longer than `longest_span`; nothing if none is, if that takes too many knots, or if the places
/// are so many that the search only ended early.
///
/// found       of this surface, which is the first or second one of it
/// tolerance   model units
std::optional<BezierSurface> with_shorter_patches(const BezierSurface& surface, OpenOn which,
                                                  const SurfaceIntersection& found,
                                                  double tolerance);

}  // namespace blossom
