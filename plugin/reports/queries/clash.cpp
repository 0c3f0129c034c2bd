// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/queries/clash.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <string_view>
#include <utility>

#include <TopTools_DataMapOfShapeInteger.hxx>

#include "adapters/occt/base/errors.h"
#include "plugin/reports/models/measured_input.h"
#include "plugin/reports/models/repairs.h"
#include "plugin/reports/text/csv.h"

namespace blossom::reports {
namespace {

int rank_of(const ClashRow& row) {
  if (row.clash == nullptr) return 5;
  switch (row.clash->relation) {
    case occt::Relation::Crossing: return 0;
    case occt::Relation::Equal:
    case occt::Relation::AInsideB:
    case occt::Relation::BInsideA: return 1;
    case occt::Relation::Touching: return 2;
    case occt::Relation::Unknown: return 3;
    case occt::Relation::Disjoint: break;
  }
  return row.clash->measured ? 4 : 5;
}

void add_far_pairs(const ClashAnswer& answer, std::vector<ClashRow>& rows) {
  std::vector<std::pair<std::size_t, std::size_t>> known;
  for (const occt::Clash& pair : answer.found.pairs) known.emplace_back(pair.a, pair.b);
  std::ranges::sort(known);
  const std::size_t count = answer.parts.size();
  for (std::size_t a = 0; a < (answer.first_of_b > 0 ? answer.first_of_b : count); ++a)
    for (std::size_t b = std::max(a + 1, answer.first_of_b); b < count; ++b) {
      if (std::ranges::binary_search(known, std::pair(a, b))) continue;
      const auto& boxes = answer.found.boxes;
      rows.push_back({a, b, nullptr, std::sqrt(squared_distance(boxes[a], boxes[b]))});
    }
}

Json part_json(const NamedPart& part) {
  return {{"file", part.input->name},
          {"name", part.name},
          {"part", part.part.empty() ? Json() : Json(part.part)},
          {"solid", part.solid > 0 ? Json(part.solid) : Json()},
          {"faces", part.faces}};
}

Json box_json(const Box& box) { return Json::array({box.low.coordinates, box.high.coordinates}); }

// The numbers of faces of inputs, for any number of contacts.
class NumbersOfFaces {
 public:
  explicit NumbersOfFaces(const std::vector<const Input*>& inputs) {
    for (const Input* const input : inputs)
      for (std::size_t i = 0; i < input->faces.size(); ++i)
        numbers_[input].Bind(input->faces[i], input->numbers[i]);
  }
  Json of(const Input& input, const TopoDS_Face& face) const {
    if (face.IsNull()) return {};
    const int* const number = numbers_.at(&input).Seek(face);
    return number == nullptr ? 0 : *number;
  }

