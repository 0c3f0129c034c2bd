// SPDX-License-Identifier: LGPL-2.1-or-later
// Bezier and B-spline surfaces, there and back.

#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/curves_detail.h"
#include "adapters/occt/convert/surfaces_detail.h"

namespace blossom::occt {
namespace {

template <class Surface>
Grid<Vec4> homogeneous_net(const Surface& surface) {
  const bool rational = surface.IsURational() || surface.IsVRational();
  Grid<Vec4> net(surface.NbUPoles(), surface.NbVPoles());
  for (int i = 0; i < net.rows(); ++i)
    for (int j = 0; j < net.columns(); ++j)
      net(i, j) =
          homogeneous(surface.Pole(i + 1, j + 1), rational ? surface.Weight(i + 1, j + 1) : 1.0);
  return net;
}

BezierSurface patches_of(const FlatKnots& u, const FlatKnots& v, const Grid<Vec4>& net,
                         const ParameterBox& box) {
  return spline_patches(u, spans_in(u, box.u), v, spans_in(v, box.v), net);
}

/// Control points and weights of a net as Open CASCADE takes them.
struct Net {
  TColgp_Array2OfPnt poles;
  TColStd_Array2OfReal weights;
  bool rational = false;

  Net(int rows, int columns) : poles(1, rows, 1, columns), weights(1, rows, 1, columns) {}

  void set(int i, int j, const Vec4& point) {
    poles(i, j) = euclidean(point);
    weights(i, j) = point[3];
    rational = rational || point[3] != 1;
  }
};

TColStd_Array1OfInteger full_multiplicities(const std::vector<double>& knots, int degree) {
  TColStd_Array1OfInteger array(1, static_cast<int>(knots.size()));
  array.Init(degree);
  array(array.Lower()) = array(array.Upper()) = degree + 1;
  return array;
}

}  // namespace

RationalBezierPatch from_occt(const Geom_BezierSurface& surface) {
  check_numbers(surface);
  return {homogeneous_net(surface)};
}

Handle(Geom_BezierSurface) to_occt(const RationalBezierPatch& patch) {
  Net net(patch.points.rows(), patch.points.columns());
  for (int i = 0; i < patch.points.rows(); ++i)
    for (int j = 0; j < patch.points.columns(); ++j) net.set(i + 1, j + 1, patch.points(i, j));
  return guarded("making a Bezier surface", [&]() -> Handle(Geom_BezierSurface) {
    if (net.rational) return new Geom_BezierSurface(net.poles, net.weights);
    return new Geom_BezierSurface(net.poles);
  });
}

BezierSurface spline_patches(const Geom_BezierSurface& surface, const ParameterBox& box) {
  return patches_of(FlatKnots(surface.UDegree()), FlatKnots(surface.VDegree()),
                    homogeneous_net(surface), box);
}

BezierSurface spline_patches(const Geom_BSplineSurface& surface, const ParameterBox& box) {
  const FlatKnots u = flat_knots(surface.UDegree(), surface.UKnots(), surface.UMultiplicities(),
                                 surface.IsUPeriodic());
  const FlatKnots v = flat_knots(surface.VDegree(), surface.VKnots(), surface.VMultiplicities(),
                                 surface.IsVPeriodic());
  return patches_of(u, v, homogeneous_net(surface), box);
}

Handle(Geom_BSplineSurface) to_occt(const BezierSurface& surface) {
  validate(surface, "to_occt");
  const int n = surface.patches(0, 0).degree_u(), m = surface.patches(0, 0).degree_v();
  const int rows = surface.patches.rows(), columns = surface.patches.columns();
  Net net(n * rows + 1, m * columns + 1);
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c)
      for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= m; ++j)
          net.set(n * r + i + 1, m * c + j + 1, surface.patches(r, c).points(i, j));
  const TColStd_Array1OfReal u = knot_array(surface.u_knots), v = knot_array(surface.v_knots);
  const TColStd_Array1OfInteger mu = full_multiplicities(surface.u_knots, n);
  const TColStd_Array1OfInteger mv = full_multiplicities(surface.v_knots, m);
  return guarded("making a B-spline surface", [&]() -> Handle(Geom_BSplineSurface) {
    if (net.rational) return new Geom_BSplineSurface(net.poles, net.weights, u, v, mu, mv, n, m);
    return new Geom_BSplineSurface(net.poles, u, v, mu, mv, n, m);
  });
}

}  // namespace blossom::occt
