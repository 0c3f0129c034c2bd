// SPDX-License-Identifier: LGPL-2.1-or-later
// Radii that change along several edges: at which rates, so that the strips of these meet.
//
// A ball's section with the envelope lies across the rate c' of its centre. With n_i the normals at
// the contacts and t the direction of the guide, which both edges have where they meet,
//
//   n_1.c' = s_1 r',   n_2.c' = s_2 r',   t.c' = |G'| (1 - (c - G).k),   k the guide's curvature,
//
// so both sides have one section if and only if r' / t.c' is one number. Where a line goes on in an
// arc, t.c' jumps by length, so r' has to jump as well: it is in proportion to the way of the ball.

#pragma once

#include <vector>

#include "adapters/occt/blending/body_edges.h"
#include "adapters/occt/blending/edge_chain.h"
#include "adapters/occt/blending/strips/rolled_strip.h"

namespace blossom::occt {

/// Changes the laws of a run's edges, which have one radius where these meet, between their ends,
/// so that they have rates there that are in proportion to the way of the ball. Their mean stays as
/// it was, and a law that grows all along goes on to do so.
///
/// profiles   by place in the run, with laws
/// throws     FilletRefused if a radius would not be positive
void match_rates(const BodyEdges& body, const EdgeRun& run, std::vector<StripProfile>& profiles);

}  // namespace blossom::occt
