// SPDX-License-Identifier: LGPL-2.1-or-later
// `blossom clash A [B]`: which parts penetrate, touch or hold each other, and how far others are.

#include <algorithm>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "adapters/occt/base/errors.h"
#include "core/base/parallel.h"
#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/arguments/options.h"
#include "plugin/cli/arguments/values.h"
#include "plugin/cli/arguments/vectors.h"
#include "plugin/cli/commands/commands.h"
#include "plugin/cli/commands/query/query_parts.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/output/reading.h"
#include "plugin/cli/output/verbosity.h"
#include "plugin/cli/picture/files.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/cli/process/progress.h"
#include "plugin/pictures/results/clash.h"
#include "plugin/reports/queries/clash.h"

namespace blossom::cli {
namespace {

using reports::ClashAnswer;
using reports::ClashRow;

struct ClashCommand {
  std::string a, b;  // b may be empty
  double clearance = -1;
  bool far = false;  // pairs of which only the boxes were looked at are listed, too
  CommonOptions common;
  EngineOptions engine;
};

std::string number(double value) { return number_text(rounded(value)); }

std::string bounds(double lower, double upper) {
  if (number(lower) == number(upper)) return number(upper);
  return number(lower) + ", at most " + number(upper);
}

std::string contact_text(const occt::Clash& clash) {
  std::map<std::string, std::size_t> kinds;
  for (const occt::BodyContact& contact : clash.contacts) ++kinds[to_string(contact.kind)];
  const occt::BodyContact& first = clash.contacts.front();
  std::string text = to_string(first.kind);
  if (const std::size_t count = kinds[text]; count > 1)
    text = std::to_string(count) + " " + text + "s, one of them";
  return text + " at " +
         vector_text({rounded(first.point[0]), rounded(first.point[1]), rounded(first.point[2])});
}

std::string details(const ClashRow& row, const ClashAnswer& answer) {
  if (row.clash == nullptr) return "at least " + number(row.lower);
  const occt::Clash& clash = *row.clash;
  std::vector<std::string> told;
  if (clash.relation == occt::Relation::AInsideB)
    told.push_back(displayed_name(answer, row.a) + " is inside");
  if (clash.relation == occt::Relation::BInsideA)
    told.push_back(displayed_name(answer, row.b) + " is inside");
  if (clash.common) told.push_back("volume " + number(clash.common->volume) + " mm³");
  if (clash.common && clash.relation != occt::Relation::Equal)
    told.push_back(
        "depth " + bounds(clash.common->lower, clash.common->upper) + ", deepest at " +
        vector_text({rounded(clash.common->deepest[0]), rounded(clash.common->deepest[1]),
                     rounded(clash.common->deepest[2])}));
  if (!clash.contacts.empty()) told.push_back(contact_text(clash));
  if (clash.relation == occt::Relation::Disjoint)
    told.push_back(clash.measured ? "distance " + bounds(clash.lower, clash.upper)
                                  : "more than " + number(clash.lower));
  std::string obstacles;
  for (const std::string& obstacle : clash.obstacles)
    obstacles += (obstacles.empty() ? "" : "; ") + obstacle;
  if (!obstacles.empty()) told.push_back(obstacles);
  if (clash.status != Status::Complete) told.emplace_back(to_string(clash.status));
  std::string text;
  for (const std::string& each : told) text += (text.empty() ? "" : ", ") + each;
  return text;
}

std::size_t width_of(const std::vector<ClashRow>& rows, const ClashAnswer& answer,
                     std::size_t ClashRow::*side) {
  std::size_t width = 0;
  for (const ClashRow& row : rows)
    width = std::max(width, displayed_name(answer, row.*side).size());
  return width + 2;
}

std::string clash_text(const ClashAnswer& answer) {
  std::vector<ClashRow> rows = reports::rows_of(answer, reports::ClashRows::Near);
  const std::size_t all = reports::pair_count(answer);
  std::ostringstream text;
  text << answer.inputs.front()->name;
  if (answer.inputs.size() > 1) text << " - " << answer.inputs.back()->name;
  text << ": " << to_string(stated(status_of(answer))) << ", " << counted_pairs(answer) << ", "
       << seconds_text(answer.seconds) << "\n";
  if (answer.lists_far)
    rows = reports::rows_of(answer, reports::ClashRows::All);
  else if (verbosity() != Verbosity::Verbose)
    std::erase_if(rows, [](const ClashRow& row) {
      return row.clash->relation == occt::Relation::Disjoint && !row.clash->measured &&
             row.clash->obstacles.empty();
    });
  const auto padded = [](const std::string& word, std::size_t width) {
    return word + std::string(width > word.size() ? width - word.size() : 0, ' ');
  };
  const std::size_t a = width_of(rows, answer, &ClashRow::a);
  const std::size_t b = width_of(rows, answer, &ClashRow::b);
  for (const ClashRow& row : rows)
    text << "  " << padded(clash_word(row), 12) << padded(displayed_name(answer, row.a), a)
         << padded(displayed_name(answer, row.b), b) << details(row, answer) << "\n";
  if (rows.size() < all)
    text << "  " << counted(all - rows.size(), "pair")
         << (answer.clearance ? " farther apart than " + number(*answer.clearance)
                              : " whose boxes are apart")
         << "; --far lists them\n";
  return text.str();
}

// The common bodies, each named by the parts that have it.
void write_common(const ClashAnswer& answer, const std::string& file) {
  const occt::Model model = reports::common_bodies(answer);
  if (!model.shape().IsNull())
    write_model(model, file);
  else
    report_nothing_found(file, "no parts have a common body");
}

int write_outputs(const ClashAnswer& answer, const CommonOptions& common) {
  stop_if_interrupted();
  const std::vector<PictureFile> pictures =
      picture_files(common, [&] { return pictures::clash_picture(answer); });
  if (!common.output.empty()) write_common(answer, common.output);
  write_pictures(pictures);
  if (!common.table.empty()) occt::write_text(reports::clash_csv(answer), common.table);
  if (!common.json.empty()) write_json(reports::clash_report(answer), common.json);
  print_summary(clash_text(answer), common.json);
  const std::vector<ClashRow> rows = reports::rows_of(answer, reports::ClashRows::Near);
  const bool any = std::ranges::any_of(
      rows, [&](const ClashRow& row) { return is_finding(row, answer.clearance); });
  return exit_code(exit_code(status_of(answer)), findings_of(any), common);
}

int run(const ClashCommand& options) {
  std::vector<std::string> files{options.a};
  if (!options.b.empty()) files.push_back(options.b);
  check_files(options.common, files);
  start_threads(options.engine.threads);
  std::vector<Input> inputs;
  for (const std::string& file : files) inputs.push_back(read_input(file));
  stop_if_interrupted();
  ClashAnswer answer;
  answer.tolerance = options.engine.tolerance;
  answer.lists_far = options.far;
  if (options.clearance >= 0) answer.clearance = options.clearance;
  for (const Input& input : inputs) reports::add_input(answer, input);
  {
    Progress progress("looking for clashes");
    reports::look_for_clashes(answer, intersection_options(options.engine, progress));
  }
  return write_outputs(answer, options.common);
}

}  // namespace

void add_clash(CLI::App& app, int& exit_code) {
  CLI::App* const command = app.add_subcommand(
      "clash", "parts that penetrate, touch or hold each other, and how far others are apart");
  const auto options = std::make_shared<ClashCommand>();
  command->add_option("a", options->a, "model, or some of its faces")->required()->type_name("A");
  command->add_option("b", options->b, "another one: pairs have one part of each")->type_name("B");
  command
      ->add_option("--clearance", options->clearance,
                   "measure distances up to this; without it those of pairs whose boxes meet, and "
                   "of parts that meet no other the nearest")
      ->check(number_not_negative())
      ->type_name("D");
  command->add_flag("--far", options->far,
                    "list pairs of which only the boxes were looked at, too: they are many");
  add_common_options(*command, options->common, "write the common bodies (.step, .brep, .iges)");
  add_table(*command, options->common, "each pair that is listed");
  add_fail_on(*command, options->common);
  add_engine_options(*command, options->engine);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace blossom::cli
