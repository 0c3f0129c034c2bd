// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids that touch: faces, edges and corners in common, with volumes known by hand. Without
// BLOSSOM_TRIALS some of each kind are tried.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <ostream>
#include <string>
#include <tuple>
#include <vector>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/solid_trim.h"

namespace blossom::occt {
namespace {

constexpr double kPi = std::numbers::pi;

TopoDS_Shape box(const gp_Pnt& from, const gp_Pnt& to) {
  return BRepPrimAPI_MakeBox(from, to).Shape();
}

TopoDS_Shape rod(const gp_Pnt& foot, double radius, double height, const gp_Dir& axis = gp::DZ(),
                 double angle = 2 * kPi) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(foot, axis), radius, height, angle).Shape();
}

// A cylinder whose seam is somewhere else.
TopoDS_Shape turned_rod(const gp_Pnt& foot, double radius, double height, double angle) {
  const gp_Ax2 place(foot, gp::DZ(), gp_Dir(std::cos(angle), std::sin(angle), 0));
  return BRepPrimAPI_MakeCylinder(place, radius, height).Shape();
}

TopoDS_Shape ball(const gp_Pnt& centre, double radius) {
  return BRepPrimAPI_MakeSphere(centre, radius).Shape();
}

// The part of a ball above, or below, its equator.
TopoDS_Shape half_ball(double from, double to) {
  return BRepPrimAPI_MakeSphere(gp_Ax2(), 1, from, to, 2 * kPi).Shape();
}

TopoDS_Shape prism(const std::vector<gp_Pnt>& corners, const gp_Vec& along) {
  BRepBuilderAPI_MakePolygon polygon;
  for (const gp_Pnt& corner : corners) polygon.Add(corner);
  polygon.Close();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(polygon.Wire()).Shape(), along).Shape();
}

TopoDS_Shape turned(const TopoDS_Shape& shape, const gp_Dir& axis, double angle) {
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp::Origin(), axis), angle);
  return BRepBuilderAPI_Transform(shape, turn, true).Shape();
}

double volume(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties, 1e-10);
  return properties.Mass();
}

std::size_t solids(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, TopAbs_SOLID, map);
  return static_cast<std::size_t>(map.Extent());
}

struct Contact {
  std::string name;
  std::function<TopoDS_Shape()> a, b;
  double common = 0;    // volume
  double error = 1e-9;  // of volumes, from images that are fitted
};

std::ostream& operator<<(std::ostream& out, const Contact& contact) { return out << contact.name; }

const gp_Pnt kOrigin(0, 0, 0);
const TopoDS_Shape& cube() {
  static const TopoDS_Shape shape = box(kOrigin, {1, 1, 1});
  return shape;
}
const TopoDS_Shape& plate() {
  static const TopoDS_Shape shape = box({-2, -2, 0}, {2, 2, 1});
  return shape;
}

