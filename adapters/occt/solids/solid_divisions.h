// SPDX-License-Identifier: LGPL-2.1-or-later
// At which tolerances, and how, two solids are divided: the next way where one leads to nothing.

#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/intersection.h"
#include "adapters/occt/solids/solid_pieces.h"

namespace blossom::occt {

/// The ways in which two solids are divided, one after the other.
///
/// What is one is decided at one tolerance. There are three looks at the faces:
///
///   (0) at what the inputs state, or what is asked for if that is more
///   (1) at another tolerance, which is told: what is asked for if they state more, since what one
///       of them states may be more than others are large; else the scale of the gaps between the
///       solids (contact_scale.h)
///   (2) at that, with surfaces that end with the trims: borders that end in the same place are
///       easier to tell apart than what goes on beyond them
///
/// Each is read in two ways: edges lie where faces that meet say so, or wherever they are near
/// (common_edges.h). What leads to obstacles is followed by the next reading.
class SolidDivisions {
 public:
  /// stated          what the inputs state besides their faces; 0: nothing. Model units
  /// a, b, options   are kept by reference
  SolidDivisions(const TrimTool& a, const TrimTool& b, double stated,
                 const IntersectionOptions& options);

  /// What the next reading leads to; nothing if there is none, or if the limit is reached after the
  /// first one.
  /// throws   BadModel if a face cannot be converted
  std::optional<SolidPieces> next();

  /// What the first look at the faces has found; null before `next`.
  const ShapeIntersection* first_look() const { return looks_[0] ? &looks_[0]->faces : nullptr; }

 private:
  struct Look {
    double tolerance = 0;
    ShapeIntersection faces;
  };

  IntersectionOptions left(double tolerance) const;
  double other_tolerance();
  const Look* look(std::size_t number);  // null: there is none
  void tell_tolerance(double tolerance, SolidPieces& pieces) const;

  const TrimTool& a_;
  const TrimTool& b_;
  const IntersectionOptions& options_;
  const SharedLimit limit_{options_};
  std::size_t readings_ = 0;
  double stated_;  // or asked for
  std::optional<double> other_;
  std::array<std::optional<Look>, 3> looks_;
};

}  // namespace blossom::occt
