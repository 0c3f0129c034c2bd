// SPDX-License-Identifier: LGPL-2.1-or-later
// blintersect result shapeA shapeB [tolerance]

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <BRep_Builder.hxx>
#include <DBRep.hxx>
#include <TopoDS_Iterator.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/border_numbers.h"
#include "adapters/occt/edge_intersection.h"
#include "adapters/occt/intersection.h"
#include "adapters/occt/intersection_edges.h"
#include "plugin/draw/commands/commands.h"
#include "plugin/draw/commands/words.h"

namespace blossom::draw {
namespace {

std::string place(const occt::BorderNumber& on) {
  return " {" + std::string(on.kind) + " " + std::to_string(on.number) + "}";
}

// Each as {{x y z} {edge 3} {face 1}}: where it is and what of a and b it is on.
std::string contacts_list(const occt::ShapeIntersection& found, const occt::BorderNumbers& a,
                          const occt::BorderNumbers& b) {
  std::string list;
  for (const occt::FaceIntersection& pair : found.pairs)
    for (std::size_t i = 0; i < pair.found.points.size(); ++i)
      list += " {" + tcl_list(pair.found.points[i].point) +
              place(a.of(pair.borders[i].on_a, pair.face_a + 1)) +
              place(b.of(pair.borders[i].on_b, pair.face_b + 1)) + "}";
  return list;
}

// A shape of the answer: its faces, or of one without faces its edges.
struct Side {
  Side(const TopoDS_Shape& of, const std::string& name)
      : shape(of), faces(occt::faces_of(of)), edges(loose_edges_in(of, name)), numbers(of) {
    if (!faces.empty()) edges.clear();
  }

  std::string place_of(const TopoDS_Shape& on) const {
    const auto face =
        std::ranges::find_if(faces, [&on](const TopoDS_Face& each) { return each.IsSame(on); });
    const bool is_face = face != faces.end();
    return place(numbers.of(is_face ? TopoDS_Shape() : on,
                            is_face ? static_cast<int>(face - faces.begin()) + 1 : 0));
  }

  TopoDS_Shape shape;
  std::vector<TopoDS_Face> faces;
  std::vector<TopoDS_Edge> edges;
  occt::BorderNumbers numbers;
};

// What the edges of one side have in common with the other.
struct EdgesMet {
  const Side& of;
  const Side& other;
  bool swapped = false;  // the other one is named first
  occt::EdgeIntersection found{};

  std::string points_list() const {
    std::string list;
    for (const occt::EdgePoint& point : found.points) {
      const std::string edge = of.place_of(of.edges[static_cast<std::size_t>(point.edge)]);
      const std::string met = other.place_of(point.on);
      list += " {" + tcl_list(point.point) + (swapped ? met + edge : edge + met) + "}";
    }
    return list;
  }

  void add_to(TopoDS_Compound& wires) const {
    if (found.points.empty() && found.stretches.empty()) return;
    const TopoDS_Compound own = occt::joined_edges(of.edges, found);
    for (TopoDS_Iterator it(own); it.More(); it.Next()) BRep_Builder().Add(wires, it.Value());
  }
};

// Edges of a meet all of b; where b has edges alone, these are then known.
EdgesMet edges_met(const Side& a, const Side& b, const IntersectionOptions& options) {
  const bool swapped = a.edges.empty();
  EdgesMet met{swapped ? b : a, swapped ? a : b, swapped};
  if (!met.of.edges.empty())
    met.found = occt::intersect_edges(met.of.edges, met.other.shape, options);
  return met;
}

std::string intersect_named(const Words& words) {
  require(words.size() == 3 || words.size() == 4);
  IntersectionOptions options;
  if (words.size() == 4) options.tolerances.point = positive_from(words[3]);
  // The result may take the name of a or b: both are fetched before it is set.
  const Side a(shape_named(words[1]), words[1]), b(shape_named(words[2]), words[2]);

  const occt::ShapeIntersection found = occt::intersect(a.faces, b.faces, options);
  const EdgesMet edges = edges_met(a, b, options);

  std::size_t curves = edges.found.stretches.size();  // one across seams counts once
  for (const occt::FaceIntersection& pair : found.pairs) curves += pair.chains.size();
  occt::JoinedIntersection joined = occt::joined_intersection(found, a.faces, b.faces);
  if (!joined.lost.empty()) throw occt::Failure(joined.lost.front());
  edges.add_to(joined.wires);
  DBRep::Set(words[0].c_str(), joined.wires);
  return std::to_string(curves) + " " + to_string(weaker(found.status, edges.found.status)) +
         contacts_list(found, a.numbers, b.numbers) + edges.points_list();
}

}  // namespace

const Command kBlintersect{
    "blintersect", "result shapeA shapeB [tolerance]",
    "\n\t\t: all intersections of the faces of two shapes, or of the edges of one without faces,"
    "\n\t\t: as a compound of wires, each stretch once, and of vertices at isolated contacts."
    "\n\t\t: The answer is the number of curves, one across seams counted once, and complete,"
    "\n\t\t: tolerance or stopped; then for each isolated contact where it is, and what of A and"
    "\n\t\t: B it is on: {{x y z} {edge 3} {face 1}}.",
    intersect_named};

}  // namespace blossom::draw
