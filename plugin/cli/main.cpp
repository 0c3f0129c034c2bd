// SPDX-License-Identifier: LGPL-2.1-or-later
// The program `blossom`.

#include "adapters/occt/shapes.h"
#include "plugin/cli/process/reproduction.h"
#include "plugin/cli/program.h"

int main(int argc, char** argv) {
  blossom::occt::quiet_messages();
  return blossom::cli::run_reproducibly({argv, argv + argc}, blossom::cli::run_program).code;
}
