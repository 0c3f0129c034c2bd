// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom convert F -o OUT`: between file formats, and to other forms of surfaces.

#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "adapters/occt/base/errors.h"
#include "core/regions/border_arcs.h"
#include "plugin/cli/arguments/options.h"
#include "plugin/cli/arguments/values.h"
#include "plugin/cli/commands/commands.h"
#include "plugin/cli/commands/meshes/convert_mesh.h"
#include "plugin/cli/commands/meshes/convert_of_mesh.h"
#include "plugin/cli/commands/meshes/meshed_input.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/nets/net_input.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/nets/conversion.h"
#include "plugin/nets/net_json.h"
#include "plugin/pictures/results/meshes.h"
#include "plugin/reports/models/repairs.h"

namespace blossom::cli {
namespace {

using Form = nets::TargetForm;

struct ConvertCommand {
  std::string input;
  std::string to;  ///< empty: the forms stay
  double tolerance = RegionOptions{}.tolerance;
  MeshConversion mesh;
  double crease = pictures::kUsualCrease;
  CommonOptions common;
};

// What was made, and what was repaired for it.
struct Made : nets::Conversion {
  Json repairs = Json::array();
  std::string others;  // says what becomes of parts that are not named
};

Made write_as_it_is(const ConvertCommand& options) {
  Input input = read_input(options.input, Faces::Optional);
  refuse_open_wires(input);
  Made made;
  made.faces = input.faces.size();
  made.repairs.push_back(repairs_json(input));
  made.others = other_parts_text(input, OtherParts::LeftOut);
  drop_other_faces(input);
  stop_if_interrupted();
  write_model(input.model, options.common.output);
  return made;
}

Made write_converted(const ConvertCommand& options, Form form) {
  NetInput input = read_net_input(options.input, Take::Faces);
  Made made;
  if (input.model) {
    static_cast<nets::Conversion&>(made) = nets::converted_faces(
        *input.model, input.nets, form, options.tolerance, stop_if_interrupted);
    made.repairs.push_back(repairs_json(*input.model));
    made.others = other_parts_text(*input.model, OtherParts::LeftOut);
  } else {
    static_cast<nets::Conversion&>(made) = nets::converted(input.nets, form, stop_if_interrupted);
  }
  stop_if_interrupted();
  write_nets(input, made.nets, options.common.output);
  return made;
}

Json report_of(const ConvertCommand& options, const Made& made) {
  return nets::conversion_report(options.input, options.common.output, options.to, made,
                                 made.repairs);
}

std::string summary(const ConvertCommand& options, const Made& made) {
  std::ostringstream text;
  text << options.input << " to " << options.common.output << ": ";
  if (made.faces > 0 || made.nets.empty()) text << counted(made.faces, "face");
  if (made.faces > 0 && !made.nets.empty()) text << ", ";
  if (!made.nets.empty()) text << counted(made.nets.size(), "net");
  if (made.trims_left_out > 0)
    text << ", the trims of " << counted(made.trims_left_out, "face") << " left out";
  if (made.largest_error() > 0) text << ", within " << made.largest_error();
  text << "\n";
  for (const nets::TrimmedNets& face : made.trimmed) {
    text << "  face " << face.face << ": ";
    if (!face.obstacle.empty())
      text << "its trims are left out: " << face.obstacle;
    else
      text << counted(face.exact, "exact piece") << ", " << face.fitted << " fitted";
    if (face.fitted > 0) text << " within " << face.border_error << " of the trims";
    text << "\n";
  }
  return text.str();
}

// What shapes triangles, and what does so to patches.
const std::vector<std::string> kOfTriangles{"--deviation", "--angle", "--edge-length", "--aspect"};

bool is_text_or_binary(const std::string& file) {
  const std::string ending = ending_of(file);
  return ending == ".stl" || ending == ".ply";
}

void refuse_idle_options(const ConvertCommand& options) {
  const std::string& out = options.common.output;
  const bool mesh = is_mesh_input(options.input), flat = is_of_triangles(out);
  if (mesh) refuse_options(options.common, kOfTriangles, options.input + " is of triangles");
  if (!flat) refuse_options(options.common, kOfTriangles, out + " is not of flat triangles");
  if (!is_text_or_binary(out))
    refuse_options(options.common, {"--text"}, out + " is not .stl and not .ply");
  if (!mesh) refuse_options(options.common, {"--crease"}, options.input + " is not of triangles");
  if (flat) refuse_options(options.common, {"--crease"}, out + " is of flat triangles");
  if (mesh || options.to.empty())
    refuse_options(options.common, {"--tolerance"}, "it is of surfaces in another form (--to)");
}

int run(const ConvertCommand& options) {
  check_files(options.common, {options.input}, Outputs::ModelsNetsAndTriangles);
  refuse_idle_options(options);
  if (is_mesh_input(options.input))
    return run_conversion_of_mesh(options.input, options.common,
                                  {options.to, options.crease, options.mesh.text});
  if (is_of_triangles(options.common.output)) {
    if (!options.to.empty())
      throw UsageError(options.common.output + ": is of flat triangles, --to is of surfaces");
    return run_mesh_conversion(options.input, options.common, options.mesh);
  }
  const bool to_nets = nets::is_net_file(options.common.output);
  const Form form = nets::target_form(options.to).value_or(Form::AsItIs);
  if (form == Form::Monomial && !to_nets)
    throw UsageError(options.common.output +
                     ": models have no monomial form; --to monomial writes .json");
  const bool from_nets = nets::is_net_file(parse_input(options.input).file);
  const Made made = form == Form::AsItIs && !from_nets && !to_nets ? write_as_it_is(options)
                                                                   : write_converted(options, form);
  if (!options.common.json.empty()) write_json(report_of(options, made), options.common.json);
  print_summary(summary(options, made) + made.others, options.common.json);
  return kExitComplete;
}

}  // namespace

void add_convert(CLI::App& app, int& exit_code) {
  CLI::App* const command =
      app.add_subcommand("convert",
                         "between file formats and forms, or to a mesh of triangles; what was "
                         "repaired in reading is written so");
  const auto options = std::make_shared<ConvertCommand>();
  command
      ->add_option("input", options->input,
                   "model, nets (.json), triangles (.stl, .ply, .obj, .off), or some of one")
      ->required()
      ->type_name("FILE");
  command
      ->add_option("-o,--output", options->common.output,
                   "write .step, .brep, .iges or .json; or triangles, as .stl, .ply, .obj, .off, "
                   ".3mf or .glb")
      ->required()
      ->type_name("FILE");
  limit_to(*command->add_option("--to", options->to,
                                "every surface in this form: bezier and triangles follow the "
                                "trims, monomial leaves them out"),
           {"bezier", "monomial", "triangles"});
  command
      ->add_option("--tolerance", options->tolerance,
                   "how far pieces may end from trims that they cannot follow exactly, mm")
      ->check(positive_number())
      ->default_str(number_text(options->tolerance))
      ->type_name("T");
  add_mesh_options(*command, options->mesh);
  add_angle(*command, "--crease", options->crease,
            "of a file of triangles, --to triangles or bezier: sides at which neighbours turn by "
            "so much stay sharp");
  add_report_options(*command, options->common);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace blossom::cli
