// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/output/reading.h"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>

#include "adapters/occt/base/errors.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/verbosity.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/cli/process/supervision.h"
#include "plugin/reports/models/reading.h"

namespace blossom::cli {
namespace {

/// The reports of all files that this program has read, by name.
std::map<std::filesystem::path, occt::ReadingReport>& all_reports() {
  static std::map<std::filesystem::path, occt::ReadingReport> reports;
  return reports;
}

bool& faces_are_left_out() {
  static bool left_out = false;
  return left_out;
}

bool shapes_are_lost() {
  return faces_are_left_out() || std::ranges::any_of(all_reports(), [](const auto& entry) {
           return entry.second.grade() == occt::ReadingGrade::ShapesLost;
         });
}

void tell(const std::filesystem::path& file, const occt::ReadingReport& report) {
  for (const std::string& made : report.notes) note(file.string() + ": " + made);
  if (report.losses.empty()) return;
  const bool more = report.losses.size() > 1 && verbosity() != Verbosity::Verbose;
  note(file.string() + ": " + report.summary() + (more ? "; -v lists all" : ""));
  for (const occt::Loss& loss : report.losses)
    detail((loss.of_shape ? "  shape: " : "  ") + loss.text());
}

std::string parts_of(const std::string& file) { return "reading parts from " + file; }

/// Tells which step of reading begins. Where faces of damaged entities never come to an end, all is
/// read again without them: both have the time of one.
///
/// named   by another file, which has parts without this one
void enter_step(const std::string& file, double allowance, std::string_view step, bool named) {
  const bool names = step.starts_with(occt::kReadingNames);
  const bool damaged = step.starts_with(occt::kMakingDamaged);
  if (names || damaged)
    enter(Phase::Optional, file, std::string(step));
  else if (named)
    enter(Phase::Optional, file, parts_of(file));
  else
    enter(Phase::Reading, file, std::string(step));
  if (damaged) allow_processor_time(allowance / 2);
}

/// Of a file of the command line, or of one that such a file names: what ends the program is left
/// out when the work begins again, names before shapes, and of these files all.
///
/// after   processor seconds for what names the file, which comes after it; 0 if nothing names it
occt::ReadOptions options_for(const std::filesystem::path& file, double after = 0) {
  const std::string name = file.string();
  const double allowance = occt::reading_allowance(file);
  const bool named = after > 0;
  allow_processor_time(allowance + after);
  occt::ReadOptions options{.names = !has_failed(occt::kReadingNames + (" of " + name)),
                            .looks = reading_policy().looks,
                            .damaged = !has_failed(occt::kMakingDamaged + (" of " + name))};
  options.left_out = named && has_failed(parts_of(name));
  options.other = [=](const std::filesystem::path& other) {
    return options_for(other, allowance + after);
  };
  options.step = [=](const char* step) { enter_step(name, allowance, step, named); };
  return options;
}

}  // namespace

void leave_faces_out() { faces_are_left_out() = true; }

ReadingPolicy& reading_policy() {
  static ReadingPolicy policy;
  return policy;
}

occt::Model read_and_report(const std::filesystem::path& file) {
  const std::string name = file.string();
  enter(Phase::Reading, name);
  occt::Model model = occt::read_model(file, options_for(file));
  enter(Phase::Working, "working on " + name);
  const occt::ReadingReport& report = model.reading();
  if (reading_policy().strict && report.grade() == occt::ReadingGrade::ShapesLost)
    throw occt::BadModel(file.string() + ": is refused by --strict: " + report.summary());
  if (all_reports().try_emplace(file, report).second) tell(file, report);
  return model;
}

occt::CheckRunner watched_checks(const std::filesystem::path& file) {
  return [name = file.string(), allowance = occt::reading_allowance(file)](
             const std::string& what, const std::function<void()>& work) {
    stop_if_interrupted();
    const std::string step = what + " of " + name;
    if (has_failed(step)) return false;
    enter(Phase::Optional, name, step);
    allow_processor_time(allowance);
    work();
    enter(Phase::Working, "looking at " + name);
    return true;
  };
}

void add_reading(reports::Json& report) {
  if (all_reports().empty()) return;
  reports::Json files = reports::Json::array();
  for (const auto& [file, reading] : all_reports()) {
    files.push_back(reports::reading_json(file, reading));
  }
  report["reading"] = std::move(files);
  const char* const complete = to_string(Status::Complete);
  if (shapes_are_lost() && report.contains("status") && report["status"] == complete)
    report["status"] = to_string(Status::Tolerance);
}

Status stated(Status status) {
  return shapes_are_lost() ? weaker(status, Status::Tolerance) : status;
}

int stated_exit_code(int code) {
  return code == kExitComplete && shapes_are_lost() ? kExitTolerance : code;
}

}  // namespace blossom::cli
