// SPDX-License-Identifier: LGPL-2.1-or-later
// What two faces may have in common at most, and the places that stand for it in a result.

#pragma once

#include "core/distance.h"
#include "core/results/result.h"
#include "core/topology/face_data.h"

namespace blossom::occt {

/// Of the faces' boxes; its corners are exchanged where these are apart.
Box common_box(const FaceData& a, const FaceData& b);

/// Over both faces, model units.
double largest_coordinate(const FaceData& a, const FaceData& b);

/// Of all that two faces may have in common, of which nothing is known.
Place open_place(const FaceData& a, const FaceData& b);

/// Of all of the first face, which lies in the second.
///
/// gap    between them at most, model units
Place whole_place(const FaceData& a, const FaceData& b, double gap);

}  // namespace blossom::occt
