// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/convert/grown.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_SweptSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include "core/math/vec.h"

namespace blossom::occt {
namespace {

// A row of weighted control points, and its knots, each as often as it counts.
struct Row {
  std::size_t degree = 1;
  std::vector<double> knots;
  std::vector<Vec<double, 4>> points;
};

// The polar form of the last span, by de Boor's algorithm with one argument a step.
Vec<double, 4> polar(const Row& row, const std::vector<double>& arguments) {
  const std::size_t p = row.degree, first = row.points.size() - 1 - p;
  std::vector<Vec<double, 4>> d(row.points.end() - static_cast<std::ptrdiff_t>(p) - 1,
                                row.points.end());
  for (std::size_t r = 1; r <= p; ++r)
    for (std::size_t i = p; i >= r; --i) {
      const double low = row.knots[first + i], high = row.knots[first + i + p + 1 - r];
      const double share = (arguments[r - 1] - low) / (high - low);
      d[i] = (1 - share) * d[i - 1] + share * d[i];
    }
  return d[p];
}

// The row with its last knot moved: control points are polar values at the knots between theirs.
//
// Source: Ramshaw 1989, "Blossoms are polar forms".
void move_last_knot(Row& row, double to) {
  const Row old = row;
  const std::size_t p = row.degree, count = row.points.size();
  std::fill(row.knots.end() - static_cast<std::ptrdiff_t>(p) - 1, row.knots.end(), to);
  for (std::size_t i = count - p; i < count; ++i) {
    const auto from = row.knots.begin() + static_cast<std::ptrdiff_t>(i) + 1;
    row.points[i] = polar(old, {from, from + static_cast<std::ptrdiff_t>(p)});
  }
}

void turn(Row& row) {
  std::ranges::reverse(row.points);
  std::ranges::reverse(row.knots);
  for (double& knot : row.knots) knot = -knot;
}

void grow(Row& row, const Interval& to) {
  if (to.to > row.knots.back()) move_last_knot(row, to.to);
  if (to.from >= row.knots.front()) return;
  turn(row);
  move_last_knot(row, -to.from);
  turn(row);
}

Vec<double, 4> weighted(const gp_Pnt& p, double w) { return {w * p.X(), w * p.Y(), w * p.Z(), w}; }

gp_Pnt unweighted(const Vec<double, 4>& h) { return gp_Pnt(h[0] / h[3], h[1] / h[3], h[2] / h[3]); }

bool has_all(const Interval& own, const Interval& wanted) {
  return own.from <= wanted.from && own.to >= wanted.to;
}

Interval own_range(const Handle(Geom_Curve) & curve) {
  return {curve->FirstParameter(), curve->LastParameter()};
}

Handle(Geom_Curve) grown(const Handle(Geom_BSplineCurve) & of, const Interval& to) {
  Row row{static_cast<std::size_t>(of->Degree()),
          {of->KnotSequence().begin(), of->KnotSequence().end()},
          {}};
  for (int i = 1; i <= of->NbPoles(); ++i)
    row.points.push_back(weighted(of->Pole(i), of->Weight(i)));
  grow(row, to);
  TColgp_Array1OfPnt poles(1, of->NbPoles());
  TColStd_Array1OfReal weights(1, of->NbPoles());
  for (int i = 1; i <= of->NbPoles(); ++i) {
    const Vec<double, 4>& h = row.points[static_cast<std::size_t>(i) - 1];
    if (!(h[3] > 0)) return Handle(Geom_Curve)(of);
    poles(i) = unweighted(h);
    weights(i) = h[3];
  }
  TColStd_Array1OfReal knots = of->Knots();
  knots.ChangeFirst() = std::min(knots.First(), to.from);
  knots.ChangeLast() = std::max(knots.Last(), to.to);
  if (of->IsRational())
    return new Geom_BSplineCurve(poles, weights, knots, of->Multiplicities(), of->Degree());
  return new Geom_BSplineCurve(poles, knots, of->Multiplicities(), of->Degree());
}

// The same curve where it need not grow, or cannot.
Handle(Geom_Curve) grown(const Handle(Geom_Curve) & of, const Interval& to) {
  const Interval own = own_range(of);
  if (has_all(own, to) || of->IsClosed()) return of;
  if (const auto part = Handle(Geom_TrimmedCurve)::DownCast(of); !part.IsNull()) {
    const Interval wanted{std::min(own.from, to.from), std::max(own.to, to.to)};
    const Handle(Geom_Curve) whole = grown(part->BasisCurve(), wanted);
    if (whole->IsPeriodic() && length(wanted) >= whole->Period()) return of;
    if (!whole->IsPeriodic() && !has_all(own_range(whole), wanted)) return of;
    return new Geom_TrimmedCurve(whole, wanted.from, wanted.to, Standard_True, Standard_False);
  }
  if (const auto bezier = Handle(Geom_BezierCurve)::DownCast(of); !bezier.IsNull())
    return grown(GeomConvert::CurveToBSplineCurve(bezier), to);
  const auto spline = Handle(Geom_BSplineCurve)::DownCast(of);
  return spline.IsNull() ? of : grown(spline, to);
}

// Of the two directions only one has ends.
Handle(Geom_Surface) grown(const Handle(Geom_SweptSurface) & of, const Interval& to) {
  const Handle(Geom_Curve) curve = of->BasisCurve(), longer = grown(curve, to);
  if (longer == curve) return Handle(Geom_Surface)(of);
  if (const auto round = Handle(Geom_SurfaceOfRevolution)::DownCast(of); !round.IsNull())
    return new Geom_SurfaceOfRevolution(longer, round->Axis());
  return new Geom_SurfaceOfLinearExtrusion(longer, of->Direction());
}

std::vector<double> knots_along(const Handle(Geom_BSplineSurface) & of, bool in_u) {
  const TColStd_Array1OfReal& knots = in_u ? of->UKnotSequence() : of->VKnotSequence();
  return {knots.begin(), knots.end()};
}

// Over a larger range of u or v.
Handle(Geom_BSplineSurface)
    grown(const Handle(Geom_BSplineSurface) & of, bool in_u, const Interval& to) {
  const int along = in_u ? of->NbUPoles() : of->NbVPoles();
  const int across = in_u ? of->NbVPoles() : of->NbUPoles();
  TColgp_Array2OfPnt poles(1, of->NbUPoles(), 1, of->NbVPoles());
  TColStd_Array2OfReal weights(1, of->NbUPoles(), 1, of->NbVPoles());
  for (int k = 1; k <= across; ++k) {
    Row row{
        static_cast<std::size_t>(in_u ? of->UDegree() : of->VDegree()), knots_along(of, in_u), {}};
    for (int i = 1; i <= along; ++i) {
      const gp_Pnt p = in_u ? of->Pole(i, k) : of->Pole(k, i);
      const double w = in_u ? of->Weight(i, k) : of->Weight(k, i);
      row.points.push_back(weighted(p, w));
    }
    grow(row, to);
    for (int i = 1; i <= along; ++i) {
      const Vec<double, 4>& h = row.points[static_cast<std::size_t>(i) - 1];
      if (!(h[3] > 0)) return of;
      const int u = in_u ? i : k, v = in_u ? k : i;
      poles(u, v) = unweighted(h);
      weights(u, v) = h[3];
    }
  }
  TColStd_Array1OfReal u_knots = of->UKnots(), v_knots = of->VKnots();
  TColStd_Array1OfReal& knots = in_u ? u_knots : v_knots;
  knots.ChangeFirst() = std::min(knots.First(), to.from);
  knots.ChangeLast() = std::max(knots.Last(), to.to);
  const TColStd_Array1OfInteger u_counts = of->UMultiplicities(), v_counts = of->VMultiplicities();
  if (of->IsURational() || of->IsVRational())
    return new Geom_BSplineSurface(poles, weights, u_knots, v_knots, u_counts, v_counts,
                                   of->UDegree(), of->VDegree());
  return new Geom_BSplineSurface(poles, u_knots, v_knots, u_counts, v_counts, of->UDegree(),
                                 of->VDegree());
}

}  // namespace

Handle(Geom_Surface) grown(const Handle(Geom_Surface) & surface, const ParameterBox& to) {
  const Handle(Geom_Surface) of = basis_of(surface);
  ParameterBox own;
  of->Bounds(own.u.from, own.u.to, own.v.from, own.v.to);
  const bool in_u = !of->IsUClosed() && !has_all(own.u, to.u);
  const bool in_v = !of->IsVClosed() && !has_all(own.v, to.v);
  if (!in_u && !in_v) return of;
  if (const auto swept = Handle(Geom_SweptSurface)::DownCast(of); !swept.IsNull())
    return grown(swept, in_v ? to.v : to.u);
  if (const auto offset = Handle(Geom_OffsetSurface)::DownCast(of); !offset.IsNull()) {
    const Handle(Geom_Surface) basis = grown(offset->BasisSurface(), to);
    if (basis == basis_of(offset->BasisSurface())) return of;
    return new Geom_OffsetSurface(basis, offset->Offset(), Standard_True);
  }
  Handle(Geom_BSplineSurface) spline = Handle(Geom_BSplineSurface)::DownCast(of);
  if (const auto bezier = Handle(Geom_BezierSurface)::DownCast(of); !bezier.IsNull())
    spline = GeomConvert::SurfaceToBSplineSurface(bezier);
  if (spline.IsNull()) return of;
  if (in_u) spline = grown(spline, true, to.u);
  if (in_v) spline = grown(spline, false, to.v);
  return spline;
}

}  // namespace blossom::occt
