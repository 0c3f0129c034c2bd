// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangles as 3MF, the packed format of printers.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/math/vec.h"

namespace blossom::lib3mf {

/// The library refused. The message says what.
class ThreeMfFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One body, and its triangles from a place on, which have a colour or none.
struct ThreeMfPart {
  std::size_t first = 0;
  std::optional<std::array<std::uint8_t, 3>> colour{};
};

/// The content of a file with one object, in millimetres, coordinates in single precision.
///
/// triangles   counter-clockwise from outside, of three different points each
/// parts       in order, up to the next
/// throws      ThreeMfFailure
std::string three_mf_bytes(const std::string& name, std::span<const Vec3> points,
                           std::span<const std::array<int, 3>> triangles,
                           const std::vector<ThreeMfPart>& parts);

}  // namespace blossom::lib3mf
