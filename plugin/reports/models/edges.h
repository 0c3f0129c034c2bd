// SPDX-License-Identifier: LGPL-2.1-or-later
// The edges of a model, as JSON; see plugin/cli/schemas/info-1.md.

#pragma once

#include <set>
#include <vector>

#include <TopoDS_Edge.hxx>

#include "adapters/occt/edge_facts.h"
#include "plugin/reports/models/input.h"
#include "plugin/reports/text/json.h"

namespace blossom::reports {

/// The numbers of the edges that an input means: those of its faces, and those that are named.
std::set<int> edge_numbers(const Input& input);

/// The edges of an input that none of its faces has: of the whole model, or those that are named.
std::vector<TopoDS_Edge> edges_without_faces(const Input& input);

/// Number, faces, kind, angle, length and middle point of each.
Json edges_json(const std::vector<occt::EdgeFacts>& edges);

}  // namespace blossom::reports
