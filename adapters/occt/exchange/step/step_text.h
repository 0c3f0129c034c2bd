// SPDX-License-Identifier: LGPL-2.1-or-later
// STEP text as Open CASCADE's parser wants it. For this folder only.

#pragma once

#include <string>

#include "adapters/occt/reading.h"

namespace blossom::occt {

/// Takes a byte-order mark and what stands before the header away, writes keywords in capitals if
/// they are not, letters beyond ASCII in STEP's codes, drops control characters and
/// what follows the end, closes a file without an end behind its last whole entity, and mends
/// sections and entities (`step_sections.h`, `step_entities.h`, `step_numbers.h`, `step_reals.h`):
/// Open CASCADE refuses these. What a missing end means is said in the report.
void mend_step_text(std::string& text, ReadingReport& report);

}  // namespace blossom::occt
