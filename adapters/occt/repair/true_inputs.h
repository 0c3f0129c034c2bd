// SPDX-License-Identifier: LGPL-2.1-or-later
// The part and the tools of an operation, with true tolerances.

#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "adapters/occt/repair/edge_tolerances.h"
#include "adapters/occt/trim_tool.h"
#include "core/base/work_limit.h"

namespace blossom::occt {

/// What an input is called in messages.
inline std::string part_name(const TrimTool& part) {
  return part.name.empty() ? "the part" : part.name;
}

inline std::string tool_name(const std::vector<TrimTool>& tools, std::size_t i) {
  if (!tools[i].name.empty()) return tools[i].name;
  return tools.size() == 1 ? "the tool" : "tool " + std::to_string(i + 1);
}

/// Inputs with true tolerances; tells what was not true.
class TrueInputs {
 public:
  TrueInputs(const TrimTool& part, const std::vector<TrimTool>& tools, const WorkLimit& limit)
      : part_(sound(part, part_name(part), limit)) {
    for (std::size_t i = 0; i < tools.size(); ++i)
      tools_.push_back(sound(tools[i], tool_name(tools, i), limit));
  }

  const TrimTool& part() const { return part_; }
  const std::vector<TrimTool>& tools() const { return tools_; }
  const std::vector<std::string>& told() const { return told_; }

 private:
  TrimTool sound(const TrimTool& input, const std::string& name, const WorkLimit& limit) {
    TrueSolid made = with_true_tolerances(input, limit);
    if (!made.told.empty()) told_.push_back(name + ": " + made.told);
    return std::move(made.solid);
  }

  std::vector<std::string> told_;
  TrimTool part_;
  std::vector<TrimTool> tools_;
};

}  // namespace blossom::occt
