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
#include "plugin/reports/queries/clash.h"

namespace blossom::draw {
namespace {

// The volume of what a pair has in common; else a proven bound on how far it is apart.
std::string figure_of(const reports::ClashRow& row) {
  if (row.clash->common) return tcl_number(row.clash->common->volume);
  return tcl_number(row.clash->measured ? row.clash->upper : row.clash->lower);
}

// What is far apart is most of a large assembly, so it is only counted.
bool is_listed(const reports::ClashRow& row, double clearance) {
  return row.clash != nullptr &&
         (row.clash->relation != occt::Relation::Disjoint || reports::is_finding(row, clearance));
}

std::string clash_answer(const Words& words) {
  require(words.size() >= 4);
  reports::ClashAnswer found;
  const double clearance = number_from(words[1]);
  if (clearance < 0) throw occt::BadModel("the clearance " + words[1] + " is negative");
  found.clearance = clearance;
  std::vector<TopoDS_Shape> shapes;
  for (std::size_t i = 2; i < words.size(); ++i) {
    shapes.push_back(sewn_shape(words[i]));
    found.parts.emplace_back().name = words[i];
  }

  found.found = occt::clashes_of(shapes, {.clearance = clearance});

  std::string list;
  std::size_t listed = 0;
  std::vector<TopoDS_Solid> common;
  for (const reports::ClashRow& row : reports::rows_of(found, reports::ClashRows::Near)) {
    if (!is_listed(row, clearance)) continue;
    ++listed;
    list += (list.empty() ? "{" : " {") + words[row.a + 2] + " " + words[row.b + 2] + " " +
            reports::clash_word(row) + " " + figure_of(row) + "}";
    if (row.clash->common)
      for (const TopoDS_Solid& solid : row.clash->common->solids) common.push_back(solid);
  }
  if (!common.empty()) DBRep::Set(words[0].c_str(), occt::compound_of(common));
  return "pairs {" + list + "} clear " + std::to_string(reports::pair_count(found) - listed);
}

}  // namespace

const Command kBlclash{
    "blclash", "result clearance part part [part ...]",
    "\n\t\t: how parts, closed solids or faces, lie to each other. The answer is a Tcl dictionary:"
    "\n\t\t: pairs that meet, or are nearer than the clearance, each a list of the parts, of"
    "\n\t\t: penetrates, contained, equal, touches, clear or unknown, and of the volume that"
    "\n\t\t: they have in common, or the distance; and the number of pairs that are clear of each"
    "\n\t\t: other by more. result is what parts have in common.",
    clash_answer};

}  // namespace blossom::draw
