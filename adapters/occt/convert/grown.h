// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces over larger ranges of parameters.

#pragma once

#include <Geom_Surface.hxx>

#include "adapters/occt/convert/surfaces.h"

namespace blossom::occt {

/// The surface with at least these parameters: it goes on past its borders as its outer spans do,
/// those of a spline, of the curve that is extruded or revolved, or of what it is an offset of.
/// Without trims, and the same where it has the parameters already, closes, is of another kind, or
/// would get a weight that is not positive.
///
/// to   finite where the surface is not endless
Handle(Geom_Surface) grown(const Handle(Geom_Surface) & surface, const ParameterBox& to);

}  // namespace blossom::occt
