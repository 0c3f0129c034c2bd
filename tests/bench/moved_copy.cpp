// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/bench/moved_copy.h"

#include <numbers>

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <Bnd_Box.hxx>
#include <gp_Ax1.hxx>
#include <gp_Trsf.hxx>

namespace blossom::bench {

Sized sized_by_box(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::AddOptimal(shape, box, false, false);
  double low[3], high[3];
  box.Get(low[0], low[1], low[2], high[0], high[1], high[2]);
  const Vec3 a{low[0], low[1], low[2]}, b{high[0], high[1], high[2]};
  return {0.5 * (a + b), distance(a, b)};
}

TopoDS_Shape moved_copy(const TopoDS_Shape& shape, double degrees, double part, const Vec3& axis) {
  const auto [middle, size] = sized_by_box(shape);
  gp_Trsf turn, move;
  turn.SetRotation(
      gp_Ax1(gp_Pnt(middle[0], middle[1], middle[2]), gp_Dir(axis[0], axis[1], axis[2])),
      degrees * std::numbers::pi / 180);
  const double step = part * size;
  move.SetTranslation(gp_Vec(0.48 * step, 0.6 * step, 0.64 * step));
  return BRepBuilderAPI_Transform(shape, move * turn, true).Shape();
}

}  // namespace blossom::bench
