// SPDX-License-Identifier: LGPL-2.1-or-later
// The steps of an intersection, one after the other: search, contacts, chains, curves.

#pragma once

#include "core/forms/surface.h"
#include "core/intersection/options.h"
#include "core/intersection/result.h"

namespace blossom {

/// The intersection of two surfaces. If `a` and `b` are one object, that of it with itself; its
/// glued borders have to be marked as closed then.
///
/// Arguments are checked by those who call this; the number of threads is theirs, too.
///
/// Source: `core/README.md`, "Intersection".
SurfaceIntersection assembled(const BezierSurface& a, const BezierSurface& b,
                              const IntersectionOptions& options);

}  // namespace blossom
