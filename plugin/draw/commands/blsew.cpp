// SPDX-License-Identifier: LGPL-2.1-or-later
// blsew result shape [gap]

#include <optional>
#include <string>

#include <DBRep.hxx>

#include "plugin/draw/commands/commands.h"
#include "plugin/draw/commands/words.h"

namespace blossom::draw {
namespace {

std::string answer_to_blsew(const Words& words) {
  require(words.size() == 2 || words.size() == 3);
  std::optional<double> within;
  if (words.size() == 3) within = positive_from(words[2]);
  const SewnShape made = sew(words[1], within);
  DBRep::Set(words[0].c_str(), made.shape);
  return std::to_string(made.sewing.solids.size()) + " " + std::to_string(made.sewing.sewn()) +
         " " + tcl_number(made.sewing.gap) + " " + std::to_string(made.sewing.open_edges);
}

}  // namespace

const Command kBlsew{
    "blsew", "result shape [gap]",
    "\n\t\t: loose faces sewn to the solids that they close, across gaps up to `gap`, or as their"
    "\n\t\t: borders allow. The answer is the numbers of solids and of faces in them, the widest "
    "gap,"
    "\n\t\t: and how many edges are open where some faces nearly close. Other commands sew "
    "likewise.",
    answer_to_blsew};

}  // namespace blossom::draw
