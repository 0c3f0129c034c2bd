// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of a chart in which images of curves lie, between its seams.

#pragma once

#include "adapters/occt/faces/surface_projector.h"
#include "core/forms/surface.h"

namespace blossom::occt {

/// A surface with the middle of the rectangle of its parameters that counts: where it is periodic,
/// one period round the middle counts, and the rectangle has its seam there if it is all of it. One
/// that closes without a period has its seam where its parameters end.
struct ChartSheet {
  const SurfaceProjector& feet;
  Vec2 middle;
  Vec2 period;  ///< or all of the range that closes; 0 for none
  bool leaps;   ///< there is a range that closes without a period
};

ChartSheet sheet_of(const SurfaceProjector& feet, const BezierSurface& surface);

/// Parameters moved by whole periods next to the middle.
Vec2 in_sheet(const ChartSheet& sheet, Vec2 uv);

/// Rounding does not take a point over a seam.
Vec2 on_seam(const ChartSheet& sheet, Vec2 uv);

}  // namespace blossom::occt
