// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers that count are int; containers want them without a sign.

#pragma once

#include <cstddef>

namespace blossom {

/// i   at least 0
constexpr std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace blossom
