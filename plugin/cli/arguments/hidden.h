// SPDX-License-Identifier: LGPL-2.1-or-later
// Options that help does not show.

#pragma once

namespace blossom::cli {

/// Their group. The parser's own, an empty one, takes their names out of messages, too.
inline constexpr const char* kHidden = "Hidden";

}  // namespace blossom::cli
