// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces and cuts for the tests of trimming, and what every split has to fulfil.

#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include <Approx_CurveOnSurface.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/convert/curves.h"
#include "adapters/occt/faces/area.h"
#include "adapters/occt/splitting/face_splitter.h"

namespace blossom::occt::testing {

inline Spline from_geom(const Handle(Geom_BSplineCurve) & curve) {
  Spline spline{curve->Degree(), {}, {}, {}};
  for (int i = 1; i <= curve->NbKnots(); ++i) {
    spline.knots.push_back(curve->Knot(i));
    spline.multiplicities.push_back(curve->Multiplicity(i));
  }
  for (int i = 1; i <= curve->NbPoles(); ++i) {
    const gp_Pnt p = curve->Pole(i);
    spline.points.push_back({p.X(), p.Y(), p.Z()});
  }
  return spline;
}

/// A cut along a curve in the chart; its space curve follows within 1e-8.
inline FaceCut cut_along(const TopoDS_Face& face, const Spline2& chart) {
  const Handle(Geom2dAdaptor_Curve) flat = new Geom2dAdaptor_Curve(to_occt(chart));
  const Handle(GeomAdaptor_Surface) surface = new GeomAdaptor_Surface(BRep_Tool::Surface(face));
  Approx_CurveOnSurface approximate(flat, surface, chart.knots.front(), chart.knots.back(), 1e-8);
  approximate.Perform(100, 14, GeomAbs_C1, Standard_True, Standard_False);
  return {from_geom(approximate.Curve3d()), chart, 1e-7};
}

inline FaceCut line_cut(const TopoDS_Face& face, const Vec2& from, const Vec2& to) {
  return cut_along(face, {1, {0, 1}, {2, 2}, {from, to}});
}

/// A closed, smooth cut round `centre`: a quartic-like loop of two cubic spans per half.
inline FaceCut loop_cut(const TopoDS_Face& face, const Vec2& centre, double radius) {
  const double k = 0.5522847498 * radius, r = radius;
  Spline2 chart{3, {0, 1, 2, 3, 4}, {4, 3, 3, 3, 4}, {}};
  const Vec2 points[] = {{r, 0},   {r, k},   {k, r},  {0, r},  {-k, r}, {-r, k}, {-r, 0},
                         {-r, -k}, {-k, -r}, {0, -r}, {k, -r}, {r, -k}, {r, 0}};
  for (const Vec2& p : points) chart.points.push_back(centre + p);
  return cut_along(face, chart);
}

/// Edges used by the shapes, and how often.
inline std::map<const void*, int> edge_uses(const std::vector<FacePiece>& pieces) {
  std::map<const void*, int> uses;
  for (const FacePiece& piece : pieces)
    for (TopExp_Explorer it(piece.face, TopAbs_EDGE); it.More(); it.Next())
      ++uses[it.Current().TShape().get()];
  return uses;
}

/// The pieces are valid, add up to the face, keep its orientation, and each edge of a cut is used
/// twice, in opposite directions.
inline void expect_sound(const TopoDS_Face& face, const FaceSplit& split, std::size_t count) {
  std::string notes;
  for (const std::string& note : split.notes) notes += note + "; ";
  ASSERT_EQ(split.pieces.size(), count) << notes;
  double sum = 0;
  std::map<const void*, int> directions;
  for (const FacePiece& piece : split.pieces) {
    EXPECT_TRUE(BRepCheck_Analyzer(piece.face).IsValid());
    EXPECT_EQ(piece.face.Orientation(), face.Orientation());
    const double size = area(piece.face);
    EXPECT_GT(size, 0);
    sum += size;
    for (const CutUse& use : piece.cuts)
      directions[use.edge.TShape().get()] += use.edge.Orientation() == TopAbs_FORWARD ? 1 : -1;
  }
  EXPECT_NEAR(sum, area(face), 1e-9 * area(face));
  const std::map<const void*, int> uses = edge_uses(split.pieces);
  for (const auto& [edge, direction] : directions) {
    EXPECT_EQ(uses.at(edge), 2);
    EXPECT_EQ(direction, 0);
  }
}

}  // namespace blossom::occt::testing
