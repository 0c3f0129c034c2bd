// SPDX-License-Identifier: LGPL-2.1-or-later
// A point inside of a trimmed chart, away from its wires.

#pragma once

#include <optional>

#include "core/topology/face_trims.h"

namespace blossom {

/// The best of some points about half way between wires: of a line along the first chart coordinate
/// the widest stretch inside, and then the stretch across it.
///
/// returns   chart coordinates; nothing of a face without a stretch that numbers can tell
/// cost      of some lines, mostly three and as many across: for each span that one meets some
/// boxes, as
///           many as halvings tell where; of faces too thin for the width of double numbers some
///           hundred lines
std::optional<Vec2> inner_point(const FaceTrims& trims);

}  // namespace blossom
