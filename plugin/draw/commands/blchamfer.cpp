// SPDX-License-Identifier: LGPL-2.1-or-later
// blchamfer result solid distance all|convex|concave|edge [edge ...]

#include <string>

#include "plugin/draw/commands/commands.h"
#include "plugin/draw/commands/fillet_chamfer.h"
#include "plugin/draw/commands/words.h"
#include "plugin/reports/blend_words.h"

namespace blossom::draw {
namespace {

std::string chamfer_answer(const Words& words) {
  require(words.size() >= 4);
  occt::FilletOptions options;
  options.chamfer = reports::chamfer_size(words[2]);
  return blended_edges(words, options);
}

int blchamfer(Draw_Interpretor& interpreter, int count, const char** words) {
  return answered(interpreter, count, words,
                  "result solid distance all|convex|concave|edge [edge ...]", chamfer_answer);
}

}  // namespace

void add_blchamfer(Draw_Interpretor& interpreter) {
  interpreter.Add(
      "blchamfer",
      "blchamfer result solid distance all|convex|concave|edge [edge ...]"
      "\n\t\t: edges of solids cut off. The distance is 2 on both faces, 2,1 on the face of the"
      "\n\t\t: smaller number and on the other, or 2:30 with an angle in degrees. Edges and answer"
      "\n\t\t: as those of blfillet.",
      "plugin/draw/commands/blchamfer.cpp", blchamfer, kGroup);
}

}  // namespace blossom::draw
