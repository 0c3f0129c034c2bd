// SPDX-License-Identifier: LGPL-2.1-or-later
// Contacts that are decided exactly: faces on one surface, edges and corners in common. Volumes are
// closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pln.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/intersection.h"
#include "adapters/occt/solid_trim.h"
#include "tests/adapters/occt/solids/solid_contacts.h"

namespace blossom::occt {
namespace {

using testing::box;

constexpr double kPi = std::numbers::pi;

TopoDS_Shape rod(double z, double radius, double height) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2({0, 0, z}, gp::DZ()), radius, height).Shape();
}

TopoDS_Shape plate_with_bore() {
  return BRepAlgoAPI_Cut(box({-10, -10, 0}, {10, 10, 5}), rod(-1, 3, 7)).Shape();
}

struct Contact {
  std::string name;
  TopoDS_Shape a, b;
  double of_a, of_b, common;
};

std::vector<Contact> contacts() {
  const TopoDS_Shape cube = box({0, 0, 0}, {10, 10, 10});
  const auto beside = [&](std::string name, const gp_Pnt& from, const gp_Pnt& to, double common) {
    const double volume = (to.X() - from.X()) * (to.Y() - from.Y()) * (to.Z() - from.Z());
    return Contact{std::move(name), cube, box(from, to), 1000, volume, common};
  };
  return {
      beside("AFace", {10, 0, 0}, {20, 10, 10}, 0),
      beside("PartOfAFace", {10, 2, 3}, {20, 7, 7}, 0),
      beside("AShiftedFace", {10, 5, 0}, {20, 15, 10}, 0),
      beside("AFaceShiftedTwice", {10, 5, 5}, {20, 15, 15}, 0),
      beside("AnEdge", {10, 10, 0}, {20, 20, 10}, 0),
      beside("PartOfAnEdge", {10, 10, 4}, {15, 15, 7}, 0),
      beside("AVertex", {10, 10, 10}, {20, 20, 20}, 0),
      beside("ACornerInside", {0, 0, 0}, {4, 4, 4}, 64),
      beside("AFaceInside", {2, 2, 6}, {6, 6, 10}, 64),
      beside("AnEdgeInside", {6, 2, 6}, {10, 6, 10}, 64),
      beside("TheUpperHalf", {0, 0, 5}, {10, 10, 15}, 500),
      beside("AStep", {5, 0, 5}, {15, 10, 15}, 250),
      {"RodsOnEachOther", rod(0, 5, 10), rod(10, 3, 10), 250 * kPi, 90 * kPi, 0},
      {"EqualRodsOnEachOther", rod(0, 5, 10), rod(10, 5, 10), 250 * kPi, 250 * kPi, 0},
      {"RodsInEachOther", rod(0, 5, 10), rod(6, 5, 10), 250 * kPi, 250 * kPi, 100 * kPi},
      {"ARodInABore", plate_with_bore(), rod(0, 3, 5), 2000 - 45 * kPi, 45 * kPi, 0},
      {"ARodThroughABore", plate_with_bore(), rod(-5, 3, 15), 2000 - 45 * kPi, 135 * kPi, 0},
  };
}

// Turned and moved as placements of parts are, so that no number is whole.
TopoDS_Shape placed(const TopoDS_Shape& shape) {
  gp_Trsf turn, move;
  turn.SetRotation(gp_Ax1({1, 2, 3}, gp_Dir(1, 2, 2)), kPi / 6);
  move.SetTranslation(gp_Vec(12.3, -7.7, 0.1));
  return BRepBuilderAPI_Transform(shape, move * turn, true).Shape();
}

std::string reasons(const SolidTrimResult& result) {
  std::string text;
  for (const std::string& reason : result.certificate.reasons) text += reason + "; ";
  return text;
}

class ExactContacts : public ::testing::TestWithParam<std::tuple<Contact, bool>> {};

TEST_P(ExactContacts, AreCompleteAndHaveTheVolumesOfClosedForms) {
  const auto& [contact, moved] = GetParam();
  const TrimTool part = trim_tool(moved ? placed(contact.a) : contact.a);
  const TrimTool tool = trim_tool(moved ? placed(contact.b) : contact.b);
  const double error = 1e-9 * (contact.of_a + contact.of_b);
  for (const SolidOperation operation :
       {SolidOperation::Fuse, SolidOperation::Cut, SolidOperation::Common, SolidOperation::Split}) {
    const SolidTrimResult made = trim_solids(part, {tool}, operation);
    ASSERT_TRUE(made.obstacles.empty()) << made.obstacles.front();
    EXPECT_EQ(made.status, Status::Complete) << reasons(made);
    const SolidVolumes& volumes = made.volumes.back();
    EXPECT_NEAR(volumes.common, contact.common, error);
    EXPECT_NEAR(volumes.cut, contact.of_a - contact.common, error);
    EXPECT_NEAR(volumes.fuse, contact.of_a + contact.of_b - contact.common, error);
    EXPECT_GT(made.certificate.identified, 0);
    EXPECT_LE(made.certificate.identified_within, 1e-12 * 100);
  }
}

INSTANTIATE_TEST_SUITE_P(Solids, ExactContacts,
                         ::testing::Combine(::testing::ValuesIn(contacts()), ::testing::Bool()),
                         [](const auto& of) {
                           return std::get<0>(of.param).name +
                                  (std::get<1>(of.param) ? "Placed" : "");
                         });

