// SPDX-License-Identifier: LGPL-2.1-or-later
// A model that was read in another process. For this folder only.

#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "adapters/occt/shapes.h"

namespace blossom::occt {

class ModelBytes {
 public:
  /// All that reading has found; nothing if the bytes would not give the model again, to the last
  /// bit.
  static std::optional<std::string> of(const Model& model);

  /// throws   std::ios_base::failure or Standard_Failure if `of` has not made them
  static Model model(const std::string& bytes, const std::filesystem::path& file);
};

}  // namespace blossom::occt
