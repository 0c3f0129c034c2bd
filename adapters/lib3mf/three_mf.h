// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangles as 3MF, the packed format of printers.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
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

/// Triangles from a place on, up to the next, which have a colour or none.
struct ThreeMfColour {
  std::size_t first = 0;
  std::optional<std::array<std::uint8_t, 3>> colour{};
};

/// What programs list, place and print as one.
struct ThreeMfObject {
  std::string name;
  std::vector<Vec3> points;                   ///< millimetres, kept in single precision
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise from outside, of three
                                              ///< different points each
  std::vector<ThreeMfColour> colours{};       ///< in order
};

/// Loads what three_mf_bytes needs, where that is not linked.
void load_three_mf();

/// The content of a file with these objects, each where its points are.
///
/// throws   ThreeMfFailure
std::string three_mf_bytes(const std::vector<ThreeMfObject>& objects);

}  // namespace blossom::lib3mf
