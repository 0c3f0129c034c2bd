// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/sheet/nearby_chains.h"

#include <algorithm>

#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopTools_MapOfShape.hxx>

namespace blossom::occt {
namespace {

// Of two blends beside each other, how far their contacts may be from their edges together.
constexpr double kReach = 4;  // radii

Bnd_Box box_of(const TopoDS_Edge& edge) {
  Bnd_Box box;
  BRepBndLib::Add(edge, box);
  return box;
}

void add_vertices(const BodyEdges& body, const FilletEdges& chain, TopTools_MapOfShape& vertices) {
  for (const auto& [edge, concave] : chain) {
    vertices.Add(TopExp::FirstVertex(body.edge(edge)));
    vertices.Add(TopExp::LastVertex(body.edge(edge)));
  }
}

bool meets(const BodyEdges& body, const FilletEdges& chain, const TopTools_MapOfShape& vertices) {
  return std::ranges::any_of(chain, [&](const auto& each) {
    const TopoDS_Edge edge = body.edge(each.first);
    return vertices.Contains(TopExp::FirstVertex(edge)) ||
           vertices.Contains(TopExp::LastVertex(edge));
  });
}

}  // namespace

NearbyChains nearby_chains(const BodyEdges& body, const std::vector<FilletEdges>& chains, int edge,
                           double radius) {
  const Bnd_Box own = box_of(body.edge(edge));
  const auto is_near = [&](const FilletEdges& chain) {
    return std::ranges::any_of(chain, [&](const auto& each) {
      return own.Distance(box_of(body.edge(each.first))) <= kReach * radius;
    });
  };
  NearbyChains near;
  TopTools_MapOfShape vertices;
  for (const FilletEdges& chain : chains) {
    if (!is_near(chain)) continue;
    add_vertices(body, chain, vertices);
    for (const auto& [each, concave] : chain) near.whole.insert(each);
  }
  for (const FilletEdges& chain : chains)
    if (meets(body, chain, vertices)) near.chains.push_back(chain);
  return near;
}

}  // namespace blossom::occt
