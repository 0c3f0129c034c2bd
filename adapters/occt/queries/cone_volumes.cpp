// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/queries/cone_volumes.h"

#include <TopoDS.hxx>

#include "adapters/occt/faces/area.h"

namespace blossom::occt {

double ConeVolumes::of(const TopoDS_Face& face) {
  const double* known = forward_.Seek(face);
  if (known == nullptr)
    known = forward_.Bound(face, cone_volume(TopoDS::Face(face.Oriented(TopAbs_FORWARD)), apex_));
  return face.Orientation() == TopAbs_REVERSED ? -*known : *known;
}

}  // namespace blossom::occt
