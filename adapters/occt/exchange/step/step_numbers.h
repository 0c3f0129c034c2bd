// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers of entities, "#12", that Open CASCADE does not read in a STEP text. For this folder only.

#pragma once

#include <string>

#include "adapters/occt/reading.h"

namespace blossom::occt {

/// Makes blanks of entities with a number that one before them has. Unless they are the same, this
/// is a loss of shape.
void drop_repeated_entities(std::string& text, ReadingReport& report);

/// Numbers entities anew, from 1 in the order in which the text has them, if a number is beyond
/// 2^31 - 1: Open CASCADE crashes on these. Messages then have the new numbers.
void renumber_large_entities(std::string& text);

}  // namespace blossom::occt
