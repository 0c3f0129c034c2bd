// SPDX-License-Identifier: LGPL-2.1-or-later
// The edges of a model, as JSON; see plugin/cli/schemas/info-1.md.

#pragma once

#include <set>
#include <vector>

#include "adapters/occt/edge_facts.h"
#include "plugin/reports/models/input.h"
#include "plugin/reports/text/json.h"

namespace blossom::reports {

/// The numbers of the edges that an input means: those of its faces, and those that are named.
std::set<int> edge_numbers(const Input& input);

/// Number, faces, kind, angle, length and middle point of each.
Json edges_json(const std::vector<occt::EdgeFacts>& edges);

}  // namespace blossom::reports
