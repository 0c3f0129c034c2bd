// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom subdivide F`: sub-curves, sub-patches and sub-triangles by blossoms.

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <TopoDS.hxx>

#include "plugin/cli/arguments/options.h"
#include "plugin/cli/arguments/values.h"
#include "plugin/cli/commands/commands.h"
#include "plugin/cli/commands/subdivide_whole.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/nets/net_input.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/picture/files.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/nets/net_shapes.h"
#include "plugin/nets/subdivision.h"
#include "plugin/pictures/results/subdivisions.h"
#include "plugin/reports/models/repairs.h"

namespace blossom::cli {
namespace {

struct SubdivideCommand {
  std::string input;
  std::vector<double> interval;
  std::vector<double> rectangle;
  std::vector<double> triangle;
  std::vector<double> q;
  int levels = 0;
  bool whole = false;  // one B-spline instead of pieces
  CommonOptions common;
};

nets::Cut cut_of(const SubdivideCommand& options) {
  nets::Cut cut = nets::cut_of({options.interval, options.rectangle, options.triangle, options.q},
                               options.levels);
  cut.stop = stop_if_interrupted;
  return cut;
}

Json report_of(const NetInput& input, const nets::Subdivision& made) {
  Json repairs = Json::array();
  if (input.model) repairs.push_back(repairs_json(*input.model));
  return nets::subdivision_report(made, std::move(repairs));
}

constexpr std::size_t kNamedSources = 3;  // faces and edges; the report has all

std::string clipped_text(const nets::ClippedSource& source) {
  std::ostringstream text;
  const bool edge = source.edge > 0;
  text << (edge ? "edge " : "face ") << (edge ? source.edge : source.face)
       << " does not fill the place, its parameters are " << (edge ? "" : "u ") << "["
       << source.u.from << ", " << source.u.to << "]";
  if (!edge) text << " and v [" << source.v.from << ", " << source.v.to << "]";
  return text.str();
}

std::string summary(const NetInput& input, const nets::Subdivision& made) {
  std::ostringstream text;
  text << input.name << ": " << counted(made.pieces.size(), "piece") << " of "
       << counted(input.nets.size(), "net") << ", " << seconds_text(made.seconds) << "\n";
  for (std::size_t i = 0; i < std::min(made.clipped.size(), kNamedSources); ++i)
    text << "  " << clipped_text(made.clipped[i]) << "\n";
  if (made.clipped.size() > kNamedSources)
    text << "  " << made.clipped.size() - kNamedSources << " more do not fill it\n";
  return text.str();
}

void write_outputs(NetInput& input, const SubdivideCommand& options,
                   const nets::Subdivision& made) {
  const std::vector<PictureFile> pictures = picture_files(options.common, [&] {
    return pictures::subdivision_picture(options.input, made.pieces, input.nets.size(),
                                         stop_if_interrupted);
  });
  if (!options.common.output.empty()) write_nets(input, made.pieces, options.common.output);
  write_pictures(pictures);
  if (!options.common.json.empty()) write_json(report_of(input, made), options.common.json);
  print_summary(summary(input, made), options.common.json);
}

int run(const SubdivideCommand& options) {
  if (options.whole)
    return run_whole({options.input, options.interval, options.rectangle, options.common});
  check_files(options.common, {options.input}, Outputs::ModelsAndNets);
  const nets::Cut cut = cut_of(options);
  NetInput input =
      read_net_input(options.input, options.interval.empty() ? Take::Faces : Take::Edges);
  const nets::Subdivision made = nets::subdivided(input.name, input.nets, cut);
  stop_if_interrupted();
  write_outputs(input, options, made);
  return kExitComplete;
}

}  // namespace

void add_subdivide(CLI::App& app, int& exit_code) {
  CLI::App* const command = app.add_subcommand(
      "subdivide",
      "faces and edges as Bezier pieces, whole, in part or halved: sub-patches by blossoms");
  const auto options = std::make_shared<SubdivideCommand>();
  command->add_option("input", options->input, "model, nets (.json), or some faces or nets")
      ->required()
      ->type_name("FILE");
  CLI::Option* const interval =
      command->add_option("--interval", options->interval, "this part of curves and of edges")
          ->expected(2)
          ->delimiter(',')
          ->check(finite_number())
          ->type_name("A B");
  CLI::Option* const rectangle =
      command->add_option("--rectangle", options->rectangle, "this part of faces and patches")
          ->expected(4)
          ->delimiter(',')
          ->check(finite_number())
          ->type_name("U0 U1 V0 V1")
          ->excludes(interval);
  CLI::Option* const triangle =
      command
          ->add_option("--triangle", options->triangle, "the triangular patch over these corners")
          ->expected(6)
          ->delimiter(',')
          ->check(finite_number())
          ->type_name("U0 V0 U1 V1 U2 V2")
          ->excludes(interval)
          ->excludes(rectangle);
  CLI::Option* const levels =
      command->add_option("--levels", options->levels, "halve so often in each direction");
  levels->check(whole_number(0, 20))->type_name("N")->capture_default_str();
  CLI::Option* const q =
      command->add_option("--q", options->q, "give pieces by their (q1,q2)-Bezier points")
          ->expected(2)
          ->delimiter(',')
          ->check(finite_number())
          ->type_name("Q1 Q2");
  command
      ->add_flag("--whole", options->whole,
                 "one B-spline surface of each face, or curve of each edge, instead of its Bezier "
                 "pieces; parameters outside of it are an error")
      ->excludes(triangle)
      ->excludes(levels)
      ->excludes(q);
  add_common_options(*command, options->common, "write the pieces (.step, .brep, .iges, .json)");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace blossom::cli
