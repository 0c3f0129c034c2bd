// SPDX-License-Identifier: LGPL-2.1-or-later
// Shapes and names from STEP. For this folder and `documents` only.

#pragma once

#include <Standard_Transient.hxx>

#include "adapters/occt/exchange/detail.h"

namespace blossom::occt {

/// As StepModule has it.
Handle(Standard_Transient) read_step(Reading& reading);

}  // namespace blossom::occt
