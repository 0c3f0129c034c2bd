// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids on a small lattice, so that they touch in faces, edges and corners, or nearly so.

#pragma once

#include <TopoDS_Shape.hxx>

#include "tests/fuzz/support/choices.h"

namespace blossom::fuzz {

/// A box, cylinder, cone, sphere, torus or wedge, moved and turned.
/// throws   InvalidInput if Open CASCADE makes none
TopoDS_Shape solid_of(Choices& choices);

}  // namespace blossom::fuzz
