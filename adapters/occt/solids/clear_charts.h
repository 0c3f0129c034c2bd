// SPDX-License-Identifier: LGPL-2.1-or-later
// Whole spheres and tori turned so that their poles and seams keep clear of what they are combined
// with.

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

/// Turns whole spheres about their centre, and moves the seams of whole tori along their charts,
/// where a seam lies ill for another solid.
///
/// The face stays where it is as a set of points. Its seams, the ends of these and the poles are
/// those of a chart that anyone may choose. As people put solids, curves of intersection often go
/// through a pole, where the chart has no longitude, or touch a seam. In a chart that is turned
/// they are as regular as elsewhere. With f the distance of a point from a surface, with a sign, s
/// the length along the seam and r the face's largest distance from its axis,
///
///   ends are clear          where |f| >= c r
///   and so is the seam      where |f| >= c r or |df/ds| >= c      (it crosses, if it meets)
///                           and no edge of the other solid goes through the face within c r
///
/// for all planes, cylinders, cones, spheres and tori of the other solid near it. So no two seams
/// cross a curve of intersection side by side either. What the seam of a torus about its axis
/// follows all round as it is, as a plane that cuts a ring in half, is no reason to move it: there
/// the seam is a border. A turn that is more clear than none is taken; of several, the first one of
/// a fixed list in the face's own frame, so that where the solids lie changes nothing.
///
/// returns   the same faces in the same order, with their tolerances
ClearCharts clear_charts(const TrimTool& solid, const TrimTool& other);

/// What nothing has divided becomes what it was again, in solids and in the list of faces.
void turn_back(const ClearCharts& charts, SolidTrimResult& result);

}  // namespace blossom::occt
