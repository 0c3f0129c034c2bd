// SPDX-License-Identifier: LGPL-2.1-or-later
// Edges and vertices that two faces of a model share.

#pragma once

#include <vector>

#include <TopoDS_Face.hxx>

#include "core/topology/shared.h"

namespace blossom::occt {

/// The edges that both faces use, but for degenerated ones and seams, which a face has twice.
/// throws   BadModel if an edge has no curve in space or on a face
std::vector<SharedEdge> shared_edges(const TopoDS_Face& a, const TopoDS_Face& b);

std::vector<SharedVertex> shared_vertices(const TopoDS_Face& a, const TopoDS_Face& b);

}  // namespace blossom::occt
