// SPDX-License-Identifier: LGPL-2.1-or-later
// blsection result shape x y z nx ny nz

#include <string>

#include <DBRep.hxx>

#include "adapters/occt/intersection_edges.h"
#include "adapters/occt/plane_section.h"
#include "plugin/draw/commands/commands.h"
#include "plugin/draw/commands/words.h"

namespace blossom::draw {
namespace {

std::string answer_to_blsection(const Words& words) {
  require(words.size() == 8);
  const occt::Plane plane{vector_from(words, 2), vector_from(words, 5)};
  const TopoDS_Shape shape = sewn_shape(words[1]);
  const occt::PlaneSection section =
      occt::plane_section(occt::faces_of(shape), plane, {}, loose_edges_in(shape, words[1]));
  DBRep::Set(words[0].c_str(), occt::compound_of(section));
  std::string list = std::to_string(section.wires.size()) + " " + to_string(section.status);
  for (const occt::SectionWire& wire : section.wires)
    list += " {" + std::string(wire.closed ? "closed" : "open") + " " + tcl_number(wire.length) +
            (wire.bounding ? "}" : " inner}");
  for (const std::size_t node : section.points)
    list += " {point " + tcl_list(section.nodes[node].point) + "}";
  return list;
}

}  // namespace

const Command kBlsection{
    "blsection", "result shape x y z nx ny nz",
    "\n\t\t: the section of faces and edges with the plane through x y z, as a compound of wires "
    "and"
    "\n\t\t: vertices. The answer is the number of wires and complete, tolerance or stopped; then"
    "\n\t\t: {closed length} or {open length} for each wire, with inner where it bounds no "
    "material,"
    "\n\t\t: and {point {x y z}} for each contact.",
    answer_to_blsection};

}  // namespace blossom::draw
