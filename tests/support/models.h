// SPDX-License-Identifier: LGPL-2.1-or-later
// Models as commands use them.

#pragma once

#include <filesystem>

#include "adapters/occt/shapes.h"

namespace blossom::testing {

/// Read from a file, with all faces repaired.
inline occt::Model repaired_model(const std::filesystem::path& file) {
  occt::Model model = occt::read_model(file);
  model.repair();
  return model;
}

}  // namespace blossom::testing