std::vector<Contact> contacts() {
  const auto whole_cube = [] { return cube(); };
  const auto whole_plate = [] { return plate(); };
  const auto boxed = [](const gp_Pnt& from, const gp_Pnt& to) {
    return [=] { return box(from, to); };
  };
  return {
      {"EqualFaces", whole_cube, boxed({1, 0, 0}, {2, 1, 1})},
      {"PartOfAFace", whole_cube, boxed({1, 0.2, 0.3}, {2, 0.7, 0.8})},
      {"FacesAcross", whole_cube, boxed({1, -1, 0.3}, {2, 2, 0.8})},
      {"ShiftedFaces", whole_cube, boxed({1, 0.5, 0.5}, {2, 1.5, 1.5})},
      {"FaceWithACommonEdge", whole_cube, boxed({1, 0, 0.3}, {2, 0.5, 0.8})},
      {"FlushInOne", whole_cube, boxed({0.3, 0.3, 0.5}, {0.7, 0.7, 1}), 0.08},
      {"FlushInOneAcross", whole_cube, boxed({0.5, 0.2, 0.5}, {1.5, 0.7, 1}), 0.125},
      {"FlushInTwo", whole_cube, boxed({0.5, 0, 0.5}, {1.5, 0.5, 1}), 0.125},
      {"FlushInThree", whole_cube, boxed({0.5, 0.5, 0.5}, {1, 1, 1}), 0.125},
      {"FlushInFour", whole_cube, boxed({0.5, 0, 0}, {1.5, 1, 1}), 0.5},
      {"FlushInFive", whole_cube, boxed(kOrigin, {1, 1, 0.5}), 0.5},
      {"Equal", whole_cube,
       [] {
         return box(kOrigin, {1, 1, 1});
       },
       1},
      {"TheSame", whole_cube, whole_cube, 1},
      {"EdgeToEdge", whole_cube, boxed({1, 1, 0}, {2, 2, 1})},
      {"PartOfAnEdge", whole_cube, boxed({1, 1, 0.25}, {2, 2, 0.75})},
      {"CornerToCorner", whole_cube, boxed({1, 1, 1}, {2, 2, 2})},
      {"CornerOnAFace", whole_cube,
       [] {
         return prism({{0.3, 0.5, 2}, {0.5, 0.5, 1}, {0.7, 0.5, 2}}, {0, 0.3, 0.5});
       }},
      {"WedgeOnItsEdge", whole_plate,
       [] {
         return prism({{-0.5, 0, 1}, {-0.2, -0.5, 2}, {-0.2, 0.5, 2}}, {1, 0, 0});
       }},
      {"WedgeOnAFace", whole_cube,
       [] {
         return prism({{0, 0, 1}, {1, 0, 1}, {0, 0, 2}}, {0, 1, 0});
       }},
      {"WedgeAlongAnEdge", whole_cube,
       [] {
         return prism({{0, 0, 0.5}, {1, 0, 1}, {0, 0, 1.5}}, {0, 1, 0});
       },
       0.25},
      {"PlaneThroughEdges", whole_cube,
       [] {
         return prism({{0, 0, 0}, {1, 0, 1}, {1, 0, 0}}, {0, 1, 0});
       },
       0.5},
      {"CutThroughTwoEdges", whole_cube,
       [] {
         return prism({{-1, -1, -1}, {2, -1, 2}, {-1, -1, 2}}, {0, 3, 0});
       },
       0.5},
      {"CutThroughThreeCorners", whole_cube,
       [] {
         return turned(prism({{-3, -3, 0}, {3, -3, 0}, {3, 3, 0}, {-3, 3, 0}}, {0, 0, 3}),
                       gp_Dir(-1, 1, 0), std::acos(1 / std::sqrt(3.0)));
       },
       1},
      {"Slot", whole_plate, boxed({-0.5, -3, 0.5}, {0.5, 3, 1}), 2},
      {"Pocket", whole_plate, boxed({-0.5, -0.5, 0.5}, {0.5, 0.5, 1}), 0.5},
      {"PocketAtAnEdge", whole_plate, boxed({-0.5, 1, 0.5}, {0.5, 2, 1}), 0.5},
      {"WindowThrough", whole_plate, boxed({-0.5, -0.5, 0}, {0.5, 0.5, 1}), 1},
      {"RodOnAPlate", whole_plate,
       [] {
         return rod({0, 0, 1}, 0.5, 1);
       }},
      {"RodFlushWithThePlate", whole_plate,
       [] {
         return rod({0.3, 0.2, -1}, 0.5, 2);
       },
       kPi / 4},
      {"RodAsThickAsThePlate", whole_plate,
       [] {
         return rod({0.3, 0.2, 0}, 0.5, 1);
       },
       kPi / 4},
      {"RodOnTheBorder", whole_plate,
       [] {
         return rod({2, 0, 1}, 0.5, 1);
       }},
      {"RodInTheBorder", whole_plate,
       [] {
         return rod({2, 0, 0}, 0.5, 1);
       },
       kPi / 8},
      {"RodOnRod", [] { return rod(kOrigin, 1, 1); },
       [] {
         return rod({0, 0, 1}, 1, 1);
       }},
      {"RodOnTurnedRod", [] { return rod(kOrigin, 1, 1); },
       [] {
         return turned_rod({0, 0, 1}, 1, 1, 1);
       }},
      {"ThinRodOnRod", [] { return rod(kOrigin, 1, 1); },
       [] {
         return rod({0, 0, 1}, 0.4, 1);
       }},
      {"RodInRod", [] { return rod(kOrigin, 1, 1); },
       [] {
         return rod({0, 0, 0.5}, 1, 1);
       },
       kPi / 2},
      {"RodInTurnedRod", [] { return rod(kOrigin, 1, 1); },
       [] {
         return turned_rod({0, 0, 0.5}, 1, 1, 1);
       },
       kPi / 2},
      {"EqualRods", [] { return rod(kOrigin, 1, 1); }, [] { return rod(kOrigin, 1, 1); }, kPi},
      {"EqualTurnedRods", [] { return rod(kOrigin, 1, 1); },
       [] { return turned_rod(kOrigin, 1, 1, 2); }, kPi},
      {"HalfRods", [] { return rod(kOrigin, 1, 1, gp::DZ(), kPi); },
       [] { return turned(rod(kOrigin, 1, 1, gp::DZ(), kPi), gp::DZ(), kPi); }},
      {"HalfRodInRod", [] { return rod(kOrigin, 1, 1); },
       [] { return turned(rod(kOrigin, 1, 1, gp::DZ(), kPi), gp::DZ(), 0.5); }, kPi / 2},
      {"QuarterRods", [] { return rod(kOrigin, 1, 1, gp::DZ(), kPi / 2); },
       [] { return turned(rod(kOrigin, 1, 1, gp::DZ(), kPi / 2), gp::DZ(), kPi / 4); }, kPi / 8},
      {"HalfBalls", [] { return half_ball(0, kPi / 2); }, [] { return half_ball(-kPi / 2, 0); }},
      {"BallHalvedByABox", [] { return ball(kOrigin, 1); }, boxed({-2, -2, 0}, {2, 2, 2}),
       2 * kPi / 3},
      {"BallHalvedThroughItsPoles", [] { return ball(kOrigin, 1); }, boxed({-2, 0, -2}, {2, 2, 2}),
       2 * kPi / 3},
      {"BallHalvedAcrossItsSeam", [] { return ball(kOrigin, 1); }, boxed({0, -2, -2}, {2, 2, 2}),
       2 * kPi / 3},
      {"EqualTurnedBalls", [] { return ball(kOrigin, 1); },
       [] { return turned(ball(kOrigin, 1), gp_Dir(1, 2, 3), 0.7); }, 4 * kPi / 3},
      {"EqualBallsWithCommonPoles", [] { return ball(kOrigin, 1); },
       [] { return turned(ball(kOrigin, 1), gp::DZ(), 0.7); }, 4 * kPi / 3},
      {"HalfBallInATurnedBall", [] { return half_ball(0, kPi / 2); },
       [] { return turned(ball(kOrigin, 1), gp_Dir(1, 2, 3), 0.7); }, 2 * kPi / 3},
      {"ConeOnAPlate", whole_plate,
       [] {
         return BRepPrimAPI_MakeCone(gp_Ax2({0, 0, 1}, gp::DZ()), 0.5, 0.2, 1).Shape();
       }},
      {"ConeInAPlate", whole_plate,
       [] { return BRepPrimAPI_MakeCone(gp_Ax2(kOrigin, gp::DZ()), 0.5, 0.2, 1).Shape(); },
       kPi / 3 * (0.25 + 0.1 + 0.04)},
      {"RingOnAPlate", whole_plate,
       [] {
         return BRepPrimAPI_MakeTorus(gp_Ax2({0, 0, 1.25}, gp::DZ()), 1, 0.25).Shape();
       }},
      {"RodLyingOnAPlate", whole_plate,
       [] {
         return rod({-1, 0, 1.5}, 0.5, 2, gp::DX());
       }},
      {"LongRodLyingOnAPlate", whole_plate,
       [] {
         return rod({-3, 0, 1.5}, 0.5, 6, gp::DX());
       }},
      {"BallOnAPlate", whole_plate,
       [] {
         return ball({0, 0, 1.5}, 0.5);
       }},
      {"TurnedBallOnAPlate", whole_plate,
       [] {
         gp_Trsf lift;
         lift.SetTranslation(gp_Vec(0.2, 0.1, 1.5));
         return BRepBuilderAPI_Transform(turned(ball(kOrigin, 0.5), gp_Dir(1, 2, 3), 0.7), lift)
             .Shape();
       }},
      {"BallToBall", [] { return ball(kOrigin, 1); },
       [] {
         return ball({2, 0, 0}, 1);
       }},
      {"RodBesideRod", [] { return rod(kOrigin, 1, 1); },
       [] {
         return rod({2, 0, 0}, 1, 1);
       }},
  };
}

