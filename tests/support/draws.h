// SPDX-License-Identifier: LGPL-2.1-or-later
// What tests with many random draws share: how many, spread over decades, and told apart when one
// fails.

#pragma once

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>

#include "tests/support/random.h"

namespace blossom::testing {

/// The number in an environment variable, which asks for more draws or for one of them.
inline int setting(const char* name, int otherwise) {
  const char* wanted = std::getenv(name);
  return wanted != nullptr ? std::atoi(wanted) : otherwise;
}

/// Between positive bounds, each power of ten as often as another.
inline double log_uniform(Random& random, double low, double high) {
  return std::exp(uniform(random, std::log(low), std::log(high)));
}

/// The values in a row, with all their digits.
template <class... Values>
std::string text(const Values&... values) {
  std::ostringstream out;
  out.precision(17);
  (out << ... << values);
  return out.str();
}

}  // namespace blossom::testing
