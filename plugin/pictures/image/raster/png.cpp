// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/pictures/image/raster/png.h"

#include <zlib.h>

#include <cstdlib>
#include <stdexcept>

namespace blossom::pictures {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr int kChannels = 3;

void put_big_endian(std::string& out, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>((value >> shift) & 0xFF);
}

// Length, name, data and checksum of name and data.
void put_chunk(std::string& out, const std::string& name, const std::string& data) {
  put_big_endian(out, static_cast<std::uint32_t>(data.size()));
  const std::string body = name + data;
  out += body;
  put_big_endian(out,
                 static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(body.data()),
                                                  static_cast<uInt>(body.size()))));
}

// The neighbour (left, above, upper left) that is nearest to left + above - upper left.
int paeth(int left, int above, int upper_left) {
  const int guess = left + above - upper_left;
  const int a = std::abs(guess - left), b = std::abs(guess - above),
            c = std::abs(guess - upper_left);
  return a <= b && a <= c ? left : b <= c ? above : upper_left;
}

// A row as differences to its neighbours. kind: 0 none, 1 left, 2 above, 4 Paeth.
Bytes filtered(const Bytes& row, const Bytes& above, int kind) {
  Bytes result{static_cast<std::uint8_t>(kind)};
  result.reserve(row.size() + 1);
  for (std::size_t i = 0; i < row.size(); ++i) {
    const int left = i < kChannels ? 0 : row[i - kChannels];
    const int upper_left = i < kChannels ? 0 : above[i - kChannels];
    const int guess = kind == 1   ? left
                      : kind == 2 ? above[i]
                      : kind == 4 ? paeth(left, above[i], upper_left)
                                  : 0;
    result.push_back(static_cast<std::uint8_t>(row[i] - guess));
  }
  return result;
}

// The usual guess at what compresses well: the sum of the differences' sizes.
long cost(const Bytes& differences) {
  long sum = 0;
  for (std::size_t i = 1; i < differences.size(); ++i)
    sum += std::abs(static_cast<std::int8_t>(differences[i]));
  return sum;
}

Bytes filtered_rows(const Image& image) {
  const std::size_t width = static_cast<std::size_t>(image.width);
  Bytes all, above(width * kChannels, 0), row(width * kChannels, 0);
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      const Colour& pixel = image.pixels[y * width + x];
      row[x * kChannels] = pixel.red;
      row[x * kChannels + 1] = pixel.green;
      row[x * kChannels + 2] = pixel.blue;
    }
    Bytes best = filtered(row, above, 0);
    for (const int kind : {1, 2, 4}) {
      Bytes other = filtered(row, above, kind);
      if (cost(other) < cost(best)) best.swap(other);
    }
    all.insert(all.end(), best.begin(), best.end());
    above.swap(row);
  }
  return all;
}

}  // namespace

std::string png_bytes(const Image& image) {
  const Bytes rows = filtered_rows(image);
  uLongf size = compressBound(static_cast<uLong>(rows.size()));
  std::string packed(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size, rows.data(),
                static_cast<uLong>(rows.size()), Z_BEST_COMPRESSION) != Z_OK)
    throw std::runtime_error("the picture cannot be compressed: out of memory");
  packed.resize(size);

  std::string header;
  put_big_endian(header, static_cast<std::uint32_t>(image.width));
  put_big_endian(header, static_cast<std::uint32_t>(image.height));
  header += {8, 2, 0, 0, 0};  // 8 bits, RGB, the standard compression and filters, no interlace

  std::string png = "\x89PNG\r\n\x1a\n";
  put_chunk(png, "IHDR", header);
  put_chunk(png, "IDAT", packed);
  put_chunk(png, "IEND", "");
  return png;
}

}  // namespace blossom::pictures
