// SPDX-License-Identifier: LGPL-2.1-or-later
// The four borders of a surface.

#pragma once

namespace blossom {

/// A border of a surface, by the parameter that is constant along it.
enum class SurfaceSide { UMin, UMax, VMin, VMax };

/// "umin", "umax", "vmin" or "vmax".
const char* to_string(SurfaceSide side);

}  // namespace blossom
