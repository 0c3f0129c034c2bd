// SPDX-License-Identifier: LGPL-2.1-or-later
// What an intersection is in words: the summary.

#pragma once

#include <string>

#include "adapters/occt/intersection.h"
#include "plugin/cli/arguments/inputs.h"
#include "plugin/reports/cuts/intersection.h"
#include "plugin/reports/cuts/intersection_words.h"

namespace blossom::cli {

using reports::counts_of;
using reports::counts_text;
using reports::curve_text;
using reports::IntersectionCounts;
using reports::overlap_area;
using reports::PairNames;
using reports::place_text;

/// Whether the summary says what the curves of all pairs come to.
bool tells_joined(const IntersectionCounts& counts);

/// The summary: what was found, and where.
/// title   of its first line
std::string intersection_text(const reports::IntersectionFindings& findings,
                              const std::string& title, const IntersectionCounts& counts,
                              const reports::RunTimes& times);

}  // namespace blossom::cli
