// SPDX-License-Identifier: LGPL-2.1-or-later
// How far the borders of faces that share no edges are apart.

#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "core/math/vec.h"

namespace blossom::occt {

/// An edge that one face uses, once.
struct LooseBorder {
  TopoDS_Edge edge;
  Vec3 middle;
  std::optional<double> gap;  ///< to the borders along it, model units; none within the bound
};

/// Faces that hang together, over edges or across gaps.
struct LooseBody {
  std::vector<std::size_t> faces;  ///< their places, increasing
  double widest = 0;               ///< of its gaps, model units
};

struct BorderGaps {
  std::vector<LooseBorder> borders;
  /// Those that touch are apart as far as the faces of each follow each other.
  std::vector<LooseBody> bodies;

  std::size_t open() const;
};

/// Within how much borders are one that were measured to be so far apart: samples are lower bounds.
double joined_within(double gap);

/// The borders of faces, and how far each is from the nearest other ones, at places along it.
///
/// within   the widest gap that is one. Without it the tolerances of both edges, since readers put
///          the resolution that a file states there; or a hundredth of the shortest border if that
///          is more: a gap so much smaller than all that a model shows is none of its features (a
///          choice). Borders no longer than their tolerance are no measure.
/// stop     asked often; ends the work by an exception
BorderGaps border_gaps(const std::vector<TopoDS_Face>& faces, std::optional<double> within,
                       const std::function<void()>& stop);

}  // namespace blossom::occt
