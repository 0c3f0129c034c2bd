// SPDX-License-Identifier: LGPL-2.1-or-later
// The lines, conics, crossings of pipes and points that two faces are known to have in common, as
// curves on both.

#pragma once

#include <optional>

#include <TopoDS_Face.hxx>

#include "adapters/occt/faces/face_data.h"
#include "core/forms/meetings/elementary_meeting.h"
#include "core/results/result.h"

namespace blossom::occt {

/// The intersection of the surfaces of two faces by closed forms.
///
/// Curves are cut where they pass a seam or a pole, and go on beyond the faces: their deviations
/// are to be proven once they are clipped. Contacts are curves that are tangential, or
/// points, with their places; the status is Tolerance if one is wider than `within`.
///
/// common    holds what the faces may have in common
/// within    what is as near as this is one (core/base/tolerances.h)
/// returns   nothing if what the surfaces have in common is not known by a closed form, or has no
///           image in a chart that is near enough
std::optional<SurfaceIntersection> known_crossings(const TopoDS_Face& face_a, const FaceData& a,
                                                   const TopoDS_Face& face_b, const FaceData& b,
                                                   const Box& common, double within,
                                                   double tolerance);

/// Trims that cut all curves, even if they are the whole border of a surface.
FaceTrims cutting_trims(FaceTrims trims);

/// Replaces the sampled deviations of known crossings, which lie in both faces, by proven ones: by
/// closed forms where these are within tolerance.
void prove_deviations(const TopoDS_Face& face_a, const FaceData& a, const TopoDS_Face& face_b,
                      const FaceData& b, double tolerance, SurfaceIntersection& found);

}  // namespace blossom::occt
