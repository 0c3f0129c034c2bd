// SPDX-License-Identifier: LGPL-2.1-or-later
// The tolerances of solids, put back when an attempt to divide them leads to nothing.

#pragma once

#include <utility>
#include <vector>

#include <TopoDS_Shape.hxx>

#include "adapters/occt/trim_tool.h"

namespace blossom::occt {

/// Edges and vertices that are not divided themselves take part in the division, and their
/// tolerances grow with what ends there. What comes of a second attempt must not depend on whether
/// there was a first one: so this one puts the tolerances of all edges and vertices back to what
/// they were when it was made, unless it is told that they are to stay.
class KeptTolerances {
 public:
  KeptTolerances(const TrimTool& a, const TrimTool& b);
  ~KeptTolerances();
  KeptTolerances(const KeptTolerances&) = delete;
  KeptTolerances& operator=(const KeptTolerances&) = delete;

  /// The attempt came to something: tolerances stay as they are.
  void leave() { were_.clear(); }

 private:
  std::vector<std::pair<TopoDS_Shape, double>> were_;
};

}  // namespace blossom::occt
