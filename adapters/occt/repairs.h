// SPDX-License-Identifier: LGPL-2.1-or-later
// What was repaired of a model.

#pragma once

#include <algorithm>
#include <vector>

namespace blossom::occt {

/// Numbers are 1-based, in the order of TopExp::MapShapes over the whole model; lengths in model
/// units.
struct Repairs {
  struct RaisedTolerance {
    int number = 0;  ///< of the edge or vertex
    double tolerance = 0;
  };
  struct RemadeCurve {
    int face = 0;
    int edge = 0;
    double gap = 0;  ///< how far it was off the edge's curve in space
  };
  struct MissingCurve {
    int face = 0;
    int edge = 0;
    bool added = false;  ///< made from the curve in space; else it could not be made
  };

  std::vector<RaisedTolerance> edges;     ///< their curves are farther apart than they stated
  std::vector<RaisedTolerance> vertices;  ///< likewise, of the ends of curves
  std::vector<RemadeCurve> remade;        ///< curves in parameters that did not fit those in space
  std::vector<MissingCurve> missing;      ///< edges without a curve in the parameters of a face
  std::vector<int> failed;                ///< faces that Open CASCADE fails on; used as they are

  bool empty() const {
    return edges.empty() && vertices.empty() && remade.empty() && missing.empty() && failed.empty();
  }
  double largest_tolerance() const {
    double most = 0;
    for (const auto* list : {&edges, &vertices})
      for (const RaisedTolerance& each : *list) most = std::max(most, each.tolerance);
    return most;
  }
  double largest_gap() const {
    double most = 0;
    for (const RemadeCurve& each : remade) most = std::max(most, each.gap);
    return most;
  }
};

}  // namespace blossom::occt
