// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/query_bodies.h"

#include <TopExp_Explorer.hxx>

namespace blossom::cli {
namespace {

// The part of a body by its first face; empty if it has none, or no name.
std::string part_of(const Input& input, const occt::Body& body) {
  const TopExp_Explorer first(body.shape, TopAbs_FACE);
  for (std::size_t i = 0; i < input.faces.size() && first.More(); ++i)
    if (input.faces[i].IsSame(first.Current()))
      return given_name(input.model.part_paths()[static_cast<std::size_t>(input.numbers[i] - 1)]);
  return {};
}

}  // namespace

QuerySide::QuerySide(const std::string& name)
    : input(read_input(name, Faces::Optional)), numbers(input.model.shape()) {}

void QuerySide::prepare() { bodies.emplace(chosen_shape(input)); }

Json QuerySide::json(const occt::ShapePoint& place) const {
  return place_json(numbers, input, place);
}

std::string QuerySide::text(const occt::ShapePoint& place) const {
  return place_text(numbers, input, place);
}

int QuerySide::solids() const {
  int count = 0;
  for (const occt::Body& body : bodies->all()) count += body.is_solid() ? 1 : 0;
  return count;
}

int QuerySide::surface_faces() const {
  for (const occt::Body& body : bodies->all())
    if (!body.is_solid()) return body.faces;
  return 0;
}

std::string QuerySide::told_surface() const {
  const int faces = surface_faces();
  if (faces == 0) return {};
  const std::string taken = "taken as a surface, which has no inside: ";
  if (static_cast<int>(input.faces.size()) < input.model.face_count())
    return "  " + input.name + " is " + taken + "it names some faces of the model\n";
  if (solids() == 0) return "  " + input.name + " is " + taken + "it has no closed solid\n";
  return "  " + counted(static_cast<std::size_t>(faces), "face") + " of " + input.name +
         " in no closed solid " + (faces == 1 ? "is " : "are ") + taken +
         "the model has closed solids beside them\n";
}

Json QuerySide::body_json(std::size_t body) const {
  const occt::Body& of = bodies->all()[body];
  Json json = {{"solid", of.is_solid() ? Json(of.solid) : Json()}};
  if (const std::string part = part_of(input, of); of.is_solid() && !part.empty())
    json["part"] = part;
  return json;
}

std::string QuerySide::body_text(std::size_t body) const {
  const occt::Body& of = bodies->all()[body];
  if (!of.is_solid()) return "the surface of " + input.name;
  const std::string part = part_of(input, of);
  return "solid " + std::to_string(of.solid) + " of " + input.name +
         (part.empty() ? "" : " (" + part + ")");
}

namespace {

std::string relation_words(occt::Relation relation, const std::string& a, const std::string& b) {
  if (relation == occt::Relation::AInsideB) return a + " is inside " + b;
  if (relation == occt::Relation::BInsideA) return b + " is inside " + a;
  if (relation == occt::Relation::Unknown) return "how they lie to each other is not known";
  return to_string(relation);
}

std::string pair_line(const occt::BodyPair& pair, const QuerySide& a, const QuerySide& b) {
  const std::string of_a = a.body_text(pair.a), of_b = b.body_text(pair.b);
  return "  " + of_a + " - " + of_b + ": " + relation_words(pair.relation, of_a, of_b) +
         (pair.status == Status::Complete ? "" : std::string(", ") + to_string(pair.status)) + "\n";
}

}  // namespace

std::string relation_text(occt::Relation relation, const QuerySide& a, const QuerySide& b) {
  return relation_words(relation, a.input.name, b.input.name);
}

void add_relation(const occt::ModelRelation& found, const QuerySide& a, const QuerySide& b,
                  Json& report) {
  report["relation"] = to_string(found.relation);
  report["pairs"] = Json::array();
  for (const occt::BodyPair& pair : found.pairs)
    report["pairs"].push_back({{"a", a.body_json(pair.a)},
                               {"b", b.body_json(pair.b)},
                               {"relation", to_string(pair.relation)},
                               {"status", to_string(pair.status)}});
  report["solids_a"] = a.solids();
  report["solids_b"] = b.solids();
  report["surface_faces_a"] = a.surface_faces();
  report["surface_faces_b"] = b.surface_faces();
}

std::string relation_lines(const occt::ModelRelation& found, const QuerySide& a,
                           const QuerySide& b) {
  std::string text;
  if (a.bodies->all().size() > 1 || b.bodies->all().size() > 1)
    for (const occt::BodyPair& pair : found.pairs) text += pair_line(pair, a, b);
  return text + a.told_surface() + b.told_surface();
}

}  // namespace blossom::cli
