// SPDX-License-Identifier: LGPL-2.1-or-later
// Vertices of results that state no more than what ends in them needs.

#pragma once

#include <vector>

#include <TopoDS_Solid.hxx>

#include "adapters/occt/trim_tool.h"

namespace blossom::occt {

/// Lowers the tolerances of vertices that are more than ten times what the ends of their edges
/// need. Where a cut touches an edge, its vertex was widened for all that both may be off: for as
/// far as they keep within tolerance of each other. Once the cut is made, only those places beside
/// the vertex count in which wires do meet; it goes on to cover them.
///
/// A vertex keeps its tolerance where a face round it would be less sound for another, of the
/// solids or of the inputs, which may share it; so does one of an input that needs it there.
///
/// solids   results
/// inputs   what they were made of
void narrow_vertices(const std::vector<TopoDS_Solid>& solids,
                     const std::vector<const TrimTool*>& inputs);

}  // namespace blossom::occt
