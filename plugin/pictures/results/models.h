// SPDX-License-Identifier: LGPL-2.1-or-later
// Models as pictures, and what is wrong with them.

#pragma once

#include "adapters/occt/soundness.h"
#include "plugin/pictures/scene/picture.h"
#include "plugin/reports/models/info.h"
#include "plugin/reports/models/input.h"

namespace blossom::pictures {

/// All faces, each with what is known of it; those that are not valid in red.
Picture model_picture(const reports::Input& input, const reports::ModelFacts& facts);

/// Faces and edges with problems in red, open and non-manifold edges, and rings where a problem
/// has a place.
Picture soundness_picture(const reports::Input& input, const occt::Soundness& found);

}  // namespace blossom::pictures
