// SPDX-License-Identifier: LGPL-2.1-or-later
// Points, directions and planes as words of the command line.

#pragma once

#include <string>

#include "adapters/occt/plane_section.h"
#include "core/math/vec.h"
#include "plugin/reports/text/vectors.h"

namespace blossom::cli {

/// Three numbers, as in "1,-2.5,3e2".
/// what     names the option in the message
/// throws   UsageError unless there are three finite numbers
Vec3 parse_vector(const std::string& text, const std::string& what);

/// Six numbers, point and normal, as in "0,0,5,0,0,1"; the normal becomes a unit vector.
/// throws   UsageError unless there are six finite numbers and the normal is not zero
occt::Plane parse_plane(const std::string& text, const std::string& what);

using reports::vector_text;
using reports::without_roundings;

}  // namespace blossom::cli
