// SPDX-License-Identifier: LGPL-2.1-or-later
// What colours the faces of a model have.

#pragma once

#include <array>
#include <optional>
#include <vector>

#include "adapters/occt/shapes.h"

namespace blossom::occt {

/// Red, green, blue in [0, 1], sRGB.
using FaceColour = std::array<double, 3>;

/// For each face, by number - 1, its colour, or that of its shell, solid or part; nothing if none
/// has one.
std::vector<std::optional<FaceColour>> face_colours(const Model& model);

}  // namespace blossom::occt
