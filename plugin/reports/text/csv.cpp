// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/text/csv.h"

#include <cmath>

#include "plugin/reports/text/json.h"

namespace blossom::reports {

std::string csv_row(const std::vector<std::string>& fields) {
  std::string row;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i > 0) row += ',';
    if (fields[i].find_first_of(",\"\r\n") == std::string::npos) {
      row += fields[i];
      continue;
    }
    row += '"';
    for (const char c : fields[i]) row += c == '"' ? std::string("\"\"") : std::string(1, c);
    row += '"';
  }
  return row + '\n';
}

std::string csv_number(double value) { return std::isfinite(value) ? Json(value).dump() : ""; }

}  // namespace blossom::reports
