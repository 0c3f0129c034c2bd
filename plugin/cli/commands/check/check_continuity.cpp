// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/check/check_continuity.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/arguments/values.h"
#include "plugin/cli/commands/check/continuity_text.h"
#include "plugin/cli/commands/intersect/intersection_picture.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/picture/files.h"
#include "plugin/cli/picture/mesh.h"
#include "plugin/cli/picture/zebra.h"
#include "plugin/cli/process/interruption.h"

namespace blossom::cli {
namespace {

constexpr Vec3 kApartColour = {0.85, 0.10, 0.60};
constexpr Vec3 kSharpColour = {0.10, 0.11, 0.13};
constexpr Vec3 kTangentColour = {0.90, 0.49, 0.08};
constexpr Vec3 kSmoothColour = {0.13, 0.58, 0.25};
constexpr Vec3 kOpenColour = {0.82, 0.12, 0.12};

// The layers of the picture; what is less smooth is drawn over what is smoother.
struct EdgeLayers {
  PictureLayer smooth{"G2", kSmoothColour};
  PictureLayer tangent{"G1", kTangentColour};
  PictureLayer sharp{"sharp (G0)", kSharpColour};
  PictureLayer apart{"apart", kApartColour};
  PictureLayer open{"not compared", kOpenColour};

  PictureLayer& of(const occt::EdgeContinuity& edge) {
    if (!edge.found) return open;
    switch (edge.smoothness) {
      case Smoothness::None: return apart;
      case Smoothness::G0: return sharp;
      case Smoothness::G1: return tangent;
      case Smoothness::G2: break;
    }
    return smooth;
  }
};

Picture picture_of(const Input& input, const ContinuityReport& report, const CommonOptions& common,
                   bool zebra) {
  Picture picture;
  picture.title = "continuity of " + short_name(input.name);
  picture.groups = {
      {input.faces, kFirstColour, kFirstOpacity, short_name(input.name), face_labels(input)}};
  if (zebra) {
    picture.view = common.look.view;
    picture.width = common.look.width;
    picture.height = common.look.height;
    paint_zebra(picture);
  }
  EdgeLayers layers;
  for (const occt::EdgeContinuity& edge : report.edges)
    if (std::vector<Vec3> points = edge_points(edge.edge); !points.empty())
      layers.of(edge).items.push_back({std::move(points), edge_line(edge)});
  picture.layers = {layers.smooth, layers.tangent, layers.sharp, layers.apart, layers.open};
  return picture;
}

CLI::Option* needing(CLI::Option* option, CLI::Option* other) { return option->needs(other); }

}  // namespace

void add_continuity_options(CLI::App& command, ContinuityCommand& options) {
  CLI::Option* const wanted = command.add_flag(
      "--continuity", options.wanted,
      "how smoothly faces meet instead: gap, angle of normals and curvature along every edge");
  const auto add_limit = [&](const char* name, double& value, const char* unit, const char* what) {
    needing(command.add_option(name, value, what), wanted)
        ->check(positive_number())
        ->type_name(unit)
        ->capture_default_str();
  };
  add_limit("--gap", options.tolerances.gap, "MM", "faces less apart meet (G0)");
  needing(
      add_angle(command, "--angle", options.tolerances.angle, "normals less turned are one (G1)"),
      wanted);
  add_limit("--curvature", options.tolerances.curvature, "PART",
            "curvatures that differ by less, relative to the larger, are one (G2)");
  CLI::Option* const require = command.add_option("--require", options.require,
                                                  "edges less smooth are findings; G0 without");
  limit_to(*needing(require, wanted), {"G0", "G1", "G2"});
  needing(command.add_flag("--zebra", options.zebra,
                           "with --picture: stripes on the faces, as they would reflect rows of "
                           "lamps; they break off, bend or go on where faces are G0, G1 or G2"),
          wanted);
  needing(command.add_flag("--edges", options.table, "print a line for every edge, as -v"), wanted);
}

int run_continuity(const std::string& name, const CommonOptions& common,
                   const ContinuityCommand& command) {
  if (command.zebra && picture_names(common).empty())
    throw UsageError("--zebra needs a picture: --picture, --html or --glb");
  check_files(common, {name});
  const Input input = read_input(name);
  stop_if_interrupted();
  const ContinuityReport report{
      {reports::measured_continuity_of(input, command.tolerances, command.require,
                                       stop_if_interrupted)},
      command.table};
  stop_if_interrupted();
  const std::vector<PictureFile> pictures =
      picture_files(common, [&] { return picture_of(input, report, common, command.zebra); });
  write_pictures(pictures);
  if (!common.json.empty()) write_json(reports::continuity_report(input, report), common.json);
  print_summary(continuity_text(input.name, report, !common.picture.empty()), common.json);
  return exit_code(kExitComplete, findings_of(!report.failing().empty()), common);
}

}  // namespace blossom::cli
