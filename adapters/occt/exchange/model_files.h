// SPDX-License-Identifier: LGPL-2.1-or-later
// A model and the files that it names for its parts. For this folder only.

#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <vector>

#include "adapters/occt/exchange/detail.h"

namespace blossom::occt {

/// Reads a model with all files that have parts of it, each once.
class ModelFiles {
 public:
  /// throws   as read_model
  Model read(const std::filesystem::path& file, const ReadOptions& options);

  /// Reads the others of a reading. What cannot be read is listed as lost, and so is what is lost
  /// in what can.
  void read_others(Reading& reading);

 private:
  std::shared_ptr<Model> other(Reading& reading, const std::filesystem::path& file);

  std::vector<std::filesystem::path> way_;  ///< files that are being read, each named by the last
  std::map<std::filesystem::path, std::shared_ptr<Model>> models_;  ///< null if it cannot be read
};

}  // namespace blossom::occt
