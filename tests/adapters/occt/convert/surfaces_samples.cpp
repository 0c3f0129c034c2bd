// SPDX-License-Identifier: LGPL-2.1-or-later
// Makers of sample curves and surfaces.

#include "tests/adapters/occt/convert/surfaces_samples.h"
#include "tests/support/measures.h"

#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_Line.hxx>
#include <Geom_OffsetCurve.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>

namespace blossom::testing {
namespace {

using testing::kPi;

gp_Pnt random_point(Random& random) {
  return {uniform(random, -5, 5), uniform(random, -5, 5), uniform(random, -5, 5)};
}

TColgp_Array1OfPnt random_points(Random& random, int count) {
  TColgp_Array1OfPnt points(1, count);
  for (gp_Pnt& point : points) point = random_point(random);
  return points;
}

TColStd_Array1OfReal weights_of(Random& random, int count, bool rational) {
  TColStd_Array1OfReal weights(1, count);
  for (double& weight : weights) weight = rational ? uniform(random, 0.3, 3) : 1.0;
  return weights;
}

template <class Array, class List>
Array array_of(const List& values) {
  Array array(1, static_cast<int>(values.size()));
  for (int i = 1; i <= array.Length(); ++i) array(i) = values[static_cast<std::size_t>(i - 1)];
  return array;
}

TColStd_Array1OfReal reals(const std::vector<double>& values) {
  return array_of<TColStd_Array1OfReal>(values);
}
TColStd_Array1OfInteger integers(const std::vector<int>& values) {
  return array_of<TColStd_Array1OfInteger>(values);
}

/// Knots of one direction, cubic.
struct Direction {
  std::vector<double> knots;
  std::vector<int> multiplicities;
  int poles;
  bool periodic;
};

const Direction kClamped{{-1, 0.3, 0.7, 1.9, 2.5}, {4, 1, 2, 1, 4}, 8, false};
const Direction kPeriodic{{0.2, 0.5, 1.1, 1.7, 2.6}, {1, 2, 1, 1, 1}, 5, true};
const Direction kPeriodicHighEnds{{0.2, 0.5, 1.1, 2.6}, {2, 1, 1, 2}, 4, true};
const Direction kUnclamped{{0, 1, 2.5, 3, 4, 5.5, 6, 7, 8}, {1, 1, 1, 1, 1, 1, 1, 1, 1}, 5, false};

Handle(Geom_BSplineCurve) spline_curve(Random& random, const Direction& d, bool rational) {
  return new Geom_BSplineCurve(random_points(random, d.poles),
                               weights_of(random, d.poles, rational), reals(d.knots),
                               integers(d.multiplicities), 3, d.periodic);
}

Handle(Geom_BSplineSurface)
    spline_surface(Random& random, const Direction& u, const Direction& v, bool rational) {
  TColgp_Array2OfPnt poles(1, u.poles, 1, v.poles);
  TColStd_Array2OfReal weights(1, u.poles, 1, v.poles);
  for (int i = 1; i <= u.poles; ++i)
    for (int j = 1; j <= v.poles; ++j) {
      poles(i, j) = random_point(random);
      weights(i, j) = rational ? uniform(random, 0.3, 3) : 1.0;
    }
  return new Geom_BSplineSurface(poles, weights, reals(u.knots), reals(v.knots),
                                 integers(u.multiplicities), integers(v.multiplicities), 3, 3,
                                 u.periodic, v.periodic);
}

/// A gentle bump over the unit square, so that offsets stay regular.
Handle(Geom_BezierSurface) bump() {
  TColgp_Array2OfPnt poles(1, 4, 1, 3);
  for (int i = 1; i <= 4; ++i)
    for (int j = 1; j <= 3; ++j)
      poles(i, j) = gp_Pnt(i / 3.0, j / 2.0, (i == 2 || i == 3) && j == 2 ? 0.4 : 0.0);
  return new Geom_BezierSurface(poles);
}

}  // namespace

gp_Ax3 tilted_frame(bool left_handed) {
  gp_Ax3 frame(gp_Pnt(1.5, -2.25, 0.75), gp_Dir(0.3, -0.5, 0.8), gp_Dir(0.9, 0.4, 0.1));
  if (left_handed) frame.YReverse();
  return frame;
}

Handle(Geom_BezierCurve) random_bezier_curve(Random& random, int degree, bool rational) {
  return new Geom_BezierCurve(random_points(random, degree + 1),
                              weights_of(random, degree + 1, rational));
}

Handle(Geom_BSplineCurve) random_spline_curve(Random& random, bool rational) {
  return spline_curve(random, kClamped, rational);
}
Handle(Geom_BSplineCurve) random_periodic_curve(Random& random, bool rational) {
  return spline_curve(random, rational ? kPeriodicHighEnds : kPeriodic, rational);
}
Handle(Geom_BSplineCurve) random_unclamped_curve(Random& random) {
  return spline_curve(random, kUnclamped, false);
}

Handle(Geom_BezierSurface)
    random_bezier_surface(Random& random, int u_degree, int v_degree, bool rational) {
  TColgp_Array2OfPnt poles(1, u_degree + 1, 1, v_degree + 1);
  TColStd_Array2OfReal weights(1, u_degree + 1, 1, v_degree + 1);
  for (int i = 1; i <= u_degree + 1; ++i)
    for (int j = 1; j <= v_degree + 1; ++j) {
      poles(i, j) = random_point(random);
      weights(i, j) = rational ? uniform(random, 0.3, 3) : 1.0;
    }
  return new Geom_BezierSurface(poles, weights);
}

Handle(Geom_BSplineSurface)
    random_spline_surface(Random& random, bool rational, bool periodic_u, bool unclamped_v) {
  return spline_surface(random, periodic_u ? kPeriodic : kClamped,
                        unclamped_v ? kUnclamped : kClamped, rational);
}

std::vector<NamedCurve> all_curves(Random& random) {
  const gp_Ax2 axes = tilted_frame().Ax2();
  const Handle(Geom_Curve) spline = random_spline_curve(random, true);
  const Handle(Geom_Curve) circle = new Geom_Circle(axes, 2.5);
  return {
      {"line", new Geom_Line(tilted_frame().Axis()), {-3, 7}},
      {"circle", circle, {0, 2 * kPi}},
      {"arc", circle, {-0.4, 3.9}},
      {"ellipse", new Geom_Ellipse(axes, 3, 1.2), {1, 7}},
      {"parabola", new Geom_Parabola(axes, 0.8), {-1.5, 4}},
      {"hyperbola", new Geom_Hyperbola(axes, 2, 1), {-1, 4.5}},
      {"bezier", random_bezier_curve(random, 5, false), {0, 1}},
      {"rational bezier", random_bezier_curve(random, 4, true), {0.2, 0.9}},
      {"spline", random_spline_curve(random, false), {-1, 2.5}},
      {"rational spline", spline, {-0.5, 2.1}},
      {"periodic spline", random_periodic_curve(random, false), {0.2, 2.6}},
      {"periodic spline across its seam", random_periodic_curve(random, false), {1.3, 3.7}},
      {"periodic spline turns before", random_periodic_curve(random, true), {-5.1, -3}},
      {"unclamped spline", random_unclamped_curve(random), {3, 5.5}},
      {"trimmed spline", new Geom_TrimmedCurve(spline, -0.7, 2), {-0.7, 2}},
      {"trimmed circle", new Geom_TrimmedCurve(circle, 1, 4), {1, 4}},
      {"offset spline",
       new Geom_OffsetCurve(new Geom_Ellipse(axes, 3, 1.5), 0.3, gp::DZ()),
       {0, 5},
       false},
  };
}

std::vector<NamedSurface> all_surfaces(Random& random) {
  const gp_Ax3 frame = tilted_frame(), mirror = tilted_frame(true);
  const gp_Dir up(0.2, 0.3, 0.9);
  const gp_Ax1 axis(gp_Pnt(9, 1, 2), gp_Dir(0.1, 1, 0.2));
  const Interval turn{0, 2 * kPi};
  const Handle(Geom_Surface) rational = random_spline_surface(random, true, false, false);
  return {
      {"plane", new Geom_Plane(frame), {{-2, 3}, {1, 5}}},
      {"plane, left-handed", new Geom_Plane(mirror), {{-2, 3}, {1, 5}}},
      {"cylinder", new Geom_CylindricalSurface(frame, 1.5), {turn, {-2, 3}}},
      {"cylinder, left-handed", new Geom_CylindricalSurface(mirror, 1.5), {{5, 9}, {-2, 3}}},
      {"cone", new Geom_ConicalSurface(frame, 0.4, 2), {turn, {0, 3}}},
      {"cone past its apex", new Geom_ConicalSurface(frame, 0.4, 2), {{1, 2}, {-9, 3}}},
      {"sphere", new Geom_SphericalSurface(frame, 2), {turn, {-kPi / 2, kPi / 2}}},
      {"piece of a sphere", new Geom_SphericalSurface(mirror, 2), {{-1, 1}, {0.2, 1.1}}},
      {"torus", new Geom_ToroidalSurface(frame, 4, 1), {turn, turn}},
      {"piece of a torus", new Geom_ToroidalSurface(frame, 4, 5), {{3, 4}, {5, 8}}},
      {"bezier", random_bezier_surface(random, 3, 4, false), {{0, 1}, {0, 1}}},
      {"rational bezier, cut", random_bezier_surface(random, 3, 2, true), {{0.1, 0.8}, {0, 0.5}}},
      {"spline", random_spline_surface(random, false, false, false), {{-1, 2.5}, {-1, 2.5}}},
      {"rational spline, cut", rational, {{0, 2}, {-0.9, 0.5}}},
      {"periodic spline",
       random_spline_surface(random, true, true, false),
       {{0.2, 2.6}, {-1, 2.5}}},
      {"periodic spline across its seam",
       random_spline_surface(random, false, true, true),
       {{2, 4.1}, {3, 5.5}}},
      {"unclamped spline", random_spline_surface(random, true, false, true), {{-1, 2}, {3.1, 5}}},
      {"trimmed spline",
       new Geom_RectangularTrimmedSurface(rational, 0.0, 1.0, 0.0, 1.0),
       {{0.1, 0.9}, {0, 1}}},
      {"extruded circle",
       new Geom_SurfaceOfLinearExtrusion(new Geom_Circle(frame.Ax2(), 2), up),
       {turn, {-1, 4}}},
      {"extruded spline",
       new Geom_SurfaceOfLinearExtrusion(random_spline_curve(random, true), up),
       {{-0.5, 2}, {-1, 4}}},
      {"extruded hyperbola",
       new Geom_SurfaceOfLinearExtrusion(new Geom_Hyperbola(frame.Ax2(), 2, 1), up),
       {{-1, 1}, {-1, 4}},
       false},
      {"revolved spline",
       new Geom_SurfaceOfRevolution(random_spline_curve(random, true), axis),
       {turn, {-1, 2.5}}},
      {"revolved circle",
       new Geom_SurfaceOfRevolution(new Geom_Circle(frame.Ax2(), 2), axis),
       {{0.5, 5}, {1, 6}}},
      {"revolved line",
       new Geom_SurfaceOfRevolution(new Geom_Line(gp::OX()), axis),
       {{0.5, 5}, {-4, 6}}},
      {"offset cylinder",
       new Geom_OffsetSurface(new Geom_CylindricalSurface(frame, 1.5), 0.25),
       {{0, 5}, {0, 1}}},
      {"offset revolved ellipse",
       new Geom_OffsetSurface(
           new Geom_SurfaceOfRevolution(new Geom_Ellipse(frame.Ax2(), 3, 1.5), axis), 0.3),
       {{0.5, 5}, {1, 6}},
       false},
      {"offset extruded ellipse",
       new Geom_OffsetSurface(
           new Geom_SurfaceOfLinearExtrusion(new Geom_Ellipse(frame.Ax2(), 3, 1.5), up), -0.3),
       {{0.5, 5}, {-1, 4}},
       false},
      {"offset bump", new Geom_OffsetSurface(bump(), 0.1), {{0, 1}, {0, 1}}, false},
      {"offset cylinder turned inside out",
       new Geom_OffsetSurface(new Geom_CylindricalSurface(frame, 1.5), -2),
       {{0, 5}, {0, 1}}},
  };
}

}  // namespace blossom::testing
