// SPDX-License-Identifier: LGPL-2.1-or-later
// What a solid with blends has to pass before it is given out.

#pragma once

#include <functional>

#include <TopoDS_Solid.hxx>

#include "adapters/occt/blending/body_edges.h"
#include "adapters/occt/blending/edge_chain.h"
#include "adapters/occt/fillet.h"
#include "core/results/options.h"

namespace blossom::occt {

/// Validity by BRepCheck of the solid and of all faces that are new or cut or have a vertex of such
/// a one, soundness of the new and cut ones, and a volume that changed the way the edges say. Other
/// faces are as they were.
///
/// before   the solid that the blends were put into, whose faces are those of `body`; faces of one
///          that is not valid itself are only looked at where they change
/// change   of the volume, cubic model units
/// throws   FilletRefused
void check_blended(const BodyEdges& body, const TopoDS_Solid& before, const FilletedSolid& made,
                   const FilletEdges& edges, double change);

/// The ball must not have run into faces that it was not known to roll on or end in.
///
/// tick     called often; may throw to stop
/// throws   FilletRefused
void check_apart(const FilletedSolid& made, const IntersectionOptions& options,
                 const std::function<void()>& tick);

}  // namespace blossom::occt
