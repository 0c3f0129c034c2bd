// SPDX-License-Identifier: LGPL-2.1-or-later
// Inputs as files, for readers that take their names.

#pragma once

#include <filesystem>
#include <string>

#include "tests/fuzz/support/target.h"

namespace blossom::fuzz {

/// A file with these bytes and this ending, in memory where the system has a folder for that; the
/// next call of the same process replaces it.
std::filesystem::path file_of(Bytes bytes, const std::string& ending);

}  // namespace blossom::fuzz
