// SPDX-License-Identifier: LGPL-2.1-or-later
// The parameter box of a face.

#include <algorithm>
#include <cmath>
#include <vector>

#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/curves_detail.h"
#include "adapters/occt/convert/pcurves.h"
#include "adapters/occt/convert/surfaces_detail.h"

namespace blossom::occt {
namespace {

/// A face's border this near to the surface's own, relative to the range, is meant to be there.
constexpr double kBorderSnap = 1e-9;

/// The same for knots in the range's inside, where moving inwards cuts off a piece of the face.
constexpr double kKnotSnap = 1e-10;

/// One direction of a surface: its natural ends, its period and the knots between.
struct Direction {
  Interval natural;
  double period = 0;
  std::vector<double> knots;
};

Direction direction_of(const Geom_Surface& surface, bool u) {
  Direction direction;
  double bounds[4];
  surface.Bounds(bounds[0], bounds[1], bounds[2], bounds[3]);
  direction.natural = u ? Interval{bounds[0], bounds[1]} : Interval{bounds[2], bounds[3]};
  if (u ? surface.IsUPeriodic() : surface.IsVPeriodic())
    direction.period = u ? surface.UPeriod() : surface.VPeriod();
  if (const auto* spline = dynamic_cast<const Geom_BSplineSurface*>(&surface))
    for (int i = 1; i <= (u ? spline->NbUKnots() : spline->NbVKnots()); ++i)
      direction.knots.push_back(u ? spline->UKnot(i) : spline->VKnot(i));
  return direction;
}

double snapped(double value, double target, double reach) {
  return std::abs(value - target) <= reach ? target : value;
}

Interval fitted(Interval range, const Direction& direction) {
  const double size = length(range);
  if (direction.period > 0) {
    // Whole turns begin and end exactly; ends in a turn's seam are snapped to it.
    const double turn = std::round((range.from - direction.natural.from) / direction.period);
    range.from = snapped(range.from, direction.natural.from + turn * direction.period,
                         kBorderSnap * direction.period);
    if (length(range) > (1 - kBorderSnap) * direction.period)
      range.to = range.from + direction.period;
    const double end = std::round((range.to - direction.natural.from) / direction.period);
    range.to = snapped(range.to, direction.natural.from + end * direction.period,
                       kBorderSnap * direction.period);
  } else {
    range.from = std::max(range.from, direction.natural.from);
    range.to = std::min(range.to, direction.natural.to);
    range.from = snapped(range.from, direction.natural.from, kBorderSnap * size);
    range.to = snapped(range.to, direction.natural.to, kBorderSnap * size);
  }
  for (const double knot : direction.knots) {
    range.from = snapped(range.from, knot, kKnotSnap * size);
    range.to = snapped(range.to, knot, kKnotSnap * size);
  }
  return range;
}

// Open CASCADE leaves out what of a periodic spline lies beyond its first period.
void add_periodic_splines(const TopoDS_Face& face, ParameterBox& box) {
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    Interval range;
    const Handle(Geom2d_Curve) curve =
        BRep_Tool::CurveOnSurface(TopoDS::Edge(it.Current()), face, range.from, range.to);
    if (!is_periodic_spline(curve)) continue;
    const auto [u, v] = bounds_of(curve, range);
    box.u = {std::min(box.u.from, u.from), std::max(box.u.to, u.to)};
    box.v = {std::min(box.v.from, v.from), std::max(box.v.to, v.to)};
  }
}

}  // namespace

ParameterBox parameter_box(const TopoDS_Face& face) {
  if (face.IsNull()) throw BadModel("there is no face");
  return guarded("measuring a face", [&] {
    ParameterBox box;
    // Where the face is placed does not matter, but chains of placements take most of the time.
    const TopoDS_Face unplaced = TopoDS::Face(face.Located(TopLoc_Location()));
    if (!BRep_Tool::Surface(unplaced).IsNull()) {
      BRepTools::UVBounds(unplaced, box.u.from, box.u.to, box.v.from, box.v.to);
      add_periodic_splines(unplaced, box);
    }
    return parameter_box(face, box);
  });
}

ParameterBox parameter_box(const TopoDS_Face& face, const ParameterBox& of_wires) {
  if (face.IsNull()) throw BadModel("there is no face");
  TopLoc_Location location;
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face, location);
  if (surface.IsNull()) throw BadModel("the face has no surface");
  return guarded("measuring a face", [&] {
    const Handle(Geom_Surface) basis = basis_of(surface);
    const ParameterBox box{fitted(of_wires.u, direction_of(*basis, true)),
                           fitted(of_wires.v, direction_of(*basis, false))};
    const Interval endless{-1e100, 1e100};
    checked_range(box.u, endless, "the face's parameter box in u");
    checked_range(box.v, endless, "the face's parameter box in v");
    return box;
  });
}

}  // namespace blossom::occt
