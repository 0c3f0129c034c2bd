// SPDX-License-Identifier: LGPL-2.1-or-later
// What a fillet is told and what it tells; see plugin/cli/schemas/blend-1.md.

#pragma once

#include <string>
#include <vector>

#include "adapters/occt/edge_facts.h"
#include "adapters/occt/fillet.h"
#include "adapters/occt/shapes.h"
#include "plugin/reports/models/input.h"
#include "plugin/reports/text/json.h"

namespace blossom::reports {

/// The numbers of the edges that can be rounded.
/// kind   "all", "convex" or "concave"
std::vector<int> edges_to_round(const std::vector<occt::EdgeFacts>& facts, const std::string& kind);

/// Which edges there are beside those that can be rounded, as a note; empty if there are none.
std::string left_out(const std::vector<occt::EdgeFacts>& facts);

/// The numbers of the edges that two faces, by number, have in common.
std::vector<int> edges_between(const std::vector<occt::EdgeFacts>& facts, int face, int other);

struct FilletAnswer {
  occt::FilletOptions of{};  ///< what was asked for across the edges
  std::vector<int> asked{};
  occt::FilletResult made{};
  bool written = false;
  double seconds = 0;
};

/// Whether all edges that were asked for need nothing: the part as it was is then the result.
bool is_unchanged(const occt::FilletResult& made);

/// "complete", "tolerance" if some edges are left out, "refused" if nothing is made, "stopped".
const char* status_word(const occt::FilletResult& made);

/// Of all solids that were made.
double volume_of(const occt::FilletResult& made);

/// The blends, each as a part that gives its face a name.
occt::Model blends_of(const FilletAnswer& answer);

/// Puts what was made in the place of the part's solids, if anything is; the part has the faces by
/// which the fillet was made, under the same numbers.
void put_fillets(occt::Model& part, const FilletAnswer& answer);

/// The whole object, schema "blossom.blend/1".
Json fillet_report(const Input& part, const FilletAnswer& answer);

}  // namespace blossom::reports
