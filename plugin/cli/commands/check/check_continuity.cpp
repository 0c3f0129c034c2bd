// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/check/check_continuity.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/arguments/values.h"
#include "plugin/cli/commands/check/continuity_text.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/picture/files.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/pictures/results/continuity.h"
#include "plugin/pictures/scene/zebra.h"

namespace blossom::cli {
namespace {

pictures::Picture picture_of(const Input& input, const ContinuityReport& report,
                             const CommonOptions& common, bool zebra) {
  pictures::Picture picture = pictures::continuity_picture(input, report);
  if (!zebra) return picture;
  picture.view = common.look.view;
  picture.width = common.look.width;
  picture.height = common.look.height;
  paint_zebra(picture);
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
