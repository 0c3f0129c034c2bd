// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom convert F -o OUT`: between file formats, and to other forms of surfaces.

#include <algorithm>
#include <chrono>
#include <iterator>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "adapters/occt/base/errors.h"
#include "core/regions/border_arcs.h"
#include "plugin/cli/commands/commands.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/interruption.h"
#include "plugin/cli/nets/net_input.h"
#include "plugin/cli/nets/net_json.h"
#include "plugin/cli/nets/pieces.h"
#include "plugin/cli/nets/trimmed_nets.h"
#include "plugin/cli/options.h"
#include "plugin/cli/output.h"
#include "plugin/cli/values.h"
#include "plugin/reports/repairs.h"

namespace blossom::cli {
namespace {

enum class Form { AsItIs, Bezier, Monomial, Triangles };

const std::map<std::string, Form> kTargets = {
    {"bezier", Form::Bezier}, {"monomial", Form::Monomial}, {"triangles", Form::Triangles}};

struct Options {
  std::string input;
  std::string to;  ///< empty: the forms stay
  double tolerance = RegionOptions{}.tolerance;
  CommonOptions common;
};

struct Made {
  std::vector<Net> nets;  ///< empty if a model was written as it is
  std::size_t faces = 0;
  std::size_t trims_left_out = 0;    ///< faces that lost their trims
  std::vector<TrimmedNets> trimmed;  ///< faces whose trims were to be followed, without their nets
  Json repairs = Json::array();      ///< of a model
  double seconds = 0;
};

std::vector<Net> converted(const std::vector<Net>& nets, Form form) {
  std::vector<Net> result;
  for (const Net& net : nets) {
    stop_if_interrupted();
    switch (form) {
      case Form::AsItIs: result.push_back(net); break;
      case Form::Bezier: result.push_back(bezier_net(net)); break;
      case Form::Monomial: result.push_back(monomial_net(net)); break;
      case Form::Triangles:
        for (Net& triangle : triangle_nets(net)) result.push_back(std::move(triangle));
        break;
    }
  }
  return result;
}

// As Bezier patches, a triangle too: one of its sides is a point.
std::vector<Net> patches_of(const std::vector<Net>& nets) {
  std::vector<Net> result;
  for (const Net& net : nets) result.push_back(is_triangle(net) ? collapsed_net(net) : net);
  return result;
}

void append(std::vector<Net>& all, std::vector<Net> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

// Face by face: what its trims leave, or all of its surface if it has none or they cannot be
// followed.
void convert_faces(const NetInput& input, Form form, double tolerance, Made& made) {
  const Input& model = *input.model;
  TriangleLowering lowering;
  for (std::size_t i = 0; i < model.faces.size(); ++i) {
    const int number = model.numbers[i];
    std::vector<Net> whole;
    for (const Net& net : input.nets)
      if (net.source.face == number) whole.push_back(net);
    TrimmedNets trimmed;
    if (is_trimmed(model.faces[i]) && !whole.empty()) {
      trimmed = trimmed_nets(model.faces[i], whole.front().source, tolerance, lowering);
      if (!trimmed.obstacle.empty()) ++made.trims_left_out;
    }
    const std::vector<Net>& nets = trimmed.nets.empty() ? whole : trimmed.nets;
    append(made.nets, form == Form::Bezier && !trimmed.nets.empty() ? patches_of(nets)
                                                                    : converted(nets, form));
    trimmed.nets.clear();
    if (trimmed.face > 0) made.trimmed.push_back(std::move(trimmed));
  }
}

Made write_as_it_is(const Options& options) {
  Input input = read_input(options.input, Faces::Optional);
  refuse_open_wires(input);
  Made made;
  made.faces = input.faces.size();
  made.repairs.push_back(repairs_json(input));
  drop_other_faces(input);
  stop_if_interrupted();
  write_model(input.model, options.common.output);
  return made;
}

Made write_converted(const Options& options, Form form) {
  NetInput input = read_net_input(options.input, Take::Faces);
  Made made;
  const bool follows_trims = input.model && (form == Form::Bezier || form == Form::Triangles);
  const auto start = std::chrono::steady_clock::now();
  if (follows_trims)
    convert_faces(input, form, options.tolerance, made);
  else
    made.nets = converted(input.nets, form);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  made.seconds = took.count();
  if (input.model) {
    made.repairs.push_back(repairs_json(*input.model));
    made.faces = input.model->faces.size();
    if (!follows_trims)
      made.trims_left_out =
          static_cast<std::size_t>(std::ranges::count_if(input.model->faces, is_trimmed));
  }
  stop_if_interrupted();
  write_nets(input, made.nets, options.common.output);
  return made;
}

double largest_error(const Made& made) {
  double error = 0;
  for (const Net& net : made.nets) error = std::max(error, net.source.error);
  return error;
}

Json trimmed_json(const std::vector<TrimmedNets>& faces) {
  Json list = Json::array();
  for (const TrimmedNets& face : faces) {
    Json json = {{"face", face.face},
                 {"exact", face.exact},
                 {"fitted", face.fitted},
                 {"border_error", face.border_error}};
    if (!face.obstacle.empty()) json["obstacle"] = face.obstacle;
    list.push_back(std::move(json));
  }
  return list;
}

Json report_of(const Options& options, const Made& made) {
  return {{"schema", "blossom.conversion/1"},
          {"file", options.input},
          {"output", options.common.output},
          {"to", options.to.empty() ? Json(nullptr) : Json(options.to)},
          {"faces", made.faces},
          {"nets", made.nets.size()},
          {"trims_left_out", made.trims_left_out},
          {"trimmed", trimmed_json(made.trimmed)},
          {"error", largest_error(made)},
          {"seconds", made.seconds},
          {"repairs", made.repairs}};
}

std::string summary(const Options& options, const Made& made) {
  std::ostringstream text;
  text << options.input << " to " << options.common.output << ": ";
  if (made.faces > 0 || made.nets.empty()) text << counted(made.faces, "face");
  if (made.faces > 0 && !made.nets.empty()) text << ", ";
  if (!made.nets.empty()) text << counted(made.nets.size(), "net");
  if (made.trims_left_out > 0)
    text << ", the trims of " << counted(made.trims_left_out, "face") << " left out";
  if (largest_error(made) > 0) text << ", within " << largest_error(made);
  text << "\n";
  for (const TrimmedNets& face : made.trimmed) {
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

int run(const Options& options) {
  check_files(options.common, {options.input}, Outputs::ModelsAndNets);
  const bool to_nets = is_net_file(options.common.output);
  const Form form = options.to.empty() ? Form::AsItIs : kTargets.at(options.to);
  if (form == Form::Monomial && !to_nets)
    throw UsageError(options.common.output +
                     ": models have no monomial form; --to monomial writes .json");
  const bool from_nets = is_net_file(parse_input(options.input).file);
  const Made made = form == Form::AsItIs && !from_nets && !to_nets ? write_as_it_is(options)
                                                                   : write_converted(options, form);
  if (!options.common.json.empty()) write_json(report_of(options, made), options.common.json);
  print_summary(summary(options, made), options.common.json);
  return kExitComplete;
}

}  // namespace

void add_convert(CLI::App& app, int& exit_code) {
  CLI::App* const command = app.add_subcommand(
      "convert", "between file formats and forms; what was repaired in reading is written so");
  const auto options = std::make_shared<Options>();
  command->add_option("input", options->input, "model, nets (.json), or some faces or nets")
      ->required()
      ->type_name("FILE");
  command->add_option("-o,--output", options->common.output, "write .step, .brep, .iges or .json")
      ->required()
      ->type_name("FILE");
  limit_to(*command->add_option("--to", options->to,
                                "every surface in this form: bezier and triangles follow the "
                                "trims, monomial leaves them out"),
           {"bezier", "monomial", "triangles"});
  command
      ->add_option("--tolerance", options->tolerance,
                   "how far pieces may end from trims that they cannot follow exactly, model units")
      ->check(positive_number())
      ->default_str(number_text(options->tolerance))
      ->type_name("T");
  add_report_options(*command, options->common);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace blossom::cli
