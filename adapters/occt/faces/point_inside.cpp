// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/point_inside.h"

#include <BRep_Tool.hxx>
#include <Geom_Surface.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/faces/face_trims.h"
#include "core/topology/inner_point.h"

namespace blossom::occt {

std::optional<gp_Pnt> point_inside(const TopoDS_Face& face) try {
  const FaceTrims trims = face_trims(face);
  const std::optional<Vec2> inner = inner_point(trims);
  if (!inner) return std::nullopt;
  return BRep_Tool::Surface(face)->Value((*inner)[0] / trims.scale[0],
                                         (*inner)[1] / trims.scale[1]);
} catch (const BadModel&) {  // nothing bounds it
  return std::nullopt;
}

}  // namespace blossom::occt
