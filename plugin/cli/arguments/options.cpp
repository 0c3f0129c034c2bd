// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/arguments/options.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <map>
#include <system_error>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "adapters/occt/base/errors.h"
#include "plugin/cli/arguments/hidden.h"
#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/arguments/values.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/output/reading.h"
#include "plugin/cli/output/verbosity.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/cli/process/stages.h"
#include "plugin/cli/process/supervision.h"
#include "plugin/reports/text/lower_case.h"

namespace blossom::cli {
namespace {

// Of the time that is left: what follows a search may take a quarter more (see WorkLimit).
constexpr double kSearchPart = 0.8;

const std::map<std::string, CellForm> kForms = {
    {"auto", CellForm::Auto}, {"monomial", CellForm::Monomial}, {"bezier", CellForm::Bezier}};

// Only making a file tells: permissions mean nothing to root, and some folders take no files. One
// without a name leaves nothing behind, whatever interrupts this; not all systems of files have
// that.
bool takes_files(const std::filesystem::path& folder) {
  int descriptor = open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600);
  if (descriptor < 0) {
    std::string probe = (folder / ".blossom-XXXXXX").string();
    descriptor = mkstemp(probe.data());
    if (descriptor >= 0) unlink(probe.c_str());
  }
  if (descriptor >= 0) close(descriptor);
  return descriptor >= 0;
}

void require_writable(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw occt::Failure(file.string() + ": cannot be written, it is a folder");
  refuse_special(file);
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (!std::filesystem::is_directory(folder, error))
    throw occt::Failure(file.string() + ": cannot be written, there is no folder " +
                        folder.string());
  if (!takes_files(folder))
    throw occt::Failure(file.string() + ": cannot be written, the folder " + folder.string() +
                        " takes no file: " + std::strerror(errno));
}

// What a file is called when all links are followed, also one that is not there yet.
std::filesystem::path real_name(const std::filesystem::path& file) {
  constexpr int kMaxLinks = 40;  // as many as the system follows
  std::error_code ignored;
  std::filesystem::path name = std::filesystem::absolute(file, ignored);
  for (int i = 0; i < kMaxLinks && std::filesystem::is_symlink(name, ignored); ++i)
    name = name.parent_path() / std::filesystem::read_symlink(name, ignored);
  return std::filesystem::weakly_canonical(name, ignored);
}

// Through links of both kinds and other spellings, too.
bool same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code ignored;
  return std::filesystem::equivalent(a, b, ignored) || real_name(a) == real_name(b);
}

struct Output {
  std::string option;
  std::string file;
  std::vector<std::string> endings;      // that messages name
  std::vector<std::string> others = {};  // that are as good; "" is none
};

std::vector<Output> wanted_outputs(const CommonOptions& options, Outputs outputs) {
  Output model{"--output", options.output, {".step", ".brep", ".iges"}, {".stp", ".igs", ".brp"}};
  if (outputs == Outputs::ModelsAndNets || outputs == Outputs::ModelsNetsAndTriangles)
    model.endings.emplace_back(".json");
  if (outputs == Outputs::ModelsNetsAndTriangles)
    for (const char* ending : {".stl", ".ply", ".obj", ".off", ".3mf", ".glb"})
      model.endings.emplace_back(ending);
  if (outputs == Outputs::ModelsAndDrawings)
    for (const char* ending : {".dxf", ".svg", ".json"}) model.endings.emplace_back(ending);
  std::vector<Output> wanted;
  for (const Output& output :
       {model, Output{"--json", options.json, {".json"}, {""}},
        Output{"--picture", options.picture, {".png"}},
        Output{"--html", options.look.html, {".html"}, {".htm"}},
        Output{"--glb", options.look.glb, {".glb"}}, Output{"--table", options.table, {".csv"}}})
    if (!output.file.empty() && !(output.option == "--json" && is_stream(output.file)))
      wanted.push_back(output);
  return wanted;
}

void check_ending(const Output& output) {
  if (output.file == "-")
    throw UsageError(output.option + " takes a file; only --json can write to stdout");
  const std::string ending = ending_of(output.file);
  for (const auto* list : {&output.endings, &output.others})
    if (std::ranges::find(*list, ending) != list->end()) return;
  throw UsageError(output.file + ": " +
                   (ending.empty() ? "a name without extension" : "extension " + ending) +
                   " is not supported by " + output.option + "; " + listed(output.endings, "and") +
                   (output.endings.size() == 1 ? " is" : " are"));
}

constexpr const char* kFindings = "findings";

std::vector<std::string> form_words() {
  std::vector<std::string> words;
  for (const auto& [word, form] : kForms) words.push_back(word);
  return words;
}

void share(CLI::App& command, const std::vector<std::string>& names) {
  for (const std::string& name : names) command.get_option(name)->group(kShared);
}

void refuse_empty_names(const CommonOptions& options) {
  if (options.command == nullptr) return;
  for (const char* name :
       {"--output", "--json", "--picture", "--html", "--glb", "--table", "--log"})
    if (const CLI::Option* const option = options.command->get_option_no_throw(name);
        option != nullptr && option->count() > 0 && option->as<std::string>().empty())
      throw UsageError(std::string(name) + " takes the name of a file, not an empty one");
}

}  // namespace

