// SPDX-License-Identifier: LGPL-2.1-or-later
// What `blossom clash` shows: parts, what they have in common, where they touch, how far they are
// apart.

#pragma once

#include <string>

#include "plugin/cli/picture/picture.h"
#include "plugin/reports/queries/clash.h"

namespace blossom::cli {

/// Parts can be seen through, those that clash in a colour of their own; common bodies are solid.
/// Rings are on contacts, thin lines along distances that were measured.
/// subtitle   what came out, in a line
Picture clash_picture(const reports::ClashAnswer& answer, const std::string& subtitle);

}  // namespace blossom::cli
