// SPDX-License-Identifier: LGPL-2.1-or-later
// A point inside of a trimmed face.

#pragma once

#include <optional>

#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>

namespace blossom::occt {

/// A point inside of a face, away from its wires (core/topology/inner_point.h); none of a face with
/// open wires, or without a width that numbers can tell.
std::optional<gp_Pnt> point_inside(const TopoDS_Face& face);

}  // namespace blossom::occt
