// SPDX-License-Identifier: LGPL-2.1-or-later
// The faces of a picture as triangles.

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/math/vec.h"
#include "plugin/pictures/scene/mesh.h"
#include "plugin/pictures/scene/picture.h"

namespace blossom::pictures {

struct SceneMesh {
  PictureMesh own;                     ///< of a face
  std::size_t group = 0;               ///< of the picture
  std::size_t face = 0;                ///< of the group
  const PictureMesh* given = nullptr;  ///< one that the picture holds, which outlives this

  const PictureMesh& mesh() const { return given != nullptr ? *given : own; }
};

/// All faces as triangles that are off by less than a pixel of the picture.
///
/// coarseness   1: what a picture shows as smooth; triangles are about so many times as long
/// throws       InvalidInput if the view is none
std::vector<SceneMesh> scene_meshes(const Picture& picture, double coarseness = 1);

/// Corners of all triangles, three after three.
std::vector<Vec3> scene_corners(const std::vector<SceneMesh>& meshes);

/// The direction to the eye: the picture's own, or the default one of what there is to see.
Vec3 scene_direction(const Picture& picture, const std::vector<Vec3>& corners);

/// What is not shown of it as it is: "the picture shows 2 faces by edges alone: ...", for each
/// cause.
std::vector<std::string> notes_on(const std::vector<SceneMesh>& meshes);

}  // namespace blossom::pictures
