// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom query KIND ...`: questions about points of models.

#include "plugin/cli/arguments/options.h"
#include "plugin/cli/arguments/values.h"
#include "plugin/cli/commands/commands.h"
#include "plugin/cli/commands/query/query_parts.h"
#include "plugin/cli/exit_code.h"

namespace blossom::cli {

void add_query_options(CLI::App& command, QueryOptions& options) {
  add_report_options(command, options);
  command.add_option("--tolerance", options.tolerance, "what counts as one point, mm")
      ->check(positive_number())
      ->type_name("T")
      ->default_str(number_text(options.tolerance))
      ->group(kShared);
}

std::string place_text(const ShapeNumbers& numbers, const Input& input,
                       const occt::ShapePoint& place) {
  const int face = reports::face_number(input, place.on);
  const std::string part = reports::part_with(input, place.on);
  return vector_text(place.point) + " on " +
         numbers.text(face > 0 ? TopoDS_Shape() : place.on, face) +
         (part.empty() ? "" : " of " + part);
}

void write_answer(const Json& report, const std::string& text, const QueryOptions& options) {
  if (!options.json.empty()) write_json(report, options.json);
  print_summary(text, options.json);
}

void add_query(CLI::App& app, int& exit_code) {
  CLI::App* const query = app.add_subcommand(
      "query", "plane sections, what a ray hits, closest points, distances, masses");
  query->require_subcommand(1);
  add_query_plane(*query, exit_code);
  add_query_ray(*query, exit_code);
  add_query_point(*query, exit_code);
  add_query_distance(*query, exit_code);
  add_query_does_intersect(*query, exit_code);
  add_query_mass(*query, exit_code);
}

}  // namespace blossom::cli
