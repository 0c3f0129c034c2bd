// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/cuts/trim.h"

#include <cstddef>
#include <map>
#include <utility>

#include "adapters/occt/soundness.h"
#include "plugin/reports/cuts/intersection.h"
#include "plugin/reports/cuts/watertight.h"
#include "plugin/reports/models/measured_input.h"
#include "plugin/reports/models/repairs.h"

namespace blossom::reports {

std::optional<occt::TrimOptions> trim_options(const std::string& keep) {
  static const std::map<std::string, occt::Keep> words = {{"above", occt::Keep::Above},
                                                          {"below", occt::Keep::Below},
                                                          {"inside", occt::Keep::Inside},
                                                          {"outside", occt::Keep::Outside},
                                                          {"all", occt::Keep::All}};
  occt::TrimOptions options;
  if (const auto word = words.find(keep); word != words.end()) {
    options.keep = word->second;
    return options;
  }
  const bool number = !keep.empty() && keep.size() <= 9 &&
                      keep.find_first_not_of("0123456789") == std::string::npos;
  if (!number) return std::nullopt;
  options.keep = occt::Keep::Number;
  options.piece = std::stoi(keep);
  return options;
}

std::vector<occt::PartFace> part_faces(const Input& part) {
  std::vector<occt::PartFace> faces;
  for (int number = 1; number <= part.model.face_count(); ++number)
    faces.push_back({number, part.model.face(number), false});
  for (const int number : part.numbers) faces[static_cast<std::size_t>(number) - 1].cut = true;
  return faces;
}

occt::TrimTool tool_of(const Input& tool) {
  if (!tool.solids.empty() || static_cast<int>(tool.faces.size()) == tool.model.face_count())
    return occt::trim_tool(chosen_shape(tool));
  return {tool.faces, {}};
}

void note_invalid_faces(const Input& tool, occt::TrimResult& made) {
  for (std::size_t i = 0; i < tool.faces.size(); ++i) {
    const std::string fault = occt::face_fault(tool.faces[i]);
    if (fault.empty()) continue;
    made.notes.push_back(tool.name + ": face " + std::to_string(tool.numbers[i]) +
                         " is not valid (" + fault + "); it may cut too much or too little");
    made.status = weaker(made.status, Status::Tolerance);
  }
}

std::string plane_name(std::size_t index) { return "plane " + std::to_string(index + 1); }

Json planes_json(const std::vector<occt::Plane>& planes) {
  Json list = Json::array();
  for (const occt::Plane& plane : planes)
    list.push_back({{"point", plane.point.coordinates}, {"normal", plane.normal.coordinates}});
  return list;
}

Json trim_report(const Input& part, const std::vector<const Input*>& others,
                 const TrimAnswer& answer) {
  Json tools = Json::array(), pieces = Json::array(), areas = Json::array();
  Json repairs = Json::array({repairs_json(part)});
  for (const Input* tool : others) {
    tools.push_back(tool->name);
    repairs.push_back(repairs_json(*tool));
  }
  std::map<int, double> sums;
  for (const occt::TrimPiece& piece : answer.made.pieces) {
    pieces.push_back({{"face", piece.face},
                      {"piece", piece.number},
                      {"side", to_string(piece.side)},
                      {"kept", piece.kept},
                      {"area", piece.area}});
    sums[piece.face] += piece.area;
  }
  for (const auto& [face, area] : answer.made.areas)
    areas.push_back({{"face", face}, {"area", area}, {"pieces", sums[face]}});
  return {{"schema", "blossom.trim/1"},
          {"part", part.name},
          {"tools", std::move(tools)},
          {"planes", planes_json(answer.planes)},
          {"keep", answer.keep},
          {"status", to_string(answer.made.status)},
          {"written", answer.written},
          {"seconds", answer.seconds},
          {"pieces", std::move(pieces)},
          {"areas", std::move(areas)},
          {"notes", answer.made.notes},
          {"watertight", answer.watertight ? to_json(*answer.watertight) : Json(nullptr)},
          {"certificate", to_json(answer.made.certificate)},
          {"repairs", std::move(repairs)}};
}

std::string side_text(occt::PieceSide side) {
  const std::string word = to_string(side);
  return word == "unknown" ? "side undecided" : word;
}

}  // namespace blossom::reports
