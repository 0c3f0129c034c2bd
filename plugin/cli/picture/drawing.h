// SPDX-License-Identifier: LGPL-2.1-or-later
// Pictures as images.

#pragma once

#include <string>
#include <vector>

#include "plugin/cli/picture/picture.h"
#include "plugin/cli/picture/raster/png.h"
#include "plugin/cli/picture/scene.h"

namespace blossom::cli {

/// The picture as an image.
/// meshes   of its scene
/// throws   UsageError if the view is none
Image picture_image(const Picture& picture, const std::vector<SceneMesh>& meshes);

/// The bytes of a PNG file.
/// throws   likewise
std::string picture_png(const Picture& picture, const std::vector<SceneMesh>& meshes);

}  // namespace blossom::cli
