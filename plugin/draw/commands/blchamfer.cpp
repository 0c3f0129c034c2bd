// SPDX-License-Identifier: LGPL-2.1-or-later
// blchamfer result solid distance all|convex|concave|edge [edge ...]

#include <string>

#include "plugin/draw/commands/commands.h"
#include "plugin/draw/commands/fillet_chamfer.h"
#include "plugin/draw/commands/words.h"
#include "plugin/reports/blends/blend_words.h"

namespace blossom::draw {
namespace {

std::string chamfer_answer(const Words& words) {
  require(words.size() >= 4);
  occt::FilletOptions options;
  options.chamfer = reports::chamfer_size(words[2]);
  return blended_edges(words, options);
}

}  // namespace

const Command kBlchamfer{
    "blchamfer", "result solid distance all|convex|concave|edge [edge ...]",
    "\n\t\t: edges of solids cut off. The distance is 2 on both faces, 2,1 on the face of the"
    "\n\t\t: smaller number and on the other, or 2:30 with an angle in degrees. Edges and answer"
    "\n\t\t: as those of blfillet.",
    chamfer_answer};

}  // namespace blossom::draw