// What only some kinds of geometry do.
std::vector<Contact> more_contacts() {
  const auto whole_cube = [] { return cube(); };
  const auto whole_plate = [] { return plate(); };
  const auto drilled = [] {
    return TopoDS_Shape(BRepAlgoAPI_Cut(plate(), rod({0, 0, -1}, 0.5, 3)).Shape());
  };
  const auto splines = [](const TopoDS_Shape& shape) {
    return BRepBuilderAPI_NurbsConvert(shape, true).Shape();
  };
  const auto frustum = [](double from, double to) {
    return BRepPrimAPI_MakeCone(gp_Ax2({0, 0, from}, gp::DZ()), 2 - from, 2 - to, to - from)
        .Shape();
  };
  const auto rounded = [] {
    constexpr double kRadius = 0.25, kFar = 1 - kRadius;
    BRepBuilderAPI_MakeWire wire;
    for (int i = 0; i < 4; ++i) {
      gp_Trsf turn;
      turn.SetRotation(gp_Ax1({0.5, 0.5, 0}, gp::DZ()), i * kPi / 2);
      const gp_Pnt from(kRadius, 0, 0), to(kFar, 0, 0), centre(kFar, kRadius, 0);
      const gp_Circ arc(gp_Ax2(centre, gp::DZ(), gp_Dir(0, -1, 0)), kRadius);
      wire.Add(BRepBuilderAPI_MakeEdge(from.Transformed(turn), to.Transformed(turn)));
      wire.Add(BRepBuilderAPI_MakeEdge(arc.Transformed(turn), 0, kPi / 2));
    }
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire.Wire()).Shape(), gp_Vec(0, 0, 1))
        .Shape();
  };
  return {
      {"PegInAHole", drilled, [] { return rod(kOrigin, 0.5, 1); }},
      {"TurnedPegInAHole", drilled,
       [] {
         return turned_rod({0, 0, 0.5}, 0.5, 1, 1);
       }},
      {"LongPegInAHole", drilled,
       [] {
         return rod({0, 0, -1}, 0.5, 3);
       }},
      {"HalfPegInAHole", drilled, [] { return rod(kOrigin, 0.5, 1, gp::DZ(), kPi); }},
      {"ThickPegInAHole", drilled, [] { return rod(kOrigin, 1, 1); }, 0.75 * kPi},
      {"FlushAtAnInnerCorner",
       [] {
         return BRepAlgoAPI_Fuse(box({3, 2, 0}, {4, 3, 2}), box({1, 0, 0}, {4, 2, 4})).Shape();
       },
       [] {
         return box({2, 0, 2}, {3, 2, 3});
       },
       2},
      {"ConeOnCone", [=] { return frustum(0, 1); }, [=] { return frustum(1, 1.5); }},
      {"ConeInCone", [=] { return frustum(0, 1); }, [=] { return frustum(0.5, 1.5); },
       kPi / 3 * (2.25 + 1.5 + 1) * 0.5},
      {"HalfRings", [] { return BRepPrimAPI_MakeTorus(2, 0.5, kPi).Shape(); },
       [] { return turned(BRepPrimAPI_MakeTorus(2, 0.5, kPi).Shape(), gp::DZ(), kPi); }},
      {"RoundedCubeInCube", whole_cube, rounded, 1 - 0.25 * 0.25 * (4 - kPi)},
      {"CubeOnRoundedCube", rounded,
       [] {
         return box({1, 0, 0}, {2, 1, 1});
       }},
      {"SplineCubeOnCube", whole_cube,
       [=] {
         return splines(box({1, 0, 0.5}, {2, 1, 1}));
       }},
      {"SplineCubeInCube", whole_cube,
       [=] {
         return splines(box({0.5, 0, 0.5}, {2, 1, 1}));
       },
       0.25},
      {"SplineRodOnAPlate", whole_plate,
       [=] {
         return splines(rod({0, 0, 1}, 0.5, 1));
       }},
      {"SplineRodInRod", [] { return rod(kOrigin, 1, 1); },
       [=] {
         return splines(rod({0, 0, 0.5}, 1, 1));
       },
       kPi / 2, 1e-7},
      {"BallInABoxAtItsWall", whole_plate,
       [] {
         return ball({0, 0, 0.6}, 0.4);
       },
       4 * kPi / 3 * 0.064},
      {"RodInABoxAtItsWall", whole_plate,
       [] {
         return rod({-1, 0, 0.6}, 0.4, 2, gp::DX());
       },
       2 * kPi * 0.16},
      {"ConeOnItsTip", whole_plate,
       [] {
         return BRepPrimAPI_MakeCone(gp_Ax2({0, 0, 1}, gp::DZ()), 0, 0.5, 1).Shape();
       }},
      {"ConeWithItsTipInACorner", whole_cube,
       [] {
         return BRepPrimAPI_MakeCone(gp_Ax2({1, 1, 1}, gp::DZ()), 0, 0.5, 1).Shape();
       }},
      {"RodInACorner", whole_cube,
       [] {
         return rod({0.5, 0.5, 0}, 0.5, 1);
       },
       kPi / 4},
      {"BallInACube", whole_cube,
       [] {
         return ball({0.5, 0.5, 0.5}, 0.5);
       },
       kPi / 6},
  };
}

