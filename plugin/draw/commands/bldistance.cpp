// SPDX-License-Identifier: LGPL-2.1-or-later
// bldistance shapeA shapeB

#include <string>

#include "adapters/occt/distance.h"
#include "plugin/draw/commands/commands.h"
#include "plugin/draw/commands/words.h"

namespace blossom::draw {
namespace {

std::string answer_to_bldistance(const Words& words) {
  require(words.size() == 2);
  const occt::MeasuredShape a(sewn_shape(words[0])), b(sewn_shape(words[1]));
  const occt::ShapeDistance found = occt::least_distance(a, b);
  return tcl_number(found.lower) + " " + tcl_number(found.upper) + " " + tcl_list(found.a.point) +
         " " + tcl_list(found.b.point);
}

}  // namespace

const Command kBldistance{
    "bldistance", "shapeA shapeB",
    "\n\t\t: the least distance of two shapes; solids are their boundaries. The answer is a proven"
    "\n\t\t: lower bound, the distance found, and the two points: 2 2 {0 0 1} {0 0 3}.",
    answer_to_bldistance};

}  // namespace blossom::draw
