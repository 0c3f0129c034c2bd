// SPDX-License-Identifier: LGPL-2.1-or-later
// The geometry of the samples: the skin of a 12 m boat, its deck, and the tunnel of a bow
// thruster. Millimetres; x runs forward, y to port, z up.

#pragma once

#include <Geom_BSplineSurface.hxx>

namespace blossom::samples {

/// The skin from the transom to the stem, one surface from port sheer over the keel to starboard
/// sheer: bicubic B-spline of 9 x 9 poles, 6 x 6 spans.
Handle(Geom_BSplineSurface) hull_skin();

/// A deck with camber and sheer that reaches out over the skin; bicubic, its normal points up.
Handle(Geom_BSplineSurface) deck();

/// A tube across the bow that widens towards both mouths: rational, exact circles around its axis;
/// its normal points away from the axis.
Handle(Geom_BSplineSurface) thruster_tunnel();

}  // namespace blossom::samples
