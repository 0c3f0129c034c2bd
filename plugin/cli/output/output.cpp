// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/output/output.h"

#include <filesystem>
#include <iostream>
#include <string>
#include <system_error>
#include <vector>

#include "adapters/occt/base/errors.h"
#include "plugin/cli/output/reading.h"
#include "plugin/cli/output/verbosity.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/cli/process/supervision.h"

namespace blossom::cli {

namespace {

bool file_unwritten = false;

bool is_stdout(const std::string& target) { return target == "-" || target == "/dev/stdout"; }

}  // namespace

void print(const std::string& text) {
  std::cout << text << std::flush;
  if (!std::cout) throw occt::Failure("stdout: cannot be written");
}

bool is_stream(const std::string& target) {
  return is_stdout(target) || target == "/dev/stderr" || target == "/dev/null" ||
         target.starts_with("/dev/fd/");
}

void write_plain_json(const Json& json, const std::string& target) {
  enter(Phase::Writing, target);
  // File names may hold bytes that are no UTF-8.
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  enter(Phase::Placing, target);
  if (is_stdout(target))
    print(text);
  else
    occt::write_text(text, target);
}

void write_model(const occt::Model& model, const std::string& file) {
  enter(Phase::Writing, file);
  const std::vector<occt::WriteNote> notes = occt::write_model(model, file, [&] {
    stop_if_interrupted();
    enter(Phase::Placing, file);
  });
  for (const occt::WriteNote& told : notes) {
    told.within_tolerance ? detail(file + ": " + told.text) : note(file + ": " + told.text);
    if (told.shapes_lost) leave_faces_out();
  }
}

void write_json(Json report, const std::string& target) {
  add_reading(report);
  write_plain_json(report, target);
}

void print_summary(const std::string& text, const std::string& json) {
  if (!is_stdout(json) && verbosity() != Verbosity::Quiet) print(text);
}

void report_nothing_found(const std::string& file, const std::string& reason) {
  std::error_code ignored;
  std::cerr << "blossom: " << file << " is not written: " << reason
            << (std::filesystem::exists(file, ignored)
                    ? "; the file of that name is an older one, left as it was\n"
                    : "\n");
}

void report_unwritten(const std::string& file, const std::string& reason) {
  report_nothing_found(file, reason);
  file_unwritten = true;
}

bool is_file_unwritten() { return file_unwritten; }

}  // namespace blossom::cli
