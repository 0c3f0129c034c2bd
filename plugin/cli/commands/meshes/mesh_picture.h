// SPDX-License-Identifier: LGPL-2.1-or-later
// Pictures of files of triangles.

#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "plugin/cli/picture/picture.h"
#include "plugin/meshes/mesh_files.h"

namespace blossom::cli {

/// Radians; what most programs smooth over.
inline constexpr double kUsualCrease = 40 * std::numbers::pi / 180;

/// Its groups as the faces of a picture, each colour of the file apart. Outlines are the sides of
/// one triangle of a group, also where another group goes on, and those at which triangles turn by
/// more than kUsualCrease.
///
/// name      of what has no colour in the file, in the legend
/// throws    Interrupted if the user has asked to stop
std::vector<PictureFaces> mesh_faces(const meshes::FileMesh& mesh, const std::string& name,
                                     const Vec3& colour, double opacity);

/// Sides of more than two triangles, others that are open, and others that are turned: a layer
/// each.
///
/// throws    Interrupted if the user has asked to stop
std::vector<PictureLayer> faulty_side_layers(const meshes::FileMesh& mesh);

}  // namespace blossom::cli
