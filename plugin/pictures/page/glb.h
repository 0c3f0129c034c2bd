// SPDX-License-Identifier: LGPL-2.1-or-later
// Pictures as glTF 2.0 in one binary file (.glb): triangles, and curves as lines, which Open
// CASCADE's writer leaves out.

#pragma once

#include <string>
#include <vector>

#include "plugin/pictures/scene/picture.h"
#include "plugin/pictures/scene/scene.h"

namespace blossom::pictures {

/// The bytes of a .glb file, in metres with y upwards as glTF has it. A node for every group and
/// layer, with its name and colour; marks are points.
/// meshes   of its scene
std::string glb_bytes(const Picture& picture, const std::vector<SceneMesh>& meshes);

}  // namespace blossom::pictures
