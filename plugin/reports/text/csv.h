// SPDX-License-Identifier: LGPL-2.1-or-later
// Tables as files of comma-separated values, as RFC 4180 has them but for the ends of lines.

#pragma once

#include <string>
#include <vector>

namespace blossom::reports {

/// A row with its end of line; fields with commas, quotes or line ends are quoted.
std::string csv_row(const std::vector<std::string>& fields);

/// The shortest text that reads back as the same number; empty of what is not finite.
std::string csv_number(double value);

}  // namespace blossom::reports
