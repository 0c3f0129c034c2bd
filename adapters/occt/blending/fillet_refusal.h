// SPDX-License-Identifier: LGPL-2.1-or-later
// Carrying the reason why a fillet cannot be made out of the work.

#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

#include "adapters/occt/fillet.h"

namespace blossom::occt {

class FilletRefused : public std::runtime_error {
 public:
  explicit FilletRefused(FilletRefusal why)
      : std::runtime_error(why.text()), why_(std::move(why)) {}
  const FilletRefusal& why() const { return why_; }

 private:
  FilletRefusal why_;
};

/// A positive size to six digits, cut off: what works below it works with what is told.
double told_below(double size);

/// "(1, 2, 0)": six digits, and 0 for what is left of rounding.
std::string told_place(const Vec3& place);

/// A text with "edge 12" and "face 3" replaced by what they are called elsewhere: of a body between
/// two groups of fillets, in words of the one that was given.
///
/// edge, face   what takes the place of both words, as "edge 7"
std::string renumbered(const std::string& text, const std::function<std::string(int)>& edge,
                       const std::function<std::string(int)>& face);

}  // namespace blossom::occt
