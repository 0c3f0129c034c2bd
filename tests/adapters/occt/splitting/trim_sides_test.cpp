// SPDX-License-Identifier: LGPL-2.1-or-later
// Sides of pieces that no cut decides: by the nearest point of an open tool.
#include "adapters/occt/splitting/trim_sides.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/distance.h"

namespace blossom::occt {
namespace {

TopoDS_Face square_at(double z, double size) {
  return BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, z), gp_Dir(0, 0, 1)), -size, size, -size, size)
      .Face();
}

ToolSide side_of(const TopoDS_Face& face, const std::vector<TopoDS_Face>& tool) {
  const FacePiece piece{face, {}, {}};
  const std::vector<FaceCut> cuts;
  const std::vector<CutSource> sources;
  return sides_of({{&piece, &cuts, &sources}}, {tool, {}}, 0).front();
}

// At a distance from a surface all in one point, which has no normal: Open CASCADE raises.
TopoDS_Face broken_face() {
  TColgp_Array2OfPnt poles(1, 2, 1, 2);
  poles.Init(gp_Pnt(0, 0, 0.5));
  const Handle(Geom_Surface) surface =
      new Geom_OffsetSurface(new Geom_BezierSurface(poles), 1, Standard_True);
  TopoDS_Face face;
  BRep_Builder().MakeFace(face, surface, 1e-7);
  BRep_Builder().NaturalRestriction(face, Standard_True);
  return face;
}

TEST(TrimSides, AreThoseOfTheNearestPoint) {
  const std::vector<TopoDS_Face> planes{square_at(0, 5), square_at(3, 5)};
  EXPECT_EQ(side_of(square_at(1, 1), planes), ToolSide::Above);
  EXPECT_EQ(side_of(square_at(2, 1), planes), ToolSide::Below);
}

TEST(TrimSides, AreNotDecidedByAFaceThatCannotBeMeasured) {
  ASSERT_THROW(nearest_point(MeasuredShape(broken_face()), {0, 0, 0}), Failure);
  EXPECT_EQ(side_of(square_at(1, 1), {broken_face(), square_at(0, 5)}), ToolSide::Above);
  EXPECT_EQ(side_of(square_at(1, 1), {broken_face()}), ToolSide::Unknown);
}

// A dome of radius about 1 round the origin, in so many cells of about the same distance that the
// search for the nearest one has to end before.
TopoDS_Face dimpled_dome() {
  constexpr int kPoints = 60;
  TColgp_Array2OfPnt points(1, kPoints, 1, kPoints);
  for (int i = 1; i <= kPoints; ++i)
    for (int j = 1; j <= kPoints; ++j) {
      const double x = 2.0 * (i - 1) / (kPoints - 1) - 1, y = 2.0 * (j - 1) / (kPoints - 1) - 1;
      const double r = (1 + 1e-3 * std::sin(30 * x) * std::sin(30 * y)) / std::hypot(x, y, 1.0);
      points(i, j) = gp_Pnt(r * x, r * y, r);
    }
  GeomAPI_PointsToBSplineSurface fit;
  fit.Interpolate(points);
  return BRepBuilderAPI_MakeFace(fit.Surface(), 1e-7).Face();
}

TEST(TrimSides, AreNotDecidedByASearchThatEndedBeforeItsBoundsMet) {
  const TopoDS_Face dome = dimpled_dome(), piece = square_at(0, 1e-3);
  const ShapeDistance found = nearest_point(MeasuredShape(dome), {0, 0, 0}, {.budget = 500});
  ASSERT_EQ(found.status, Status::Stopped);
  ASSERT_LT(found.lower, 0.99);
  EXPECT_EQ(side_of(piece, {dome}), ToolSide::Unknown);
  EXPECT_EQ(side_of(piece, {dome, square_at(-0.5, 5)}), ToolSide::Above);
  EXPECT_EQ(side_of(piece, {square_at(-1.5, 5), dome}), ToolSide::Unknown);
}

}  // namespace
}  // namespace blossom::occt