void add_report_options(CLI::App& command, CommonOptions& options) {
  options.command = &command;
  command.add_option("--json", options.json, "write a report; - is stdout")->type_name("FILE");
  command.add_flag("--strict", reading_policy().strict,
                   "refuse files of which shapes are missing or not as they are there");
  const auto sew = [](const double& within) { reading_policy().sew = within; };
  command
      .add_option_function<double>("--sew-gap", sew,
                                   "join loose faces with gaps up to this to solids; 0 leaves "
                                   "them loose")
      ->check(CLI::NonNegativeNumber)
      ->type_name("T");
  const auto take = [](const double& seconds) { set_time_limit(seconds); };
  command.add_option_function<double>("--time-limit", take, "stop after so many seconds in all")
      ->check(positive_number())
      ->type_name("S");
  command
      .add_option_function<std::string>("--log", log_stages,
                                        "add what is done, and how long, to a file")
      ->type_name("FILE");
  command.add_flag_callback("--profile", profile_stages, "say in the end where the time went");
  command
      .add_option("--reproduce", options.reproduce,
                  "write what repeats the command to a folder, if it fails or is stopped")
      ->type_name("DIR");
  const auto flag = [&](const char* name, const char* what, Verbosity level) {
    return command.add_flag_callback(
        name, [level] { set_verbosity(level); }, what);
  };
  CLI::Option* const verbose =
      flag("-v,--verbose", "say more: what was repaired, and where", Verbosity::Verbose);
  flag("-q,--quiet", "say nothing but errors", Verbosity::Quiet)->excludes(verbose);
  share(command, {"--json", "--strict", "--sew-gap", "--time-limit", "--log", "--profile",
                  "--reproduce", "--verbose", "--quiet"});
}

void add_common_options(CLI::App& command, CommonOptions& options, const std::string& output) {
  if (!output.empty()) command.add_option("-o,--output", options.output, output)->type_name("FILE");
  add_picture_options(command, options.picture, options.look);
  share(command, {"--picture", "--html", "--glb", "--view", "--size"});
  add_report_options(command, options);
}

void add_table(CLI::App& command, CommonOptions& options, const std::string& what) {
  command.add_option("--table", options.table, "write a table (CSV) with a row for " + what)
      ->type_name("FILE");
}

void add_fail_on(CLI::App& command, CommonOptions& options) {
  limit_to(*command.add_option("--fail-on", options.fail_on, "exit with code 5 if there are any"),
           {kFindings});
}

void add_engine_options(CLI::App& command, EngineOptions& options) {
  command.add_option("--tolerance", options.tolerance, "what counts as one point, mm")
      ->check(positive_number())
      ->type_name("T")
      ->default_str(number_text(options.tolerance));
  limit_to(
      *command.add_option("--form", options.form, "form that control nets of cells are made from")
           ->capture_default_str(),
      form_words());
  command.add_option("--budget", options.budget, "stop after so many pairs of cells")
      ->check(whole_number(1, 1'000'000'000'000))
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--threads", options.threads, "how many threads may work; 0 is all")
      ->check(whole_number(0, 4096))
      ->type_name("N")
      ->capture_default_str();
  share(command, {"--tolerance", "--budget", "--threads"});
  command.get_option("--form")->group(kHidden);
}

IntersectionOptions intersection_options(const EngineOptions& options, Progress& progress) {
  IntersectionOptions result;
  result.tolerances.point = options.tolerance;
  result.form = kForms.at(options.form);
  result.budget = options.budget;
  result.time_limit = kSearchPart * seconds_left();
  result.threads = options.threads;
  result.cancelled = [&progress] {
    progress.tick();
    return interrupted();
  };
  return result;
}

std::string ending_of(const std::string& file) {
  return reports::lower_case(std::filesystem::path(file).extension());
}

void refuse_options(const CommonOptions& options, const std::vector<std::string>& names,
                    const std::string& why) {
  if (options.command == nullptr) return;
  for (const std::string& name : names)
    if (const CLI::Option* const option = options.command->get_option_no_throw(name);
        option != nullptr && option->count() > 0)
      throw UsageError(name + " does nothing here: " + why);
}

void check_files(const CommonOptions& options, const std::vector<std::string>& inputs,
                 Outputs outputs) {
  if (options.picture.empty() && options.look.html.empty() && options.look.glb.empty())
    refuse_options(options, {"--view", "--size"}, "there is no --picture, --html or --glb");
  refuse_empty_names(options);
  reading_policy().looks = !options.output.empty() || !options.reproduce.empty();
  for (const std::string& input : inputs) refuse_special(parse_input(input).file);
  const std::vector<Output> wanted = wanted_outputs(options, outputs);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const std::string& file = wanted[i].file;
    for (const std::string& input : inputs)
      if (same_file(parse_input(input).file, file))
        throw UsageError(file + ": is an input, which the output would replace");
    check_ending(wanted[i]);
    for (std::size_t j = 0; j < i; ++j)
      if (same_file(wanted[j].file, file))
        throw UsageError(file + ": is the file of " + wanted[j].option + ", too");
    require_writable(file);
  }
}

Findings findings_of(bool any) { return any ? Findings::Some : Findings::None; }

int exit_code(int code, Findings findings, const CommonOptions& options) {
  const bool fails = findings == Findings::Some && options.fail_on == kFindings;
  return fails ? kExitFindings : code;
}

}  // namespace blossom::cli
