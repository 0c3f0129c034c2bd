// SPDX-License-Identifier: LGPL-2.1-or-later
// How smoothly faces meet as a picture.

#pragma once

#include "plugin/pictures/scene/picture.h"
#include "plugin/reports/blends/continuity.h"
#include "plugin/reports/models/input.h"

namespace blossom::pictures {

/// The faces, and edges in colours by how smooth they are; see paint_zebra for stripes.
Picture continuity_picture(const reports::Input& input, const reports::ContinuityAnswer& answer);

}  // namespace blossom::pictures
