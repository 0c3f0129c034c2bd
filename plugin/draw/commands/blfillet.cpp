// SPDX-License-Identifier: LGPL-2.1-or-later
// blfillet result solid radius|from..to all|convex|concave|edge[:radius] [edge ...]

#include <string>

#include "plugin/draw/commands/commands.h"
#include "plugin/draw/commands/fillet_chamfer.h"
#include "plugin/draw/commands/words.h"
#include "plugin/reports/blends/blend_words.h"

namespace blossom::draw {
namespace {

std::string fillet_answer(const Words& words) {
  require(words.size() >= 4);
  occt::FilletOptions options;
  const occt::EdgeRadius of = reports::edge_radius(words[2]);
  options.radius = of.radius;
  options.law = of.law;
  return blended_edges(words, options);
}

}  // namespace

const Command kBlfillet{
    "blfillet", "result solid radius|from..to all|convex|concave|edge[:radius] [edge ...]",
    "\n\t\t: edges of solids rounded by a ball that rolls along them; 2..5: from 2 at the start"
    "\n\t\t: of a run of edges to 5 at its end; 7:3 and 7:2..5: edge 7 has its own. Edges by"
    "\n\t\t: their numbers in the order of explode. The answer is how many edges were rounded, and"
    "\n\t\t: the volumes before and after; behind them edges that are smooth or seams, which are"
    "\n\t\t: left out. Where one cannot be rounded the error says why.",
    fillet_answer};

}  // namespace blossom::draw
