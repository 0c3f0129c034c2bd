// SPDX-License-Identifier: LGPL-2.1-or-later
// Where the cuts end that a sheet makes in a solid.

#pragma once

#include <vector>

#include <TopoDS_Face.hxx>

#include "adapters/occt/solids/curve_edges.h"

namespace blossom::occt {

/// Whether the cuts of a sheet go on in one another, or end where the sheet itself does: at an edge
/// that only one of its faces has. A cut that ends elsewhere breaks off, since the curve with which
/// it goes on was not found.
///
/// pieces   of the sheet's faces, divided along the cuts
/// cuts     the edges that the cuts became in them
bool end_with_sheet(const std::vector<TopoDS_Face>& pieces, const std::vector<CurveEdges>& cuts);

}  // namespace blossom::occt
