// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/models/reading.h"

#include <utility>

namespace blossom::reports {
namespace {

Json loss_json(const occt::Loss& loss) {
  return {{"what", loss.what},   {"count", loss.count},           {"cause", loss.cause},
          {"which", loss.which}, {"belongs_to", loss.belongs_to}, {"of_shape", loss.of_shape}};
}

}  // namespace

Json reading_json(const std::filesystem::path& file, const occt::ReadingReport& report) {
  Json losses = Json::array();
  for (const occt::Loss& loss : report.losses) losses.push_back(loss_json(loss));
  return {{"file", file.string()},
          {"grade", to_string(report.grade())},
          {"losses", std::move(losses)},
          {"notes", report.notes}};
}

}  // namespace blossom::reports
