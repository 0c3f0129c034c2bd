// SPDX-License-Identifier: LGPL-2.1-or-later
// Strips as doors ask for them, and their JSON report; see plugin/cli/schemas/blend-1.md.

#pragma once

#include <string>

#include "adapters/occt/strip.h"
#include "plugin/reports/models/input.h"
#include "plugin/reports/text/json.h"

namespace blossom::reports {

/// Borders are "umin", "umax", "vmin" or "vmax", the number of an edge of the model, from 1, or
/// empty: the nearest.
struct StripWishes {
  std::string border_a;
  std::string border_b;
  StripOptions strip;
};

/// What a border's word means on a face of a model.
/// throws   BadModel if there is no such edge, with the numbers of the face's own; InvalidInput for
///          any other word
occt::StripStart strip_start(const TopoDS_Shape& model, const TopoDS_Face& face,
                             const std::string& name, const std::string& border);

/// "umin", or "edge 12".
std::string start_text(const TopoDS_Shape& model, const occt::StripStart& start);

/// Both inputs have one face.
occt::FaceStrip strip_between(const Input& a, const Input& b, const StripWishes& wishes);

/// The larger figures of both ends.
StripContact worst_of(const Strip& strip);

/// The whole object, schema "blossom.blend/1".
Json strip_report(const Input& a, const Input& b, const StripWishes& wishes,
                  const occt::FaceStrip& made, double seconds);

}  // namespace blossom::reports
