// SPDX-License-Identifier: LGPL-2.1-or-later
// Enclosures of the derivatives of a rational patch, from the control points of its derivatives.

#pragma once

#include "core/forms/patch.h"
#include "core/forms/surface.h"
#include "core/math/interval.h"
#include "core/tessellation/charts/jet_enclosure.h"

namespace blossom {

/// Where a net lies in a span of a surface.
struct CellSide {
  Interval span;  ///< in the surface's own parameters
  ParameterLaw law = ParameterLaw::Linear;
  Interval part;  ///< of the span's local parameter, which the net covers
};

struct CellJet {
  JetEnclosure jet;
  VectorRange first_u, first_v;
};

/// All by the surface's own parameters. With w the weight and X = w S the quotient rule gives
///
///   w S_u = X_u - w_u S,   w S_uu = X_uu - 2 w_u S_u - w_uu S,   w S_uv likewise
///
/// about a point of the cell as the origin, each term in the range of its control points.
CellJet cell_jet(RationalBezierPatch net, const CellSide& u, const CellSide& v);

/// By coordinate, the largest |jump| of S_u over the common border of two patches, the first of
/// which ends where the second begins; by the surface's own parameters. With D the difference of
/// the homogeneous derivatives it is (D_X w - D_w X) / w^2, bounded by its coefficients.
Vec3 largest_jump_u(const RationalBezierPatch& before, const CellSide& at_before,
                    const RationalBezierPatch& after, const CellSide& at_after);
Vec3 largest_jump_v(const RationalBezierPatch& before, const CellSide& at_before,
                    const RationalBezierPatch& after, const CellSide& at_after);

}  // namespace blossom
