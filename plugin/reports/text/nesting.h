// SPDX-License-Identifier: LGPL-2.1-or-later
// How deep the lists and objects of a JSON text lie in each other. Copies and texts of JSON values
// are made by recursion, which ends the stack where they lie in each other some 10 000 deep.

#pragma once

#include <string_view>

namespace blossom::reports {

/// What files of ours need is less than 20.
inline constexpr int kMaxNesting = 64;

/// Whether they lie in each other no deeper than that; the text need not be JSON.
bool is_nested_soundly(std::string_view json);

}  // namespace blossom::reports
