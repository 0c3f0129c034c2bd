// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom query mass F`: volume, area, centre of gravity and inertia of solids.

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <sstream>
#include <string>

#include "plugin/cli/arguments/options.h"
#include "plugin/cli/arguments/values.h"
#include "plugin/cli/commands/query/query_parts.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/reading.h"
#include "plugin/cli/output/verbosity.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/cli/process/supervision.h"
#include "plugin/reports/queries/mass.h"

namespace blossom::cli {
namespace {

struct MassCommand {
  std::string input;
  double density = 0;  // kg/m³; 0: not given
  CommonOptions common;
};

std::string mass_text(const occt::Mass& mass, double density) {
  std::ostringstream text;
  text.precision(12);
  if (mass.is_solid) text << "volume " << mass.volume << " mm³, ";
  if (mass.is_solid && density > 0)
    text << "mass " << reports::kilograms(mass.volume, density) << " kg, ";
  text << "area " << mass.area << " mm², centre " << vector_text(without_roundings(mass.centre));
  if (mass.is_solid && mass.volume < 0) text << ", turned inwards";
  return text.str();
}

constexpr double kRoundings = 1e-12;  // of the largest moment; sums over faces have some 1e-13

std::string inertia_text(const occt::Mass& mass) {
  std::ostringstream text;
  text.precision(12);
  auto [xx, yy, zz, xy, xz, yz] = mass.inertia.coordinates;
  // What symmetry makes 0 comes with the roundings of the moments.
  for (double* product : {&xy, &xz, &yz})
    if (std::abs(*product) <= kRoundings * std::max({xx, yy, zz})) *product = 0;
  text << "    inertia about its centre (mm⁵): xx " << xx << ", yy " << yy << ", zz " << zz
       << ", xy " << xy << ", xz " << xz << ", yz " << yz << "\n";
  return text.str();
}

std::string text_of(const Input& input, const reports::MassAnswer& answer, double density) {
  std::size_t solids = 0;
  for (const reports::PartMass& part : answer.parts) solids += part.mass.is_solid ? 1 : 0;
  std::string text = input.name + ": " + to_string(stated(answer.status)) + ", " +
                     counted(solids, "closed solid") + "\n";
  for (const reports::PartMass& part : answer.parts) {
    text += "  " + part.part.name + ": " + mass_text(part.mass, density) + "\n";
    if (part.mass.is_solid && verbosity() == Verbosity::Verbose) text += inertia_text(part.mass);
  }
  if (solids > 1) text += "  all solids: " + mass_text(answer.solids, density) + "\n";
  return text;
}

int run(const MassCommand& options) {
  check_files(options.common, {options.input});
  const Input input = read_usable_input(options.input);
  stop_if_interrupted();
  enter(Phase::Working, "measuring masses of " + input.name);
  const Stopwatch watch;
  const std::function<bool()> cancelled = interrupted;
  const WorkLimit limit(seconds_left(), cancelled);
  reports::MassAnswer answer = reports::masses_of(input, limit);
  answer.seconds = watch.seconds();
  stop_if_interrupted();
  if (!options.common.json.empty())
    write_json(reports::mass_report(input, answer, options.density), options.common.json);
  print_summary(text_of(input, answer, options.density), options.common.json);
  return exit_code(answer.status);
}

}  // namespace

void add_query_mass(CLI::App& query, int& exit_code) {
  CLI::App* const command =
      query.add_subcommand("mass", "volume, area, centre of gravity and inertia of solids");
  const auto options = std::make_shared<MassCommand>();
  command->add_option("input", options->input, "model, or some of its parts")
      ->required()
      ->type_name("FILE");
  command->add_option("--density", options->density, "masses of solids, too; kg/m³, of steel 7850")
      ->check(positive_number())
      ->type_name("D");
  add_report_options(*command, options->common);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace blossom::cli
