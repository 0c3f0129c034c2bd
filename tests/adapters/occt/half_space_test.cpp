// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids cut by planes, with volumes in closed form.
#include "adapters/occt/half_space.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom_Plane.hxx>
#include <gp_GTrsf.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/solid_trim.h"
#include "tests/adapters/occt/solids/solid_contacts.h"

namespace blossom::occt {
namespace {

using testing::box;
using testing::turned;

constexpr double kPi = std::numbers::pi;

double volume(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties, 1e-10);
  return properties.Mass();
}

SolidTrimResult cut(const TopoDS_Shape& part, const std::vector<Plane>& planes,
                    SolidOperation operation) {
  std::vector<TrimTool> tools;
  for (const Plane& plane : planes) tools.push_back(half_space_tool(plane, part, "plane"));
  return trim_solids(trim_tool(part), tools, operation);
}

double total(const SolidTrimResult& made) {
  double sum = 0;
  for (const TopoDS_Solid& solid : made.solids) sum += volume(solid);
  return sum;
}

// Cut keeps what is below, common what is above, and split both.
void expect_parts(const TopoDS_Shape& part, const Plane& plane, double below, double above,
                  double error = 1e-9) {
  const double whole = below + above;
  const SolidTrimResult lower = cut(part, {plane}, SolidOperation::Cut);
  EXPECT_TRUE(lower.obstacles.empty()) << lower.obstacles.front();
  EXPECT_NEAR(total(lower), below, error * whole);
  const SolidTrimResult upper = cut(part, {plane}, SolidOperation::Common);
  EXPECT_TRUE(upper.obstacles.empty()) << upper.obstacles.front();
  EXPECT_NEAR(total(upper), above, error * whole);
  const SolidTrimResult both = cut(part, {plane}, SolidOperation::Split);
  EXPECT_TRUE(both.obstacles.empty()) << both.obstacles.front();
  EXPECT_NEAR(total(both), whole, error * whole);
  EXPECT_EQ(both.solids.size(), lower.solids.size() + upper.solids.size());
  for (const TopoDS_Solid& solid : both.solids) EXPECT_TRUE(BRepCheck_Analyzer(solid).IsValid());
}

const Plane kUp{{0, 0, 0.5}, {0, 0, 1}};

TEST(HalfSpace, DividesABox) {
  expect_parts(box(gp_Pnt(0, 0, 0), gp_Pnt(2, 3, 4)), kUp, 3, 21);
  expect_parts(box(gp_Pnt(0, 0, 0), gp_Pnt(2, 3, 4)), {{0, 0, 0.5}, {0, 0, -7}}, 21, 3);
}

// The cap of height h of a ball of radius r has pi h^2 (3 r - h) / 3.
TEST(HalfSpace, CutsACapOffABall) {
  const double cap = kPi * 0.25 * 2.5 / 3, whole = 4 * kPi / 3;
  expect_parts(BRepPrimAPI_MakeSphere(1).Shape(), kUp, whole - cap, cap);
  expect_parts(BRepPrimAPI_MakeSphere(1).Shape(), {{0.5, 0, 0}, {1, 0, 0}}, whole - cap, cap);
}

TEST(HalfSpace, DividesACylinderAcrossAlongAndAslant) {
  const TopoDS_Shape part = BRepPrimAPI_MakeCylinder(1, 4).Shape();
  expect_parts(part, kUp, 0.5 * kPi, 3.5 * kPi);
  const double segment = std::acos(0.5) - 0.5 * std::sqrt(0.75);
  expect_parts(part, {{0.5, 0, 0}, {1, 0, 0}}, 4 * (kPi - segment), 4 * segment);
  expect_parts(part, {{0, 0, 2}, {0.3, 0.1, 1}}, 2 * kPi, 2 * kPi);
}

TEST(HalfSpace, CutsAConeIntoAFrustumAndATip) {
  const auto cone = [](double r, double h) { return kPi * r * r * h / 3; };
  expect_parts(BRepPrimAPI_MakeCone(1, 0, 2).Shape(), kUp, cone(1, 2) - cone(0.75, 1.5),
               cone(0.75, 1.5));
}

TEST(HalfSpace, DividesATorus) {
  const TopoDS_Shape ring = BRepPrimAPI_MakeTorus(3, 1).Shape();
  const double whole = 2 * kPi * kPi * 3;
  expect_parts(ring, {{0, 0, 0}, {0, 0, 1}}, whole / 2, whole / 2);
  expect_parts(ring, {{0, 0, 0}, {1, 0, 0}}, whole / 2, whole / 2);
  EXPECT_EQ(cut(ring, {{{0, 0, 0}, {1, 0, 0}}}, SolidOperation::Cut).solids.size(), 1U);
  const double segment = std::acos(0.5) - 0.5 * std::sqrt(0.75);  // of the tube, above z = 1/2
  expect_parts(ring, kUp, whole - 2 * kPi * 3 * segment, 2 * kPi * 3 * segment);
}

TEST(HalfSpace, CutsACapOffAnEllipsoid) {
  gp_GTrsf stretch;
  stretch.SetValue(1, 1, 3);
  stretch.SetValue(2, 2, 2);
  const TopoDS_Shape part =
      BRepBuilderAPI_GTransform(BRepPrimAPI_MakeSphere(1).Shape(), stretch, true).Shape();
  const double cap = 6 * kPi * 0.25 * 2.5 / 3;
  // The edge of the section is fitted within the tolerance of 1e-7.
  expect_parts(part, kUp, 8 * kPi - cap, cap, 1e-7);
}

TEST(HalfSpace, CutsNothingOffWhereItOnlyTouches) {
  const TopoDS_Shape part = box(gp_Pnt(0, 0, 0), gp_Pnt(1, 1, 1));
  expect_parts(part, {{0, 0, 1}, {0, 0, 1}}, 1, 0);
  expect_parts(part, {{0, 0, 0}, {0, 0, 1}}, 0, 1);
  expect_parts(part, {{1, 1, 0}, {1, 1, 0}}, 1, 0);
  expect_parts(part, {{1, 1, 1}, {1, 1, 1}}, 1, 0);
  const double ball = 4 * kPi / 3;
  expect_parts(BRepPrimAPI_MakeSphere(1).Shape(), {{0, 0, 1}, {0, 0, 1}}, ball, 0);
  expect_parts(BRepPrimAPI_MakeSphere(1).Shape(), {{1, 0, 0}, {1, 0, 0}}, ball, 0);
  expect_parts(BRepPrimAPI_MakeCylinder(1, 2).Shape(), {{0, 1, 0}, {0, 1, 0}}, 2 * kPi, 0);
}

TEST(HalfSpace, MissesWhatItDoesNotReach) {
  const TopoDS_Shape part = box(gp_Pnt(0, 0, 0), gp_Pnt(1, 1, 1));
  expect_parts(part, {{0, 0, 1e3}, {0, 0, 1}}, 1, 0);
  expect_parts(part, {{0, 0, -1e3}, {0, 1e-3, 1}}, 0, 1);
}

TEST(HalfSpace, DividesThroughEdgesAndVertices) {
  const TopoDS_Shape part = box(gp_Pnt(0, 0, 0), gp_Pnt(1, 1, 1));
  expect_parts(part, {{0, 0, 0}, {1, -1, 0}}, 0.5, 0.5);
  expect_parts(part, {{1, 0, 0}, {1, 1, 1}}, 1.0 / 6, 5.0 / 6);
  // x + y > z: of each height z < 1 all but the triangle x + y < z.
  expect_parts(part, {{0, 0, 0}, {1, 1, -1}}, 1.0 / 6, 5.0 / 6);
}

TEST(HalfSpaces, DivideOneAfterTheOther) {
  const TopoDS_Shape part = box(gp_Pnt(-1, -1, -1), gp_Pnt(1, 1, 1));
  const std::vector<Plane> planes{
      {{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {0, 1, 0}}, {{0, 0, 0}, {0, 0, 1}}};
  const SolidTrimResult pieces = cut(part, planes, SolidOperation::Split);
  EXPECT_TRUE(pieces.obstacles.empty());
  ASSERT_EQ(pieces.solids.size(), 8U);
  for (const TopoDS_Solid& piece : pieces.solids) {
    EXPECT_NEAR(volume(piece), 1, 1e-12);
    EXPECT_TRUE(BRepCheck_Analyzer(piece).IsValid());
  }
  EXPECT_NEAR(total(cut(part, planes, SolidOperation::Common)), 1, 1e-12);
  EXPECT_NEAR(total(cut(part, planes, SolidOperation::Cut)), 1, 1e-12);
}

TEST(HalfSpaces, SplitWhatOtherToolsHaveSplit) {
  const TopoDS_Shape part = box(gp_Pnt(-2, -2, -2), gp_Pnt(2, 2, 2));
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(1).Shape();
  const SolidTrimResult pieces =
      trim_solids(trim_tool(part),
                  {trim_tool(ball), half_space_tool({{0, 0, 0.5}, {0, 0, 1}}, part, "plane 1")},
                  SolidOperation::Split);
  EXPECT_TRUE(pieces.obstacles.empty());
  ASSERT_EQ(pieces.solids.size(), 4U);
  EXPECT_NEAR(total(pieces), 64, 1e-9);
}

// No face of the result is one of the box beyond the part.
TEST(HalfSpace, GivesItsPlaneAndNoOtherFace) {
  const Plane plane{{0.1, 0.2, 0.3}, {1, 2, 3}};
  const SolidTrimResult made =
      cut(box(gp_Pnt(-1, -1, -1), gp_Pnt(1, 1, 1)), {plane}, SolidOperation::Cut);
  int caps = 0;
  for (const SolidFace& face : made.faces) {
    if (face.tool < 0) continue;
    ++caps;
    EXPECT_EQ(face.from, 0);
    const auto surface = Handle(Geom_Plane)::DownCast(BRep_Tool::Surface(face.face));
    ASSERT_FALSE(surface.IsNull());
    EXPECT_TRUE(surface->Location().IsEqual(gp_Pnt(0.1, 0.2, 0.3), 0));
    EXPECT_LE(surface->Pln().Axis().Direction().Angle(gp_Dir(1, 2, 3)), 1e-15);
  }
  EXPECT_EQ(caps, 1);
}

TEST(HalfSpace, IsRefusedWithoutADirection) {
  const TopoDS_Shape part = box(gp_Pnt(0, 0, 0), gp_Pnt(1, 1, 1));
  EXPECT_THROW(half_space_tool({{0, 0, 0}, {0, 0, 0}}, part, ""), BadModel);
  EXPECT_THROW(plane_tool({{0, std::numeric_limits<double>::quiet_NaN(), 0}, {0, 0, 1}}, part, ""),
               BadModel);
}

}  // namespace
}  // namespace blossom::occt
