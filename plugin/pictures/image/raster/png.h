// SPDX-License-Identifier: LGPL-2.1-or-later
// Pictures as PNG files.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace blossom::pictures {

struct Colour {
  std::uint8_t red = 0;  ///< sRGB
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  friend bool operator==(const Colour&, const Colour&) = default;
};

struct Image {
  int width = 0;
  int height = 0;
  std::vector<Colour> pixels;  ///< row after row from the top
};

/// The bytes of a PNG file, 8 bits a channel; the same for the same image.
/// throws   std::runtime_error if the memory does not suffice
std::string png_bytes(const Image& image);

}  // namespace blossom::pictures
