// SPDX-License-Identifier: LGPL-2.1-or-later
// An input's bytes as a sequence of decisions. After the last byte all are the first possible one,
// so that every input means something and shorter ones mean simpler things.

#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "tests/fuzz/support/target.h"

namespace blossom::fuzz {

class Choices {
 public:
  explicit Choices(Bytes bytes) : bytes_(bytes) {}

  bool is_empty() const { return bytes_.empty(); }

  int byte() {
    if (bytes_.empty()) return 0;
    const int value = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return value;
  }

  /// A whole number of that range, which is no longer than 256.
  int within(int first, int last) { return first + byte() % (last - first + 1); }

  bool is_so() { return byte() % 2 == 1; }

  /// In steps of 2^-16.
  double between(double low, double high) {
    const int part = byte() << 8;
    return low + (high - low) * (part + byte()) / 65536.0;
  }

  /// Any double, also infinite and none.
  double any() {
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i) bits = bits << 8 | static_cast<std::uint64_t>(byte());
    return std::bit_cast<double>(bits);
  }

  /// A power of ten.
  double magnitude(int least, int most) { return std::pow(10.0, within(least, most)); }

  Bytes rest() {
    const Bytes all = bytes_;
    bytes_ = {};
    return all;
  }

 private:
  Bytes bytes_;
};

}  // namespace blossom::fuzz
