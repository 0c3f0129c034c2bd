// SPDX-License-Identifier: LGPL-2.1-or-later
// Inputs that are nets, or faces and edges that give nets; and results that go back to models.

#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plugin/cli/arguments/inputs.h"
#include "plugin/nets/net.h"

namespace blossom::cli {

using nets::Net;

struct NetInput {
  std::string name;            ///< as the user wrote it
  std::optional<Input> model;  ///< unless it is a file of nets
  std::vector<Net> nets;       ///< all spans of all chosen faces or edges, or the chosen nets
};

/// Which nets a model gives.
enum class Take { Faces, Edges };

/// Reads FILE, FILE#3 or FILE#3,5-9; the numbers are those of faces, or of nets in a JSON file.
/// Take::Edges takes the edges of the chosen faces, or all of the model.
/// throws   UsageError and occt::BadModel as read_input and read_nets
NetInput read_net_input(const std::string& text, Take take);

/// Writes nets made from an input to a JSON file or a model. In a model, patches and triangles take
/// the places of their faces, with names and colours, and faces that were not chosen go; other nets
/// become parts named after their source. The model of the input is used up.
/// throws   occt::BadModel if a net has no form there; occt::Failure if it cannot be written
void write_nets(NetInput& input, std::span<const Net> nets, const std::string& file);

/// Takes all faces out of a model that were not chosen.
void drop_other_faces(Input& input);

}  // namespace blossom::cli
