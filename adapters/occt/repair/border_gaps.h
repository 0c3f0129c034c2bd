// SPDX-License-Identifier: LGPL-2.1-or-later
// How far the borders of faces that share no edges are apart.

#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include <TopoDS_Face.hxx>

#include "core/math/vec.h"

namespace blossom::occt {

/// An edge that one face uses, once.
struct LooseBorder {
  Vec3 middle;
  std::optional<double> gap;  ///< to the borders along it, model units; none within the bound
};

struct BorderGaps {
  std::vector<LooseBorder> borders;
  double widest = 0;     ///< of all gaps, model units
  double tolerance = 0;  ///< the largest of a border, model units
  /// Places of faces that hang together, over edges or across gaps. Bodies that touch are apart as
  /// far as the faces of each follow each other.
  std::vector<std::vector<std::size_t>> bodies;

  std::size_t open() const;
};

/// The borders of faces, and how far each is from the nearest other ones, at five places of it.
///
/// within   the widest gap that is one. Without it a hundredth of the shortest border, since a gap
///          so much smaller than all that a model shows is none of its features (a choice), or
///          twice the largest tolerance of a border if that is more: readers put the resolution
///          that a file states there. Borders shorter than that are no measure.
/// stop     asked often; ends the work by an exception
BorderGaps border_gaps(const std::vector<TopoDS_Face>& faces, std::optional<double> within,
                       const std::function<void()>& stop);

}  // namespace blossom::occt
