// SPDX-License-Identifier: LGPL-2.1-or-later
// Nets in JSON; the format is described in plugin/cli/schemas/net-1.md.

#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "plugin/nets/net.h"
#include "plugin/reports/text/json.h"

namespace blossom::nets {

using reports::Json;

/// True for the ending .json, in any case.
bool is_net_file(const std::filesystem::path& file);

/// All nets of a file.
/// throws   occt::BadModel if it cannot be read, is no JSON or holds what is no net; the message
///          names the file, the net, the member and what was wanted
std::vector<Net> read_nets(const std::filesystem::path& file);

/// One net, an object without "schema".
Json to_json(const Net& net);

/// A whole file, schema "blossom.net/1".
Json nets_json(std::span<const Net> nets);

}  // namespace blossom::nets
