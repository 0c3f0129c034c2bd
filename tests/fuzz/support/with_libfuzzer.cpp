// SPDX-License-Identifier: LGPL-2.1-or-later
// The door of libFuzzer to the target.
#include "tests/fuzz/support/target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  blossom::fuzz::watch_time();
  blossom::fuzz::try_input({data, size});
  blossom::fuzz::stop_watching_time();
  return 0;
}
