// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers in binary files of triangles.

#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>

namespace blossom::meshes {

/// The bytes of a number, the lowest one first.
template <class Number>
void add_bytes(std::string& bytes, Number value) {
  std::array<char, sizeof value> raw{};
  std::memcpy(raw.data(), &value, sizeof value);
  if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(raw);
  bytes.append(raw.data(), raw.size());
}

}  // namespace blossom::meshes
