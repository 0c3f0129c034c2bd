// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/queries/least_box.h"

#include <algorithm>
#include <utility>

#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/distance.h"
#include "core/math/grid.h"

namespace blossom::occt {
namespace {

// Of the size of a box: how far beyond it planes are. Near ones lose fewer digits.
constexpr double kBeyond = 1e-3;
constexpr double kPrecision = 1e-7;  // model units, what is Open CASCADE's confusion
// Of cells, for a side: where a shape comes as far all along a curve, the last digits take a time
// that nobody wants to wait; the box says how precise it is.
constexpr long kMaxPairs = 20'000;

// A box that is not the least, but holds all of the shape, and more.
Box some_box(const TopoDS_Shape& shape) {
  Bnd_Box found;
  BRepBndLib::Add(shape, found, Standard_False);
  if (found.IsVoid() || found.IsOpen()) throw BadModel("the shape has no end, or nothing in it");
  Box box;
  found.Get(box.low[0], box.low[1], box.low[2], box.high[0], box.high[1], box.high[2]);
  const double beyond = kBeyond * std::max(1.0, max_norm(box.high - box.low));
  return {box.low - Vec3{beyond, beyond, beyond}, box.high + Vec3{beyond, beyond, beyond}};
}

// A square through a point across an axis, that goes beyond the box in the other directions.
PreparedSet wall(const Box& box, int axis, double at) {
  const double size = max_norm(box.high - box.low);
  BezierSurface square{.u_knots = {0, 1}, .v_knots = {0, 1}};
  square.patches = Grid<RationalBezierPatch>(1, 1);
  Grid<Vec4>& corners = square.patches(0, 0).points;
  corners = Grid<Vec4>(2, 2);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      Vec3 corner = 0.5 * (box.low + box.high);
      corner[axis] = at;
      corner[(axis + 1) % 3] += (2 * i - 1) * size;
      corner[(axis + 2) % 3] += (2 * j - 1) * size;
      corners(i, j) = {corner[0], corner[1], corner[2], 1};
    }
  return PreparedSet(measured(square));
}

}  // namespace

LeastBox least_box(const TopoDS_Shape& shape, const std::function<bool()>& cancelled) {
  const MeasuredShape parts(shape);
  const Box around = some_box(shape);
  LeastBox least{around, 0};
  for (int axis = 0; axis < 3; ++axis)
    for (const auto& [side, at] : {std::pair{&least.box.low, around.low[axis]},
                                   std::pair{&least.box.high, around.high[axis]}}) {
      const DistanceResult found =
          least_distance(parts.set(), wall(around, axis, at),
                         {.budget = kMaxPairs, .cancelled = cancelled, .resolution = kPrecision});
      (*side)[axis] = found.a.point[axis];
      least.precision = std::max(least.precision, found.upper - found.lower);
    }
  least.precision += parts.error();
  return least;
}

}  // namespace blossom::occt
