// SPDX-License-Identifier: LGPL-2.1-or-later
// blinfo shape

#include <map>
#include <string>

#include <BRepAdaptor_Surface.hxx>
#include <GeomAbs_SurfaceType.hxx>
#include <TopAbs_ShapeEnum.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "adapters/occt/base/surface_words.h"
#include "adapters/occt/edge_facts.h"
#include "adapters/occt/intersection_edges.h"
#include "plugin/draw/commands/commands.h"
#include "plugin/draw/commands/words.h"

namespace blossom::draw {
namespace {

struct Counted {
  TopAbs_ShapeEnum kind;
  const char* word;
};
constexpr Counted kCounted[] = {{TopAbs_SOLID, "solids"},
                                {TopAbs_SHELL, "shells"},
                                {TopAbs_FACE, "faces"},
                                {TopAbs_EDGE, "edges"},
                                {TopAbs_VERTEX, "vertices"}};

std::string counts_list(const std::map<std::string, int>& counts) {
  std::string list;
  for (const auto& [word, count] : counts)
    list += (list.empty() ? "" : " ") + word + " " + std::to_string(count);
  return "{" + list + "}";
}

// How many of each kind, what the surfaces are, and how faces meet in edges.
std::string answer_to_blinfo(const Words& words) {
  require(words.size() == 1);
  const TopoDS_Shape shape = sewn_shape(words[0]);
  std::string list;
  for (const auto& [kind, word] : kCounted) {
    TopTools_IndexedMapOfShape all;
    TopExp::MapShapes(shape, kind, all);
    list += std::string(word) + " " + std::to_string(all.Extent()) + " ";
  }
  std::map<std::string, int> surfaces, edges;
  for (const TopoDS_Face& face : occt::faces_of(shape))
    ++surfaces[occt::surface_word(BRepAdaptor_Surface(face, Standard_False).GetType())];
  for (const occt::EdgeFacts& edge : occt::edge_facts(shape)) ++edges[to_string(edge.kind)];
  return list + "surfaces " + counts_list(surfaces) + " meetings " + counts_list(edges);
}

}  // namespace

const Command kBlinfo{
    "blinfo", "shape",
    "\n\t\t: what a shape is made of, as a Tcl dictionary: numbers of solids, shells, faces,"
    "\n\t\t: edges and vertices; surfaces by their type; meetings of faces in edges (convex,"
    "\n\t\t: concave, smooth, open, ...).",
    answer_to_blinfo};

}  // namespace blossom::draw