// Both turned, so that nothing is parallel to an axis.
enum class Place { AsItIs, Turned };

class TrimSolidsInContact : public ::testing::TestWithParam<std::tuple<Contact, Place>> {
 protected:
  TopoDS_Shape placed(const TopoDS_Shape& shape) const {
    return std::get<1>(GetParam()) == Place::AsItIs ? shape : turned(shape, gp_Dir(1, 2, 3), 0.7);
  }
};

std::string words(const SolidTrimResult& result) {
  std::string text;
  for (const std::string& obstacle : result.obstacles) text += obstacle + "; ";
  return text;
}

void expect_solids(const SolidTrimResult& result, double wanted, double error, std::size_t count) {
  ASSERT_EQ(words(result), "");
  double sum = 0;
  for (const TopoDS_Solid& solid : result.solids) {
    EXPECT_TRUE(BRepCheck_Analyzer(solid).IsValid());
    sum += volume(solid);
  }
  EXPECT_NEAR(sum, wanted, error);
  EXPECT_EQ(result.solids.size(), count);
  EXPECT_LE(result.volumes.back().cut_error(), error);
  EXPECT_LE(result.volumes.back().fuse_error(), error);
}

TEST_P(TrimSolidsInContact, HasTheVolumesKnownByHandAndAsManySolidsAsOpenCascade) {
  const Contact& contact = std::get<0>(GetParam());
  const TopoDS_Shape a = placed(contact.a()), b = placed(contact.b());
  const TrimTool part = trim_tool(a), tool = trim_tool(b);
  const double of_a = volume(a), of_b = volume(b), common = contact.common;
  const std::size_t cut = solids(BRepAlgoAPI_Cut(a, b).Shape());
  const std::size_t both = solids(BRepAlgoAPI_Common(a, b).Shape());
  const auto expect = [&](const SolidTrimResult& made, double wanted, std::size_t count) {
    expect_solids(made, wanted, contact.error, count);
  };
  expect(trim_solids(part, {tool}, SolidOperation::Fuse), of_a + of_b - common,
         solids(BRepAlgoAPI_Fuse(a, b).Shape()));
  expect(trim_solids(part, {tool}, SolidOperation::Split), of_a, cut + both);
  expect(trim_solids(tool, {part}, SolidOperation::Cut), of_b - common,
         solids(BRepAlgoAPI_Cut(b, a).Shape()));
}

