// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces of a STEP file of which Open CASCADE takes the wrong side of their borders. For this folder
// only.

#pragma once

#include <vector>

#include <BRepTools_ReShape.hxx>
#include <StepData_StepModel.hxx>
#include <StepShape_FaceSurface.hxx>
#include <Transfer_TransientProcess.hxx>

namespace blossom::occt {

/// What was found of them.
struct TurnedFaces {
  Handle(BRepTools_ReShape) mended;                 ///< null if there is nothing to mend
  std::vector<Handle(StepShape_FaceSurface)> left;  ///< that could not be mended
};

/// A border on a closed surface, a sphere, a torus, one from pole to pole, has a face on either
/// side. STEP says which: the one to the left along the border, seen against the surface's normal.
/// Open CASCADE takes the one that its parameters surround, and so holes for faces. Where it has
/// turned the border round, the face becomes what is left of the surface.
///
/// The direction in the file is not believed if it is wrong for a face of the file that has one
/// possible side only; unless the loops of the face themselves go along a seam or stand at a pole,
/// which they do when the face has these.
///
/// made   its shapes are exchanged for mended ones; shapes taken from it before need `mended`
TurnedFaces mend_turned_faces(const StepData_StepModel& model, Transfer_TransientProcess& made);

}  // namespace blossom::occt
