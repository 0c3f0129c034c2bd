// SPDX-License-Identifier: LGPL-2.1-or-later
// Poles of one face within tolerance of another face.
//
// The tip of a cone ends the surface as a border does. Where it stops short of a face, or reaches
// through it by less than the tolerance, the surfaces hardly cross: a search for crossings finds a
// loop shorter than an edge, or nothing.

#pragma once

#include <vector>

#include <TopoDS_Face.hxx>

#include "core/topology/clipping/clipped_result.h"
#include "core/topology/face_data.h"

namespace blossom::occt {

/// The poles of either face that lie within tolerance of the other one, inside of its trims or as
/// near to them; those that both have come twice.
///
/// tolerance   model units
std::vector<Touch> pole_contacts(const TopoDS_Face& a, const FaceData& of_a, const TopoDS_Face& b,
                                 const FaceData& of_b, double tolerance);

}  // namespace blossom::occt
