// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/plane_section.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <utility>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/intersection_edges.h"
#include "adapters/occt/shapes.h"
#include "tests/support/models.h"
#include "tests/support/test_data.h"

namespace blossom::occt {
namespace {

constexpr double kPi = std::numbers::pi;

PlaneSection section_of(const TopoDS_Shape& shape, const Vec3& point, const Vec3& normal) {
  return plane_section(faces_of(shape), {point, normal});
}

double total_length(const PlaneSection& section) {
  double sum = 0;
  for (const SectionWire& wire : section.wires) sum += wire.length;
  return sum;
}

std::size_t closed_wires(const PlaneSection& section) {
  return static_cast<std::size_t>(
      std::count_if(section.wires.begin(), section.wires.end(),
                    [](const SectionWire& wire) { return wire.closed; }));
}

int count_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, kind, map);
  return map.Extent();
}

// Closed wires only, of this length, and nothing else.
void expect_wires(const PlaneSection& section, std::size_t wires, double length) {
  EXPECT_EQ(section.wires.size(), wires);
  EXPECT_EQ(closed_wires(section), wires);
  EXPECT_NEAR(total_length(section), length, 1e-7 * length);
  EXPECT_TRUE(section.points.empty());
}

// The far end of each use is the near end of the next one.
void expect_chained(const PlaneSection& section) {
  for (const SectionWire& wire : section.wires)
    for (std::size_t i = 0; i + 1 < wire.uses.size() + (wire.closed ? 1 : 0); ++i) {
      const CurveUse &use = wire.uses[i], &next = wire.uses[(i + 1) % wire.uses.size()];
      EXPECT_EQ(section.curves[use.curve].nodes[use.forward ? 1 : 0],
                section.curves[next.curve].nodes[next.forward ? 0 : 1]);
    }
}

TEST(PlaneSection, OfASphereIsACircle) {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(2).Shape();
  const Vec3 normal = unit(Vec3{1, 2, 2});
  const PlaneSection section = section_of(ball, normal, {2, 4, 4});
  EXPECT_EQ(section.status, Status::Complete);
  expect_wires(section, 1, 2 * kPi * std::sqrt(3));
  for (const SectionCurve& curve : section.curves)
    for (const Vec3& p : curve.samples) {
      EXPECT_NEAR(norm(p), 2, 1e-9);
      EXPECT_NEAR(dot(normal, p), 1, 1e-9);
    }
}

// A closed circle of which a bore takes a part is one curve, also where it begins in what is left.
TEST(PlaneSection, OfABoredSphereHasNoEndWhereItsCircleBegins) {
  const gp_Ax2 axis(gp_Pnt(0, 0, -20), gp_Dir(0, 0, 1));
  const TopoDS_Shape bored = BRepAlgoAPI_Cut(BRepPrimAPI_MakeSphere(15).Shape(),
                                             BRepPrimAPI_MakeCylinder(axis, 7.5, 40).Shape());
  for (int i = 0; i < 40; ++i) {
    const double angle = -1.2 + 0.06 * i;  // at which the plane keeps off the seam
    const PlaneSection section =
        section_of(bored, {0, -7.2, 1.6}, {0.3 * std::sin(angle), -0.97, 0.3 * std::cos(angle)});
    EXPECT_EQ(section.status, Status::Complete) << i;
    EXPECT_EQ(closed_wires(section), section.wires.size()) << i;
    for (const SectionNode& node : section.nodes) EXPECT_FALSE(node.on.IsNull()) << i;
  }
}

TEST(PlaneSection, OfASphereThroughItsPolesIsAGreatCircle) {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(2).Shape();
  expect_wires(section_of(ball, {0, 0, 0}, {1, 3, 0}), 1, 4 * kPi);
  expect_wires(section_of(ball, {0, 0, 0}, {0, 1, 0}), 1, 4 * kPi);  // along its seam
}

TEST(PlaneSection, OfASphereThatItTouchesIsAPoint) {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(2).Shape();
  const Vec3 normal = unit(Vec3{-1, 2, 2});
  const PlaneSection section = section_of(ball, 2 * normal, normal);
  EXPECT_EQ(section.status, Status::Complete);
  EXPECT_TRUE(section.curves.empty());
  ASSERT_EQ(section.points.size(), 1u);
  EXPECT_LE(distance(section.nodes[section.points[0]].point, 2 * normal), 1e-6);
}

