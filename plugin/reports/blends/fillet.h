// SPDX-License-Identifier: LGPL-2.1-or-later
// What a fillet is told and what it tells; see plugin/cli/schemas/blend-1.md.

#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "adapters/occt/fillet.h"
#include "adapters/occt/shapes.h"
#include "plugin/reports/models/input.h"
#include "plugin/reports/text/json.h"

namespace blossom::reports {

/// Which edges of a model are meant.
struct EdgeWish {
  std::set<int> edges{};                         ///< numbers as in `edge_facts`
  std::string kind{};                            ///< "all", "convex", "concave", or empty
  std::optional<std::pair<int, int>> between{};  ///< the edges that two faces have in common
};

/// The numbers of the edges that are meant, which are those of the part: of a part of a model its
/// own.
/// note     which edges there are beside those that can be rounded, if all are meant
/// throws   InvalidInput if two faces have no edge in common, or an edge is of another part;
///          BadModel if there is no edge
std::vector<int> edges_asked(const EdgeWish& wish, const Input& part, std::string& note);

/// The radii of two edges with which their fillets leave nothing of the face between them.
/// throws   InvalidInput if there are not two, or as `occt::full_round_radii`
std::map<int, occt::EdgeRadius> full_round_of(const Input& part, const std::vector<int>& edges);

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

/// "2 edges rounded", "refused", or that nothing had to be done.
std::string done_text(const FilletAnswer& answer);

}  // namespace blossom::reports
