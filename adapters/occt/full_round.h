// SPDX-License-Identifier: LGPL-2.1-or-later
// Full rounds: fillets of two edges of one face that meet in it and leave nothing of it.

#pragma once

#include <map>

#include <TopoDS_Shape.hxx>

#include "adapters/occt/fillet.h"

namespace blossom::occt {

/// The radii with which one ball touches a plane face and the planes beside two straight edges of
/// it, all along: constant where the edges are parallel, else linear.
///
/// With T = tan(turn / 2) of the turn of the normals at an edge, D the distance of a point of the
/// one edge from the other one and c the cosine of the directions across both into the face,
///
///   the contact is r T_1 from the one edge, and D + r T_1 c = r T_2 from the other:
///   r = D / (T_2 - T_1 c)
///
/// shape    as of `fillet`
/// returns  by edge, as `FilletOptions::own`
/// throws   InvalidInput if they are no such edges, saying why, and which pairs would do
std::map<int, EdgeRadius> full_round_radii(const TopoDS_Shape& shape, int edge_a, int edge_b);

/// A radius as it is told: to six digits, cut off, with which the fillets can be made, too.
double told_radius(double radius);

}  // namespace blossom::occt
