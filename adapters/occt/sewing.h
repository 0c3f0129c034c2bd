// SPDX-License-Identifier: LGPL-2.1-or-later
// What became of the loose faces of a model.

#pragma once

#include <string>
#include <vector>

#include "core/math/vec.h"

namespace blossom::occt {

/// Which faces of a model that bound no closed solid are sewn.
enum class Sewable {
  All,
  /// Not those of shells that are closed, nor faces that close alone: they are sheets, unless
  /// others of the model are, or become, solids.
  Open,
};

/// Loose faces are those that bound no closed solid. Lengths in model units.
struct Sewing {
  int loose = 0;            ///< faces that bounded no closed solid
  std::vector<int> solids;  ///< of each solid that they became, how many faces it has
  double gap = 0;           ///< the widest between borders that were joined, as measured
  double within = 0;        ///< within how much borders were joined

  /// Of the faces that stay loose, where some borders met and others did not: the edges that no
  /// other border is near to, and the middle of the first. None if nothing is nearly closed.
  int open_edges = 0;
  Vec3 open_at;

  /// Why faces stay loose that Open CASCADE fails to sew, whether or not they close; empty if it
  /// does not fail.
  std::string failed;

  bool renumbered = false;  ///< faces of several solids took turns: they have new numbers

  /// Faces that are in solids now.
  int sewn() const {
    int count = 0;
    for (const int faces : solids) count += faces;
    return count;
  }
};

}  // namespace blossom::occt