TEST(PlaneSection, OfATorusIsTwoCircles) {
  const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(3, 1).Shape();
  expect_wires(section_of(torus, {0, 0, 0}, {0, 0, 1}), 2, 12 * kPi);  // one along its seam
  expect_wires(section_of(torus, {0, 0, 0}, {1, 2, 0}), 2, 4 * kPi);
  const PlaneSection high = section_of(torus, {0, 0, 0.5}, {0, 0, 1});
  EXPECT_EQ(high.status, Status::Complete);
  expect_wires(high, 2, 12 * kPi);
}

TEST(PlaneSection, OfATorusWithItsBitangentPlaneIsTwoCirclesThatCross) {
  const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(3, 1).Shape();
  const PlaneSection section = section_of(torus, {0, 0, 0}, {1, 0, std::sqrt(8)});
  EXPECT_EQ(section.status, Status::Tolerance);
  EXPECT_NEAR(total_length(section), 12 * kPi, 1e-2);  // branches end where the contacts start
  EXPECT_EQ(closed_wires(section), section.wires.size());
}

TEST(PlaneSection, OfABoxIsAHexagonWhoseCornersLieOnItsEdges) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
  const PlaneSection section = section_of(box, {0.5, 0.5, 0.5}, {1, 1, 1});
  EXPECT_EQ(section.status, Status::Complete);
  expect_wires(section, 1, 3 * std::sqrt(2));
  expect_chained(section);
  EXPECT_EQ(section.curves.size(), 6u);
  ASSERT_EQ(section.nodes.size(), 6u);
  for (const SectionNode& node : section.nodes) {
    EXPECT_EQ(node.on.ShapeType(), TopAbs_EDGE);
    EXPECT_TRUE(node.proven);
    EXPECT_LE(node.reach, 1e-9);
  }
}

TEST(PlaneSection, GoesThroughVertices) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
  const PlaneSection section = section_of(box, {1, 0, 0}, {1, 1, 1});
  expect_wires(section, 1, 3 * std::sqrt(2));
  expect_chained(section);
  ASSERT_EQ(section.nodes.size(), 3u);
  for (const SectionNode& node : section.nodes) EXPECT_EQ(node.on.ShapeType(), TopAbs_VERTEX);
}

TEST(PlaneSection, HasAnEdgeInThePlaneOnce) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
  const PlaneSection section = section_of(box, {0, 0, 0}, {1, -1, 0});
  expect_wires(section, 1, 2 + 2 * std::sqrt(2));
  EXPECT_EQ(section.curves.size(), 4u);
  EXPECT_EQ(std::count_if(section.curves.begin(), section.curves.end(),
                          [](const SectionCurve& curve) { return !curve.edge.IsNull(); }),
            2);
}

TEST(PlaneSection, TouchesAVertexOrAnEdge) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
  const PlaneSection vertex = section_of(box, {0, 0, 0}, {1, 1, 1});
  EXPECT_TRUE(vertex.curves.empty());
  ASSERT_EQ(vertex.points.size(), 1u);
  EXPECT_EQ(vertex.nodes[vertex.points[0]].on.ShapeType(), TopAbs_VERTEX);
  const PlaneSection edge = section_of(box, {0, 0, 0}, {1, 1, 0});
  ASSERT_EQ(edge.curves.size(), 1u);
  EXPECT_FALSE(edge.curves[0].edge.IsNull());
  EXPECT_EQ(closed_wires(edge), 0u);
  EXPECT_NEAR(total_length(edge), 1, 1e-12);
  EXPECT_TRUE(edge.points.empty());
}

double oriented_area(PlaneSection section, const Plane& plane) {
  orient_wires(section, plane);
  return bounded_area(section).value_or(-1);
}

