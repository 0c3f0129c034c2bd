// SPDX-License-Identifier: LGPL-2.1-or-later
// Which Blossom this is, under which licence the binary falls, and what it stands on.

#pragma once

#include <string>

namespace blossom::cli {

/// "blossom 0.1.0", the licence, and the libraries with their versions, a line each.
std::string version_text();

/// "0.1.0"
std::string version_number();

/// The same with what tells builds of it apart: the size of the program and when it was made.
std::string build_name();

}  // namespace blossom::cli