TopoDS_Shape shifted(const TopoDS_Shape& shape, const gp_Vec& by) {
  gp_Trsf move;
  move.SetTranslation(by);
  return BRepBuilderAPI_Transform(shape, move, true).Shape();
}

// As coordinates come out of a file, or of turning a part there and back.
TEST(TrimSolidsNearlyInContact, CountsAsInContactWithinTheTolerance) {
  const TrimTool part = trim_tool(cube());
  for (const double off : {1e-12, -1e-12, 1e-9, -1e-9, 4e-8, -4e-8}) {
    const gp_Vec by(0.6 * off, 0.5 * off, 0.62 * off);
    const TopoDS_Shape beside = shifted(box({1, 0, 0}, {2, 1, 1}), by);
    const SolidTrimResult fused = trim_solids(part, {trim_tool(beside)}, SolidOperation::Fuse);
    expect_solids(fused, 2, 1e-7, 1);
    const TopoDS_Shape flush = shifted(box({0.5, 0, 0.5}, {1.5, 0.5, 1}), by);
    const SolidTrimResult cut = trim_solids(part, {trim_tool(flush)}, SolidOperation::Cut);
    if (cut.obstacles.empty()) expect_solids(cut, 0.875, 1e-7, 1);
  }
}

// Beyond it results may be refused, but not wrong.
TEST(TrimSolidsNearlyInContact, IsRightOrRefusedBeyondTheTolerance) {
  const TrimTool part = trim_tool(cube());
  for (const double off : {2e-7, -2e-7, 1e-6, -1e-6, 1e-5, -1e-5}) {
    const TopoDS_Shape beside =
        shifted(box({1, 0, 0}, {2, 1, 1}), gp_Vec(0.6 * off, 0.5 * off, 0.62 * off));
    const SolidTrimResult fused = trim_solids(part, {trim_tool(beside)}, SolidOperation::Fuse);
    const double found = fused.obstacles.empty() ? fused.volumes.back().fuse : 2;
    EXPECT_NEAR(found, 2, std::abs(off));
  }
}

