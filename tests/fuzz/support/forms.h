// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves and surfaces of all kinds that are hard: on small lattices, so that borders, corners and
// whole pieces coincide; degenerate; nearly those of another one; huge, tiny, and far away.

#pragma once

#include "core/forms/curve_spans.h"
#include "core/forms/surface.h"
#include "core/results/options.h"
#include "tests/fuzz/support/choices.h"

namespace blossom::fuzz {

/// Well formed or not.
BezierSurface surface_of(Choices& choices);
CurveSpans curve_of(Choices& choices);

/// Another surface, perhaps a copy of that one that is moved, turned around, or changed a little.
BezierSurface surface_beside(const BezierSurface& first, Choices& choices);
CurveSpans curve_beside(const CurveSpans& first, Choices& choices);

/// A curve on the surface, or near it, or any.
CurveSpans curve_near(const BezierSurface& surface, Choices& choices);

/// So that no input takes long by what it asks for.
IntersectionOptions options_of(Choices& choices);

}  // namespace blossom::fuzz
