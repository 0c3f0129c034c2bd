// SPDX-License-Identifier: LGPL-2.1-or-later
// The sections of a STEP text as Open CASCADE's parser wants them. For this folder only.

#pragma once

#include <string>

namespace blossom::occt {

/// Takes the blanks and comments before the semicolons of "ENDSEC ;" and of what begins the file
/// and its sections away, and what later editions of the standard have there, "DATA('a',('b'));",
/// and adds a header, and the end of the last section, to a file without one.
void mend_step_sections(std::string& text);

}  // namespace blossom::occt