 private:
  std::map<const Input*, TopTools_DataMapOfShapeInteger> numbers_;
};

Json contact_json(const occt::BodyContact& contact, const Input& a, const Input& b,
                  const NumbersOfFaces& numbers) {
  return {{"kind", to_string(contact.kind)},
          {"face_a", numbers.of(a, contact.face_a)},
          {"face_b", numbers.of(b, contact.face_b)},
          {"point", contact.point.coordinates},
          {"box", box_json(contact.box)}};
}

Json pair_json(const ClashRow& row, const ClashAnswer& answer, const NumbersOfFaces& numbers) {
  Json json = {{"a", row.a}, {"b", row.b}, {"relation", clash_word(row)}};
  if (row.clash == nullptr) {
    json["status"] = to_string(Status::Complete);
    json["distance"] = {row.lower, nullptr};
    return json;
  }
  const occt::Clash& clash = *row.clash;
  const Input &a = *answer.parts[row.a].input, &b = *answer.parts[row.b].input;
  json["status"] = to_string(clash.status);
  if (clash.relation == occt::Relation::AInsideB) json["inner"] = "a";
  if (clash.relation == occt::Relation::BInsideA) json["inner"] = "b";
  if (!has_common_points(clash.relation))
    json["distance"] = {clash.lower, clash.measured ? Json(clash.upper) : Json()};
  json["boundary_distance"] = {clash.lower, clash.measured ? Json(clash.upper) : Json()};
  if (clash.measured)
    json["nearest"] = {clash.near_a.point.coordinates, clash.near_b.point.coordinates};
  json["contacts"] = Json::array();
  for (const occt::BodyContact& contact : clash.contacts)
    json["contacts"].push_back(contact_json(contact, a, b, numbers));
  if (clash.common)
    json["common"] = {{"volume", clash.common->volume},
                      {"depth", {clash.common->lower, clash.common->upper}},
                      {"deepest", clash.common->deepest.coordinates},
                      {"solids", clash.common->solids.size()}};
  json["obstacles"] = clash.obstacles;
  return json;
}

ClashRows reported(const ClashAnswer& answer) {
  return answer.lists_far ? ClashRows::All : ClashRows::Near;
}

// Where a pair meets or is nearest.
std::vector<std::string> place_fields(const occt::Clash& clash) {
  const Vec3 at = !clash.contacts.empty() ? clash.contacts.front().point
                  : clash.common          ? clash.common->deepest
                                          : clash.near_a.point;
  return {csv_number(at[0]), csv_number(at[1]), csv_number(at[2])};
}

std::string csv_line(const ClashRow& row, const ClashAnswer& answer) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::string> fields{answer.parts[row.a].name, answer.parts[row.b].name,
                                  clash_word(row)};
  const occt::Clash* const clash = row.clash;
  const bool touches = clash != nullptr && !clash->contacts.empty();
  const bool common = clash != nullptr && clash->common.has_value();
  const bool apart = clash == nullptr || !has_common_points(clash->relation);
  fields.emplace_back(touches ? to_string(clash->contacts.front().kind) : "");
  fields.push_back(csv_number(common ? clash->common->volume : kNone));
  fields.push_back(csv_number(common ? clash->common->lower : kNone));
  fields.push_back(csv_number(common ? clash->common->upper : kNone));
  fields.push_back(csv_number(apart ? row.lower : kNone));
  fields.push_back(csv_number(apart && clash != nullptr && clash->measured ? clash->upper : kNone));
  const bool has_place = touches || common || (clash != nullptr && clash->measured);
  const std::vector<std::string> place =
      has_place ? place_fields(*clash) : std::vector<std::string>(3);
  fields.insert(fields.end(), place.begin(), place.end());
  fields.emplace_back(to_string(clash == nullptr ? Status::Complete : clash->status));
  std::string note;
  if (clash != nullptr)
    for (const std::string& obstacle : clash->obstacles)
      note += (note.empty() ? "" : "; ") + obstacle;
  if (clash != nullptr && clash->relation == occt::Relation::AInsideB) note = "a is inside b";
  if (clash != nullptr && clash->relation == occt::Relation::BInsideA) note = "b is inside a";
  fields.push_back(note);
  return csv_row(fields);
}

// The words of counts in the order of the table.
std::string counts_by_relation(const std::vector<ClashRow>& near, std::size_t all) {
  std::map<std::string, std::size_t> counts;
  for (const ClashRow& row : near) ++counts[clash_word(row)];
  counts["clear"] += all - near.size();
  std::string text;
  for (const char* word : {"penetrates", "contained", "equal", "touches", "clear", "unknown"})
    if (counts[word] > 0) text += ", " + std::to_string(counts[word]) + " " + word;
  return text;
}

}  // namespace

void add_input(ClashAnswer& answer, const Input& input) {
  if (!answer.inputs.empty()) answer.first_of_b = answer.parts.size();
  answer.inputs.push_back(&input);
  for (NamedPart& part : named_parts(input)) answer.parts.push_back(std::move(part));
}