TEST(PlaneSection, KnowsWhatItsWiresEnclose) {
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(2, 20).Shape();
  const Plane oblique{{0, 0, 10}, {1, 0, -1}};
  const PlaneSection ellipse = section_of(cylinder, oblique.point, oblique.normal);
  EXPECT_NEAR(oriented_area(ellipse, oblique), 4 * kPi * std::sqrt(2), 1e-9);
  ASSERT_EQ(ellipse.wires.size(), 1u);
  EXPECT_NEAR(std::abs(ellipse.wires[0].area.value()), 4 * kPi * std::sqrt(2), 1e-9);

  // Two outlines that are splines. Their widths at a height follow from the circles there.
  const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(4, 1).Shape();
  const Plane across{{0.5, 0, 0}, {1, 0, 0}};
  double area = 0;  // by the midpoint rule over the angle, which is exact but for 1e-10 here
  constexpr int kSteps = 200;
  for (int i = 0; i < kSteps; ++i) {
    const double angle = kPi * (i + 0.5) / kSteps;
    const double half = std::sin(angle), outer = 4 + half, inner = 4 - half;
    const double width = std::sqrt(outer * outer - 0.25) - std::sqrt(inner * inner - 0.25);
    area += 2 * width * half * kPi / kSteps;
  }
  EXPECT_NEAR(oriented_area(section_of(torus, across.point, across.normal), across), area, 1e-6);

  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
  EXPECT_FALSE(bounded_area(plane_section({faces_of(box)[0]}, {{0, 0, 0.5}, {0, 0, 1}})));
}

double length_inside(const PlaneSection& section) {
  double sum = 0;
  for (const SectionWire& wire : section.wires) sum += wire.bounding ? 0 : wire.length;
  return sum;
}

TEST(PlaneSection, AtAStepHasTheWholeOutlineAndTheStepsEdgeInside) {
  const TopoDS_Shape low = BRepPrimAPI_MakeBox(10, 10, 5).Shape();
  const TopoDS_Shape wall = BRepPrimAPI_MakeBox(4, 10, 12).Shape();
  const TopoDS_Shape boss = BRepPrimAPI_MakeBox(gp_Pnt(3, 3, 0), 4, 4, 12).Shape();
  for (const auto& [high, inside] : {std::pair{wall, 10.0}, std::pair{boss, 16.0}}) {
    const TopoDS_Shape part = BRepAlgoAPI_Fuse(low, high).Shape();
    const PlaneSection section = section_of(part, {0, 0, 5}, {0, 0, 1});
    EXPECT_EQ(section.status, Status::Complete);
    EXPECT_NEAR(oriented_area(section, {{0, 0, 5}, {0, 0, 1}}), 100, 1e-9);
    EXPECT_NEAR(length_inside(section), inside, 1e-9);
  }
}

TEST(PlaneSection, OfABallOnAnEdgeThatThePlaneTouchesIsTheDiscAndTheRestOfTheEdge) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 10, 10).Shape();
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Pnt(0, 0, 5), 2).Shape();
  const Plane plane{{0, 0, 5}, {1, 1, 0}};
  const PlaneSection section =
      section_of(BRepAlgoAPI_Fuse(box, ball).Shape(), plane.point, plane.normal);
  EXPECT_NEAR(length_inside(section), 6, 1e-6);
  EXPECT_NEAR(total_length(section) - length_inside(section), 4 * kPi, 1e-6);
  EXPECT_EQ(closed_wires(section), 1u);
}

TEST(PlaneSection, CutsACurveWhereItBeginsToRunAlongAnEdgeInThePlane) {
  // The top of a box whose corner stands out of a ball: a part of the ball's circle is its edge.
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(5).Shape();
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(6, 6, 3).Shape();
  const PlaneSection section =
      section_of(BRepAlgoAPI_Fuse(ball, box).Shape(), {0, 0, 3}, {0, 0, 1});
  EXPECT_EQ(section.status, Status::Complete);
  const double angle = std::acos(0.0);  // the box's sides go through the ball's axis
  EXPECT_NEAR(length_inside(section), 4 * angle, 1e-6);
  EXPECT_NEAR(oriented_area(section, {{0, 0, 3}, {0, 0, 1}}), 0.75 * 16 * kPi + 36, 1e-9);
  EXPECT_EQ(closed_wires(section), 1u);
  // A pocket's wall in the plane, and the block's own face on both sides of it.
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(10, 10, 10).Shape();
  const TopoDS_Shape pocket = BRepPrimAPI_MakeBox(gp_Pnt(5, 3, 6), 3, 3, 6).Shape();
  const Plane wall{{5, 0, 0}, {1, 0, 0}};
  const PlaneSection through =
      section_of(BRepAlgoAPI_Cut(block, pocket).Shape(), wall.point, wall.normal);
  EXPECT_NEAR(oriented_area(through, wall), 100, 1e-9);
  EXPECT_NEAR(length_inside(through), 11, 1e-9);
}

