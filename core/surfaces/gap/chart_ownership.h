// SPDX-License-Identifier: LGPL-2.1-or-later
// Which chart of b each cell of a was read in.
//
// Charts overlap, so that nothing is cut where they meet: a cell whose foot points lie in several
// of them belongs to the first that found something in it.

#pragma once

#include <array>
#include <map>
#include <set>
#include <vector>

#include "core/math/interval.h"

namespace blossom {

/// A rectangle of a patch's parameters.
using Box2 = std::array<Interval, 2>;

bool within(const Box2& inner, const Box2& outer);

class ChartOwnership {
 public:
  enum class Claim { Free, Taken, Partly };

  /// Returns the number of a new chart on a piece of b.
  int add_chart(const Box2& piece);

  /// The cell at work; cells are entered from parents to children.
  void enter(int cell) { path_.push_back(cell); }
  void leave() { path_.pop_back(); }

  /// Whether the cell at work, with foot points in a box, may be read in a chart.
  Claim claim_of(const Box2& foot, int chart) const;

  /// Something was found in the cell at work.
  void claim(int chart);

 private:
  bool meets(const Box2& foot, int chart) const;

  std::vector<Box2> pieces_;                   // of the charts so far
  std::vector<int> path_;                      // the cell at work and its ancestors
  std::map<int, std::vector<int>> claims_;     // charts, by cell of a
  std::map<int, std::set<int>> claims_below_;  // likewise, of cells inside it
};

}  // namespace blossom
