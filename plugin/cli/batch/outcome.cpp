// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/batch/outcome.h"

#include <sstream>

#include "plugin/cli/arguments/values.h"
#include "plugin/cli/exit_code.h"
#include "plugin/reports/text/nesting.h"

namespace blossom::cli {
namespace {

constexpr std::string_view kProgramName = "blossom: ";  // before what explains an exit code
constexpr JobStatus kStatuses[] = {JobStatus::Done, JobStatus::Stopped, JobStatus::Failed};

// Why a job was stopped that said nothing about it: the first reason of its report.
std::string reason_in(const Json& line) {
  const Json reasons = line.value(Json::json_pointer("/report/certificate/reasons"), Json::array());
  return reasons.empty() ? "a limit was reached" : reasons.front().get<std::string>();
}

Json lines_of(const std::string& text) {
  Json lines = Json::array();
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace

const char* to_string(JobStatus status) {
  switch (status) {
    case JobStatus::Done: return "done";
    case JobStatus::Stopped: return "stopped";
    case JobStatus::Failed: break;
  }
  return "failed";
}

std::string result_line(const Job& job, const Outcome& outcome) {
  Json line{{"id", job.id},
            {"status", to_string(outcome.status)},
            {"code", outcome.code},
            {"arguments", job.arguments},
            {"run",
             {{"attempts", outcome.attempts},
              {"seconds", rounded(outcome.seconds)},
              {"memory_mb", rounded(outcome.memory)}}},
            {"messages", lines_of(outcome.err)}};
  Json report;
  if (reports::is_nested_soundly(outcome.out)) report = Json::parse(outcome.out, nullptr, false);
  if (report.is_object())
    line["report"] = std::move(report);
  else if (!outcome.out.empty())
    line["output"] = outcome.out;
  return line.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result parse_result(const std::string& line, const std::string& place) try {
  if (!reports::is_nested_soundly(line)) throw UsageError("");
  const Json json = Json::parse(line);
  Result result;
  result.id = json.at("id");
  const std::string status = json.at("status");
  const auto* const known = std::ranges::find(kStatuses, status, to_string);
  if (known == std::ranges::end(kStatuses)) throw UsageError("");
  result.status = *known;
  result.code = json.at("code");
  result.seconds = json.at("run").at("seconds");
  result.arguments = hash_of(json.at("arguments"));
  for (const Json& message : json.at("messages"))
    if (const std::string text = message; text.starts_with(kProgramName))
      result.message = text.substr(kProgramName.size());
  if (result.message.empty() && result.status == JobStatus::Stopped)
    result.message = reason_in(json);
  return result;
} catch (const std::exception&) {
  throw UsageError(place + ": is no result of a batch");
}

}  // namespace blossom::cli
