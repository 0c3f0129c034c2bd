// SPDX-License-Identifier: LGPL-2.1-or-later
// The one exception of the core.

#pragma once

#include <stdexcept>

namespace blossom {

/// The caller broke a written precondition: a wrong count, a value that is not
/// finite, cuts that do not increase. The message names the function and the
/// argument, what came and what was wanted.
class InvalidInput : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

}  // namespace blossom
