// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers as people write them.

#pragma once

#include <string>

namespace blossom::reports {

/// The shortest text that reads back as the same number, with exponents as people write them:
/// 1e-9, 0.25, 300.
std::string number_text(double value);

/// The nearest number of six digits, for summaries.
double rounded(double value);

/// "0.0124 s": a time in seconds, of three digits.
std::string seconds_text(double seconds);

}  // namespace blossom::reports
