// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/point_inside.h"

#include <BOPTools_AlgoTools3D.hxx>
#include <IntTools_Context.hxx>
#include <gp_Pnt2d.hxx>

namespace blossom::occt {

std::optional<gp_Pnt> point_inside(const TopoDS_Face& face) {
  gp_Pnt point;
  gp_Pnt2d uv;
  const Handle(IntTools_Context) context = new IntTools_Context;
  if (BOPTools_AlgoTools3D::PointInFace(face, point, uv, context) != 0) return std::nullopt;
  return point;
}

}  // namespace blossom::occt
