// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/text/nesting.h"

#include <cstddef>

namespace blossom::reports {

bool is_nested_soundly(std::string_view json) {
  int depth = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_text && c == '\\')
      ++i;
    else if (c == '"')
      in_text = !in_text;
    else if (!in_text && (c == '[' || c == '{') && ++depth > kMaxNesting)
      return false;
    else if (!in_text && (c == ']' || c == '}'))
      --depth;
  }
  return true;
}

}  // namespace blossom::reports
