// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/convert/curve_breaks.h"

#include <algorithm>
#include <cmath>

#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColStd_Array1OfReal.hxx>

#include "adapters/occt/convert/curves.h"

namespace blossom::occt {
namespace {

void add_inside(double value, const Interval& range, std::vector<double>& breaks) {
  if (value > range.from && value < range.to) breaks.push_back(value);
}

template <class Spline>
void add_knots(const Spline& curve, const Interval& range, std::vector<double>& breaks) {
  const double period = curve.IsPeriodic() ? curve.Period() : 0;
  const int last = curve.LastUKnotIndex() - (period > 0 ? 1 : 0);  // the first one again
  for (int i = curve.FirstUKnotIndex(); i <= last; ++i) {
    const double knot = curve.Knot(i);
    if (period == 0) {
      add_inside(knot, range, breaks);
      continue;
    }
    const double first = knot + period * std::ceil((range.from - knot) / period);
    for (int turn = 0; first + turn * period < range.to; ++turn)
      add_inside(first + turn * period, range, breaks);
  }
}

template <class Adaptor>
void add_intervals(const Adaptor& curve, const Interval& range, std::vector<double>& breaks) {
  TColStd_Array1OfReal ends(1, curve.NbIntervals(GeomAbs_CN) + 1);
  curve.Intervals(ends, GeomAbs_CN);
  for (const double end : ends) add_inside(end, range, breaks);
}

template <class Spline, class Adaptor, class Curve>
std::vector<double> breaks(const Curve& curve, const Interval& range) {
  std::vector<double> found;
  if (const auto spline = Spline::DownCast(basis_of(curve)); !spline.IsNull())
    add_knots(*spline, range, found);
  else
    add_intervals(Adaptor(curve, range.from, range.to), range, found);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace

std::vector<double> breaks_of(const Handle(Geom_Curve) & curve, const Interval& range) {
  return breaks<Handle(Geom_BSplineCurve), GeomAdaptor_Curve>(curve, range);
}

std::vector<double> breaks_of(const Handle(Geom2d_Curve) & curve, const Interval& range) {
  return breaks<Handle(Geom2d_BSplineCurve), Geom2dAdaptor_Curve>(curve, range);
}

}  // namespace blossom::occt
