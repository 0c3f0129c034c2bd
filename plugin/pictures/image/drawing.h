// SPDX-License-Identifier: LGPL-2.1-or-later
// Pictures as images.

#pragma once

#include <string>
#include <vector>

#include "plugin/pictures/image/raster/png.h"
#include "plugin/pictures/scene/picture.h"
#include "plugin/pictures/scene/scene.h"

namespace blossom::pictures {

/// The picture as an image.
/// meshes   of its scene
/// throws   InvalidInput if the view is none
Image picture_image(const Picture& picture, const std::vector<SceneMesh>& meshes);

/// The bytes of a PNG file.
/// throws   likewise
std::string picture_png(const Picture& picture, const std::vector<SceneMesh>& meshes);

}  // namespace blossom::pictures
