// SPDX-License-Identifier: LGPL-2.1-or-later
// Models that are not part of the repository.

#pragma once

#include <cstdlib>

namespace blossom::testing {

/// The folder with models/ that the environment variable BLOSSOM_TEST_DATA names, or null. A test
/// that needs it is skipped with the words below.
inline const char* test_data() { return std::getenv("BLOSSOM_TEST_DATA"); }

inline constexpr const char* kNoTestData = "BLOSSOM_TEST_DATA names no folder with models/";

}  // namespace blossom::testing
