// SPDX-License-Identifier: LGPL-2.1-or-later
// What `check --continuity` found, counted and in words.

#pragma once

#include <string>

#include "plugin/reports/blends/continuity.h"
#include "plugin/reports/blends/continuity_words.h"

namespace blossom::cli {

using reports::class_word;
using reports::kClassWords;

struct ContinuityReport : reports::ContinuityAnswer {
  bool table = false;  ///< wanted, with a line for every edge
};

/// The summary, and the table if it is asked for.
/// has_picture   then colours are explained
std::string continuity_text(const std::string& name, const ContinuityReport& report,
                            bool has_picture);

}  // namespace blossom::cli
