// SPDX-License-Identifier: LGPL-2.1-or-later
// A face made ready to be intersected.

#pragma once

#include <optional>

#include "core/bounds/box_tree.h"
#include "core/curves/swept_profile.h"
#include "core/forms/elementary.h"
#include "core/forms/surface.h"
#include "core/results/options.h"
#include "core/topology/face_trims.h"

namespace blossom {

struct FaceData {
  BezierSurface surface;
  FaceTrims trims;
  Box box;                                 ///< of the surface, its error and the tolerance included
  std::optional<Elementary> elementary{};  ///< what the surface is part of, if it is that
  double off_elementary = 0;               ///< bound on its distance from that; model units
  std::optional<SweptProfile> swept{};     ///< likewise; elementary ones are none
};

/// Holds all of a surface; `margin` wider on every side.
Box box_of(const BezierSurface& surface, double margin);

/// Which part of the face's surface counts; empty for a naturally bounded one. Keeps a reference.
PartTest part_test(const FaceTrims& trims);

}  // namespace blossom
