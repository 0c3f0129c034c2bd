// SPDX-License-Identifier: LGPL-2.1-or-later
// Pictures of files of triangles.

#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "core/meshes/mesh_facts.h"
#include "plugin/cli/picture/picture.h"
#include "plugin/meshes/mesh_files.h"

namespace blossom::cli {

/// Radians; what most programs smooth over.
inline constexpr double kUsualCrease = 40 * std::numbers::pi / 180;

/// Its groups as the faces of a picture, each colour of the file apart; sides at which triangles
/// turn by more than kUsualCrease are outlines.
///
/// name      of what has no colour in the file, in the legend
std::vector<PictureFaces> mesh_faces(const meshes::FileMesh& mesh, const std::string& name,
                                     const Vec3& colour, double opacity);

/// Sides that are open, of more than two triangles, or turned: a layer each.
std::vector<PictureLayer> faulty_side_layers(const meshes::FileMesh& mesh, const MeshFacts& facts);

}  // namespace blossom::cli
