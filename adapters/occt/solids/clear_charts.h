// SPDX-License-Identifier: LGPL-2.1-or-later
// Charts of spheres, tori and faces that go round an axis, moved so that their poles and seams keep
// clear of what they are combined with.

#pragma once

#include <utility>
#include <vector>

#include <TopoDS_Face.hxx>

#include "adapters/occt/solid_trim.h"
#include "adapters/occt/trim_tool.h"

namespace blossom::occt {

/// A solid, and which of its faces are not as they were given: as they are, as they were.
struct ClearCharts {
  TrimTool solid;
  std::vector<std::pair<TopoDS_Face, TopoDS_Face>> turned;
};

/// Moves charts (free_charts.h) in which a seam lies ill for another solid.
///
/// The faces stay where they are as sets of points. Their seams, the ends of these and the poles
/// are those of a chart that anyone may choose. As people put solids, curves of intersection often
/// go through a pole, where the chart has no longitude, or touch a seam. In a chart that is turned
/// they are as regular as elsewhere. With f the distance of a point from a surface, with a sign, s
/// the length along the seam and r the chart's largest distance from its axis,
///
///   an end is clear       where |f| >= c r
///   and so is the seam    where |f| >= c r or |df/ds| >= c      (it crosses, if it meets)
///                         and no edge of the other solid goes through the face within c r
///
/// for all planes, cylinders, cones, spheres and tori of the other solid near it. So no two seams
/// cross a curve of intersection side by side either. What a seam lies in and crosses, as a plane
/// through the axis, is no reason to move it: there it is a border.
///
/// A chart is moved where that leaves fewer faces near ends, or as few there and fewer things near
/// the rest; of such moves the first best one of a fixed list in the chart's own frame, so that
/// where the solids lie changes nothing.
///
/// returns   the same faces in the same order, with their tolerances
ClearCharts clear_charts(const TrimTool& solid, const TrimTool& other);

/// What nothing has divided becomes what it was again, in solids and in the list of faces.
void turn_back(const ClearCharts& charts, SolidTrimResult& result);

}  // namespace blossom::occt
