// SPDX-License-Identifier: LGPL-2.1-or-later
// What was repaired of an input, in words and in reports.

#pragma once

#include <string>
#include <vector>

#include "adapters/occt/repairs.h"
#include "plugin/reports/models/input.h"
#include "plugin/reports/text/json.h"

namespace blossom::reports {

/// "117 parameter curves recomputed (up to 0.004), 34 tolerances raised (up to 2e-05)".
std::string summary_of(const occt::Repairs& repairs);

/// Where that was, the first ten of each kind, a line for each kind.
std::vector<std::string> details_of(const occt::Repairs& repairs);

/// What became of loose faces, in lines: "44 loose faces sewn into 1 solid, gaps up to 0.0003";
/// none if there is nothing to say.
/// way   how the user joins across wider gaps, as words
std::vector<std::string> words_of(const occt::Sewing& sewing, const std::string& way);

/// What reports say of both; they have a list, `repairs`, of each input in the order in which the
/// command takes them.
Json repairs_json(const Input& input);

}  // namespace blossom::reports
