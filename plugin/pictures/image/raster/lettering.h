// SPDX-License-Identifier: LGPL-2.1-or-later
// Letters as strokes of a pen, for pictures made without fonts.

#pragma once

#include <string>
#include <vector>

#include "core/math/vec.h"

namespace blossom::pictures {

/// Letters of one size on one line; units are those of `height`.
struct Lettering {
  /// Polylines; x to the right from the text's beginning, y downwards from the base line.
  std::vector<std::vector<Vec2>> strokes;
  double width = 0;
};

/// text      UTF-8; printable ASCII has letters, anything else is an empty box
/// height    of a capital letter
Lettering lettering_of(const std::string& text, double height);

/// The text, or as much of its beginning as fits with "..." after it.
std::string fitting(const std::string& text, double height, double width);

}  // namespace blossom::pictures
