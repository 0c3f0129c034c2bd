// SPDX-License-Identifier: LGPL-2.1-or-later
// Nets of models, and models of nets.

#pragma once

#include <span>
#include <vector>

#include "plugin/nets/net.h"
#include "plugin/reports/models/input.h"

namespace blossom::nets {

/// All spans of the chosen faces.
/// stop     asked for every face; ends the work by an exception
/// throws   occt::BadModel, naming the face
std::vector<Net> nets_of_faces(const reports::Input& input, const Stop& stop);

/// Likewise of the chosen edges and those of the chosen faces, or of all edges; they have the
/// numbers of the whole model.
/// throws   occt::BadModel if there is no edge with a curve, and naming the edge
std::vector<Net> nets_of_edges(const reports::Input& input, bool all, const Stop& stop);

void append(std::vector<Net>& all, std::vector<Net> more);

/// Puts nets of faces, patches and triangles, in the places of the model's faces, oriented as they
/// are, with names and colours; faces without a net go.
/// throws   occt::BadModel if a net has no form there
void put_nets(occt::Model& model, std::span<const Net> nets);

/// Every net as a part named after its source.
/// throws   occt::BadModel if a net has no form there
occt::Model model_of_nets(std::span<const Net> nets);

}  // namespace blossom::nets
