// SPDX-License-Identifier: LGPL-2.1-or-later
// Filling the holes of a model, given by edges of its faces.

#pragma once

#include <vector>

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "adapters/occt/blending/hole_loop.h"
#include "adapters/occt/blending/hole_side.h"
#include "core/blending/fills/fill.h"

namespace blossom::occt {

struct HoleOptions {
  FillOptions fill;
  double within = 0;  ///< how far sides may be apart where they meet; see OpenBorders
};

struct FilledSide {
  HoleEdge edge;
  FillContinuity continuity = FillContinuity::G1;  ///< that was asked for
  bool exact = false;      ///< else the neighbour was fitted, and these are the errors of that
  double error = 0;        ///< model units
  double angle_error = 0;  ///< radians
};

struct FilledHole {
  Fill fill;                       ///< its sides are those of `sides`
  std::vector<FilledSide> sides;   ///< one after the other round the hole
  std::vector<TopoDS_Face> faces;  ///< one for each patch, beside their neighbours' orientation
  bool flat = false;               ///< the face is a piece of a plane, and `fill` has no patches
};

/// Fills one hole: by patches, or where its edges have no corners between them, as those of a round
/// hole, or are too many, by the plane in which they lie.
/// continuity  of each edge of the loop
/// returns     the faces, or none and the reason in `fill`
/// throws      BadModel as hole_side, or if the loop has too few or too many edges and lies in no
///             plane; Failure if Open CASCADE makes no valid face
FilledHole filled_hole(const HoleLoop& loop, const std::vector<FillContinuity>& continuity,
                       const HoleOptions& options = {});

struct SewnHoles {
  TopoDS_Shape shape;              ///< shells and faces
  std::vector<TopoDS_Face> faces;  ///< the model's, in their order in TopExp::MapShapes, oriented
                                   ///< as they are there
  std::vector<std::vector<TopoDS_Face>> patches;  ///< of each hole, beside their neighbours'
};

/// The faces joined to shells along common edges, and to those of `model` if it is not null.
/// throws   Failure if what comes out is not valid
SewnHoles sewn_holes(const std::vector<FilledHole>& holes, const TopoDS_Shape& model,
                     double tolerance);

}  // namespace blossom::occt
