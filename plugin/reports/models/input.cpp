// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/reports/models/input.h"

#include <cstddef>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/soundness.h"

namespace blossom::reports {
namespace {

constexpr const char* kNoName = "Open CASCADE STEP translator";  // its writer's word for no name

}  // namespace

void refuse_open_wires(const Input& input) {
  for (std::size_t i = 0; i < input.faces.size(); ++i)
    if (occt::has_open_wire(input.faces[i]))
      throw occt::BadModel(input.name + ": a wire of face " + std::to_string(input.numbers[i]) +
                           " is open and encloses nothing; `blossom check` lists what is wrong");
}

std::string given_name(const std::string& part) { return part.starts_with(kNoName) ? "" : part; }

}  // namespace blossom::reports
