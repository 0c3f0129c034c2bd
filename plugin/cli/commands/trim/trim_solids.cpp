// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/trim/trim_solids.h"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include "adapters/occt/base/compounds.h"
#include "adapters/occt/half_space.h"
#include "adapters/occt/solid_trim.h"
#include "core/base/parallel.h"
#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/arguments/values.h"
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
#include "plugin/reports/cuts/solids.h"
#include "plugin/reports/cuts/trim.h"
#include "plugin/reports/models/repairs.h"
#include "plugin/reports/models/selection.h"

namespace blossom::cli {
namespace {

using TimedSolids = reports::SolidAnswer;

// All solids at once: those side by side keep their common faces. Pieces come from where their
// faces do.
void make_watertight(TimedSolids& timed, const EngineOptions& engine) {
  const TopoDS_Compound all = occt::compound_of(timed.made.solids);
  occt::WatertightShape made = watertight_of(all, engine, seconds_left());
  timed.made.status = status_with(timed.made.status, made.pieces);
  if (const std::string reason = reason_of(made.pieces); !reason.empty()) {
    timed.made.obstacles.push_back(reason);
    timed.watertight = std::move(made.pieces);
    return;
  }
  timed.made.solids.clear();
  for (TopoDS_Iterator it(made.shape); it.More(); it.Next())
    timed.made.solids.push_back(TopoDS::Solid(it.Value()));
  TopTools_IndexedMapOfShape numbers;
  TopExp::MapShapes(all, TopAbs_FACE, numbers);
  std::vector<occt::SolidFace> faces;
  for (const occt::SolidFace& face : timed.made.faces)
    if (const int number = numbers.FindIndex(face.face); number > 0)
      for (const TopoDS_Face& piece : made.faces[static_cast<std::size_t>(number) - 1]) {
        faces.push_back(face);
        faces.back().face = piece;
      }
  timed.made.faces = std::move(faces);
  timed.watertight = std::move(made.pieces);
}

Input input_of(const std::string& text, Json& repairs) {
  Input input =
      read_input(text, Faces::Optional, reports::Repairing::Used, reports::LooseFaces::OpenSewn);
  repairs.push_back(repairs_json(input));
  return input;
}

// What is named, or all. Models of their own, even of one file: the part is changed. What another
// input has as well stays with it.
occt::Model model_of(Input& input, std::optional<occt::Model> named) {
  if (named) return *std::move(named);
  return input.owner.use_count() > 1 ? input.model.copy() : std::move(input.model);
}

using Models = std::vector<occt::Model>;

occt::TrimTool named_tool(const occt::Model& model, const std::string& name) {
  occt::TrimTool tool = occt::trim_tool(model.shape());
  tool.name = name;
  return tool;
}

// Who takes a sheet for a solid is told what else there is.
void check_sheets(const occt::TrimTool& part, const std::vector<occt::TrimTool>& tools,
                  occt::SolidOperation operation) {
  if (const std::string cause = occt::misplaced_sheet(part, tools, operation); !cause.empty())
    throw UsageError(cause);
}

TimedSolids timed_trim(const SolidTrim& options, const occt::Model& part, const Models& tools) {
  Progress progress("combining solids");
  const IntersectionOptions engine = intersection_options(options.engine, progress);
  const occt::SolidOperation operation = *reports::solid_operation(options.operation);
  const occt::TrimTool whole = named_tool(part, options.part);
  std::vector<occt::TrimTool> others;
  for (std::size_t i = 0; i < options.tools.size(); ++i)
    others.push_back(named_tool(tools[i], options.tools[i]));
  for (std::size_t i = 0; i < options.planes.size(); ++i)
    others.push_back(
        occt::half_space_tool(options.planes[i], part.shape(), reports::plane_name(i)));
  check_sheets(whole, others, operation);
  const auto start = std::chrono::steady_clock::now();
  TimedSolids result{.part = options.part,
                     .tools = options.tools,
                     .planes = options.planes,
                     .operation = options.operation};
  result.made = occt::trim_solids(whole, others, operation, engine);
  const auto seconds = [start] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  if (options.watertight && !result.made.solids.empty()) make_watertight(result, options.engine);
  stop_if_interrupted();
  result.seconds = seconds();
  reports::note_faces(result);
  return result;
}

std::string counted_shapes(const occt::SolidTrimResult& made) {
  if (made.of_wires) return reports::counted_wires(made);
  return made.of_sheets ? counted(made.sheets.size(), "sheet")
                        : counted(made.solids.size(), "solid");
}

// Sheets have no volume to tell it by.
bool cuts_nothing(const SolidTrim& options, const occt::SolidTrimResult& made) {
  const bool cuts = options.operation == "cut" || options.operation == "split";
  return cuts && !options.tools.empty() && options.planes.empty() && !made.volumes.empty() &&
         std::ranges::all_of(made.volumes,
                             [](const auto& step) { return step.tool > 0 && step.common == 0; });
}

// Of the inputs and the result, and how well those of all steps add up.
std::string told_volumes(const SolidTrim& options, const occt::SolidTrimResult& made) {
  const auto number = [](double value) { return number_text(rounded(value)); };
  std::ostringstream text;
  if (made.obstacles.empty() && made.of_wires) {
    text << "  lengths: part " << number(made.lengths.part) << ", tools "
         << number(made.lengths.tools) << ", result " << number(made.lengths.result) << " mm\n";
  } else if (made.obstacles.empty() && made.of_sheets) {
    text << "  areas: part " << number(made.areas.part) << ", tools " << number(made.areas.tools)
         << ", result " << number(made.areas.result) << " mm²\n";
  } else if (made.obstacles.empty()) {
    text << "  volumes: part " << number(made.total.part);
    if (!options.tools.empty()) text << ", tools " << number(made.total.tools);
    text << ", result " << number(made.total.result) << " mm³\n";
    if (cuts_nothing(options, made))
      text << "  nothing is cut: part and tools have no volume in common\n";
  }
  double cut = 0, fuse = 0;
  std::size_t count = 0;
  for (const occt::SolidVolumes& step : made.volumes) {
    cut = std::max(cut, step.cut_error());
    fuse = std::max(fuse, step.fuse_error());
    if (++count; verbosity() != Verbosity::Verbose) continue;
    text << "  step " << count << ": part " << number(step.part) << ", tool " << number(step.tool)
         << ", cut " << number(step.cut) << ", common " << number(step.common) << ", fuse "
         << number(step.fuse) << " mm³\n";
  }
  if (count > 0)
    text << "  checked: " << (made.of_sheets ? "areas" : "volumes") << " add up within "
         << number(std::max(cut, fuse)) << " of the whole"
         << (count > 1 ? ", in each of " + counted(count, "step") : "") << "\n";
  return text.str();
}

std::string summary(const SolidTrim& options, const TimedSolids& timed) {
  std::ostringstream text;
  text << options.part << ": " << options.operation << ", " << to_string(stated(timed.made.status))
       << ", " << counted_shapes(timed.made) << ", " << seconds_text(timed.seconds) << "\n";
  if (!timed.made.open_part.empty())
    text << "  " << options.part << " is taken as a sheet: " << timed.made.open_part << "\n";
  for (const std::string& loose : timed.made.left_out) text << "  " << loose << "\n";
  text << told_volumes(options, timed.made);
  if (timed.watertight) text << summary_of(*timed.watertight);
  for (const std::string& wrong : timed.made.tolerances) text << "  " << wrong << "\n";
  for (const std::string& text_of : timed.made.merged) text << "  " << text_of << "\n";
  for (const std::string& invalid : timed.invalid) text << "  " << invalid << "\n";
  for (const std::string& idle : timed.idle) text << "  " << idle << "\n";
  for (const std::string& cause : reports::causes(timed.made)) text << "  " << cause << "\n";
  if (timed.made.status != Status::Complete)
    for (const std::string& reason : reported_reasons(timed.made.certificate, Contacts::NotListed))
      text << "  " << reason << "\n";
  return text.str();
}

// What gives the faces of a cut along a plane their name: the plane as a part.
occt::Model plane_model(const occt::Plane& plane, const occt::Model& part,
                        const std::string& name) {
  occt::Model model;
  model.add(occt::plane_tool(plane, part.shape(), name).faces.front(), name);
  return model;
}

// Puts the solids in the place of the part's, as the output file can have them; sheets take that of
// the whole part.
void replace_shapes(occt::Model& part, const occt::SolidTrimResult& made, const Models& tools,
                    const std::string& output) {
  std::vector<const occt::Model*> origins;
  for (const occt::Model& tool : tools) origins.push_back(&tool);
  if (made.of_wires) {
    part = reports::wires_model(made, part);
    return;
  }
  if (!made.sheets.empty()) {
    part = reports::sheets_model(made, part, origins);
    return;
  }
  std::vector<occt::CombinedSolid> solids;
  for (const TopoDS_Solid& solid : made.solids)
    solids.push_back({solid, reports::origins_of(solid, made, part, origins)});
  part.replace_solids(
      solids, occt::keeps_names(output) ? occt::CommonFaces::Copy : occt::CommonFaces::Keep);
}

bool wants_shape(const CommonOptions& outputs) {
  return !outputs.output.empty() || !picture_names(outputs).empty();
}

// Why nothing is written though it was asked for; empty if nothing speaks against it.
std::string reason_of(const occt::SolidTrimResult& made) {
  if (!made.obstacles.empty()) return reports::causes(made).front();
  const bool wires = !made.wires.IsNull() && TopExp_Explorer(made.wires, TopAbs_VERTEX).More();
  return made.solids.empty() && made.sheets.empty() && !wires ? "the result is empty" : "";
}

void report_no_solid(const CommonOptions& outputs, const std::string& reason) {
  if (!outputs.output.empty()) report_unwritten(outputs.output, reason);
  for (const std::string& file : picture_names(outputs)) report_unwritten(file, reason);
  if (!wants_shape(outputs)) std::cerr << "blossom: there is no solid: " << reason << '\n';
}

int exit_code_of(const occt::SolidTrimResult& made) {
  const int code = exit_code(made.status);
  return made.obstacles.empty() ? code : exit_code_unwritten(code);
}

}  // namespace

bool is_solid_operation(const std::string& word) {
  return reports::solid_operation(word).has_value();
}

int trim_solids(const SolidTrim& options) {
  if (options.operation == "fuse" && !options.planes.empty())
    throw UsageError("--solid fuse takes no --plane: what is above a plane has no end");
  std::vector<std::string> files = options.tools;
  files.push_back(options.part);
  check_files(options.common, files, options.watertight ? Outputs::ModelsAndNets : Outputs::Models);
  start_threads(options.engine.threads);
  Json repairs = Json::array();
  Input given = input_of(options.part, repairs);
  std::optional<occt::Model> named = reports::alone_for_solids(given);
  Models tools;
  std::set<int> used;  // by tools of the same file
  for (const std::string& tool : options.tools) {
    Input input = input_of(tool, repairs);
    if (parse_input(tool).file == parse_input(options.part).file)
      used.insert(input.numbers.begin(), input.numbers.end());
    tools.push_back(model_of(input, reports::alone_for_solids(input)));
  }
  const std::string others = other_parts_text(given, OtherParts::LeftOut, used);
  occt::Model part = model_of(given, std::move(named));
  stop_if_interrupted();
  TimedSolids timed = timed_trim(options, part, tools);
  for (std::size_t i = 0; i < options.planes.size(); ++i)
    tools.push_back(plane_model(options.planes[i], part, reports::plane_name(i)));
  const std::string reason = reason_of(timed.made);
  const CommonOptions& outputs = options.common;
  const bool write = reason.empty() && !outputs.output.empty();
  timed.written = write;
  timed.repairs = repairs;
  std::vector<PictureFile> pictures;
  if (reason.empty())
    pictures = picture_files(outputs, [&] { return pictures::solids_picture(timed); });
  if (write && nets::is_net_file(outputs.output)) {
    write_plain_json(nets::nets_json(nets_of(*timed.watertight, options.part)), outputs.output);
  } else if (write) {
    replace_shapes(part, timed.made, tools, outputs.output);
    write_model(part, outputs.output);
  }
  write_pictures(pictures);
  if (!reason.empty()) report_no_solid(outputs, reason);
  if (!outputs.json.empty()) write_json(reports::solid_report(timed), outputs.json);
  print_summary(summary(options, timed) + (write ? others : ""), outputs.json);
  return exit_code_of(timed.made);
}

}  // namespace blossom::cli
