// SPDX-License-Identifier: LGPL-2.1-or-later
// Documents as GLB. For this folder only.

#pragma once

#include <string>

#include "adapters/occt/exchange/detail.h"

namespace blossom::occt {

/// The content of a .glb file: the triangles on the faces of all parts, with names, colours and
/// instances; in metres, and y upwards, as glTF has it.
/// throws   Failure if no face has triangles, or Open CASCADE cannot write them
std::string glb_bytes(const Document& document);

}  // namespace blossom::occt
