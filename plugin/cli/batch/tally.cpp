// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/batch/tally.h"

#include <algorithm>
#include <sstream>

#include "plugin/cli/arguments/values.h"
#include "plugin/cli/exit_code.h"

namespace blossom::cli {
namespace {

constexpr std::size_t kFew = 5;  // that a summary names

Json brief(const Result& result) {
  Json json{{"id", result.id}, {"code", result.code}, {"seconds", result.seconds}};
  if (!result.message.empty()) json["message"] = result.message;
  return json;
}

Json brief(const std::vector<Result>& results) {
  Json list = Json::array();
  for (const Result& result : results) list.push_back(brief(result));
  return list;
}

// "part 7: part7.step: no such file"; the id alone where nothing was said.
std::string told(const Result& result) {
  return result.id + (result.message.empty() ? "" : ": ") + result.message;
}

}  // namespace

void Tally::add(const Result& result) {
  Kind& kind = kinds_[static_cast<std::size_t>(result.status)];
  ++kind.count;
  if (result.status != JobStatus::Done && kind.first.size() < kMaxListed)
    kind.first.push_back(result);
  findings_ += result.code == kExitFindings ? 1 : 0;
  tolerance_ += result.code == kExitTolerance ? 1 : 0;
  const auto place =
      std::ranges::upper_bound(slowest_, result.seconds, std::greater(), &Result::seconds);
  if (place - slowest_.begin() >= static_cast<std::ptrdiff_t>(kMaxSlowest)) return;
  slowest_.insert(place, result);
  if (slowest_.size() > kMaxSlowest) slowest_.pop_back();
}

std::size_t Tally::count() const {
  return count(JobStatus::Done) + count(JobStatus::Stopped) + count(JobStatus::Failed);
}

int Tally::exit_code() const {
  if (count(JobStatus::Failed) > 0) return kExitFailure;
  if (count(JobStatus::Stopped) > 0) return kExitStopped;
  if (findings_ > 0) return kExitFindings;
  return tolerance_ > 0 ? kExitTolerance : kExitComplete;
}

std::string Tally::text(bool all) const {
  std::ostringstream text;
  if (tolerance_ > 0)
    text << "  done, but within tolerance or with shapes missing (exit code 3): "
         << counted(tolerance_, "job") << "\n";
  if (findings_ > 0)
    text << "  done, with findings (exit code 5): " << counted(findings_, "job") << "\n";
  for (const JobStatus status : {JobStatus::Failed, JobStatus::Stopped}) {
    const Kind& kind = of(status);
    if (kind.count == 0) continue;
    text << "  " << to_string(status) << ": " << counted(kind.count, "job") << "\n";
    const std::size_t named = std::min(kind.first.size(), all ? kMaxListed : kFew);
    for (std::size_t i = 0; i < named; ++i) text << "    " << told(kind.first[i]) << "\n";
    if (named < kind.count)
      text << "    and " << kind.count - named << " more" << (all ? "" : "; -v names them") << "\n";
  }
  if (!slowest_.empty()) text << "  slowest:\n";
  for (std::size_t i = 0; i < std::min(slowest_.size(), all ? kMaxSlowest : kFew); ++i)
    text << "    " << seconds_text(slowest_[i].seconds) << "  " << slowest_[i].id << "\n";
  return text.str();
}

Json Tally::json() const {
  return {{"jobs", count()},
          {"done", count(JobStatus::Done)},
          {"tolerance", tolerance_},
          {"findings", findings_},
          {"stopped",
           {{"count", count(JobStatus::Stopped)}, {"first", brief(of(JobStatus::Stopped).first)}}},
          {"failed",
           {{"count", count(JobStatus::Failed)}, {"first", brief(of(JobStatus::Failed).first)}}},
          {"slowest", brief(slowest_)}};
}

}  // namespace blossom::cli
