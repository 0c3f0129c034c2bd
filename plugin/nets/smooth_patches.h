// SPDX-License-Identifier: LGPL-2.1-or-later
// Curved patches over the triangles of a mesh, and what is told of them; see
// plugin/cli/schemas/mesh-patches-1.md.

#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "adapters/occt/shapes.h"
#include "core/math/vec.h"
#include "plugin/nets/conversion.h"
#include "plugin/nets/net.h"
#include "plugin/reports/text/json.h"

namespace blossom::nets {

struct SmoothPatches {
  std::vector<Net> nets;      ///< of degree 4, three for each triangle
  std::size_t triangles = 0;  ///< of the mesh
  double crease = 0;          ///< radians
  std::size_t smooth_sides = 0, sharp_sides = 0;
  double largest_angle = 0;  ///< over smooth sides, radians
};

/// See core/meshes/smooth_triangles.h.
///
/// crease   sides at which neighbours turn by so much stay sharp, radians
/// form     Bezier: patches one side of which is a point; Triangles: as they are
/// file     what the nets are of
SmoothPatches smooth_patches(std::span<const Vec3> points,
                             std::span<const std::array<int, 3>> triangles, double crease,
                             TargetForm form, const std::string& file, const Stop& stop);

/// All patches as one part.
occt::Model model_of(const SmoothPatches& made, const Stop& stop);

/// Schema blossom.mesh-patches/1.
/// output   the file's name, or null
/// notes    of the mesh
reports::Json smooth_patches_report(const std::string& file, const reports::Json& output,
                                    const SmoothPatches& made,
                                    const std::vector<std::string>& notes, double seconds);

}  // namespace blossom::nets
