// SPDX-License-Identifier: LGPL-2.1-or-later
// The JSON report of a section with a plane; see plugin/cli/schemas/query-1.md.

#pragma once

#include "adapters/occt/plane_section.h"
#include "plugin/reports/input.h"
#include "plugin/reports/json.h"

namespace blossom::reports {

/// Schema "blossom.query/1", kind "plane".
/// seconds   from the model in memory to finished wires
Json section_report(const Input& input, const occt::Plane& plane, double tolerance,
                    const occt::PlaneSection& section, double seconds);

}  // namespace blossom::reports
