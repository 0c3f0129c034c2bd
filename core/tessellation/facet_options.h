// SPDX-License-Identifier: LGPL-2.1-or-later
// How fine facets are to be.

#pragma once

namespace blossom {

struct FacetOptions {
  /// Largest distance between facets and surfaces, both ways; model units.
  double deviation = 0.1;
  /// Largest turn of the normal along one side of a facet, about; radians, 0 for any. With it a
  /// small hole stays round though the deviation would let it become a triangle.
  double angle = 0.5;
  /// Largest length of a side, about; model units, 0 for any.
  double edge_length = 0;
  /// How much longer than wide facets may be, about, where the surface bends; 0 for 16. They follow
  /// the curvature, which in one direction may be much less than in the other.
  double aspect = 0;
};

}  // namespace blossom