// Lines in which sides of boxes cross are as long as the sides, even if all they share is a corner.
TEST(FacesOfBoxesInContact, AreDecidedExactlyWithoutGoingBeyondTheirTrims) {
  for (const Contact& contact : contacts()) {
    if (contact.name.find("Rod") != std::string::npos) continue;
    const ShapeIntersection found =
        intersect(trim_tool(contact.a).faces, trim_tool(contact.b).faces, {}, Extent::Trims);
    EXPECT_EQ(found.status, Status::Complete) << contact.name;
    EXPECT_FALSE(found.pairs.empty()) << contact.name;
  }
}

TopoDS_Shape half_torus(bool upper) {
  return BRepPrimAPI_MakeTorus(gp_Ax2({0, 0, 0}, gp::DZ()), 5, 2, upper ? 0 : -kPi,
                               upper ? kPi : 0);
}

// A rim of one face that runs along the other one is found as what lies inside of it is.
TEST(FacesOfRoundSolidsInContact, AreDecidedExactly) {
  std::vector<Contact> all = contacts();
  all.push_back({"HalvesOfATorus", half_torus(true), half_torus(false), 0, 0, 0});
  for (const Contact& contact : all)
    for (const bool moved : {false, true}) {
      const auto faces = [&](const TopoDS_Shape& shape) {
        return trim_tool(moved ? placed(shape) : shape).faces;
      };
      const ShapeIntersection found = intersect(faces(contact.a), faces(contact.b));
      EXPECT_EQ(found.status, Status::Complete)
          << contact.name << ' ' << ::testing::PrintToString(found.certificate.reasons);
      EXPECT_FALSE(found.pairs.empty()) << contact.name;
    }
}

// --- beside the rule

Status status_of_boxes(double off, double tilt = 0) {
  gp_Trsf move, turn;
  move.SetTranslation(gp_Vec(off, 0, 0));
  turn.SetRotation(gp_Ax1({1000, 0, 0}, gp::DY()), tilt);
  const TopoDS_Shape beside =
      BRepBuilderAPI_Transform(box({1000, 0, 0}, {2000, 1000, 1000}), move * turn, true).Shape();
  return trim_solids(trim_tool(box({0, 0, 0}, {1000, 1000, 1000})), {trim_tool(beside)},
                     SolidOperation::Fuse)
      .status;
}

TEST(FacesBesideEachOther, AreOneOnlyWithinTheRule) {
  EXPECT_EQ(status_of_boxes(0), Status::Complete);
  EXPECT_EQ(status_of_boxes(1e-9), Status::Complete);
  EXPECT_EQ(status_of_boxes(6e-8), Status::Tolerance);
  EXPECT_EQ(status_of_boxes(0, 8e-11), Status::Tolerance);
}

ShapeIntersection squares(double apart, double tilt, double x) {
  const TopoDS_Face a = BRepBuilderAPI_MakeFace(gp_Pln(), 0, 1000, 0, 1000);
  const gp_Pln plane({0, 0, apart}, gp_Dir(std::sin(tilt), 0, std::cos(tilt)));
  const TopoDS_Face b = BRepBuilderAPI_MakeFace(plane, x, x + 1000, 0, 1000);
  return intersect({a}, {b});
}

// What is apart is told to be, or to be within tolerance; never to be one.
TEST(PlanesBesideEachOther, AreOneOnlyWithinTheRule) {
  for (const double off : {0.0, 1e-10, -5e-9}) {
    const ShapeIntersection found = squares(off, 0, 500);
    EXPECT_EQ(found.status, Status::Complete) << off;
    ASSERT_EQ(found.pairs.size(), 1u) << off;
    EXPECT_EQ(found.pairs.front().found.overlaps.size(), 1u) << off;
  }
  for (const auto& [off, tilt] : {std::pair{5e-8, 0.0},
                                  {1e-6, 0.0},
                                  {2e-6, 1e-9},
                                  {-1e-3, 1e-9},
                                  {1e-6, 1e-9},
                                  {0.0, 1e-9}}) {
    const ShapeIntersection found = squares(off, tilt, 500);
    if (found.status != Status::Complete) continue;
    for (const FaceIntersection& pair : found.pairs)
      EXPECT_TRUE(pair.found.overlaps.empty()) << off << ' ' << tilt;
  }
}

// Of two squares in one plane: whether their sides are one is told as that of the planes is.
TEST(SidesInOnePlane, AreOneOnlyWithinTheRule) {
  for (const double off : {0.0, 1e-10, -1e-10}) {
    const ShapeIntersection found = squares(0, 0, 1000 + off);
    EXPECT_EQ(found.status, Status::Complete) << off;
    ASSERT_EQ(found.pairs.size(), 1u);
    EXPECT_TRUE(found.pairs.front().found.overlaps.empty());
    ASSERT_EQ(found.pairs.front().found.curves.size(), 1u);
    EXPECT_TRUE(found.pairs.front().found.curves.front().tangential);
    EXPECT_NEAR(found.pairs.front().found.curves.front().length, 1000, 1e-9);
  }
  for (const double off : {6e-8, -6e-8})
    EXPECT_EQ(squares(0, 0, 1000 + off).status, Status::Tolerance) << off;
  const ShapeIntersection apart = squares(0, 0, 1000 + 1e-6);
  EXPECT_TRUE(apart.status == Status::Complete && apart.pairs.empty());
}

}  // namespace
}  // namespace blossom::occt
