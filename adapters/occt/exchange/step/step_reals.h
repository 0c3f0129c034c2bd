// SPDX-License-Identifier: LGPL-2.1-or-later
// Real numbers as Open CASCADE reads them in a STEP text. For this folder only.

#pragma once

#include <string>

namespace blossom::occt {

/// Writes numbers with an exponent as the standard (ISO 10303-21, 6.4.2) has them, "1.E-05":
/// programs write "1e-05", "1E-05" and "1.D-05", too, which Open CASCADE takes for 0, or for
/// several numbers.
void mend_reals(std::string& text);

}  // namespace blossom::occt
