// SPDX-License-Identifier: LGPL-2.1-or-later
// The steps of an intersection, one after the other: search, contacts, chains, curves.

#pragma once

#include "core/bounds/patch_boxes.h"
#include "core/forms/surface.h"
#include "core/results/options.h"
#include "core/results/result.h"

namespace blossom {

/// A surface, which is not kept, and the boxes of its patches.
struct BoxedSurface {
  const BezierSurface& surface;
  PatchBoxes boxes;
};

/// The intersection of two surfaces. If `a` and `b` are one object, that of it with itself; its
/// glued borders have to be marked as closed then.
///
/// Arguments are checked by those who call this; the number of threads is theirs, too.
///
/// Source: `core/surfaces/README.md`.
SurfaceIntersection assembled(const BoxedSurface& a, const BoxedSurface& b,
                              const IntersectionOptions& options);

}  // namespace blossom
