// SPDX-License-Identifier: LGPL-2.1-or-later
// blfill result shape G0|G1|G2 [edge ...]

#include <map>
#include <string>
#include <vector>

#include <DBRep.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/blending/hole.h"
#include "adapters/occt/blending/hole_loop.h"
#include "core/base/tolerances.h"
#include "plugin/draw/commands/commands.h"
#include "plugin/draw/commands/words.h"

namespace blossom::draw {
namespace {

std::string answer_to_blfill(const Words& words) {
  static const std::map<std::string, FillContinuity> kWords = {
      {"G0", FillContinuity::G0}, {"G1", FillContinuity::G1}, {"G2", FillContinuity::G2}};
  require(words.size() >= 3);
  const TopoDS_Shape shape = shape_named(words[1]);
  const auto continuity = kWords.find(words[2]);
  if (continuity == kWords.end())
    throw occt::BadModel("'" + words[2] + "' is none of G0, G1 and G2");
  std::vector<int> edges;
  for (std::size_t i = 3; i < words.size(); ++i) edges.push_back(count_from(words[i]));
  const occt::OpenBorders borders = occt::open_borders(shape);
  const std::vector<occt::HoleLoop> loops = edges.empty()
                                                ? occt::open_loops(shape, borders).holes
                                                : occt::hole_loops(shape, edges, borders.within);
  if (loops.empty()) throw occt::BadModel(words[1] + ": no edge is open, so there is no hole");

  std::vector<occt::FilledHole> holes;
  std::string list;
  for (const occt::HoleLoop& loop : loops) {
    holes.push_back(occt::filled_hole(loop,
                                      std::vector<FillContinuity>(loop.size(), continuity->second),
                                      {.fill = {}, .within = borders.within}));
    const Fill& fill = holes.back().fill;
    if (fill.problem != FillProblem::None) throw occt::Failure(fill.message);
    list += " {" + std::to_string(holes.back().faces.size()) + " " + to_string(fill.reached) + "}";
  }
  DBRep::Set(words[0].c_str(),
             occt::sewn_holes(holes, shape, std::max(Tolerances{}.point, borders.within)).shape);
  return std::to_string(holes.size()) + list;
}

}  // namespace

const Command kBlfill{
    "blfill", "result shape G0|G1|G2 [edge ...]",
    "\n\t\t: closes holes by patches that meet their neighbours so smoothly: every hole that"
    "\n\t\t: open edges go round, or that of the numbered edges, sewn to the shape. The answer is "
    "the number of"
    "\n\t\t: holes, and for each one the number of patches and what was reached: {4 G1}.",
    answer_to_blfill};

}  // namespace blossom::draw
