// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom query plane F --point P --normal N`: the section of a model with a plane, or with many.

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>
#include <string>
#include <utility>

#include "adapters/occt/plane_section.h"
#include "core/base/parallel.h"
#include "plugin/cli/arguments/options.h"
#include "plugin/cli/arguments/values.h"
#include "plugin/cli/commands/intersect/intersection_text.h"
#include "plugin/cli/commands/meshes/mesh_meetings.h"
#include "plugin/cli/commands/meshes/meshed_input.h"
#include "plugin/cli/commands/query/query_parts.h"
#include "plugin/cli/commands/query/query_planes.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/reading.h"
#include "plugin/cli/output/reasons.h"
#include "plugin/cli/output/verbosity.h"
#include "plugin/cli/picture/files.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/cli/process/progress.h"
#include "plugin/pictures/results/sections.h"
#include "plugin/reports/models/edges.h"
#include "plugin/reports/queries/plane_cuts.h"
#include "plugin/reports/queries/section.h"

namespace blossom::cli {
namespace {

struct PlaneCommand {
  std::string input;
  std::string point;
  std::string normal;
  std::string offsets;
  std::vector<std::string> given;  // one by one
  std::string planes;              // a file
  CommonOptions common;
  EngineOptions engine;
};

struct Answer {
  occt::Plane plane;
  occt::PlaneSection section;
  double seconds = 0;
};

occt::Plane plane_of(const PlaneCommand& options) {
  if (!options.given.empty()) return parse_plane(options.given.front(), "--plane");
  occt::Plane plane{parse_vector(options.point, "--point"),
                    parse_vector(options.normal, "--normal")};
  const double largest = max_norm(plane.normal);
  if (largest == 0) throw UsageError("--normal: the zero vector has no direction");
  plane.normal = unit(plane.normal * (1 / largest));
  return plane;
}

void list_places(const Input& input, const occt::PlaneSection& section, std::ostream& text) {
  constexpr std::size_t kFew = 20;
  std::vector<Vec3> points;
  for (const std::size_t node : section.points) points.push_back(section.nodes[node].point);
  const bool all = verbosity() == Verbosity::Verbose || section.places.size() <= kFew;
  for (std::size_t i = 0; i < (all ? section.places.size() : kFew); ++i) {
    const auto& [face, place] = section.places[i];
    text << "  face " << input.numbers[static_cast<std::size_t>(face)] << ": "
         << place_text(place, points) << "\n";
  }
  if (!all)
    text << "  and " << section.places.size() - kFew << " more such places, which -v lists\n";
}

std::string text_of(const Input& input, const Answer& answer) {
  const occt::PlaneSection& section = answer.section;
  std::ostringstream text;
  text.precision(12);
  text << input.name << ": " << to_string(stated(section.status)) << ", "
       << counted(section.wires.size(), "wire") << ", " << counted(section.curves.size(), "curve")
       << ", " << counted(section.points.size(), "point") << ", "
       << counted(section.faces_in_plane.size(), "face") << " in the plane";
  const auto open = static_cast<std::size_t>(std::ranges::count_if(
      section.places, [](const auto& each) { return each.place.kind == PlaceKind::Open; }));
  if (const std::size_t contacts = section.places.size() - open; contacts > 0)
    text << ", " << counted(contacts, "contact") << " within tolerance";
  if (open > 0) text << ", " << counted(open, "unresolved region");
  text << ", " << seconds_text(answer.seconds) << "\n";
  for (const occt::SectionWire& wire : section.wires) {
    text << "  " << (wire.closed ? "closed" : "open") << ", " << counted(wire.uses.size(), "curve")
         << ", length " << wire.length;
    if (wire.bounding && wire.area) text << ", area " << std::abs(*wire.area);
    const bool loose = section.curves[wire.uses.front().curve].face < 0;
    text << (loose           ? ", of edges without faces\n"
             : wire.bounding ? "\n"
                             : ", inside the section or only touching\n");
  }
  for (const std::size_t node : section.points)
    text << "  point " << vector_text(without_roundings(section.nodes[node].point)) << "\n";
  list_places(input, section, text);
  for (const std::string& reason : reported_reasons(section.certificate, Contacts::Listed))
    text << "  " << reason << "\n";
  return text.str();
}

void write_outputs(const Input& input, const PlaneCommand& options, const Answer& answer) {
  const occt::PlaneSection& section = answer.section;
  const CommonOptions& common = options.common;
  const bool any = !section.wires.empty() || !section.points.empty();
  const bool report = ending_of(common.output) == ".json";
  const bool shapes = !common.output.empty() && !report;
  const std::vector<PictureFile> pictures = picture_files(
      common, [&] { return pictures::section_picture(input, section, stated(section.status)); });
  stop_if_interrupted();
  if (shapes && any) write_parts(input, {answer.plane, "section"}, options.engine, common.output);
  const Json json = reports::section_report(input, answer.plane, options.engine.tolerance, section,
                                            answer.seconds);
  if (report) write_json(json, common.output);
  if (shapes && !any) report_nothing_found(common.output, "no wire and no point was found");
  write_pictures(pictures);
  if (!common.json.empty()) write_json(json, common.json);
  print_summary(text_of(input, answer), common.json);
}

// Of the planes that were asked for, when they are many; none if it is a single one.
std::vector<reports::NamedPlane> planes_of(const PlaneCommand& options) {
  if (!options.planes.empty()) return planes_in(options.planes);
  std::vector<reports::NamedPlane> planes;
  for (const std::string& each : options.given)
    planes.push_back({parse_plane(each, "--plane"), "plane " + std::to_string(planes.size() + 1)});
  if (planes.size() > 1) return planes;
  if (options.offsets.empty()) return {};
  PlaneCommand base = options;
  if (base.point.empty()) base.point = "0,0,0";
  if (base.normal.empty()) base.normal = "0,0,1";
  return planes_at(options.offsets, plane_of(base));
}

void check_question(const PlaneCommand& options) {
  if (!options.offsets.empty() || !options.planes.empty() || !options.given.empty()) return;
  if (options.point.empty())
    throw UsageError(
        "query plane needs --plane X,Y,Z,NX,NY,NZ (a point and the normal), --point X,Y,Z with "
        "--normal, --offsets FROM:TO:NUMBER or --planes FILE");
  if (options.normal.empty())
    throw UsageError("query plane needs --normal X,Y,Z (its normal; of any length)");
}

int run(const PlaneCommand& options) {
  check_question(options);
  std::vector<std::string> inputs{options.input};
  if (!options.planes.empty()) inputs.push_back(options.planes);
  check_files(options.common, inputs, Outputs::ModelsAndDrawings);
  start_threads(options.engine.threads);
  if (std::vector<reports::NamedPlane> planes = planes_of(options); !planes.empty())
    return is_mesh_input(options.input)
               ? run_mesh_sections(options.input, planes, options.common)
               : run_planes(options.input, std::move(planes), options.common, options.engine);
  Answer answer;
  answer.plane = plane_of(options);
  if (is_mesh_input(options.input))
    return run_mesh_sections(options.input, {{answer.plane, "section"}}, options.common);
  const Input input = input_to_cut(options.input);
  stop_if_interrupted();
  {
    Progress progress("cutting");
    const IntersectionOptions engine = intersection_options(options.engine, progress);
    const Stopwatch watch;
    answer.section =
        occt::plane_section(input.faces, answer.plane, engine, reports::edges_without_faces(input));
    answer.seconds = watch.seconds();
  }
  stop_if_interrupted();
  write_outputs(input, options, answer);
  return exit_code(answer.section.status);
}

}  // namespace

void add_query_plane(CLI::App& query, int& exit_code) {
  CLI::App* const command = query.add_subcommand("plane", "the section of a model with a plane");
  const auto options = std::make_shared<PlaneCommand>();
  command->add_option("input", options->input, "model, some of its faces, or triangles")
      ->required()
      ->type_name("FILE");
  CLI::Option* const point =
      command->add_option("--point", options->point, "a point of the plane")->type_name("X,Y,Z");
  CLI::Option* const normal =
      command->add_option("--normal", options->normal, "its normal; of any length")
          ->type_name("X,Y,Z");
  CLI::Option* const offsets =
      command
          ->add_option("--offsets", options->offsets,
                       "so many planes instead of one, from the first offset along the normal to "
                       "the last, or one at an offset; the point is then 0,0,0 and the normal "
                       "0,0,1 unless given")
          ->type_name("FROM:TO:NUMBER");
  CLI::Option* const plane =
      command
          ->add_option("--plane", options->given,
                       "a plane by a point and its normal; may be given several times")
          ->type_name("X,Y,Z,NX,NY,NZ")
          ->allow_extra_args(false)
          ->excludes(point)
          ->excludes(normal)
          ->excludes(offsets);
  command
      ->add_option("--planes", options->planes,
                   "planes of a file, one a line: X,Y,Z,NX,NY,NZ and perhaps a name")
      ->type_name("FILE")
      ->excludes(point)
      ->excludes(normal)
      ->excludes(offsets)
      ->excludes(plane);
  add_common_options(*command, options->common,
                     "write the wires (.step, .brep, .iges, .dxf, .svg, .json)");
  add_engine_options(*command, options->engine);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace blossom::cli
