// SPDX-License-Identifier: LGPL-2.1-or-later
// Between which numbers values lie.

#pragma once

namespace blossom {

/// All from `low` to `high`.
struct ValueRange {
  double low = 0;
  double high = 0;
};

}  // namespace blossom
