// SPDX-License-Identifier: LGPL-2.1-or-later
// Parameters of borders and of their edges that go together.

#pragma once

#include <cstddef>
#include <map>
#include <utility>

#include "core/watertight/watertight_pieces.h"

namespace blossom {

/// Each parameter is asked for once, so that the way there and back ends where it began, bit for
/// bit, though the functions undo each other to rounding only. Of parameters of an edge within
/// kShortestArc the one asked for last goes with the border's.
class PairedParameters {
 public:
  /// model   outlives this
  explicit PairedParameters(const CommonModel& model) : model_(model) {}

  double on_edge(std::size_t face, std::size_t border, double parameter);
  double on_border(std::size_t face, std::size_t border, double parameter);

 private:
  struct Known {
    std::map<double, double> on_edge, on_border;
  };

  bool is_same(std::size_t face, std::size_t border) const;

  const CommonModel& model_;
  std::map<std::pair<std::size_t, std::size_t>, Known> known_;  // by face and border
};

}  // namespace blossom
