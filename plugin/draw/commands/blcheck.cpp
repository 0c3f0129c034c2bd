// SPDX-License-Identifier: LGPL-2.1-or-later
// blcheck shape

#include <string>

#include "adapters/occt/soundness.h"
#include "plugin/draw/commands/commands.h"
#include "plugin/draw/commands/words.h"

namespace blossom::draw {
namespace {

std::string answer_to_blcheck(const Words& words) {
  require(words.size() == 1);
  const occt::Soundness found = occt::soundness(sewn_shape(words[0]));
  std::string list;
  std::size_t count = 0;
  const auto add = [&](const std::string& what) {
    ++count;
    list += " " + tcl_word(what);
  };
  for (const std::string& problem : found.problems) add(problem);
  for (const occt::FaceSoundness& face : found.faces)
    for (const occt::Problem& problem : face.problems)
      add("face " + std::to_string(face.number) + ": " + problem.text());
  for (const occt::EdgeSoundness& edge : found.edges)
    for (const occt::Problem& problem : edge.problems)
      add("edge " + std::to_string(edge.number) + ": " + problem.text());
  return std::to_string(count) + list;
}

}  // namespace

const Command kBlcheck{
    "blcheck", "shape",
    "\n\t\t: what is wrong with a shape: validity, gaps beside the tolerances that it states, "
    "wires,"
    "\n\t\t: open edges of solids. The answer is the number of problems, 0 if it is sound, and each"
    "\n\t\t: of them as a text.",
    answer_to_blcheck};

}  // namespace blossom::draw
