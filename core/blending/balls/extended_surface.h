// SPDX-License-Identifier: LGPL-2.1-or-later
// A surface that goes on past its borders as its outer patches do.

#pragma once

#include <array>

#include "core/forms/surface.h"

namespace blossom {

/// The surface with one more span on some of its sides: the polynomials of its first and last
/// patches outside of their own spans, so it is as smooth there as can be.
///
/// parts     of the length of the first and the last span in u, in v: how long the new spans are;
///           0: none. Closed directions, and those whose parameter is an angle, stay as they are.
///           A span that would have a weight that is not positive is left out.
/// accuracy  a coordinate grows by at most (1 + 2 part)^degree of the patch's extent
///
/// Source: a Bezier patch outside of its unit square, by its blossom (Ramshaw 1989).
BezierSurface extended(const BezierSurface& surface, const std::array<double, 2>& u_parts,
                       const std::array<double, 2>& v_parts);

}  // namespace blossom
