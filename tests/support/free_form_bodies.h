// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies with two free-form faces that meet in a sharp edge.
//
//   c(x, y) = 0.3 x^3 - 0.25 x y^2 + 0.2 x y - 0.15 y^2 + 0.1 x - 0.05 y + 0.12 x^2 y
//   A(s, t) = (s, t / 2, c),   B(s, t) = (s, 0.5 + 0.3 t + 0.1 t^2, c(s, 0.5) + 0.8 t - 0.2 t^2 +
//   0.15 s t)
//
// Both are exact bicubics over the unit square; they share the edge y = 0.5.

#pragma once

#include <array>
#include <functional>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>
#include <gp_Pln.hxx>

namespace blossom::testing {

inline double base_cubic(double x, double y) {
  return 0.3 * x * x * x - 0.25 * x * y * y + 0.2 * x * y - 0.15 * y * y + 0.1 * x - 0.05 * y +
         0.12 * x * x * y;
}

/// The Bezier points of a cubic from its values at 0, 1/3, 2/3, 1.
inline std::array<gp_XYZ, 4> cubic_points(const std::array<gp_XYZ, 4>& f) {
  return {f[0], (f[0] * -5 + f[1] * 18 - f[2] * 9 + f[3] * 2) / 6,
          (f[0] * 2 - f[1] * 9 + f[2] * 18 - f[3] * 5) / 6, f[3]};
}

inline Handle(Geom_BezierSurface) bicubic(const std::function<gp_XYZ(double, double)>& point) {
  std::array<std::array<gp_XYZ, 4>, 4> rows;  // by s, points along t
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<gp_XYZ, 4> values;
    for (std::size_t k = 0; k < 4; ++k)
      values[k] = point(static_cast<double>(i) / 3, static_cast<double>(k) / 3);
    rows[i] = cubic_points(values);
  }
  TColgp_Array2OfPnt poles(1, 4, 1, 4);
  for (std::size_t k = 0; k < 4; ++k) {
    const std::array<gp_XYZ, 4> column =
        cubic_points({rows[0][k], rows[1][k], rows[2][k], rows[3][k]});
    for (std::size_t i = 0; i < 4; ++i)
      poles(static_cast<int>(i) + 1, static_cast<int>(k) + 1) = gp_Pnt(column[i]);
  }
  return new Geom_BezierSurface(poles);
}

inline Handle(Geom_BezierSurface) surface_a() {
  return bicubic([](double s, double t) { return gp_XYZ(s, t / 2, base_cubic(s, t / 2)); });
}

inline Handle(Geom_BezierSurface) surface_b() {
  return bicubic([](double s, double t) {
    return gp_XYZ(s, 0.5 + 0.3 * t + 0.1 * t * t,
                  base_cubic(s, 0.5) + 0.8 * t - 0.2 * t * t + 0.15 * s * t);
  });
}

/// What lies between both surfaces and the plane z = height, over x in [0, 1], y in [0, 0.9].
inline TopoDS_Shape free_form_body(double height) {
  const Handle(Geom_BezierSurface) a = surface_a(), b = surface_b();
  BRepBuilderAPI_Sewing sewing(1e-9);
  sewing.Add(BRepBuilderAPI_MakeFace(a, 1e-7).Face());
  sewing.Add(BRepBuilderAPI_MakeFace(b, 1e-7).Face());
  const auto edge = [](const gp_Pnt& from, const gp_Pnt& to) {
    return BRepBuilderAPI_MakeEdge(from, to).Edge();
  };
  for (const double x : {0.0, 1.0}) {
    const Handle(Geom_Curve) of_a = a->UIso(x), of_b = b->UIso(x);
    const gp_Pnt low(x, 0, height), high(x, 0.9, height);
    BRepBuilderAPI_MakeWire wire(edge(low, of_a->Value(0)), BRepBuilderAPI_MakeEdge(of_a).Edge(),
                                 BRepBuilderAPI_MakeEdge(of_b).Edge(), edge(of_b->Value(1), high));
    wire.Add(edge(high, low));
    sewing.Add(
        BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(x, 0, 0), gp_Dir(1, 0, 0)), wire.Wire()).Face());
  }
  const std::array<std::pair<double, Handle(Geom_Curve)>, 2> ends{
      {{0.0, a->VIso(0)}, {0.9, b->VIso(1)}}};
  for (const auto& [y, border] : ends) {
    const gp_Pnt low(0, y, height), high(1, y, height);
    BRepBuilderAPI_MakeWire wire(edge(low, border->Value(0)),
                                 BRepBuilderAPI_MakeEdge(border).Edge(),
                                 edge(border->Value(1), high), edge(high, low));
    sewing.Add(
        BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, y, 0), gp_Dir(0, 1, 0)), wire.Wire()).Face());
  }
  const gp_Pnt corners[] = {{0, 0, height}, {1, 0, height}, {1, 0.9, height}, {0, 0.9, height}};
  sewing.Add(
      BRepBuilderAPI_MakeFace(
          BRepBuilderAPI_MakePolygon(corners[0], corners[1], corners[2], corners[3], true).Wire())
          .Face());
  sewing.Perform();
  TopExp_Explorer shell(sewing.SewedShape(), TopAbs_SHELL);
  TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(TopoDS::Shell(shell.Current())).Solid();
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

}  // namespace blossom::testing
