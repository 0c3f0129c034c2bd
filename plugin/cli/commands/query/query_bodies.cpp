// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/query/query_bodies.h"

namespace blossom::cli {
std::string QuerySide::text(const occt::ShapePoint& place) const {
  return place_text(numbers, input, place);
}

std::string QuerySide::displayed_surface() const {
  const int faces = surface_faces();
  if (faces == 0) return {};
  const std::string taken = "taken as a surface, which has no inside: ";
  if (input.solids.empty() && static_cast<int>(input.faces.size()) < input.model.face_count())
    return "  " + input.name + " is " + taken + "it is some faces of the model\n";
  if (solids() == 0) return "  " + input.name + " is " + taken + "it has no closed solid\n";
  return "  " + counted(static_cast<std::size_t>(faces), "face") + " of " + input.name +
         " in no closed solid " + (faces == 1 ? "is " : "are ") + taken +
         "the model has closed solids beside them\n";
}

std::string QuerySide::body_text(std::size_t body) const {
  const occt::Body& of = bodies->all()[body];
  if (!of.is_solid()) return "the surface of " + input.name;
  const std::string part = reports::part_of(input, of);
  return "solid " + std::to_string(reports::solid_number(input, of)) + " of " + input.name +
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

std::string relation_lines(const occt::ModelRelation& found, const QuerySide& a,
                           const QuerySide& b) {
  std::string text;
  if (a.bodies->all().size() > 1 || b.bodies->all().size() > 1)
    for (const occt::BodyPair& pair : found.pairs) text += pair_line(pair, a, b);
  return text + a.displayed_surface() + b.displayed_surface();
}

}  // namespace blossom::cli
