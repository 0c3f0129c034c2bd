// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/models/mesh.h"

#include <algorithm>
#include <sstream>

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>

namespace blossom::reports {
namespace {

constexpr std::size_t kNamed = 20;  // in one line; reports have them all

template <class Items, class Text>
std::string named(const Items& items, const Text& text) {
  std::ostringstream list;
  for (std::size_t k = 0; k < items.size() && k < kNamed; ++k)
    list << (k > 0 ? ", " : " ") << text(items[k]);
  if (items.size() > kNamed) list << " and " << items.size() - kNamed << " more";
  return list.str();
}

}  // namespace

BorderEdges border_edges(const TopoDS_Shape& shape) {
  TopTools_IndexedDataMapOfShapeListOfShape faces;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces);
  BorderEdges found;
  for (int k = 1; k <= faces.Extent(); ++k) {
    if (BRep_Tool::Degenerated(TopoDS::Edge(faces.FindKey(k)))) continue;
    if (faces(k).Extent() == 1) found.open.push_back(k);
    if (faces(k).Extent() > 2) found.crowded.push_back(k);
  }
  return found;
}

MeshAnswer answer_of(const occt::ShapeTessellation& made, const TopoDS_Shape& shape,
                     const std::vector<int>& faces, const FacetOptions& options) {
  MeshAnswer answer;
  answer.options = options;
  answer.distance = made.facets.distance;
  answer.edges = border_edges(shape);
  for (const int place : made.finer) answer.finer.push_back(faces[static_cast<std::size_t>(place)]);
  for (std::size_t f = 0; f < made.facets.faces.size(); ++f) {
    const MeshedFace& face = made.facets.faces[f];
    answer.folded += face.folded;
    answer.moved = std::max(answer.moved, face.moved);
    if (!face.obstacle.empty()) answer.refused.emplace_back(faces[f], face.obstacle);
  }
  return answer;
}

Json mesh_report(const std::string& file, const std::string& output, const MeshAnswer& answer) {
  Json refused = Json::array();
  for (const auto& [face, why] : answer.refused) refused.push_back({{"face", face}, {"why", why}});
  return {{"schema", "blossom.mesh/1"},
          {"file", file},
          {"output", output},
          {"deviation", answer.options.deviation},
          {"angle", answer.options.angle},
          {"edge_length", answer.options.edge_length},
          {"aspect", answer.options.aspect},
          {"points", answer.points},
          {"triangles", answer.triangles},
          {"distance", answer.distance},
          {"rounding", answer.rounding},
          {"lost", answer.lost},
          {"edges_off_faces", answer.moved},
          {"closed",
           answer.edges.open.empty() && answer.edges.crowded.empty() && answer.refused.empty()},
          {"open_edges", answer.edges.open},
          {"non_manifold_edges", answer.edges.crowded},
          {"folded", answer.folded},
          {"finer", answer.finer},
          {"crossings", answer.crossings ? Json(*answer.crossings) : Json(nullptr)},
          {"crossing_faces", answer.crossing_faces},
          {"crossings_between_parts", answer.between_parts},
          {"refused", std::move(refused)},
          {"seconds", answer.seconds}};
}

std::string mesh_notes(const MeshAnswer& answer) {
  std::ostringstream text;
  const auto number = [](int k) { return k; };
  if (answer.distance - answer.rounding > answer.options.deviation && answer.moved > 0)
    text << "  edges of the model are up to " << answer.moved
         << " off their faces: triangles, which meet there, cannot be nearer\n";
  if (!answer.edges.open.empty())
    text << "  it is open at " << counted(answer.edges.open.size(), "edge")
         << " of one face:" << named(answer.edges.open, number) << "\n";
  if (!answer.edges.crowded.empty())
    text << "  it is no manifold at " << counted(answer.edges.crowded.size(), "edge")
         << " of more than two faces:" << named(answer.edges.crowded, number) << "\n";
  if (std::ranges::find(answer.lost, "colours") != answer.lost.end())
    text << "  the file has no place for the model's colours\n";
  const std::size_t crossing = answer.crossings.value_or(0);
  if (crossing > answer.between_parts)
    text << "  " << counted(crossing - answer.between_parts, "pair")
         << " of triangles cross, of faces"
         << named(answer.faces_of_one,
                  [](const std::array<int, 2>& pair) {
                    return std::to_string(pair[0]) +
                           (pair[0] == pair[1] ? "" : " and " + std::to_string(pair[1]));
                  })
         << "\n";
  if (answer.between_parts > 0)
    text << "  " << counted(answer.between_parts, "pair")
         << " of triangles of different parts cross, as where these touch; clash says which do\n";
  if (answer.folded > 0)
    text << "  " << counted(static_cast<std::size_t>(answer.folded), "triangle")
         << " turned over, where a face is narrower than the deviation\n";
  if (!answer.finer.empty())
    text << "  " << counted(answer.finer.size(), "face")
         << " meshed finer, as triangles crossed or "
         << "turned over:" << named(answer.finer, number) << "\n";
  for (const auto& [face, why] : answer.refused)
    text << "  face " << face << " is left out: " << why << "\n";
  return text.str();
}

}  // namespace blossom::reports
