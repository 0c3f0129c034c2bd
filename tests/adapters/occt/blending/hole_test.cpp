// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/hole.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/base/errors.h"
#include "core/forms/evaluation.h"
#include "tests/support/face_holes.h"

namespace blossom::occt {
namespace {

using testing::base_cubic;
using testing::open_box;
using testing::slantly_holed;
using testing::squarely_holed;

/// Edges 1 to 4 are the outer border of these faces, 5 to 8 the hole's.
const std::vector<int> kHole{5, 6, 7, 8};

FilledHole filled(const TopoDS_Shape& model, const std::vector<int>& edges,
                  FillContinuity continuity) {
  const std::vector<HoleLoop> loops = hole_loops(model, edges);
  EXPECT_EQ(loops.size(), 1u);
  return filled_hole(loops.front(), std::vector(loops.front().size(), continuity));
}

double off_graph(const Fill& fill) {
  double largest = 0;
  for (const RationalBezierPatch& patch : fill.patches)
    for (int i = 0; i <= 8; ++i)
      for (int j = 0; j <= 8; ++j) {
        const Vec3 p = point_at(patch, i / 8.0, j / 8.0);
        largest = std::max(largest, std::abs(p[2] - base_cubic(p[0], p[1])));
      }
  return largest;
}

double largest_angle(const Fill& fill) {
  double angle = fill.figures.inside.normal_angle;
  for (const FillContact& side : fill.figures.sides) angle = std::max(angle, side.normal_angle);
  return angle;
}

double area_of(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties, 1e-9);
  return properties.Mass();
}

TEST(Hole, AlongIsoLinesIsFilledWithTheSurfaceThatItWasCutFrom) {
  for (const FillContinuity continuity : {FillContinuity::G1, FillContinuity::G2}) {
    const FilledHole hole = filled(squarely_holed(), kHole, continuity);
    ASSERT_EQ(hole.fill.problem, FillProblem::None) << hole.fill.message;
    for (const FilledSide& side : hole.sides) EXPECT_TRUE(side.exact);
    EXPECT_EQ(hole.fill.reached, continuity);
    EXPECT_LE(off_graph(hole.fill), 1e-12);
    EXPECT_LE(largest_angle(hole.fill), 1e-12);
    EXPECT_EQ(hole.faces.size(), hole.fill.patches.size());
  }
}

TEST(Hole, AlongOtherLinesIsFollowedWithinTheErrorThatItStates) {
  const FilledHole hole = filled(slantly_holed(), kHole, FillContinuity::G1);
  ASSERT_EQ(hole.fill.problem, FillProblem::None) << hole.fill.message;
  double error = 0;
  for (const FilledSide& side : hole.sides) {
    EXPECT_FALSE(side.exact);
    EXPECT_LE(side.error, 1e-7);
    EXPECT_LE(side.angle_error, 1e-6);
    error = std::max(error, side.error);
  }
  EXPECT_LE(largest_angle(hole.fill), 1e-6);
  EXPECT_LE(off_graph(hole.fill), 1e-3);
}

TEST(Hole, TakesItsEdgesInAnyOrder) {
  std::vector<int> edges = kHole;
  const FilledHole first = filled(squarely_holed(), edges, FillContinuity::G1);
  while (std::next_permutation(edges.begin(), edges.end())) {
    const FilledHole other = filled(squarely_holed(), edges, FillContinuity::G1);
    ASSERT_EQ(other.fill.problem, FillProblem::None) << other.fill.message;
    EXPECT_LE(off_graph(other.fill), 1e-12);
  }
}

TEST(Hole, IsTheSameInAFaceThatIsReversedOrMoved) {
  const TopoDS_Shape turned = squarely_holed().Reversed();
  const FilledHole hole = filled(turned, kHole, FillContinuity::G1);
  ASSERT_EQ(hole.fill.problem, FillProblem::None) << hole.fill.message;
  EXPECT_LE(off_graph(hole.fill), 1e-12);

  gp_Trsf move;
  move.SetRotation(gp_Ax1({1, 2, 3}, {1, 1, 0}), 0.8);
  const FilledHole moved =
      filled(squarely_holed().Moved(TopLoc_Location(move)), kHole, FillContinuity::G1);
  ASSERT_EQ(moved.fill.problem, FillProblem::None) << moved.fill.message;
  EXPECT_LE(largest_angle(moved.fill), 1e-12);
}

TEST(Hole, IsSewnToItsNeighboursAsAValidShape) {
  const TopoDS_Face face = squarely_holed();
  const FilledHole hole = filled(face, kHole, FillContinuity::G1);
  const TopoDS_Shape joined = sewn_holes({hole}, face, 1e-7).shape;
  EXPECT_TRUE(BRepCheck_Analyzer(joined).IsValid());
  EXPECT_EQ(open_edges(joined).size(), 4u);
  EXPECT_NEAR(area_of(joined), area_of(testing::graph_face({})), 1e-9);
}

TEST(Hole, OfAnOpenBoxIsClosedByItsLid) {
  const TopoDS_Shape box = open_box();
  const FilledHole hole = filled(box, open_edges(box), FillContinuity::G0);
  ASSERT_EQ(hole.fill.problem, FillProblem::None) << hole.fill.message;
  const TopoDS_Shape joined = sewn_holes({hole}, box, 1e-7).shape;
  EXPECT_TRUE(open_edges(joined).empty());
  EXPECT_NEAR(area_of(joined), 6, 1e-12);
  GProp_GProps properties;
  BRepGProp::VolumeProperties(joined, properties);
  EXPECT_NEAR(std::abs(properties.Mass()), 1, 1e-12);
}

TEST(Hole, OfAnOpenBoxHasNoSmoothFilling) {
  const TopoDS_Shape box = open_box();
  const FilledHole hole = filled(box, open_edges(box), FillContinuity::G1);
  EXPECT_EQ(hole.fill.problem, FillProblem::TangentPlanes);
  EXPECT_TRUE(hole.faces.empty());
  EXPECT_NE(hole.fill.message.find("at the corner of edge 10 and edge 2"), std::string::npos)
      << hole.fill.message;
  EXPECT_NE(hole.fill.message.find("G0 asks for no"), std::string::npos) << hole.fill.message;
}

TEST(Hole, IsNotTheOuterBorderOfAFace) {
  const FilledHole hole = filled(squarely_holed(), {1, 2, 3, 4}, FillContinuity::G1);
  EXPECT_EQ(hole.fill.problem, FillProblem::ReflexCorner) << hole.fill.message;
}

/// Faces that share no edges, each moved by so much in a direction of its own.
TopoDS_Compound apart(const TopoDS_Shape& shape, double far) {
  TopoDS_Compound loose;
  const BRep_Builder builder;
  builder.MakeCompound(loose);
  double turn = 0;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next(), ++turn) {
    gp_Trsf move;
    move.SetTranslation(far * gp_Vec(std::cos(turn), std::sin(turn), std::cos(2 * turn)));
    builder.Add(loose, BRepBuilderAPI_Copy(face.Current()).Shape().Moved(TopLoc_Location(move)));
  }
  return loose;
}

