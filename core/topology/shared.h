// SPDX-License-Identifier: LGPL-2.1-or-later
// What two faces of a model have in common by their construction: a part of their intersection that
// needs no search.

#pragma once

#include "core/math/vec.h"
#include "core/results/result.h"

namespace blossom {

struct SharedEdge {
  int in_a = -1;  ///< its number in either face's trims; -1: it is in no loop there
  int in_b = -1;
  IntersectionCurve curve;  ///< its parameter is the edge's own; deviations are those of samples
  double tolerance = 0;     ///< of the edge, model units
  double gap = 0;           ///< largest distance of edge and faces at the samples, model units
  double most_sine = 0;     ///< of the angle between the faces along it
};

struct SharedVertex {
  int in_a = -1;  ///< its number in either face's trims; -1: it is of no edge there
  int in_b = -1;
  Vec3 point;
  double tolerance = 0;  ///< model units
};

}  // namespace blossom
