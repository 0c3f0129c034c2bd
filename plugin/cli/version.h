// SPDX-License-Identifier: LGPL-2.1-or-later
// Which Blossom this is, with which Open CASCADE, and under which licence the binary falls.

#pragma once

#include <string>

namespace blossom::cli {

/// "blossom 0.1.0", the version of Open CASCADE and the licence, a line each.
std::string version_text();

/// "0.1.0"
std::string version_number();

}  // namespace blossom::cli
