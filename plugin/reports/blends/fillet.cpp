// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/blends/fillet.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/edge_facts.h"
#include "adapters/occt/full_round.h"
#include "core/base/errors.h"
#include "plugin/reports/blends/blend_words.h"
#include "plugin/reports/models/edges.h"
#include "plugin/reports/models/repairs.h"

namespace blossom::reports {
namespace {

bool can_be_rounded(const occt::EdgeFacts& edge) {
  return edge.kind == occt::EdgeKind::Convex || edge.kind == occt::EdgeKind::Concave;
}

std::string kind_of(const FilletAnswer& answer) { return answer.of.chamfer ? "chamfer" : "fillet"; }

std::string blend_name(const FilletAnswer& answer, const occt::FilletFace& face) {
  return kind_of(answer) +
         (face.edge > 0 ? " of edge " + std::to_string(face.edge) : " of a corner");
}

Json number_or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

// The radii at the ends and at the knots of a law.
Json law_json(const std::optional<RadiusLaw>& law) {
  if (!law) return nullptr;
  std::vector<double> at{0};
  for (const double knot : law->knots()) at.push_back(knot);
  at.push_back(1);
  std::vector<double> radii;
  for (const double share : at) radii.push_back(law->at(share).value);
  return {{"law", to_string(law->kind())}, {"at", at}, {"radii", radii}};
}

// Whether an edge was asked for that has no radius of its own.
bool has_common_radius(const FilletAnswer& answer) {
  return std::ranges::any_of(answer.asked,
                             [&](int edge) { return answer.of.own.count(edge) == 0; });
}

Json own_json(const std::map<int, occt::EdgeRadius>& own) {
  Json radii = Json::array();
  for (const auto& [edge, of] : own)
    radii.push_back({{"edge", edge},
                     {"radius", of.law ? Json(nullptr) : Json(of.radius)},
                     {"law", law_json(of.law)}});
  return radii;
}

// What was asked for across the edges.
Json size_json(const FilletAnswer& answer) {
  const occt::FilletOptions& of = answer.of;
  if (const auto& chamfer = of.chamfer)
    return {{"distance", chamfer->first},
            {"second_distance", number_or_null(chamfer->second)},
            {"angle", number_or_null(chamfer->angle)}};
  const bool conic = of.section.kind == SectionKind::Conic;
  const bool common = has_common_radius(answer) && !of.law;
  return {{"radius", common ? Json(of.radius) : Json(nullptr)},
          {"law", law_json(of.law)},
          {"radii", own_json(of.own)},
          {"section", section_name(of.section)},
          {"setback", number_or_null(of.setback)},
          {"rho", conic ? Json(of.section.rho) : Json(nullptr)}};
}

Json refusal_json(const occt::FilletRefusal& refusal) {
  return {{"edge", refusal.edge > 0 ? Json(refusal.edge) : Json(nullptr)},
          {"fault", to_string(refusal.fault)},
          {"cause", refusal.cause + refusal.tried},
          {"parameter", number_or_null(refusal.parameter)},
          {"point", refusal.point ? Json(refusal.point->coordinates) : Json(nullptr)},
          {"largest_radius", number_or_null(refusal.told_largest())},
          {"largest_is_bound", refusal.at_least}};
}

std::vector<int> edges_to_round(const std::vector<occt::EdgeFacts>& facts,
                                const std::string& kind) {
  std::vector<int> edges;
  for (const occt::EdgeFacts& each : facts)
    if (kind == "all" ? can_be_rounded(each) : kind == to_string(each.kind))
      edges.push_back(each.number);
  return edges;
}

std::string left_out(const std::vector<occt::EdgeFacts>& facts) {
  std::map<occt::EdgeKind, std::vector<int>> others;
  for (const occt::EdgeFacts& each : facts)
    if (!can_be_rounded(each) && each.kind != occt::EdgeKind::Degenerate)
      others[each.kind].push_back(each.number);
  std::string needless, left;
  for (const auto& [kind, edges] : others) {
    const bool is_needless = kind == occt::EdgeKind::Smooth || kind == occt::EdgeKind::Seam;
    std::string& text = is_needless ? needless : left;
    const char* first = is_needless ? "nothing to blend at " : "left out: ";
    text += (text.empty() ? first : ", ") +
            counted(edges.size(), std::string(to_string(kind)) + " edge");
    if (is_needless) continue;
    text += " (";
    for (const int edge : edges) text += (edge == edges.front() ? "" : ", ") + std::to_string(edge);
    text += ")";
  }
  return left + (left.empty() || needless.empty() ? "" : "; ") + needless;
}

std::vector<int> edges_between(const std::vector<occt::EdgeFacts>& facts, int face, int other) {
  const std::vector<int> pair{std::min(face, other), std::max(face, other)};
  std::vector<int> edges;
  for (const occt::EdgeFacts& each : facts) {
    std::vector<int> faces = each.faces;
    std::ranges::sort(faces);
    if (faces == pair && each.kind != occt::EdgeKind::Degenerate) edges.push_back(each.number);
  }
  return edges;
}

bool is_whole(const Input& part) {
  return static_cast<int>(part.numbers.size()) == part.model.face_count();
}

void add_between(const Input& part, std::pair<int, int> faces,
                 const std::vector<occt::EdgeFacts>& facts, std::set<int>& edges) {
  const std::vector<int> common = edges_between(facts, faces.first, faces.second);
  if (common.empty())
    throw InvalidInput(
        part.name + ": faces " + std::to_string(std::min(faces.first, faces.second)) + " and " +
        std::to_string(std::max(faces.first, faces.second)) + " have no edge in common");
  edges.insert(common.begin(), common.end());
}

void refuse_edges_beside(const Input& part, const std::set<int>& edges) {
  if (is_whole(part)) return;
  const std::set<int> own = edge_numbers(part);
  TopTools_IndexedMapOfShape all;  // an edge that is not there at all is told by who rounds it
  TopExp::MapShapes(part.model.shape(), TopAbs_EDGE, all);
  for (const int edge : edges)
    if (edge <= all.Extent() && !own.contains(edge))
      throw InvalidInput(part.name + ": edge " + std::to_string(edge) +
                         " is of another part; info --edges has the numbers");
}

}  // namespace

std::vector<int> edges_asked(const EdgeWish& wish, const Input& part, std::string& note) {
  std::set<int> edges = wish.edges;
  if (!wish.kind.empty() || wish.between) {
    std::vector<occt::EdgeFacts> facts = occt::edge_facts(part.model.shape());
    if (!is_whole(part)) {
      const std::set<int> own = edge_numbers(part);
      std::erase_if(facts, [&](const occt::EdgeFacts& edge) { return !own.contains(edge.number); });
    }
    if (wish.between) add_between(part, *wish.between, facts, edges);
    if (wish.kind == "all") note = left_out(facts);
    if (!wish.kind.empty())
      for (const int edge : edges_to_round(facts, wish.kind)) edges.insert(edge);
  }
  refuse_edges_beside(part, edges);
  if (edges.empty())
    throw occt::BadModel(part.name + ": it has no " +
                         (wish.kind.empty() || wish.kind == "all" ? "" : wish.kind + " ") +
                         "edges that can be rounded");
  return {edges.begin(), edges.end()};
}

std::map<int, occt::EdgeRadius> full_round_of(const Input& part, const std::vector<int>& edges) {
  if (edges.size() != 2)
    throw InvalidInput("a full round takes two edges, not " + std::to_string(edges.size()));
  return occt::full_round_radii(part.model.shape(), edges[0], edges[1]);
}

bool is_unchanged(const occt::FilletResult& made) {
  return made.solids.empty() && made.status != Status::Stopped && !made.refused.empty() &&
         std::ranges::all_of(made.refused, [](const occt::FilletRefusal& each) {
           return each.fault == occt::FilletFault::Nothing;
         });
}

const char* status_word(const occt::FilletResult& made) {
  if (made.status == Status::Stopped) return to_string(made.status);
  if (made.solids.empty() && !is_unchanged(made)) return "refused";
  return to_string(made.refused.empty() ? made.status : Status::Tolerance);
}

double volume_of(const occt::FilletResult& made) {
  double volume = 0;
  for (const occt::FilletedSolid& solid : made.solids) volume += solid.volume;
  return volume;
}

occt::Model blends_of(const FilletAnswer& answer) {
  occt::Model blends;
  for (const occt::FilletedSolid& solid : answer.made.solids)
    for (const occt::FilletFace& face : solid.faces)
      if (face.from == 0) blends.add(face.face, blend_name(answer, face));
  return blends;
}

void put_fillets(occt::Model& part, const FilletAnswer& answer) {
  if (answer.made.solids.empty()) return;
  const occt::Model blends = blends_of(answer);
  std::vector<occt::CombinedSolid> solids;
  int next = 0;
  for (const occt::FilletedSolid& each : answer.made.solids) {
    solids.push_back({each.solid, {}});
    for (const occt::FilletFace& face : each.faces)
      solids.back().faces.push_back(face.from > 0 ? occt::FaceOrigin{face.face, &part, face.from}
                                                  : occt::FaceOrigin{face.face, &blends, ++next});
  }
  part.replace_solids(solids);
}

Json fillet_report(const Input& part, const FilletAnswer& answer) {
  Json refused = Json::array();
  for (const occt::FilletRefusal& each : answer.made.refused) refused.push_back(refusal_json(each));
  const bool any = !answer.made.solids.empty();
  Json report = {{"schema", "blossom.blend/1"}, {"kind", kind_of(answer)}, {"part", part.name}};
  report.update(size_json(answer));
  report.update({{"status", status_word(answer.made)},
                 {"asked", answer.asked},
                 {"edges", answer.made.edges},
                 {"refused", std::move(refused)},
                 {"notes", answer.made.notes},
                 {"written", answer.written},
                 {"volume",
                  {{"before", answer.made.volume_before},
                   {"after", any ? Json(volume_of(answer.made)) : Json(nullptr)}}},
                 {"seconds", answer.seconds},
                 {"repairs", Json::array({repairs_json(part)})}});
  return report;
}

std::string done_text(const FilletAnswer& answer) {
  if (is_unchanged(answer.made)) return "the part is as it was";
  if (answer.made.solids.empty()) return "refused";
  return counted(answer.made.edges.size(), "edge") + (answer.of.chamfer ? " cut off" : " rounded");
}

}  // namespace blossom::reports
