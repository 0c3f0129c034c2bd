// SPDX-License-Identifier: LGPL-2.1-or-later
// JSON as reports are made of it.

#pragma once

#include <cstddef>
#include <string>

#include <nlohmann/json.hpp>

namespace blossom::reports {

/// Objects keep the order in which their members were added.
using Json = nlohmann::ordered_json;

/// "1 curve", "2 curves".
inline std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

}  // namespace blossom::reports
