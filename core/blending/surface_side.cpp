// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/surface_side.h"

namespace blossom {

const char* to_string(SurfaceSide side) {
  switch (side) {
    case SurfaceSide::UMin: return "umin";
    case SurfaceSide::UMax: return "umax";
    case SurfaceSide::VMin: return "vmin";
    case SurfaceSide::VMax: break;
  }
  return "vmax";
}

}  // namespace blossom
