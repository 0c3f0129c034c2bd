// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom query KIND ...`: questions about points of models.

#include <TopExp_Explorer.hxx>

#include "adapters/occt/base/compounds.h"
#include "plugin/cli/commands/commands.h"
#include "plugin/cli/commands/query_parts.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/options.h"
#include "plugin/cli/values.h"

namespace blossom::cli {

void add_query_options(CLI::App& command, QueryOptions& options) {
  add_report_options(command, options);
  command.add_option("--tolerance", options.tolerance, "what counts as one point, in model units")
      ->check(positive_number())
      ->type_name("T")
      ->default_str(number_text(options.tolerance));
}

namespace {

// The number of a face in its model; 0 of what is no face.
int face_number(const Input& input, const TopoDS_Shape& on) {
  for (std::size_t i = 0; i < input.faces.size(); ++i)
    if (input.faces[i].IsSame(on)) return input.numbers[i];
  return 0;
}

// The part that a face belongs to, or a face with the edge or vertex; empty if it has no name.
std::string part_with(const Input& input, const TopoDS_Shape& on) {
  for (std::size_t i = 0; i < input.faces.size() && !on.IsNull(); ++i)
    for (TopExp_Explorer it(input.faces[i], on.ShapeType()); it.More(); it.Next())
      if (it.Current().IsSame(on))
        return given_name(input.model.part_paths()[static_cast<std::size_t>(input.numbers[i] - 1)]);
  return {};
}

}  // namespace

Json place_json(const ShapeNumbers& numbers, const Input& input, const occt::ShapePoint& place) {
  const int face = face_number(input, place.on);
  Json json = {{"point", place.point.coordinates},
               {"on", numbers.place(face > 0 ? TopoDS_Shape() : place.on, face)}};
  if (face > 0) json["uv"] = place.uv.coordinates;
  if (const std::string part = part_with(input, place.on); !part.empty()) json["part"] = part;
  return json;
}

std::string place_text(const ShapeNumbers& numbers, const Input& input,
                       const occt::ShapePoint& place) {
  const int face = face_number(input, place.on);
  const std::string part = part_with(input, place.on);
  return vector_text(place.point) + " on " +
         numbers.text(face > 0 ? TopoDS_Shape() : place.on, face) +
         (part.empty() ? "" : " of " + part);
}

TopoDS_Shape chosen_shape(const Input& input) {
  if (input.faces.empty() || static_cast<int>(input.faces.size()) == input.model.face_count())
    return input.model.shape();
  return occt::compound_of(input.faces);
}

void write_answer(const Json& report, const std::string& text, const QueryOptions& options) {
  if (!options.json.empty()) write_json(report, options.json);
  print_summary(text, options.json);
}

void add_query(CLI::App& app, int& exit_code) {
  CLI::App* const query =
      app.add_subcommand("query", "plane sections, what a ray hits, closest points, distances");
  query->require_subcommand(1);
  add_query_plane(*query, exit_code);
  add_query_ray(*query, exit_code);
  add_query_point(*query, exit_code);
  add_query_distance(*query, exit_code);
  add_query_does_intersect(*query, exit_code);
}

}  // namespace blossom::cli
