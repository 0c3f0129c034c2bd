// SPDX-License-Identifier: LGPL-2.1-or-later
// The volumes under faces, each measured once: results have the faces of their inputs.

#pragma once

#include <NCollection_DataMap.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS_Face.hxx>

#include "core/math/vec.h"

namespace blossom::occt {

class ConeVolumes {
 public:
  /// apex   of all cones
  explicit ConeVolumes(const Vec3& apex) : apex_(apex) {}

  /// As `cone_volume` (adapters/occt/faces/area.h); of a face turned round since, the negative.
  /// throws   BadModel as that
  double of(const TopoDS_Face& face);

  bool knows(const TopoDS_Face& face) const { return forward_.IsBound(face); }

  const Vec3& apex() const { return apex_; }

 private:
  Vec3 apex_;
  NCollection_DataMap<TopoDS_Shape, double, TopTools_ShapeMapHasher> forward_;  // by face
};

}  // namespace blossom::occt
