// SPDX-License-Identifier: LGPL-2.1-or-later
// Intersection curves as a model of edges that other programs open.

#pragma once

#include "adapters/occt/intersection.h"
#include "adapters/occt/intersection_edges.h"
#include "adapters/occt/shapes.h"
#include "plugin/cli/arguments/inputs.h"
#include "plugin/reports/cuts/edge_findings.h"

namespace blossom::cli {

/// A part for each pair of faces that meet, named after them ("hull.step#1 x deck.step#2"): its
/// edges, and its isolated contacts as vertices. Edges have their 3D curve and a pcurve on a copy
/// of each of the two surfaces; edges that end in one point share the vertex. And a part for what
/// the edges of an input have in common with the other one ("wire.step x deck.step").
///
/// throws   occt::Failure if Open CASCADE refuses a curve
occt::Model paired_model(const Input& a, const Input& b, const occt::ShapeIntersection& found,
                         const reports::EdgeFindings& edges);

/// One part: wires in which each stretch is once, whatever the number of faces that have it in
/// common, and lone contacts as vertices.
///
/// throws   likewise
occt::Model joined_model(const Input& a, const Input& b, const occt::JoinedIntersection& joined);

}  // namespace blossom::cli
