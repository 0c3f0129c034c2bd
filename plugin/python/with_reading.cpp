// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <filesystem>
#include <map>

#include "plugin/python/answers.h"
#include "plugin/reports/models/reading.h"

namespace blossom::python {
namespace {

bool lost_shapes(const SharedModel& model) {
  const reports::UnusableFaces& left_out = model->left_out();
  if (!left_out.open.empty() || !left_out.lines.empty()) return true;
  const occt::Model* const file = model->file();
  return file != nullptr && file->reading().grade() == occt::ReadingGrade::ShapesLost;
}

}  // namespace

Status stated_status(Status status, const std::vector<SharedModel>& models) {
  return std::ranges::any_of(models, lost_shapes) ? weaker(status, Status::Tolerance) : status;
}

reports::Json with_reading(reports::Json report, const std::vector<SharedModel>& models) {
  std::map<std::filesystem::path, const occt::ReadingReport*> files;
  for (const SharedModel& model : models)
    if (const occt::Model* const file = model->file())
      files.emplace(file->file(), &file->reading());
  if (!files.empty()) report["reading"] = reports::Json::array();
  for (const auto& [file, reading] : files)
    report["reading"].push_back(reports::reading_json(file, *reading));
  const char* const complete = to_string(Status::Complete);
  if (std::ranges::any_of(models, lost_shapes) && report.contains("status") &&
      report["status"] == complete)
    report["status"] = to_string(Status::Tolerance);
  return report;
}

}  // namespace blossom::python
