// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves in parameters that do not fit those in space, made anew.

#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>

namespace blossom::occt {

/// Curves that were made anew.
struct RemadeImages {
  int count = 0;
  double worst = 0;  ///< how far the worst of them was off its curve in space
};

/// Replaces curves in the parameters of faces that are more than 1e-4, and a thousandth of the
/// edge's length, off the curves of their edges in space, where these lie on the surface ten times
/// as near: readers of files make some so badly that the faces at the edge seem as far apart. Their
/// edges, and the vertices of these, get the tolerances that are left.
///
/// Seams stay, curves through poles, and faces that would be less valid by BRepCheck.
///
/// unseen   edges whose reader did not see how far their curves are apart, however long they are
RemadeImages remake_loose_images(const TopoDS_Shape& shape,
                                 const TopTools_IndexedMapOfShape& unseen = {});

}  // namespace blossom::occt