TEST(PlaneSection, IsClosedWhereItTouchesSeamsAndLinesBetweenPatches) {
  for (const double radius : {10.0, 7.5, 6.9734}) {
    const double far = radius + 2.6;  // through the seam's vertex, and a quarter turn from it
    const PlaneSection section =
        section_of(BRepPrimAPI_MakeTorus(radius, 2.6).Shape(), {far, 0, 0}, {1, 1, 0});
    EXPECT_EQ(closed_wires(section), 1u);
    EXPECT_EQ(section.wires.size(), 1u);
  }
}

TEST(PlaneSection, BoundsNothingWhereASolidOnlyTouches) {
  const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(3, 1).Shape();
  const PlaneSection on_it = section_of(torus, {0, 0, 1}, {0, 0, 1});
  EXPECT_NEAR(length_inside(on_it), 6 * kPi, 1e-9);
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
  EXPECT_NEAR(length_inside(section_of(box, {0, 0, 0}, {1, 1, 0})), 1, 1e-12);
  EXPECT_EQ(length_inside(section_of(box, {0, 0, 0}, {1, -1, 0})), 0);
  // A cylinder's seam in the plane is crossed, and a plane in which a solid lies bounds it.
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(1, 2).Shape();
  EXPECT_EQ(length_inside(section_of(cylinder, {0, 0, 0}, {0, 1, 0})), 0);
  for (const double z : {0.0, 2.0})
    EXPECT_NEAR(oriented_area(section_of(cylinder, {0, 0, z}, {0, 0, 1}), {{0, 0, z}, {0, 0, 1}}),
                kPi, 0.01);
}

TEST(PlaneSection, TellsOfAFaceInThePlane) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
  const PlaneSection section = section_of(box, {0, 0, 3}, {0, 0, 1});
  ASSERT_EQ(section.faces_in_plane.size(), 1u);
  expect_wires(section, 1, 6);
  expect_chained(section);
  EXPECT_EQ(section.curves.size(), 4u);
}

TEST(PlaneSection, OfACylinderCutObliquelyIsAnEllipse) {
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(1, 10).Shape();
  const PlaneSection section = section_of(cylinder, {0, 0, 5}, {1, 0.5, 1.5});
  EXPECT_EQ(section.status, Status::Complete);
  const double a = std::sqrt(3.5) / 1.5;  // the normal's length over its part along the axis
  expect_wires(section, 1, 4 * a * std::comp_ellint_2(std::sqrt(1 - 1 / (a * a))));
}

TEST(PlaneSection, OfACylinderThroughBothEndsIsARectangle) {
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(1, 10).Shape();
  const PlaneSection section = section_of(cylinder, {0.6, 0, 0}, {3, 0, 0});
  EXPECT_EQ(section.status, Status::Complete);
  expect_wires(section, 1, 2 * (10 + 1.6));
  expect_chained(section);
  EXPECT_EQ(section.curves.size(), 4u);
}

TEST(PlaneSection, OfACylinderThatItTouchesIsALine) {
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(1, 10).Shape();
  for (const Vec3& normal : {Vec3{0, 1, 0}, Vec3{1, 0, 0}}) {  // inside of the face, on its seam
    const PlaneSection section = section_of(cylinder, normal, normal);
    EXPECT_NEAR(total_length(section), 10, 1e-6);
    ASSERT_EQ(section.curves.size(), 1u);
    EXPECT_TRUE(section.curves[0].tangential || !section.curves[0].edge.IsNull());
  }
}

TEST(PlaneSection, OfAConeThroughItsApexIsATriangle) {
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(1, 0, 2).Shape();
  const PlaneSection section = section_of(cone, {0, 0, 2}, {1, 2, 0});
  expect_wires(section, 1, 2 + 2 * std::sqrt(5));
  expect_chained(section);
}

TEST(PlaneSection, TakesAllPartsOfAnAssembly) {
  TopoDS_Compound both;
  BRep_Builder builder;
  builder.MakeCompound(both);
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
  gp_Trsf move;
  move.SetTranslation(gp_Vec(5, 0, 0));
  builder.Add(both, box);
  builder.Add(both, box.Moved(move));
  const PlaneSection section = section_of(both, {0, 0, 0.25}, {0, 0, 1});
  EXPECT_EQ(section.status, Status::Complete);
  expect_wires(section, 2, 8);
}

