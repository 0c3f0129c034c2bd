// SPDX-License-Identifier: LGPL-2.1-or-later
// What is known of the arc of a certified pair over parts of its parameter.

#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "core/cells/cell_pair.h"
#include "core/cells/pair_model.h"

namespace blossom {

/// A part of the arc's parameter, and all that may be of the arc over it.
struct ArcStretch {
  bool empty = false;
  PairPart part;
  std::optional<JacobianBounds> bounds;  ///< of J over the part; nothing if it is empty
};

/// Stretch 1 is all of the arc, and that of number i has the halves 2 i and 2 i + 1. Each is made
/// when first asked for: over a stretch J is known better than over the whole pair, and so the arc.
class ArcStretches {
 public:
  static constexpr std::size_t kCount = 16;  ///< twice as many as the shortest ones

  /// along   the arc's parameter
  /// The model is used as long as this object is.
  ArcStretches(const PairModel& model, int along) : model_(model), along_(along) {}

  const ArcStretch& stretch(std::size_t number);

  /// Narrows a stretch once more, from its new middle. False if that does not get on.
  bool narrow_again(std::size_t number);

 private:
  void narrow_stretch(ArcStretch& s) const;

  const PairModel& model_;
  const int along_;
  std::array<std::optional<ArcStretch>, kCount> made_;
};

}  // namespace blossom
