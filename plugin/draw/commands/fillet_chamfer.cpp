// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/draw/commands/fillet_chamfer.h"

#include <vector>

#include <DBRep.hxx>
#include <TopoDS_Solid.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/edge_facts.h"

namespace blossom::draw {
namespace {

// Numbers of edges, or a word for all of a kind.
std::vector<int> edges_of(const TopoDS_Shape& shape, const Words& words, std::size_t first) {
  std::vector<int> edges;
  const std::string& word = words[first];
  const bool all = word == "all";
  if (!all && word != "convex" && word != "concave") {
    for (std::size_t i = first; i < words.size(); ++i) edges.push_back(count_from(words[i]));
    return edges;
  }
  require(words.size() == first + 1);
  for (const occt::EdgeFacts& edge : occt::edge_facts(shape)) {
    const bool sharp = edge.kind == occt::EdgeKind::Convex || edge.kind == occt::EdgeKind::Concave;
    if (sharp && (all || word == to_string(edge.kind))) edges.push_back(edge.number);
  }
  if (edges.empty()) throw occt::BadModel("there is no such edge");
  return edges;
}

}  // namespace

std::string blended_edges(const Words& words, const occt::FilletOptions& options) {
  require(words.size() >= 4);
  const TopoDS_Shape shape = shape_named(words[1]);
  faces_in(shape, words[1]);

  const occt::FilletResult made = occt::fillet(shape, edges_of(shape, words, 3), options);

  if (!made.refused.empty()) throw occt::Failure(made.refused.front().text());
  std::vector<TopoDS_Solid> solids;
  double volume = 0;
  for (const occt::FilletedSolid& solid : made.solids) {
    solids.push_back(solid.solid);
    volume += solid.volume;
  }
  DBRep::Set(words[0].c_str(), occt::compound_of(solids));
  return std::to_string(made.edges.size()) + " " + tcl_number(made.volume_before) + " " +
         tcl_number(volume);
}

}  // namespace blossom::draw
