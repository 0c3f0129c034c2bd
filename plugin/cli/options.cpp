// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/options.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <map>
#include <set>
#include <string_view>
#include <system_error>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "adapters/occt/errors.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/inputs.h"
#include "plugin/cli/interruption.h"
#include "plugin/cli/reading.h"
#include "plugin/cli/supervision.h"
#include "plugin/cli/verbosity.h"

namespace blossom::cli {
namespace {

constexpr std::array<std::string_view, 6> kModelEndings = {".step", ".stp",  ".iges",
                                                           ".igs",  ".brep", ".brp"};

// Of the time that is left: what follows a search may take a quarter more (see WorkLimit).
constexpr double kSearchPart = 0.8;

const std::map<std::string, CellForm> kForms = {
    {"auto", CellForm::Auto}, {"monomial", CellForm::Monomial}, {"bezier", CellForm::Bezier}};

std::string lower_case(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

void require_writable(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw occt::Failure(file.string() + ": cannot be written, it is a folder");
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (!std::filesystem::is_directory(folder, error))
    throw occt::Failure(file.string() + ": cannot be written, there is no folder " +
                        folder.string());
  // Only making a file tells: permissions mean nothing to root, and some folders take no files.
  std::string probe = (folder / ".blossom-XXXXXX").string();
  const int descriptor = mkstemp(probe.data());
  if (descriptor < 0)
    throw occt::Failure(file.string() + ": cannot be written, the folder " + folder.string() +
                        " takes no file: " + std::strerror(errno));
  close(descriptor);
  unlink(probe.c_str());
}

std::string positive_number(const std::string& text) {
  try {
    std::size_t used = 0;
    const double value = std::stod(text, &used);
    if (used == text.size() && std::isfinite(value) && value > 0) return {};
  } catch (const std::exception&) {  // no number: answered below
  }
  return "'" + text + "' is no positive number";
}

// Through links and other spellings, too; no file is the same as one that is not there.
bool same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code ignored;
  return std::filesystem::equivalent(a, b, ignored);
}

}  // namespace

void add_report_options(CLI::App& command, CommonOptions& options) {
  command.add_option("--json", options.json, "write a report; - is stdout")->type_name("FILE");
  command.add_flag("--strict", reading_policy().strict,
                   "refuse files of which shapes are missing or not as they are there");
  const auto take = [](const double& seconds) { set_time_limit(seconds); };
  command.add_option_function<double>("--time-limit", take, "stop after so many seconds in all")
      ->check(CLI::Validator(positive_number, "POSITIVE"))
      ->type_name("S");
  const auto flag = [&](const char* name, const char* what, Verbosity level) {
    return command.add_flag_callback(
        name, [level] { set_verbosity(level); }, what);
  };
  CLI::Option* const verbose =
      flag("-v,--verbose", "say more: what was repaired, and where", Verbosity::Verbose);
  flag("-q,--quiet", "say nothing but errors", Verbosity::Quiet)->excludes(verbose);
}

void add_common_options(CLI::App& command, CommonOptions& options, const std::string& output) {
  if (!output.empty()) command.add_option("-o,--output", options.output, output)->type_name("FILE");
  command.add_option("--picture", options.picture, "write a picture (PNG)")->type_name("FILE");
  add_report_options(command, options);
}

void add_engine_options(CLI::App& command, EngineOptions& options) {
  command.add_option("--tolerance", options.tolerance, "what counts as one point, in model units")
      ->check(CLI::Validator(positive_number, "POSITIVE"))
      ->type_name("T")
      ->capture_default_str();
  command.add_option("--form", options.form, "form that the nets of cells are made from")
      ->check(CLI::IsMember(kForms))
      ->type_name("")
      ->capture_default_str();
  command.add_option("--budget", options.budget, "stop after so many pairs of cells")
      ->check(CLI::Range(1L, 1'000'000'000'000L))
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--threads", options.threads, "how many threads may work; 0 is all")
      ->check(CLI::Range(0, 4096))
      ->type_name("N")
      ->capture_default_str();
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

void check_outputs(const CommonOptions& options, const std::vector<std::string>& inputs,
                   Outputs outputs) {
  std::set<std::filesystem::path> seen;
  for (const std::string* file : {&options.output, &options.json, &options.picture}) {
    if (file->empty() || (file == &options.json && *file == "-")) continue;
    if (!seen.insert(std::filesystem::absolute(*file).lexically_normal()).second)
      throw UsageError(*file + ": two outputs cannot be the same file");
    for (const std::string& input : inputs)
      if (same_file(parse_input(input).file, *file))
        throw UsageError(*file + ": is an input, which the output would replace");
    require_writable(*file);
  }
  if (options.output.empty()) return;
  const std::string ending = lower_case(std::filesystem::path(options.output).extension());
  const bool nets = outputs == Outputs::ModelsAndNets;
  if (nets && ending == ".json") return;
  if (std::ranges::find(kModelEndings, ending) == kModelEndings.end())
    throw UsageError(options.output + ": the ending says no known format; " +
                     (nets ? ".step, .brep, .iges and .json are" : ".step, .brep and .iges are"));
}

}  // namespace blossom::cli
