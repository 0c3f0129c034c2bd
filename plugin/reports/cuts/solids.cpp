// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/cuts/solids.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <sstream>
#include <string>
#include <utility>

#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "adapters/occt/soundness.h"
#include "plugin/reports/cuts/intersection.h"
#include "plugin/reports/cuts/trim.h"
#include "plugin/reports/cuts/watertight.h"

namespace blossom::reports {
namespace {

// What a tool is called: the files come first.
std::string tool_name(const SolidAnswer& answer, int tool) {
  const auto index = static_cast<std::size_t>(tool);
  return index < answer.tools.size() ? answer.tools[index]
                                     : plane_name(index - answer.tools.size());
}

// Relative. Lengths of what is not cut differ by rounding of their sums.
constexpr double kSameLength = 1e-9;

// Faces that nothing reached are those of the inputs, and may be invalid as they were given.
std::vector<std::string> invalid_as_given(const SolidAnswer& answer) {
  std::vector<std::string> told;
  for (const occt::SolidFace& face : answer.made.faces) {
    const std::string fault = face.as_given ? occt::face_fault(face.face) : "";
    if (fault.empty()) continue;
    const std::string file = face.tool < 0 ? answer.part : tool_name(answer, face.tool);
    told.push_back("face " + std::to_string(face.from + 1) + " of " + file + " is not valid (" +
                   fault + "), and in the result as it was given");
  }
  return told;
}

// Whether a cut left all of the part's wires.
bool leaves_all_wires(const SolidAnswer& answer) {
  const occt::TotalLengths& lengths = answer.made.lengths;
  return answer.made.of_wires && answer.operation == "cut" && answer.made.obstacles.empty() &&
         lengths.part > 0 && lengths.part - lengths.result <= kSameLength * lengths.part;
}

// Planes, and tools that are to split, of which nothing is in the result. What is cut off may have
// been all of a solid. Of what cuts wires only all together tell.
std::vector<std::string> idle_tools(const SolidAnswer& answer) {
  const std::size_t all = answer.tools.size() + answer.planes.size();
  const std::size_t first = answer.operation == "split" ? 0 : answer.tools.size();
  std::vector<std::string> told;
  for (std::size_t i = 0; i < all && leaves_all_wires(answer); ++i)
    told.push_back(tool_name(answer, static_cast<int>(i)) + " cuts nothing of the wires");
  for (std::size_t i = first; i < all && !answer.made.solids.empty(); ++i)
    if (std::ranges::none_of(answer.made.faces, [i](const occt::SolidFace& face) {
          return face.tool == static_cast<int>(i);
        }))
      told.push_back(tool_name(answer, static_cast<int>(i)) +
                     " cuts nothing of what is in the result");
  return told;
}

int face_count(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  return faces.Extent();
}

int shell_count(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape shells;
  TopExp::MapShapes(shape, TopAbs_SHELL, shells);
  return shells.Extent();
}

int edge_count(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape edges;
  if (!shape.IsNull()) TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  return edges.Extent();
}

// Those of no edge.
std::size_t lone_vertices(const TopoDS_Shape& shape) {
  std::size_t count = 0;
  if (shape.IsNull()) return count;
  for (TopExp_Explorer it(shape, TopAbs_VERTEX, TopAbs_EDGE); it.More(); it.Next()) ++count;
  return count;
}

Json volumes_json(const occt::SolidVolumes& volumes) {
  return {{"part", volumes.part},
          {"tool", volumes.tool},
          {"cut", volumes.cut},
          {"common", volumes.common},
          {"fuse", volumes.fuse},
          {"cut_error", volumes.cut_error()},
          {"fuse_error", volumes.fuse_error()}};
}

std::string input_name(int tool) {
  return tool < 0 ? "the part" : "tool " + std::to_string(tool + 1);
}

std::string sentence(const occt::Finding& finding) {
  const std::vector<occt::InputFace>& faces = finding.faces;
  std::ostringstream text;
  text << input_name(faces.front().tool) << " meets itself: its face " << faces.front().face + 1;
  text << (faces.size() == 1 ? " meets itself"
                             : " meets face " + std::to_string(faces.back().face + 1) +
                                   " beside what they share");
  if (const auto& at = finding.point)
    text << ", at (" << (*at)[0] << ", " << (*at)[1] << ", " << (*at)[2] << ")";
  return text.str();
}

Json findings_json(const std::vector<occt::Finding>& findings) {
  Json all = Json::array();
  for (const occt::Finding& finding : findings) {
    Json faces = Json::array();
    for (const occt::InputFace& face : finding.faces)
      faces.push_back(
          {{"tool", face.tool < 0 ? Json() : Json(face.tool + 1)}, {"face", face.face + 1}});
    all.push_back({{"code", "input-meets-itself"},
                   {"faces", std::move(faces)},
                   {"point", finding.point ? to_json(*finding.point) : Json()},
                   {"size", finding.size}});
  }
  return all;
}

}  // namespace

std::optional<occt::SolidOperation> solid_operation(const std::string& word) {
  static const std::map<std::string, occt::SolidOperation> operations = {
      {"cut", occt::SolidOperation::Cut},
      {"common", occt::SolidOperation::Common},
      {"fuse", occt::SolidOperation::Fuse},
      {"split", occt::SolidOperation::Split}};
  const auto found = operations.find(word);
  if (found == operations.end()) return std::nullopt;
  return found->second;
}

std::vector<occt::FaceOrigin> origins_of(const TopoDS_Shape& shape,
                                         const occt::SolidTrimResult& made, const occt::Model& part,
                                         const std::vector<const occt::Model*>& tools) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  std::vector<occt::FaceOrigin> origins;
  for (const occt::SolidFace& face : made.faces)
    if (faces.RemoveKey(face.face))
      origins.push_back({face.face,
                         face.tool < 0 ? &part : tools[static_cast<std::size_t>(face.tool)],
                         face.from + 1});
  return origins;
}

