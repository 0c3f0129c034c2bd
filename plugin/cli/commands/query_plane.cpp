// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom query plane F --point P --normal N`: the section of a model with a plane.

#include <memory>
#include <sstream>
#include <string>
#include <utility>

#include "adapters/occt/plane_section.h"
#include "core/base/parallel.h"
#include "plugin/cli/commands/query_parts.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/interruption.h"
#include "plugin/cli/options.h"
#include "plugin/cli/picture/picture.h"
#include "plugin/cli/progress.h"
#include "plugin/cli/reading.h"
#include "plugin/reports/section.h"

namespace blossom::cli {
namespace {

struct Options {
  std::string input;
  std::string point;
  std::string normal;
  CommonOptions common;
  EngineOptions engine;
};

struct Answer {
  occt::Plane plane;
  occt::PlaneSection section;
  double seconds = 0;
};

occt::Plane plane_of(const Options& options) {
  occt::Plane plane{parse_vector(options.point, "--point"),
                    parse_vector(options.normal, "--normal")};
  const double largest = max_norm(plane.normal);
  if (largest == 0) throw UsageError("--normal: the zero vector has no direction");
  plane.normal = unit(plane.normal * (1 / largest));
  return plane;
}

std::string text_of(const Input& input, const Answer& answer) {
  const occt::PlaneSection& section = answer.section;
  std::ostringstream text;
  text.precision(12);
  text << input.name << ": " << to_string(stated(section.status)) << ", "
       << counted(section.wires.size(), "wire") << ", " << counted(section.curves.size(), "curve")
       << ", " << counted(section.points.size(), "point") << ", "
       << counted(section.faces_in_plane.size(), "face") << " in the plane";
  if (!section.places.empty())
    text << ", " << counted(section.places.size(), "contact") << " or unresolved regions";
  text << ", " << answer.seconds << " s\n";
  for (const occt::SectionWire& wire : section.wires)
    text << "  " << (wire.closed ? "closed" : "open") << ", " << counted(wire.uses.size(), "curve")
         << ", length " << wire.length << "\n";
  for (const std::size_t node : section.points)
    text << "  point " << vector_text(section.nodes[node].point) << "\n";
  for (const std::string& reason : section.certificate.reasons) text << "  " << reason << "\n";
  return text.str();
}

Picture picture_of(const Input& input, const occt::PlaneSection& section) {
  Picture picture;
  picture.groups = {{input.faces, kFirstColour, kFirstOpacity}};
  for (const occt::SectionCurve& curve : section.curves) picture.curves.push_back(curve.samples);
  for (const std::size_t node : section.points) picture.points.push_back(section.nodes[node].point);
  return picture;
}

void write_outputs(const Input& input, const Options& options, const Answer& answer) {
  const occt::PlaneSection& section = answer.section;
  const CommonOptions& common = options.common;
  const bool any = !section.wires.empty() || !section.points.empty();
  const bool unwritten = !common.output.empty() && !any;
  occt::Model model;
  if (!common.output.empty() && any) model.add(occt::compound_of(section), "section", {});
  std::string png;
  if (!common.picture.empty()) png = picture_png(picture_of(input, section));
  stop_if_interrupted();
  if (!common.output.empty() && any) write_model(model, common.output);
  if (unwritten) tell_unwritten(common.output, "no wire and no point was found");
  if (!common.picture.empty()) occt::write_text(png, common.picture);
  if (!common.json.empty())
    write_json(reports::section_report(input, answer.plane, options.engine.tolerance, section,
                                       answer.seconds),
               common.json);
  print_summary(text_of(input, answer), common.json);
}

int run(const Options& options) {
  check_files(options.common, {options.input});
  start_threads(options.engine.threads);
  Answer answer;
  answer.plane = plane_of(options);
  const Input input = read_input(options.input);
  stop_if_interrupted();
  {
    Progress progress("cutting");
    const IntersectionOptions engine = intersection_options(options.engine, progress);
    const Stopwatch watch;
    answer.section = occt::plane_section(input.faces, answer.plane, engine);
    answer.seconds = watch.seconds();
  }
  stop_if_interrupted();
  write_outputs(input, options, answer);
  return exit_code(answer.section.status);
}

}  // namespace

void add_query_plane(CLI::App& query, int& exit_code) {
  CLI::App* const command = query.add_subcommand("plane", "the section of a model with a plane");
  const auto options = std::make_shared<Options>();
  command->add_option("input", options->input, "model, or some of its faces")
      ->required()
      ->type_name("FILE");
  command->add_option("--point", options->point, "a point of the plane")
      ->required()
      ->type_name("X,Y,Z");
  command->add_option("--normal", options->normal, "its normal; of any length")
      ->required()
      ->type_name("X,Y,Z");
  add_common_options(*command, options->common, "write the wires (.step, .brep, .iges)");
  add_engine_options(*command, options->engine);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace blossom::cli
