// SPDX-License-Identifier: LGPL-2.1-or-later
// blclash result clearance part part [part ...]

#include <string>
#include <vector>

#include <DBRep.hxx>
#include <TopoDS_Solid.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/base/errors.h"
#include "adapters/occt/clash.h"
#include "plugin/draw/commands/commands.h"
#include "plugin/draw/commands/words.h"
#include "plugin/reports/clash.h"

namespace blossom::draw {
namespace {

// The volume of what a pair has in common; else a proven bound on how far it is apart.
std::string figure_of(const reports::ClashRow& row) {
  if (row.clash == nullptr) return tcl_number(row.lower);
  if (row.clash->common) return tcl_number(row.clash->common->volume);
  return tcl_number(row.clash->measured ? row.clash->upper : row.clash->lower);
}

std::string clash_answer(const Words& words) {
  require(words.size() >= 4);
  reports::ClashAnswer found;
  const double clearance = number_from(words[1]);
  if (clearance < 0) throw occt::BadModel("the clearance " + words[1] + " is negative");
  found.clearance = clearance;
  std::vector<TopoDS_Shape> shapes;
  for (std::size_t i = 2; i < words.size(); ++i) {
    shapes.push_back(shape_named(words[i]));
    found.parts.emplace_back().name = words[i];
  }

  found.found = occt::clashes_of(shapes, {.clearance = clearance});

  std::string list;
  std::vector<TopoDS_Solid> common;
  for (const reports::ClashRow& row : reports::rows_of(found, reports::ClashRows::All)) {
    list += (list.empty() ? "{" : " {") + words[row.a + 2] + " " + words[row.b + 2] + " " +
            reports::clash_word(row) + " " + figure_of(row) + "}";
    if (row.clash != nullptr && row.clash->common)
      for (const TopoDS_Solid& solid : row.clash->common->solids) common.push_back(solid);
  }
  if (!common.empty()) DBRep::Set(words[0].c_str(), occt::compound_of(common));
  return list;
}

int blclash(Draw_Interpretor& interpreter, int count, const char** words) {
  return answered(interpreter, count, words, "result clearance part part [part ...]", clash_answer);
}

}  // namespace

void add_blclash(Draw_Interpretor& interpreter) {
  interpreter.Add(
      "blclash",
      "blclash result clearance part part [part ...]"
      "\n\t\t: how parts, closed solids or faces, lie to each other. Distances up to the clearance"
      "\n\t\t: are measured. The answer is a list for each pair: the parts, penetrates, contained,"
      "\n\t\t: equal, touches, clear or unknown, and the volume that they have in common, or"
      "\n\t\t: the distance; result is what they have in common.",
      "plugin/draw/commands/blclash.cpp", blclash, kGroup);
}

}  // namespace blossom::draw
