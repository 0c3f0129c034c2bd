// SPDX-License-Identifier: LGPL-2.1-or-later
// A point inside of a trimmed face.

#pragma once

#include <optional>

#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>

namespace blossom::occt {

/// A point inside of a face; none if Open CASCADE finds none.
std::optional<gp_Pnt> point_inside(const TopoDS_Face& face);

}  // namespace blossom::occt
