// SPDX-License-Identifier: LGPL-2.1-or-later
// Pictures of files of triangles.

#pragma once

#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "plugin/meshes/mesh_files.h"
#include "plugin/pictures/scene/picture.h"

namespace blossom::pictures {

/// Radians; what most programs smooth over.
inline constexpr double kUsualCrease = 40 * std::numbers::pi / 180;

/// Its groups as the faces of a picture, each colour of the file apart. Outlines are the sides of
/// one triangle of a group, also where another group goes on, and those at which triangles turn by
/// more than kUsualCrease.
///
/// name      of what has no colour in the file, in the legend
/// stop      throws what ends the work
std::vector<PictureFaces> mesh_faces(const meshes::FileMesh& mesh, const std::string& name,
                                     const Vec3& colour, double opacity,
                                     const std::function<void()>& stop);

/// Sides of more than two triangles, others that are open, and others that are turned: a layer
/// each.
///
/// stop      throws what ends the work
std::vector<PictureLayer> faulty_side_layers(const meshes::FileMesh& mesh,
                                             const std::function<void()>& stop);

/// A mesh with its faulty sides.
/// input      its name; its title is the short one
/// subtitle   what came out, in a line
Picture mesh_picture(const std::string& input, const meshes::FileMesh& mesh,
                     const std::string& subtitle, const std::function<void()>& stop);

}  // namespace blossom::pictures
