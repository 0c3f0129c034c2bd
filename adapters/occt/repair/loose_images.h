// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves in parameters that do not fit those in space, made anew.

#pragma once

#include <functional>
#include <vector>

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "adapters/occt/base/shared_parts.h"

namespace blossom::occt {

/// The tolerance of edges beyond which their curves are looked at, model units.
inline constexpr double kLooseTolerance = 1e-4;

/// A curve that was made anew.
struct RemadeImage {
  TopoDS_Face face;
  TopoDS_Edge edge;
  double gap = 0;  ///< how far it was off its curve in space, model units
};

/// Replaces curves in the parameters of faces that are more than kLooseTolerance, and a thousandth
/// of the edge's length, off the curves of their edges in space, where these lie on the surface ten
/// times as near: readers of files make some so badly that the faces at the edge seem as far apart.
/// Their edges, and the vertices of these, get the tolerances that are left.
///
/// Seams stay, curves through poles, and faces that would be less valid by BRepCheck.
///
/// faces    with all that share a vertex with an edge of them whose tolerance is loose
/// parts    of the shape that they are of
/// unseen   edges whose reader did not see how far their curves are apart, however long they are
/// stop     asked now and then; ends the work by an exception
std::vector<RemadeImage> remake_loose_images(const std::vector<TopoDS_Face>& faces,
                                             const SharedParts& parts,
                                             const TopTools_IndexedMapOfShape& unseen = {},
                                             const std::function<void()>& stop = {});

}  // namespace blossom::occt
