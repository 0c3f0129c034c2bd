// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/draw/commands/fillet_chamfer.h"

#include <utility>
#include <vector>

#include <DBRep.hxx>
#include <TopoDS_Solid.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/edge_facts.h"
#include "plugin/reports/blends/blend_words.h"

namespace blossom::draw {
namespace {

// Numbers of edges, some with radii, or a word for all of a kind.
reports::EdgeChoice edges_of(const TopoDS_Shape& shape, const Words& words, std::size_t first) {
  reports::EdgeChoice chosen;
  const std::string& word = words[first];
  const bool all = word == "all";
  if (!all && word != "convex" && word != "concave") {
    for (std::size_t i = first; i < words.size(); ++i) reports::choose_edges(words[i], chosen);
    return chosen;
  }
  require(words.size() == first + 1);
  for (const occt::EdgeFacts& edge : occt::edge_facts(shape)) {
    const bool sharp = edge.kind == occt::EdgeKind::Convex || edge.kind == occt::EdgeKind::Concave;
    if (sharp && (all || word == to_string(edge.kind))) chosen.edges.push_back(edge.number);
  }
  if (chosen.edges.empty()) throw occt::BadModel("there is no such edge");
  return chosen;
}

}  // namespace

std::string blended_edges(const Words& words, occt::FilletOptions options) {
  require(words.size() >= 4);
  const TopoDS_Shape shape = sewn_shape(words[1]);
  faces_in(shape, words[1]);

  reports::EdgeChoice chosen = edges_of(shape, words, 3);
  options.own = std::move(chosen.own);
  const occt::FilletResult made = occt::fillet(shape, chosen.edges, options);

  if (made.solids.empty()) throw occt::Failure(made.refused.front().text());
  std::vector<TopoDS_Solid> solids;
  double volume = 0;
  for (const occt::FilletedSolid& solid : made.solids) {
    solids.push_back(solid.solid);
    volume += solid.volume;
  }
  DBRep::Set(words[0].c_str(), occt::compound_of(solids));
  std::string answer = std::to_string(made.edges.size()) + " " + tcl_number(made.volume_before) +
                       " " + tcl_number(volume);
  for (const occt::FilletRefusal& each : made.refused) answer += " " + std::to_string(each.edge);
  return answer;
}

}  // namespace blossom::draw
