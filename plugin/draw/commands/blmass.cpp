// SPDX-License-Identifier: LGPL-2.1-or-later
// blmass shape

#include <string>

#include "adapters/occt/bodies.h"
#include "adapters/occt/mass.h"
#include "plugin/draw/commands/commands.h"
#include "plugin/draw/commands/words.h"

namespace blossom::draw {
namespace {

std::string answer_to_blmass(const Words& words) {
  require(words.size() == 1);
  occt::Mass solids;
  solids.is_solid = true;
  double area = 0;
  for (const occt::Body& body : occt::bodies_of(sewn_shape(words[0]))) {
    const occt::Mass mass = occt::mass_of(body.shape);
    area += mass.area;
    if (mass.is_solid) solids += mass;
  }
  return tcl_number(solids.volume) + " " + tcl_number(area) + " " + tcl_list(solids.centre);
}

}  // namespace

const Command kBlmass{
    "blmass", "shape",
    "\n\t\t: volume of all closed solids, area of all faces, and the solids' centre of gravity:"
    "\n\t\t: 24 52 {1 1.5 2}.",
    answer_to_blmass};

}  // namespace blossom::draw
