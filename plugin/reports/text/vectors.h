// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers and vectors as people write them, and read back.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/math/vec.h"

namespace blossom::reports {

/// The number that a word is; none if it is not finite or goes on after it.
std::optional<double> finite_value(const std::string& text);

/// Numbers between commas; nothing if one is none.
std::optional<std::vector<double>> finite_numbers(const std::string& text);

/// A point whose coordinates are 0 where they are nothing beside the others.
Vec3 without_roundings(const Vec3& v);

/// "(1, -2.5, 300)".
std::string vector_text(const Vec3& v);

}  // namespace blossom::reports
