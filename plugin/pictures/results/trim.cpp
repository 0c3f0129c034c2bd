// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/pictures/results/trim.h"

#include <map>
#include <set>
#include <utility>

#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "plugin/pictures/results/intersection.h"
#include "plugin/pictures/scene/mesh.h"
#include "plugin/reports/cuts/trim.h"
#include "plugin/reports/text/number_text.h"

namespace blossom::pictures {
namespace {

using reports::counted;
using reports::Input;
using reports::number_text;
using reports::rounded;
using reports::short_name;

// Which faces meet in an edge, by what they come from; an edge of one face has it twice.
using EdgeOwners = std::vector<std::pair<TopoDS_Edge, std::vector<int>>>;

EdgeOwners owners_of(const std::vector<std::pair<TopoDS_Face, int>>& faces) {
  TopTools_IndexedMapOfShape edges;
  EdgeOwners owners;
  for (const auto& [face, owner] : faces)
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      const auto place = static_cast<std::size_t>(edges.Add(it.Current())) - 1;
      if (place == owners.size()) owners.push_back({TopoDS::Edge(it.Current()), {}});
      owners[place].second.push_back(owner);
    }
  return owners;
}

// Edges that part pieces of one face; a seam parts a piece from itself.
void add_cuts(const occt::TrimResult& made, PictureLayer& layer) {
  std::vector<std::pair<TopoDS_Face, int>> faces;
  std::map<int, int> face_of;  // by piece
  for (const occt::TrimPiece& piece : made.pieces) {
    faces.emplace_back(piece.shape, piece.number);
    face_of[piece.number] = piece.face;
  }
  for (const auto& [edge, pieces] : owners_of(faces)) {
    const std::set<int> different(pieces.begin(), pieces.end());
    std::set<int> cut;
    for (const int piece : different) cut.insert(face_of[piece]);
    if (different.size() > cut.size())
      layer.items.push_back({edge_points(edge), "cut of face " + std::to_string(*cut.begin())});
  }
}

std::string title_of(const reports::SolidAnswer& answer) {
  std::string title = answer.operation + " of " + short_name(answer.part);
  for (const std::string& tool : answer.tools) title += ", " + short_name(tool);
  for (std::size_t i = 0; i < answer.planes.size(); ++i) title += ", " + reports::plane_name(i);
  return title;
}

}  // namespace

Picture trim_picture(const Input& part, const std::vector<const Input*>& tools,
                     const occt::TrimResult& made, Status stated) {
  Picture picture;
  picture.title = short_name(part.name);
  for (std::size_t i = 0; i < tools.size(); ++i)
    picture.title += (i == 0 ? " trimmed by " : ", ") + short_name(tools[i]->name);
  const reports::FaceLabels labels(part);
  std::size_t kept = 0;
  for (const occt::TrimPiece& piece : made.pieces) {
    if (!piece.kept) continue;
    const std::string name =
        "piece " + std::to_string(piece.number) + ": " + reports::side_text(piece.side);
    picture.groups.push_back({{piece.shape},
                              palette(kept++),
                              kFirstOpacity,
                              name,
                              {name + "\nof " + labels.of(piece.face) + "\narea " +
                               number_text(rounded(piece.area)) + " mm²"}});
  }
  picture.subtitle = std::string(to_string(stated)) + ": " + counted(made.areas.size(), "face") +
                     " in " + counted(made.pieces.size(), "piece") + ", " + std::to_string(kept) +
                     " kept";
  for (const Input* tool : tools)
    picture.groups.push_back({tool->faces, kToolColour, kToolOpacity, short_name(tool->name),
                              reports::face_labels(*tool)});
  picture.layers = {{"cut", kCurveColour}};
  add_cuts(made, picture.layers.front());
  picture.facts = certificate_facts(made.certificate);
  return picture;
}

Picture solids_picture(const reports::SolidAnswer& answer) {
  const occt::SolidTrimResult& made = answer.made;
  Picture picture;
  picture.title = title_of(answer);
  std::vector<TopoDS_Shape> shapes(made.solids.begin(), made.solids.end());
  shapes.insert(shapes.end(), made.sheets.begin(), made.sheets.end());
  const std::string kind = made.sheets.empty() ? "solid" : "sheet";
  picture.subtitle = made.of_wires ? reports::counted_wires(made) + ", length " +
                                         number_text(rounded(made.lengths.result)) + " mm"
                                   : counted(shapes.size(), kind);
  for (TopExp_Explorer it(made.wires, TopAbs_EDGE); it.More(); it.Next())
    picture.curves.push_back(edge_points(TopoDS::Edge(it.Current())));
  if (!made.of_wires)
    picture.subtitle += made.sheets.empty()
                            ? ", volume " + number_text(rounded(made.total.result)) + " mm³"
                            : ", area " + number_text(rounded(made.areas.result)) + " mm²";
  TopTools_IndexedMapOfShape known;
  std::vector<int> tools;
  for (const occt::SolidFace& face : made.faces)
    if (known.Add(face.face) > static_cast<int>(tools.size())) tools.push_back(face.tool);
  std::vector<std::pair<TopoDS_Face, int>> faces;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const std::string name = kind + ' ' + std::to_string(i + 1);
    PictureFaces group{{}, palette(i), kFirstOpacity, name};
    for (TopExp_Explorer it(shapes[i], TopAbs_FACE); it.More(); it.Next()) {
      const int number = known.FindIndex(it.Current());
      const int tool = number > 0 ? tools[static_cast<std::size_t>(number) - 1] : -1;
      group.faces.push_back(TopoDS::Face(it.Current()));
      group.labels.push_back(name + "\nface of " +
                             (tool < 0 ? "the part" : "tool " + std::to_string(tool + 1)));
      faces.emplace_back(group.faces.back(), tool);
    }
    picture.groups.push_back(std::move(group));
  }
  PictureLayer cuts{"cut", kCurveColour};
  for (const auto& [edge, owners] : owners_of(faces))
    if (std::set<int>(owners.begin(), owners.end()).size() > 1)
      cuts.items.push_back({edge_points(edge), "where faces of different inputs meet"});
  picture.layers = {std::move(cuts)};
  picture.facts = certificate_facts(made.certificate);
  return picture;
}

}  // namespace blossom::pictures
