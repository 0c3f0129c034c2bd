// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/models/soundness.h"

#include <utility>
#include <vector>

#include "plugin/reports/models/repairs.h"

namespace blossom::reports {
namespace {

Json to_json(const std::vector<occt::Problem>& problems) {
  Json list = Json::array();
  for (const occt::Problem& problem : problems) list.push_back(problem.text());
  return list;
}

Json to_json(const LargestGaps& all) {
  return {{"tolerance", all.tolerance},
          {"gap", all.gap},
          {"same_parameter", all.same_parameter},
          {"vertex_gap", all.vertex_gap},
          {"free_edges", all.free},
          {"crowded_edges", all.crowded}};
}

Json edge_json(const occt::EdgeSoundness& edge) {
  return {{"number", edge.number},
          {"faces", edge.faces},
          {"tolerance", edge.tolerance},
          {"gap", edge.gap},
          {"same_parameter", edge.same_parameter},
          {"vertex_gap", edge.vertex_gap},
          {"vertex_tolerance", edge.vertex_tolerance},
          {"free", edge.free},
          {"crowded", edge.crowded},
          {"problems", to_json(edge.problems)}};
}

}  // namespace

LargestGaps largest_of(const occt::Soundness& found) {
  LargestGaps all;
  for (const occt::EdgeSoundness& edge : found.edges) all.add(edge);
  return all;
}

LargestGaps largest_of(const occt::Soundness& found, const occt::FaceSoundness& face) {
  LargestGaps all;
  for (const occt::EdgeSoundness& edge : found.edges)
    if (std::ranges::find(edge.faces, face.number) != edge.faces.end()) all.add(edge);
  return all;
}

std::size_t problem_count(const occt::Soundness& found) {
  std::size_t count = found.problems.size();
  for (const occt::FaceSoundness& face : found.faces) count += face.problems.size();
  for (const occt::EdgeSoundness& edge : found.edges) count += edge.problems.size();
  return count;
}

const char* verdict_of(const occt::Soundness& found) {
  return problem_count(found) == 0 ? "sound" : "not sound";
}

Json soundness_report(const Input& input, const occt::Soundness& found) {
  Json faces = Json::array(), edges = Json::array();
  for (const occt::FaceSoundness& face : found.faces) {
    Json json = {{"number", face.number}, {"edges", face.edges}};
    json.update(to_json(largest_of(found, face)));
    json["problems"] = to_json(face.problems);
    faces.push_back(std::move(json));
  }
  for (const occt::EdgeSoundness& edge : found.edges) edges.push_back(edge_json(edge));
  const std::size_t count = problem_count(found);
  return {{"schema", "blossom.check/1"},  {"file", input.name},
          {"verdict", verdict_of(found)}, {"sound", count == 0},
          {"problem_count", count},       {"summary", to_json(largest_of(found))},
          {"problems", found.problems},   {"faces", std::move(faces)},
          {"edges", std::move(edges)},    {"repairs", Json::array({repairs_json(input)})}};
}

}  // namespace blossom::reports
