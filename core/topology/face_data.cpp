// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/topology/face_data.h"

namespace blossom {

Box box_of(const BezierSurface& surface, double margin) {
  Box box;
  for (const RationalBezierPatch& patch : surface.patches.values())
    for (const Vec4& p : patch.points.values()) {
      const Vec3 x = projected(p);
      box = joined(box, {x, x});
    }
  const Vec3 r{margin, margin, margin};
  return {box.low - r, box.high + r};
}

PartTest part_test(const FaceTrims& trims) {
  if (trims.natural) return {};
  return [&trims](const Interval& u, const Interval& v) { return part_side(trims, u, v); };
}

}  // namespace blossom
