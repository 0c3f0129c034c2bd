// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces on surfaces of revolution and of extrusion.

#pragma once

#include <optional>

#include <Geom_Surface.hxx>

#include "adapters/occt/convert/surfaces.h"
#include "core/curves/swept_profile.h"

namespace blossom::occt {

/// The curve that a surface is swept by, and how; nothing of other surfaces, of meridians that are
/// in no plane with their axis, and of curves that cannot be converted.
///
/// box         the part of the surface that counts: it bounds curves that have no ends
/// tolerance   within which curves are approximated that have no exact Bezier form, model units
std::optional<SweptProfile> swept_of(const Handle(Geom_Surface) & surface, const ParameterBox& box,
                                     double tolerance);

}  // namespace blossom::occt