// An offset surface has no hull of control points.
TEST(PlaneSection, OfAnOffsetSurfaceIsFoundByObliquePlanes) {
  TColgp_Array2OfPnt poles(1, 2, 1, 2);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) poles(i + 1, j + 1) = gp_Pnt(i, j, 0);
  const Handle(Geom_Surface) flat = new Geom_BezierSurface(poles);
  const Handle(Geom_Surface) offset = new Geom_OffsetSurface(flat, 0.5, true);
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(offset, 1e-7);
  const PlaneSection found = section_of(face, {0.2, 0, 0}, {1, -1, 0});
  ASSERT_EQ(found.wires.size(), 1u);
  EXPECT_NEAR(total_length(found), 0.8 * std::numbers::sqrt2, 1e-6);
}

TEST(PlaneSection, BesideAShapeIsEmptyWithoutASearch) {
  const PlaneSection section =
      section_of(BRepPrimAPI_MakeBox(1, 1, 1).Shape(), {0, 0, 1.001}, {0, 0, 1});
  EXPECT_EQ(section.status, Status::Complete);
  EXPECT_TRUE(section.wires.empty() && section.points.empty());
  EXPECT_EQ(section.faces_searched, 0);
}

TEST(PlaneSection, GivesWiresThatOpenCascadeFindsSound) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
  const TopoDS_Compound wires = compound_of(section_of(box, {0.5, 0.5, 0.5}, {1, 1, 1}));
  EXPECT_EQ(count_of(wires, TopAbs_WIRE), 1);
  EXPECT_EQ(count_of(wires, TopAbs_EDGE), 6);
  EXPECT_EQ(count_of(wires, TopAbs_VERTEX), 6);
  EXPECT_TRUE(BRepCheck_Analyzer(wires).IsValid());
  const TopoDS_Compound loop =
      compound_of(section_of(BRepPrimAPI_MakeSphere(2).Shape(), {0, 0, 1}, {0, 0.1, 1}));
  EXPECT_TRUE(BRepCheck_Analyzer(loop).IsValid());
}

TEST(PlaneSection, RefusesAPlaneWithoutADirection) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
  EXPECT_THROW(section_of(box, {0, 0, 0}, {0, 0, 0}), BadModel);
  EXPECT_THROW(section_of(box, {0, 0, std::nan("")}, {0, 0, 1}), BadModel);
}

TEST(PlaneSection, OfARealSolidIsClosed) {
  const char* data = blossom::testing::test_data();
  if (data == nullptr) GTEST_SKIP() << blossom::testing::kNoTestData;
  const auto models = std::filesystem::path(data) / "models";
  for (const char* name : {"ball.brep", "propeller.brep", "s1_mainbody_back.stp"}) {
    const TopoDS_Shape shape = testing::repaired_model(models / name).shape();
    Bnd_Box box;
    BRepBndLib::Add(shape, box, false);
    const gp_Pnt low = box.CornerMin(), high = box.CornerMax();
    const Vec3 middle{0.5 * (low.X() + high.X()), 0.5 * (low.Y() + high.Y()),
                      0.5 * (low.Z() + high.Z())};
    const PlaneSection section = section_of(shape, middle, {0.3, 1, -0.2});
    EXPECT_FALSE(section.wires.empty()) << name;
    EXPECT_EQ(closed_wires(section), section.wires.size()) << name;
    expect_chained(section);
  }
}

TEST(PlaneSectionOfEdges, WithoutFacesHasTheirPointsBesideWhatFacesHave) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 10, 10).Shape();
  const TopoDS_Edge ring =
      BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2({20, 0, 5}, {0, 1, 0}), 3)).Edge();
  const TopoDS_Edge flat = BRepBuilderAPI_MakeEdge(gp_Pnt(0, 30, 5), gp_Pnt(8, 30, 5)).Edge();
  const PlaneSection section =
      plane_section(faces_of(box), {{0, 0, 5}, {0, 0, 1}}, {}, {ring, flat});
  EXPECT_EQ(section.status, Status::Complete);
  EXPECT_EQ(section.wires.size(), 2u);
  EXPECT_NEAR(total_length(section), 40 + 8, 1e-9);
  EXPECT_NEAR(bounded_area(section).value_or(0), 100, 1e-9);
  ASSERT_EQ(section.points.size(), 2u);
  for (const std::size_t node : section.points)
    EXPECT_NEAR(std::abs(section.nodes[node].point[0] - 20), 3, 1e-7);
}

}  // namespace
}  // namespace blossom::occt
