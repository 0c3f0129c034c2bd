// SPDX-License-Identifier: LGPL-2.1-or-later
// blintersect result shapeA shapeB [tolerance]

#include <cstddef>
#include <string>

#include <DBRep.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/border_numbers.h"
#include "adapters/occt/intersection.h"
#include "adapters/occt/intersection_edges.h"
#include "plugin/draw/commands/commands.h"
#include "plugin/draw/commands/words.h"

namespace blossom::draw {
namespace {

// Each as {{x y z} {edge 3} {face 1}}: where it is and what of a and b it is on.
std::string contacts_list(const occt::ShapeIntersection& found, const occt::BorderNumbers& a,
                          const occt::BorderNumbers& b) {
  const auto place = [](const occt::BorderNumber& on) {
    return " {" + std::string(on.kind) + " " + std::to_string(on.number) + "}";
  };
  std::string list;
  for (const occt::FaceIntersection& pair : found.pairs)
    for (std::size_t i = 0; i < pair.found.points.size(); ++i)
      list += " {" + tcl_list(pair.found.points[i].point) +
              place(a.of(pair.borders[i].on_a, pair.face_a + 1)) +
              place(b.of(pair.borders[i].on_b, pair.face_b + 1)) + "}";
  return list;
}

std::string intersect_named(const Words& words) {
  require(words.size() == 3 || words.size() == 4);
  IntersectionOptions options;
  if (words.size() == 4) options.tolerances.point = positive_from(words[3]);
  // The result may take the name of a or b: both are fetched before it is set.
  const TopoDS_Shape a = shape_named(words[1]), b = shape_named(words[2]);

  const std::vector<TopoDS_Face> of_a = faces_in(a, words[1]), of_b = faces_in(b, words[2]);
  const occt::ShapeIntersection found = occt::intersect(of_a, of_b, options);

  std::size_t curves = 0;  // one across seams counts once
  for (const occt::FaceIntersection& pair : found.pairs) curves += pair.chains.size();
  const occt::JoinedIntersection joined = occt::joined_intersection(found, of_a, of_b);
  if (!joined.lost.empty()) throw occt::Failure(joined.lost.front());
  DBRep::Set(words[0].c_str(), joined.wires);
  return std::to_string(curves) + " " + to_string(found.status) +
         contacts_list(found, occt::BorderNumbers(a), occt::BorderNumbers(b));
}

}  // namespace

const Command kBlintersect{
    "blintersect", "result shapeA shapeB [tolerance]",
    "\n\t\t: all intersections of the faces of two shapes, as a compound of wires,"
    "\n\t\t: each stretch once, and of vertices at isolated contacts. The answer is the number of"
    "\n\t\t: curves, one across seams counted once, and complete, tolerance or"
    "\n\t\t: stopped; then for each isolated contact where it is and what of A and"
    "\n\t\t: B it is on: {{x y z} {edge 3} {face 1}}.",
    intersect_named};

}  // namespace blossom::draw
