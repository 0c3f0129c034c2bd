// SPDX-License-Identifier: LGPL-2.1-or-later
// Carrying the reason why a fillet cannot be made out of the work.

#pragma once

#include <stdexcept>
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

}  // namespace blossom::occt