TEST(Hole, OfLooseFacesThatMeetIsClosed) {
  for (const double far : {0., 1e-4, 1e-3}) {
    const TopoDS_Compound box = apart(open_box(), far);
    const OpenBorders borders = open_borders(box);
    EXPECT_EQ(borders.edges.size(), 4u) << far;
    const OpenLoops found = open_loops(box, borders);
    ASSERT_EQ(found.holes.size(), 1u) << far;
    EXPECT_TRUE(found.left_out.empty() && found.sheets.empty()) << far;
    const FilledHole hole =
        filled_hole(found.holes.front(), std::vector<FillContinuity>(4, FillContinuity::G0),
                    {.fill = {}, .within = borders.within});
    ASSERT_EQ(hole.fill.problem, FillProblem::None) << hole.fill.message;
    const TopoDS_Shape joined = sewn_holes({hole}, box, borders.within).shape;
    EXPECT_TRUE(open_edges(joined).empty()) << far;
    EXPECT_NEAR(area_of(joined), 6, 20 * far + 1e-9);
  }
}

TEST(Hole, OfLooseFacesIsNoneIfNoneMayMeet) {
  EXPECT_EQ(open_borders(apart(open_box(), 0), 0).edges.size(), 20u);
}

TEST(HoleLoops, TellTheBorderOfASheetFromAHole) {
  for (const bool turned : {false, true}) {
    TopoDS_Face face = squarely_holed();
    if (turned) face.Reverse();
    const OpenLoops found = open_loops(face, open_borders(face));
    ASSERT_EQ(found.holes.size(), 1u);
    EXPECT_EQ(found.holes.front().front().number, kHole.front());
    ASSERT_EQ(found.sheets.size(), 1u);
    EXPECT_EQ(found.sheets.front().front().number, 1);
  }
}

TEST(HoleLoops, RefuseEdgesThatBoundNone) {
  const TopoDS_Face face = squarely_holed();
  EXPECT_THROW(hole_loops(face, {5, 6, 7}), BadModel);
  EXPECT_THROW(hole_loops(face, {5, 5, 6, 7, 8}), BadModel);
  EXPECT_THROW(hole_loops(face, {0}), BadModel);
  EXPECT_THROW(hole_loops(face, {9}), BadModel);
  EXPECT_THROW(hole_loops(BRepPrimAPI_MakeBox(1, 1, 1).Shape(), {1, 2, 3, 4}), BadModel);
}

TEST(HoleLoops, FindAllThatAreOpen) {
  const TopoDS_Face face = squarely_holed();
  const std::vector<HoleLoop> loops = hole_loops(face, open_edges(face));
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_EQ(loops[0].size(), 4u);
  EXPECT_EQ(loops[1].size(), 4u);
}

TEST(HoleLoops, LeaveOutWaysThatForkAndKeepTheOthers) {
  // Two faces that lie side by side and are not sewn, and one with a hole.
  TopoDS_Compound model;
  BRep_Builder builder;
  builder.MakeCompound(model);
  builder.Add(model, testing::graph_face({}));
  gp_Trsf beside;
  beside.SetTranslation(gp_Vec(1, 0, 0));
  builder.Add(model, testing::graph_face({}, [](double x, double y) {
                       return base_cubic(x + 1, y);
                     }).Moved(TopLoc_Location(beside)));
  gp_Trsf away;
  away.SetTranslation(gp_Vec(10, 0, 0));
  builder.Add(model, squarely_holed().Moved(TopLoc_Location(away)));

  const OpenLoops found = open_loops(model, {open_edges(model)});
  // The hole and the outer border of its face; of the two others one border, since the first way
  // forks.
  EXPECT_EQ(found.holes.size(), 1u);
  EXPECT_EQ(found.sheets.size(), 2u);
  EXPECT_FALSE(found.left_out.empty());
  for (const std::string& message : found.left_out)
    EXPECT_TRUE(message.find("forks") != std::string::npos ||
                message.find("ends") != std::string::npos)
        << message;
}

}  // namespace
}  // namespace blossom::occt
