// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/exchange/modules.h"
#include "adapters/occt/exchange/step/step.h"

namespace blossom::occt {

const StepModule& step_module() {
  static constexpr StepModule module{read_step};
  return module;
}

}  // namespace blossom::occt
