// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/exit_code.h"

namespace blossom::cli {

int exit_code(Status status) {
  switch (status) {
    case Status::Complete: return kExitComplete;
    case Status::Tolerance: return kExitTolerance;
    case Status::Stopped: break;
  }
  return kExitStopped;
}

int exit_code_unwritten(int code) { return code == kExitStopped ? kExitStopped : kExitFailure; }

}  // namespace blossom::cli
