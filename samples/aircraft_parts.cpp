// SPDX-License-Identifier: LGPL-2.1-or-later
#include "samples/aircraft_parts.h"

#include <array>
#include <cstddef>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>

namespace blossom::samples {
namespace {

using Points = TColgp_Array1OfPnt;

struct ClampedKnots {
  TColStd_Array1OfReal values;
  TColStd_Array1OfInteger counts;
};

// Of a cubic with so many poles: 0, 1, 2, ...
ClampedKnots cubic_knots(int poles) {
  ClampedKnots knots{{1, poles - 2}, {1, poles - 2}};
  for (int i = 1; i <= poles - 2; ++i) {
    knots.values(i) = i - 1;
    knots.counts(i) = i == 1 || i == poles - 2 ? 4 : 1;
  }
  return knots;
}

Handle(Geom_BSplineCurve) cubic(const Points& poles) {
  const ClampedKnots knots = cubic_knots(poles.Length());
  return new Geom_BSplineCurve(poles, knots.values, knots.counts, 3);
}

/// A section of a wing across y.
struct Foil {
  double x, y, z, chord;
};

Points poles_of(const Foil& foil) {
  constexpr std::array<double, 10> kBack = {1, 0.72, 0.38, 0.08, 0, 0, 0.1, 0.4, 0.75, 1};
  constexpr std::array<double, 10> kUp = {0.015, 0.06,  0.13,  0.125, 0.05,
                                          -0.03, -0.07, -0.07, -0.03, -0.015};
  Points poles(1, 10);
  for (std::size_t i = 0; i < 10; ++i)
    poles(static_cast<int>(i) + 1) =
        gp_Pnt(foil.x + foil.chord * kBack[i], foil.y, foil.z + foil.chord * kUp[i]);
  return poles;
}

TopoDS_Face skin_between(const Points& root, const Points& tip) {
  TColgp_Array2OfPnt poles(1, root.Length(), 1, 2);
  for (int i = 1; i <= root.Length(); ++i) {
    poles(i, 1) = root(i);
    poles(i, 2) = tip(i);
  }
  const ClampedKnots u = cubic_knots(root.Length());
  TColStd_Array1OfReal v(1, 2);
  TColStd_Array1OfInteger counts(1, 2);
  v(1) = 0;
  v(2) = 1;
  counts.Init(2);
  const Handle(Geom_BSplineSurface) surface =
      new Geom_BSplineSurface(poles, u.values, v, u.counts, counts, 3, 1);
  return BRepBuilderAPI_MakeFace(surface, 1e-7).Face();
}

TopoDS_Face cap_of(const Points& section) {
  const TopoDS_Edge round = BRepBuilderAPI_MakeEdge(cubic(section)).Edge();
  const TopoDS_Edge back = BRepBuilderAPI_MakeEdge(section.Last(), section.First()).Edge();
  return BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(round, back).Wire(), true).Face();
}

TopoDS_Face trailing_edge(const Points& root, const Points& tip) {
  BRepBuilderAPI_MakeWire wire;
  const std::array<gp_Pnt, 4> corners{root.First(), tip.First(), tip.Last(), root.Last()};
  for (std::size_t i = 0; i < 4; ++i)
    wire.Add(BRepBuilderAPI_MakeEdge(corners[i], corners[(i + 1) % 4]).Edge());
  return BRepBuilderAPI_MakeFace(wire.Wire(), true).Face();
}

}  // namespace

TopoDS_Solid fuselage() {
  constexpr std::array<std::array<double, 2>, 8> kProfile = {{{0, 0},
                                                              {0, 300},
                                                              {700, 620},
                                                              {2000, 700},
                                                              {4000, 690},
                                                              {6000, 520},
                                                              {8000, 260},
                                                              {8600, 120}}};
  Points poles(1, 8);
  for (std::size_t i = 0; i < 8; ++i)
    poles(static_cast<int>(i) + 1) = gp_Pnt(kProfile[i][0], 0, kProfile[i][1]);
  const gp_Pnt end(8600, 0, 0);
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(cubic(poles)).Edge(),
                               BRepBuilderAPI_MakeEdge(poles.Last(), end).Edge(),
                               BRepBuilderAPI_MakeEdge(end, poles.First()).Edge());
  const TopoDS_Face half = BRepBuilderAPI_MakeFace(wire.Wire(), true).Face();
  TopoDS_Solid solid =
      TopoDS::Solid(BRepPrimAPI_MakeRevol(half, gp_Ax1(gp::Origin(), gp::DX())).Shape());
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

TopoDS_Solid wing(int side) {
  const Points root = poles_of({2300, 100.0 * side, -150, 2400});
  const Points tip = poles_of({3300, 5600.0 * side, 150, 1100});
  BRepBuilderAPI_Sewing sewing;
  for (const TopoDS_Face& face :
       {skin_between(root, tip), trailing_edge(root, tip), cap_of(root), cap_of(tip)})
    sewing.Add(face);
  sewing.Perform();
  TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(TopoDS::Shell(sewing.SewedShape())).Solid();
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

}  // namespace blossom::samples
