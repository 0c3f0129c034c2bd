// SPDX-License-Identifier: LGPL-2.1-or-later
// What is wrong with a model as a picture.

#pragma once

#include "adapters/occt/soundness.h"
#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/picture/picture.h"

namespace blossom::cli {

/// Faces and edges with problems in red, open and non-manifold edges, and rings where a problem
/// has a place.
Picture soundness_picture(const Input& input, const occt::Soundness& found);

}  // namespace blossom::cli
