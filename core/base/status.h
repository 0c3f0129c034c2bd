// SPDX-License-Identifier: LGPL-2.1-or-later
// How far an answer is proven.

#pragma once

namespace blossom {

enum class Status {
  Complete,   ///< every component is proven, the topology is exact; of what a certificate counts as
              ///< identified, exact once that is one
  Tolerance,  ///< right up to contacts within tolerance, all of them in the listed places
  Stopped,    ///< a budget, a time limit or a cancellation; the open places are listed
};

/// "complete", "tolerance" or "stopped": the words of the JSON report.
const char* to_string(Status status);

/// The weaker of two statuses: Stopped < Tolerance < Complete.
Status weaker(Status a, Status b);

}  // namespace blossom
