// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/base/status.h"

#include <algorithm>

namespace blossom {

const char* to_string(Status status) {
  switch (status) {
    case Status::Complete: return "complete";
    case Status::Tolerance: return "tolerance";
    case Status::Stopped: break;
  }
  return "stopped";
}

Status weaker(Status a, Status b) { return std::max(a, b); }

}  // namespace blossom