// One of each kind, for the quick tests.
bool is_quick(const std::string& name) {
  const std::array names{
      "EqualFaces",       "ShiftedFaces",    "FlushInTwo",           "Equal",
      "EdgeToEdge",       "WedgeOnAFace",    "CutThroughTwoEdges",   "Slot",
      "PocketAtAnEdge",   "RodOnAPlate",     "RodInTheBorder",       "RodInTurnedRod",
      "HalfBalls",        "BallOnAPlate",    "LongRodLyingOnAPlate", "PegInAHole",
      "SplineCubeInCube", "EqualTurnedBalls"};
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::tuple<Contact, Place>> cases(const std::vector<Contact>& all) {
  const bool only_quick = std::getenv("BLOSSOM_TRIALS") == nullptr;
  std::vector<std::tuple<Contact, Place>> chosen;
  for (const Contact& contact : all) {
    if (only_quick && !is_quick(contact.name)) continue;
    chosen.emplace_back(contact, Place::AsItIs);
    if (!only_quick) chosen.emplace_back(contact, Place::Turned);
  }
  return chosen;
}

std::string name_of(const ::testing::TestParamInfo<std::tuple<Contact, Place>>& of) {
  return std::get<0>(of.param).name + (std::get<1>(of.param) == Place::Turned ? "Turned" : "");
}

INSTANTIATE_TEST_SUITE_P(Simple, TrimSolidsInContact, ::testing::ValuesIn(cases(contacts())),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Others, TrimSolidsInContact, ::testing::ValuesIn(cases(more_contacts())),
                         name_of);

}  // namespace
}  // namespace blossom::occt
