// SPDX-License-Identifier: LGPL-2.1-or-later
// Homogeneous points (wx, wy, wz, w) by their parts.

#pragma once

#include "core/math/vec.h"

namespace blossom {

inline Vec4 with_weight(const Vec3& head, double weight) {
  return {head[0], head[1], head[2], weight};
}

}  // namespace blossom
