// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces without spans that are narrower than trims can tell.

#pragma once

#include "core/forms/surface.h"
#include "core/regions/limits.h"

namespace blossom {

/// The surface without its narrow spans: the patches before them, or after them if they are the
/// first, reach to their other end, and have the points there for their last row.
///
/// surface   polynomial, of linear parameters; all patches of one degree, and not all narrow
/// returns   the surface; `error` has grown by a bound on the way of any point at equal parameters
BezierSurface without_narrow_spans(BezierSurface surface);

}  // namespace blossom