occt::Model sheets_model(const occt::SolidTrimResult& made, const occt::Model& part,
                         const std::vector<const occt::Model*>& tools) {
  occt::Model model;
  int number = 0;
  for (const TopoDS_Shell& sheet : made.sheets) {
    const std::vector<occt::FaceOrigin> origins = origins_of(sheet, made, part, tools);
    std::string name = origins.front().model->part_name(origins.front().number);
    if (name.empty()) name = "sheet";
    if (made.sheets.size() > 1) name += "." + std::to_string(++number);
    model.add_combined(sheet, name, origins);
  }
  return model;
}

occt::Model wires_model(const occt::SolidTrimResult& made, const occt::Model& part) {
  const std::vector<occt::AssemblyNode> roots = part.assembly();
  std::string name;
  if (part.face_count() > 0)
    name = part.part_name(1);
  else if (!roots.empty())
    name = roots.front().name;
  occt::Model model;
  model.add(made.wires, name.empty() ? "wires" : name);
  return model;
}

std::string counted_wires(const occt::SolidTrimResult& made) {
  const auto edges = static_cast<std::size_t>(edge_count(made.wires));
  const std::size_t vertices = lone_vertices(made.wires);
  return counted(edges, "edge") + (vertices == 1  ? " and a vertex"
                                   : vertices > 1 ? " and " + std::to_string(vertices) + " vertices"
                                                  : "");
}

void note_faces(SolidAnswer& answer) {
  answer.invalid = invalid_as_given(answer);
  answer.idle = idle_tools(answer);
}

std::vector<std::string> causes(const occt::SolidTrimResult& made) {
  std::vector<std::string> all;
  for (const occt::Finding& finding : made.findings) all.push_back(sentence(finding));
  all.insert(all.end(), made.obstacles.begin(), made.obstacles.end());
  return all;
}

Json solid_report(const SolidAnswer& answer) {
  Json solids = Json::array(), steps = Json::array(), sheets = Json::array();
  for (const TopoDS_Shell& sheet : answer.made.sheets)
    sheets.push_back({{"faces", face_count(sheet)}});
  for (const occt::SolidVolumes& volumes : answer.made.volumes)
    steps.push_back(volumes_json(volumes));
  for (const TopoDS_Solid& solid : answer.made.solids)
    solids.push_back({{"faces", face_count(solid)}, {"voids", shell_count(solid) - 1}});
  return {{"schema", "blossom.solid/1"},
          {"part", answer.part},
          {"tools", answer.tools},
          {"planes", planes_json(answer.planes)},
          {"operation", answer.operation},
          {"status", to_string(answer.made.status)},
          {"written", answer.written},
          {"seconds", answer.seconds},
          {"solids", std::move(solids)},
          {"sheets", std::move(sheets)},
          {"open_part", answer.made.open_part.empty() ? Json() : Json(answer.made.open_part)},
          {"areas",
           {{"part", answer.made.areas.part},
            {"tools", answer.made.areas.tools},
            {"result", answer.made.areas.result}}},
          {"wires",
           {{"edges", edge_count(answer.made.wires)},
            {"vertices", lone_vertices(answer.made.wires)},
            {"lengths",
             {{"part", answer.made.lengths.part},
              {"tools", answer.made.lengths.tools},
              {"result", answer.made.lengths.result}}}}},
          {"volumes", steps.empty() ? Json(nullptr) : steps.back()},
          {"steps", steps},
          {"total",
           {{"part", answer.made.total.part},
            {"tools", answer.made.total.tools},
            {"result", answer.made.total.result}}},
          {"left_out", answer.made.left_out},
          {"obstacles", causes(answer.made)},
          {"findings", findings_json(answer.made.findings)},
          {"thin", answer.made.merged},
          {"tolerances", answer.made.tolerances},
          {"invalid", answer.invalid},
          {"idle", answer.idle},
          {"watertight", answer.watertight ? to_json(*answer.watertight) : Json(nullptr)},
          {"certificate", to_json(answer.made.certificate)},
          {"repairs", answer.repairs}};
}

}  // namespace blossom::reports
