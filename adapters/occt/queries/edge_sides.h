// SPDX-License-Identifier: LGPL-2.1-or-later
// Where an edge runs between the places where it meets faces.

#pragma once

#include <vector>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>

#include "core/base/status.h"
#include "core/results/options.h"

namespace blossom::occt {

struct EdgeStretches {
  std::vector<gp_Pnt> middles;  ///< of the stretches between common points, by their order
  Status status = Status::Complete;
};

/// Beside closed faces each stretch of an edge runs on one side, or along them.
/// throws   BadModel as `intersect` of an edge and a face
EdgeStretches stretches_beside(const TopoDS_Edge& edge, const std::vector<TopoDS_Face>& faces,
                               const IntersectionOptions& options);

}  // namespace blossom::occt
