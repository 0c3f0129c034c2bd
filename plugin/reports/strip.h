// SPDX-License-Identifier: LGPL-2.1-or-later
// The JSON report of a strip; see plugin/cli/schemas/blend-1.md.

#pragma once

#include "adapters/occt/strip.h"
#include "plugin/reports/input.h"
#include "plugin/reports/json.h"

namespace blossom::reports {

/// The larger figures of both ends.
StripContact worst_of(const Strip& strip);

/// The whole object, schema "blossom.blend/1". Both inputs have one face.
Json strip_report(const Input& a, const Input& b, const StripOptions& options,
                  const occt::FaceStrip& made, double seconds);

}  // namespace blossom::reports
