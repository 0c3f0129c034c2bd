// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom trim PART TOOL...`: a part cut along its intersections with tools.

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/half_space.h"
#include "adapters/occt/trim.h"
#include "core/base/parallel.h"
#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/arguments/options.h"
#include "plugin/cli/arguments/values.h"
#include "plugin/cli/arguments/vectors.h"
#include "plugin/cli/commands/commands.h"
#include "plugin/cli/commands/trim/trim_solids.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/output/reading.h"
#include "plugin/cli/output/reasons.h"
#include "plugin/cli/output/verbosity.h"
#include "plugin/cli/output/watertight_output.h"
#include "plugin/cli/picture/files.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/cli/process/progress.h"
#include "plugin/cli/process/supervision.h"
#include "plugin/nets/net_json.h"
#include "plugin/pictures/results/trim.h"
#include "plugin/reports/cuts/trim.h"

namespace blossom::cli {
namespace {

struct TrimCommand {
  std::string part;
  std::vector<std::string> tools;
  std::vector<std::string> planes;
  std::string keep;
  std::string solid;  // an operation on solids, instead of keep
  double fuzzy = 0;   // with solid: how much farther apart than the tolerance things may be one
  bool allow_incomplete = false;
  bool watertight = false;
  CommonOptions common;
  EngineOptions engine;
};

occt::TrimOptions trim_options(const std::string& keep) {
  if (const std::optional<occt::TrimOptions> options = reports::trim_options(keep)) return *options;
  throw UsageError(
      "--keep takes above, below, inside, outside, all or the number of a piece, not '" + keep +
      "'");
}

struct Inputs {
  Input part;
  std::vector<Input> tools;
  std::vector<occt::Plane> planes;
};

using TimedTrim = reports::TrimAnswer;

// What cannot be used is told by file and face where an open wire is the cause.
occt::TrimResult trim_named(const Inputs& inputs, const std::vector<occt::PartFace>& part,
                            const std::vector<occt::TrimTool>& tools,
                            const occt::TrimOptions& options) try {
  return occt::trim(part, tools, options);
} catch (const occt::BadModel&) {
  refuse_open_wires(inputs.part);
  for (const Input& tool : inputs.tools) refuse_open_wires(tool);
  throw;
}

TimedTrim timed_trim(const Inputs& inputs, const TrimCommand& options) {
  Progress progress("trimming");
  occt::TrimOptions wanted = trim_options(options.keep);
  wanted.intersection = intersection_options(options.engine, progress);
  const std::string& output = options.common.output;
  if (!output.empty() && (nets::is_net_file(output) || !occt::keeps_internal_edges(output)))
    wanted.open_cuts = occt::OpenCuts::LeaveOut;
  const std::vector<occt::PartFace> part = reports::part_faces(inputs.part);
  std::vector<occt::TrimTool> tools;
  for (const Input& tool : inputs.tools) {
    tools.push_back(reports::tool_of(tool));
    tools.back().name = tool.name;
  }
  for (std::size_t i = 0; i < inputs.planes.size(); ++i)
    tools.push_back(
        occt::plane_tool(inputs.planes[i], inputs.part.model.shape(), reports::plane_name(i)));
  const auto start = std::chrono::steady_clock::now();
  TimedTrim result{.planes = inputs.planes,
                   .keep = options.keep,
                   .made = trim_named(inputs, part, tools, wanted)};
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  stop_if_interrupted();
  result.seconds = took.count();
  for (const Input& tool : inputs.tools) reports::note_invalid_faces(tool, result.made);
  return result;
}

std::size_t kept_count(const occt::TrimResult& made) {
  std::size_t count = 0;
  for (const occt::TrimPiece& piece : made.pieces) count += piece.kept ? 1 : 0;
  return count;
}

// labels   of the faces as the part had them when it was read
std::string summary(const Inputs& inputs, const FaceLabels& labels, const TimedTrim& timed) {
  std::ostringstream text;
  text << inputs.part.name << ": " << to_string(stated(timed.made.status)) << ", "
       << counted(timed.made.areas.size(), "face") << " in "
       << counted(timed.made.pieces.size(), "piece") << ", " << kept_count(timed.made) << " kept, "
       << seconds_text(timed.seconds) << "\n";
  constexpr std::size_t kFew = 20;
  const std::size_t pieces = timed.made.pieces.size();
  const bool all = verbosity() == Verbosity::Verbose || pieces <= kFew;
  for (const occt::TrimPiece& piece : std::span(timed.made.pieces).first(all ? pieces : kFew))
    text << "  piece " << piece.number << " of " << labels.of(piece.face) << ": "
         << reports::side_text(piece.side) << ", area " << number_text(rounded(piece.area))
         << " mm²" << (piece.kept ? "" : ", left out") << "\n";
  if (!all) text << "  and " << pieces - kFew << " more pieces, which -v lists\n";
  for (const std::string& note : timed.made.notes) text << "  " << note << "\n";
  if (timed.made.status != Status::Complete)
    for (const std::string& reason : reported_reasons(timed.made.certificate, Contacts::NotListed))
      text << "  " << reason << "\n";
  return text.str();
}

// Why no model is written though one was asked for; empty if nothing speaks against it.
std::string obstacle(const Inputs& inputs, const TimedTrim& timed, const TrimCommand& options) {
  if (timed.made.status == Status::Stopped && !options.allow_incomplete)
    return "the intersection is not complete; --allow-incomplete writes what there is";
  const std::size_t others =
      static_cast<std::size_t>(inputs.part.model.face_count()) - inputs.part.numbers.size();
  if (kept_count(timed.made) + others == 0) return "no piece is on the side to keep";
  return {};
}

// Puts pieces with common sides in the place of all faces, if there is time for it.
WatertightPieces make_watertight(occt::Model& model, const EngineOptions& engine) {
  occt::WatertightShape made = watertight_of(model.shape(), engine, seconds_left());
  if (!made.pieces.open.empty()) return std::move(made.pieces);
  std::map<int, std::vector<TopoDS_Face>> faces;
  for (std::size_t k = 0; k < made.faces.size(); ++k)
    faces[static_cast<int>(k) + 1] = std::move(made.faces[k]);
  model.replace_faces(faces);
  return std::move(made.pieces);
}

// Returns the exit code.
int write_outputs(Inputs& inputs, TimedTrim& timed, const TrimCommand& options) {
  std::string reason = obstacle(inputs, timed, options);
  std::vector<const Input*> tools;
  for (const Input& tool : inputs.tools) tools.push_back(&tool);
  const std::vector<PictureFile> pictures = picture_files(options.common, [&] {
    return pictures::trim_picture(inputs.part, tools, timed.made, stated(timed.made.status));
  });
  const FaceLabels labels(inputs.part);
  const std::string others = other_parts_text(inputs.part, OtherParts::Kept);
  if (reason.empty()) inputs.part.model.replace_faces(timed.made.replacements);
  std::optional<WatertightPieces>& watertight = timed.watertight;
  if (options.watertight && reason.empty()) {
    watertight = make_watertight(inputs.part.model, options.engine);
    reason = reason_of(*watertight);
    timed.made.status = status_with(timed.made.status, *watertight);
  }
  const bool write = !options.common.output.empty() && reason.empty();
  const bool unwritten = !options.common.output.empty() && !write;
  std::string text = summary(inputs, labels, timed);
  if (write) text += others;
  timed.written = write;
  const Json report = reports::trim_report(inputs.part, tools, timed);
  if (watertight) text += summary_of(*watertight);
  stop_if_interrupted();

  if (write && nets::is_net_file(options.common.output))
    write_plain_json(nets::nets_json(nets_of(*watertight, inputs.part.name)),
                     options.common.output);
  else if (write)
    write_model(inputs.part.model, options.common.output);
  if (unwritten) report_unwritten(options.common.output, reason);
  write_pictures(pictures);
  if (!options.common.json.empty()) write_json(report, options.common.json);
  print_summary(text, options.common.json);
  return exit_code(timed.made.status);
}

std::vector<occt::Plane> planes_of(const TrimCommand& options) {
  std::vector<occt::Plane> planes;
  for (const std::string& plane : options.planes) planes.push_back(parse_plane(plane, "--plane"));
  return planes;
}

// What other programs call the operations.
std::string other_name(const std::string& word) {
  static const std::map<std::string, std::string> kNames{
      {"union", "fuse"},     {"unite", "fuse"},      {"add", "fuse"},
      {"merge", "fuse"},     {"join", "fuse"},       {"intersect", "common"},
      {"subtract", "cut"},   {"difference", "cut"},  {"intersection", "common"},
      {"minus", "cut"},      {"divide", "split"},    {"partition", "split"},
      {"fragment", "split"}, {"fragments", "split"}, {"slice", "split"}};
  const auto known = kNames.find(word);
  const std::string near = known != kNames.end()
                               ? known->second
                               : nearest_word(word, {"cut", "common", "fuse", "split"});
  return near.empty() ? "" : "; did you mean '" + near + "'?";
}

int run_solid(const TrimCommand& options) {
  if (!options.keep.empty() || options.allow_incomplete)
    throw UsageError("--solid goes without --keep and --allow-incomplete");
  if (!is_solid_operation(options.solid))
    throw UsageError("--solid takes cut, common, fuse or split, not '" + options.solid + "'" +
                     other_name(options.solid));
  EngineOptions engine = options.engine;
  engine.tolerance += options.fuzzy;
  return trim_solids({options.part, options.tools, planes_of(options), options.solid,
                      options.watertight, options.common, engine});
}

int run(const TrimCommand& options) {
  if (options.tools.empty() && options.planes.empty())
    throw UsageError("trim needs a TOOL, or a plane by --plane");
  if (!options.solid.empty()) return run_solid(options);
  if (options.fuzzy > 0) throw UsageError("--fuzzy goes with --solid");
  if (options.keep.empty())
    throw UsageError(
        "trim needs --keep above, below, inside, outside or all; or for solids and sheets --solid "
        "cut, common, fuse or split");
  std::vector<std::string> files = options.tools;
  files.push_back(options.part);
  check_files(options.common, files, options.watertight ? Outputs::ModelsAndNets : Outputs::Models);
  trim_options(options.keep);  // a wrong word is told before a long reading
  start_threads(options.engine.threads);
  std::vector<occt::Plane> planes = planes_of(options);
  Inputs inputs{read_input(options.part), {}, std::move(planes)};
  for (const std::string& tool : options.tools) inputs.tools.push_back(read_input(tool));
  stop_if_interrupted();
  TimedTrim timed = timed_trim(inputs, options);
  return write_outputs(inputs, timed, options);
}

}  // namespace

void add_trim(CLI::App& app, int& exit_code) {
  CLI::App* const command = app.add_subcommand(
      "trim",
      "a part cut along its intersections with tools; with --solid the booleans cut "
      "(difference), common, fuse (union) and split");
  const auto options = std::make_shared<TrimCommand>();
  command->add_option("part", options->part, "model to be cut, or some of its faces")
      ->required()
      ->type_name("PART");
  command->add_option("tools", options->tools, "models that cut it, or some of their faces")
      ->type_name("TOOL");
  command
      ->add_option(
          "--plane", options->planes,
          "a plane that cuts it, by a point and its normal, which points to what is above; "
          "may be given several times. With --solid what is above is the tool")
      ->type_name("X,Y,Z,NX,NY,NZ")
      ->allow_extra_args(false);
  command
      ->add_option("--keep", options->keep,
                   "above (where the tools' normals point), below, inside, outside (of solid "
                   "tools), all, or the number of a piece")
      ->type_name("SIDE");
  command
      ->add_option(
          "--solid", options->solid,
          "combine closed solids, sheets or wires instead: cut, common, fuse or split (cut and "
          "common side by "
          "side), with all tools: common is what lies in all of them; each tool, sheet or plane "
          "splits all pieces")
      ->type_name("OPERATION");
  command
      ->add_option("--fuzzy", options->fuzzy,
                   "with --solid: what is up to so much farther apart than the tolerance counts as "
                   "one, mm")
      ->check(positive_number())
      ->type_name("T");
  command->add_flag("--allow-incomplete", options->allow_incomplete,
                    "write the model even if the intersection was stopped");
  command->add_flag("--watertight", options->watertight,
                    "write patches and triangles whose sides along edges have the same control "
                    "points; also to .json");
  add_common_options(*command, options->common, "write the trimmed model (.step, .brep, .iges)");
  add_engine_options(*command, options->engine);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace blossom::cli
