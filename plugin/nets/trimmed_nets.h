// SPDX-License-Identifier: LGPL-2.1-or-later
// Trimmed faces to nets that cover what the trims leave.

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <TopoDS_Face.hxx>

#include "core/regions/triangle_lowering.h"
#include "plugin/nets/net.h"

namespace blossom::nets {

struct TrimmedNets {
  int face = 0;
  std::vector<Net> nets;    ///< patches and triangles; none if there is an obstacle
  std::size_t exact = 0;    ///< pieces whose trimmed sides are the trims themselves, or have none
  std::size_t fitted = 0;   ///< the others
  double border_error = 0;  ///< bound on how far fitted sides lie from the trims, model units
  std::string obstacle;     ///< why the face's trims cannot be followed
};

/// Whether more than the border of its parameter box bounds a face. Trims that cannot be read
/// count.
bool is_trimmed(const TopoDS_Face& face);

/// The region of a trimmed face as patches and triangles, which lie on its surface or, if fitted,
/// within the tolerance of it.
///
/// tolerance   how far borders may lie from the trims where they cannot be exact, model units
/// lowering    keeps its matrices for the next face
/// stop        asked for every piece; ends the work by an exception
TrimmedNets trimmed_nets(const TopoDS_Face& face, const NetSource& source, double tolerance,
                         TriangleLowering& lowering, const Stop& stop = {});

}  // namespace blossom::nets
