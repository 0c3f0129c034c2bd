// SPDX-License-Identifier: LGPL-2.1-or-later
// Pieces of many nets, and what is told of them; see plugin/cli/schemas/subdivision-1.md.

#pragma once

#include <string>
#include <vector>

#include "plugin/nets/pieces.h"
#include "plugin/reports/text/json.h"

namespace blossom::nets {

/// A face or an edge that does not fill the place that was wanted of it.
struct ClippedSource {
  int face = 0, edge = 0;  ///< one of them
  Interval u, v;           ///< its parameters; of an edge u alone
};

struct Subdivision {
  std::string input;  ///< its name
  Cut cut;
  std::vector<Net> pieces{};
  std::vector<ClippedSource> clipped{};
  double seconds = 0;
};

/// The pieces of all nets.
/// throws   occt::BadModel, naming the input, if these would be more than a million or none; and as
///          `pieces`
Subdivision subdivided(const std::string& input, const std::vector<Net>& nets, const Cut& cut);

/// The whole object, schema "blossom.subdivision/1".
/// repairs   of the model, if the nets are of one
reports::Json subdivision_report(const Subdivision& made, reports::Json repairs);

}  // namespace blossom::nets