void look_for_clashes(ClashAnswer& answer, const IntersectionOptions& engine) {
  if (answer.parts.size() < 2)
    throw occt::BadModel(answer.inputs.front()->name +
                         ": has one part alone; clash compares two or more, or two models");
  std::vector<TopoDS_Shape> shapes;
  for (const NamedPart& part : answer.parts) shapes.push_back(part.shape);
  const auto start = std::chrono::steady_clock::now();
  answer.found = occt::clashes_of(shapes, {answer.clearance, engine}, answer.first_of_b);
  answer.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

occt::Model common_bodies(const ClashAnswer& answer) {
  occt::Model model;
  for (const ClashRow& row : rows_of(answer, ClashRows::Near)) {
    if (!row.clash->common) continue;
    for (const TopoDS_Solid& solid : row.clash->common->solids)
      model.add(solid, answer.parts[row.a].name + " x " + answer.parts[row.b].name);
  }
  return model;
}

std::string displayed_name(const ClashAnswer& answer, std::size_t part) {
  const NamedPart& named = answer.parts[part];
  if (answer.inputs.size() < 2 || !named.part.empty()) return named.name;
  return std::filesystem::path(named.input->name).filename().string() + " " + named.name;
}

std::size_t pair_count(const ClashAnswer& answer) {
  const std::size_t count = answer.parts.size(), of_a = answer.first_of_b;
  return of_a > 0 ? of_a * (count - of_a) : count * (count - 1) / 2;
}

std::vector<ClashRow> rows_of(const ClashAnswer& answer, ClashRows wanted) {
  std::vector<ClashRow> rows;
  for (const occt::Clash& pair : answer.found.pairs)
    rows.push_back({pair.a, pair.b, &pair, pair.lower});
  if (wanted == ClashRows::All) add_far_pairs(answer, rows);
  std::ranges::stable_sort(rows, {}, rank_of);
  return rows;
}

const char* clash_word(const ClashRow& row) {
  if (row.clash == nullptr) return "clear";
  switch (row.clash->relation) {
    case occt::Relation::Disjoint: return "clear";
    case occt::Relation::Touching: return "touches";
    case occt::Relation::Crossing: return "penetrates";
    case occt::Relation::AInsideB:
    case occt::Relation::BInsideA: return "contained";
    case occt::Relation::Equal: return "equal";
    case occt::Relation::Unknown: break;
  }
  return "unknown";
}

Status status_of(const ClashAnswer& answer) {
  Status status = Status::Complete;
  for (const occt::Clash& pair : answer.found.pairs) status = weaker(status, pair.status);
  return status;
}

bool is_finding(const ClashRow& row, const std::optional<double>& clearance) {
  if (row.clash == nullptr) return false;
  if (has_common_points(row.clash->relation)) return true;
  return clearance && row.clash->measured && row.clash->lower < *clearance;
}

Json clash_report(const ClashAnswer& answer) {
  Json report = {{"schema", "blossom.clash/1"},
                 {"files", Json::array()},
                 {"tolerance", answer.tolerance},
                 {"clearance", answer.clearance ? Json(*answer.clearance) : Json()},
                 {"status", to_string(status_of(answer))},
                 {"seconds", answer.seconds},
                 {"parts", Json::array()},
                 {"counts", Json::object()},
                 {"pairs", Json::array()},
                 {"repairs", Json::array()}};
  for (const Input* input : answer.inputs) {
    report["files"].push_back(input->name);
    report["repairs"].push_back(repairs_json(*input));
  }
  for (const NamedPart& part : answer.parts) report["parts"].push_back(part_json(part));
  for (const char* word : {"penetrates", "contained", "equal", "touches", "clear", "unknown"})
    report["counts"][word] = 0;
  const NumbersOfFaces numbers(answer.inputs);
  for (const ClashRow& row : rows_of(answer, reported(answer))) {
    Json& count = report["counts"][clash_word(row)];
    count = count.get<std::size_t>() + 1;
    report["pairs"].push_back(pair_json(row, answer, numbers));
  }
  Json& clear = report["counts"]["clear"];
  clear = clear.get<std::size_t>() + pair_count(answer) - report["pairs"].size();
  return report;
}

std::string clash_csv(const ClashAnswer& answer) {
  std::string table =
      csv_row({"a", "b", "relation", "contact", "volume", "depth_lower", "depth_upper",
               "distance_lower", "distance_upper", "x", "y", "z", "status", "note"});
  for (const ClashRow& row : rows_of(answer, reported(answer))) table += csv_line(row, answer);
  return table;
}

std::string counted_pairs(const ClashAnswer& answer) {
  const std::size_t all = pair_count(answer);
  return counted(answer.parts.size(), "part") + ", " + counted(all, "pair") +
         counts_by_relation(rows_of(answer, ClashRows::Near), all);
}

}  // namespace blossom::reports
