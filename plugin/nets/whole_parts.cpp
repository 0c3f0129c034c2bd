// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/nets/whole_parts.h"

#include <map>
#include <utility>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "core/base/tolerances.h"
#include "plugin/nets/net_json.h"
#include "plugin/nets/whole.h"
#include "plugin/reports/models/repairs.h"

namespace blossom::nets {
namespace {

WholePart whole_face(const reports::Input& input, std::size_t i,
                     const std::vector<std::string>& names,
                     const std::optional<std::array<Interval, 2>>& rectangle) {
  WholePart part;
  part.source.file = input.model.file().string();
  part.source.face = input.numbers[i];
  part.source.name = names[static_cast<std::size_t>(part.source.face) - 1];
  const auto surface = whole_surface(input.faces[i], part.source, rectangle);
  BRepBuilderAPI_MakeFace maker(surface, Tolerances{}.point);
  if (!maker.IsDone()) throw occt::BadModel(text_of(part.source) + ": gives no face");
  part.shape = maker.Shape().Oriented(input.faces[i].Orientation());
  part.json = spline_json(*surface);
  part.json["face"] = part.source.face;
  return part;
}

std::vector<WholePart> whole_edges(const reports::Input& input, const WholeCut& cut) {
  TopTools_IndexedMapOfShape numbered, wanted;
  TopExp::MapShapes(input.model.shape(), TopAbs_EDGE, numbered);
  for (const TopoDS_Face& face : input.faces) TopExp::MapShapes(face, TopAbs_EDGE, wanted);
  for (const int number : input.edges) wanted.Add(numbered(number));
  std::vector<WholePart> parts;
  for (int number = 1; number <= numbered.Extent(); ++number) {
    if (!cut.all_edges && !wanted.Contains(numbered(number))) continue;
    ask(cut.stop);
    WholePart part;
    part.source.file = input.model.file().string();
    part.source.edge = number;
    const auto curve = whole_curve(TopoDS::Edge(numbered(number)), part.source, cut.interval);
    if (curve.IsNull()) continue;
    BRepBuilderAPI_MakeEdge maker(curve);
    if (!maker.IsDone())
      throw occt::BadModel(text_of(part.source) + ": gives no edge: is it a point?");
    part.shape = maker.Shape();
    part.json = spline_json(*curve);
    part.json["edge"] = number;
    parts.push_back(std::move(part));
  }
  if (parts.empty())
    throw occt::BadModel(input.model.file().string() + ": there is no edge with a curve in it");
  return parts;
}

}  // namespace

std::vector<WholePart> whole_parts(const reports::Input& input, const WholeCut& cut) {
  if (cut.interval || input.faces.empty()) return whole_edges(input, cut);
  const std::vector<std::string> names = input.model.face_names();
  std::vector<WholePart> parts;
  for (std::size_t i = 0; i < input.faces.size(); ++i) {
    ask(cut.stop);
    parts.push_back(whole_face(input, i, names, cut.rectangle));
  }
  return parts;
}

void put_whole_faces(occt::Model& model, const std::vector<WholePart>& parts) {
  std::map<int, std::vector<TopoDS_Face>> faces;
  for (int number = 1; number <= model.face_count(); ++number) faces[number];
  for (const WholePart& part : parts) faces[part.source.face] = {TopoDS::Face(part.shape)};
  model.replace_faces(faces);
}

occt::Model model_of_whole_edges(const std::vector<WholePart>& parts) {
  occt::Model model;
  for (const WholePart& part : parts) model.add(part.shape, name_of(part.source));
  return model;
}

reports::Json whole_report(const reports::Input& input, const WholeCut& cut,
                           const std::vector<WholePart>& parts, double seconds) {
  reports::Json json = {{"schema", "blossom.subdivision/1"},
                        {"file", input.name},
                        {"whole", true},
                        {"interval", nullptr},
                        {"rectangle", nullptr},
                        {"seconds", seconds},
                        {"pieces", parts.size()},
                        {"splines", reports::Json::array()},
                        {"repairs", reports::Json::array({reports::repairs_json(input)})}};
  if (const auto& i = cut.interval) json["interval"] = {i->from, i->to};
  if (const auto& r = cut.rectangle)
    json["rectangle"] = {(*r)[0].from, (*r)[0].to, (*r)[1].from, (*r)[1].to};
  for (const WholePart& part : parts) json["splines"].push_back(part.json);
  return json;
}

}  // namespace blossom::nets
