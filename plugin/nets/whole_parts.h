// SPDX-License-Identifier: LGPL-2.1-or-later
// Chosen faces or edges of a model as one B-spline each, in a model and in a report.

#pragma once

#include <array>
#include <optional>
#include <vector>

#include <TopoDS_Shape.hxx>

#include "adapters/occt/shapes.h"
#include "core/math/interval.h"
#include "plugin/nets/net.h"
#include "plugin/reports/models/input.h"
#include "plugin/reports/text/json.h"

namespace blossom::nets {

struct WholePart {
  NetSource source;
  TopoDS_Shape shape;  ///< an untrimmed face, or an edge
  reports::Json json;  ///< see `spline_json`, with the number of its face or edge
};

/// What of faces or edges is wanted, in their own parameters; at most one of the places.
struct WholeCut {
  std::optional<Interval> interval{};  ///< of edges, which a model without faces means, too
  std::optional<std::array<Interval, 2>> rectangle{};  ///< of faces; none: the box of their trims
  bool all_edges = false;  ///< all of the model's, also those of no chosen face
  Stop stop{};             ///< asked for every part
};

/// throws   occt::BadModel as `whole_surface`, and if there is no edge with a curve
std::vector<WholePart> whole_parts(const reports::Input& input, const WholeCut& cut);

/// Puts faces in the places of those that they come from, with names and colours; faces without
/// one go.
void put_whole_faces(occt::Model& model, const std::vector<WholePart>& parts);

/// Edges as parts of their own.
occt::Model model_of_whole_edges(const std::vector<WholePart>& parts);

/// The whole object, schema "blossom.subdivision/1" with `whole`.
reports::Json whole_report(const reports::Input& input, const WholeCut& cut,
                           const std::vector<WholePart>& parts, double seconds);

}  // namespace blossom::nets
