// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/adapters/occt/solids/solid_contacts.h"
#include "tests/support/measures.h"

#include <cmath>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFill.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <TopoDS.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>
#include <gp_Trsf.hxx>

namespace blossom::testing {
namespace {

using Maker = std::function<TopoDS_Shape()>;

using testing::kPi;
const gp_Pnt kOrigin(0, 0, 0);
constexpr double kOverEllipses = 5e-8;    // of volumes, by the integrals of Open CASCADE
constexpr double kOverHyperbolas = 5e-8;  // of volumes, above curves that are fitted

TopoDS_Shape whole_cube() {
  static const TopoDS_Shape shape = box(kOrigin, {1, 1, 1});
  return shape;
}

TopoDS_Shape whole_plate() {
  static const TopoDS_Shape shape = box({-2, -2, 0}, {2, 2, 1});
  return shape;
}

Maker boxed(const gp_Pnt& from, const gp_Pnt& to) {
  return [=] { return box(from, to); };
}

Maker rod(const gp_Pnt& foot, double radius, double height, const gp_Dir& axis = gp::DZ(),
          double angle = 2 * kPi) {
  return
      [=] { return BRepPrimAPI_MakeCylinder(gp_Ax2(foot, axis), radius, height, angle).Shape(); };
}

// A cylinder whose seam is somewhere else.
Maker turned_rod(const gp_Pnt& foot, double radius, double height, double angle) {
  const gp_Ax2 place(foot, gp::DZ(), gp_Dir(std::cos(angle), std::sin(angle), 0));
  return [=] { return BRepPrimAPI_MakeCylinder(place, radius, height).Shape(); };
}

Maker ball(const gp_Pnt& centre, double radius) {
  return [=] { return BRepPrimAPI_MakeSphere(centre, radius).Shape(); };
}

// The part of a ball above, or below, its equator.
Maker half_ball(double from, double to) {
  return [=] { return BRepPrimAPI_MakeSphere(gp_Ax2(), 1, from, to, 2 * kPi).Shape(); };
}

// The part of a ball between two half planes through its poles, the first one at y = 0 < x, and
// perhaps only above its equator.
Maker wedge(double angle, double from = -kPi / 2) {
  return [=] { return BRepPrimAPI_MakeSphere(gp_Ax2(), 1, from, kPi / 2, angle).Shape(); };
}

Maker cone(const gp_Pnt& foot, double low, double high, double height, double angle = 2 * kPi) {
  return [=] {
    return BRepPrimAPI_MakeCone(gp_Ax2(foot, gp::DZ()), low, high, height, angle).Shape();
  };
}

// Of the cone with its tip at height 2.
Maker frustum(double from, double to) { return cone({0, 0, from}, 2 - from, 2 - to, to - from); }

Maker ring(const gp_Pnt& centre, double large, double small, double angle = 2 * kPi) {
  return
      [=] { return BRepPrimAPI_MakeTorus(gp_Ax2(centre, gp::DZ()), large, small, angle).Shape(); };
}

Maker prism(const std::vector<gp_Pnt>& corners, const gp_Vec& along) {
  return [=] {
    BRepBuilderAPI_MakePolygon polygon;
    for (const gp_Pnt& corner : corners) polygon.Add(corner);
    polygon.Close();
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(polygon.Wire()).Shape(), along).Shape();
  };
}

// One unit high, above an ellipse.
Maker elliptic_rod(double height, double major, double minor) {
  return [=] {
    const gp_Elips outline(gp_Ax2(gp_Pnt(0, 0, height), gp::DZ(), gp_Dir(1, 0.3, 0)), major, minor);
    const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(outline);
    const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(edge);
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire).Shape(), gp_Vec(0, 0, 1)).Shape();
  };
}

Maker turning(const Maker& make, const gp_Dir& axis, double angle) {
  return [=] { return turned(make(), axis, angle); };
}

Maker lifted(const Maker& make, const gp_Vec& by) {
  return [=] {
    gp_Trsf lift;
    lift.SetTranslation(by);
    return BRepBuilderAPI_Transform(make(), lift).Shape();
  };
}

Maker splines(const Maker& make) {
  return [=] { return BRepBuilderAPI_NurbsConvert(make(), true).Shape(); };
}

// Of two balls whose surfaces are square to each other.
double lens(double a, double b) {
  const double apart = std::hypot(a, b);
  const auto cap = [&](double radius) {
    const double height = radius - radius * radius / apart;
    return kPi * height * height * (3 * radius - height) / 3;
  };
  return cap(a) + cap(b);
}

TopoDS_Shape drilled_plate() {
  return BRepAlgoAPI_Cut(whole_plate(), rod({0, 0, -1}, 0.5, 3)()).Shape();
}

TopoDS_Shape rounded_cube() {
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
}

// A cube with a hollow whose seam goes through (0.25, 0, 0).
TopoDS_Shape hollow_cube() {
  const gp_Pnt centre(0.25, 0.25, 0);
  const gp_Ax2 place(centre, gp::DZ(), gp_Dir(0, -1, 0));
  return BRepAlgoAPI_Cut(box({-0.25, -0.25, -0.5}, {0.75, 0.75, 0.5}),
                         BRepPrimAPI_MakeSphere(place, 0.25).Shape())
      .Shape();
}

// What a plane 0.25 from its axis leaves of a frustum one unit high with radii from 0.5 to 0.25: 4
// times the integral of a disc without its segment over the radius.
double flattened_frustum() {
  constexpr double kOff = 0.25, kLarge = 0.5;
  const double half_chord = std::sqrt(kLarge * kLarge - kOff * kOff);
  const double product = kOff * half_chord;
  const double logarithm = kOff * kOff / 2 * std::log((kLarge + half_chord) / kOff);
  const double segments = kLarge * kLarge * kLarge / 3 * std::acos(kOff / kLarge) -
                          kOff / 3 * (product + logarithm) - kOff * (product - logarithm);
  return kPi / 3 * (0.25 + 0.125 + 0.0625) - 4 * segments;
}

TopoDS_Shape two_boxes() {
  return BRepAlgoAPI_Fuse(box({3, 2, 0}, {4, 3, 2}), box({1, 0, 0}, {4, 2, 4})).Shape();
}

const gp_Dir kOblique(1, 2, 3);

}  // namespace

TopoDS_Shape box(const gp_Pnt& from, const gp_Pnt& to) {
  return BRepPrimAPI_MakeBox(from, to).Shape();
}

TopoDS_Shape turned(const TopoDS_Shape& shape, const gp_Dir& axis, double angle) {
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp::Origin(), axis), angle);
  return BRepBuilderAPI_Transform(shape, turn, true).Shape();
}

std::vector<SolidContact> box_contacts() {
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
      {"Equal", whole_cube, boxed(kOrigin, {1, 1, 1}), 1},
      {"TheSame", whole_cube, whole_cube, 1},
      {"EdgeToEdge", whole_cube, boxed({1, 1, 0}, {2, 2, 1})},
      {"PartOfAnEdge", whole_cube, boxed({1, 1, 0.25}, {2, 2, 0.75})},
      {"CornerToCorner", whole_cube, boxed({1, 1, 1}, {2, 2, 2})},
      {"Slot", whole_plate, boxed({-0.5, -3, 0.5}, {0.5, 3, 1}), 2},
      {"Pocket", whole_plate, boxed({-0.5, -0.5, 0.5}, {0.5, 0.5, 1}), 0.5},
      {"PocketAtAnEdge", whole_plate, boxed({-0.5, 1, 0.5}, {0.5, 2, 1}), 0.5},
      {"WindowThrough", whole_plate, boxed({-0.5, -0.5, 0}, {0.5, 0.5, 1}), 1},
  };
}

std::vector<SolidContact> prism_contacts() {
  const Maker triangle = prism({{0.3, 0.5, 2}, {0.5, 0.5, 1}, {0.7, 0.5, 2}}, {0, 0.3, 0.5});
  const Maker on_its_edge = prism({{-0.5, 0, 1}, {-0.2, -0.5, 2}, {-0.2, 0.5, 2}}, {1, 0, 0});
  const Maker on_a_face = prism({{0, 0, 1}, {1, 0, 1}, {0, 0, 2}}, {0, 1, 0});
  const Maker along_an_edge = prism({{0, 0, 0.5}, {1, 0, 1}, {0, 0, 1.5}}, {0, 1, 0});
  const Maker half = prism({{0, 0, 0}, {1, 0, 1}, {1, 0, 0}}, {0, 1, 0});
  const Maker through_edges = prism({{-1, -1, -1}, {2, -1, 2}, {-1, -1, 2}}, {0, 3, 0});
  const Maker through_corners =
      turning(prism({{-3, -3, 0}, {3, -3, 0}, {3, 3, 0}, {-3, 3, 0}}, {0, 0, 3}), gp_Dir(-1, 1, 0),
              std::acos(1 / std::sqrt(3.0)));
  return {
      {"CornerOnAFace", whole_cube, triangle},
      {"WedgeOnItsEdge", whole_plate, on_its_edge},
      {"WedgeOnAFace", whole_cube, on_a_face},
      {"WedgeAlongAnEdge", whole_cube, along_an_edge, 0.25},
      {"PlaneThroughEdges", whole_cube, half, 0.5},
      {"CutThroughTwoEdges", whole_cube, through_edges, 0.5},
      {"CutThroughThreeCorners", whole_cube, through_corners, 1},
  };
}

std::vector<SolidContact> rod_contacts() {
  const Maker whole = rod(kOrigin, 1, 1), half = rod(kOrigin, 1, 1, gp::DZ(), kPi),
              quarter = rod(kOrigin, 1, 1, gp::DZ(), kPi / 2);
  return {
      {"RodOnAPlate", whole_plate, rod({0, 0, 1}, 0.5, 1)},
      {"RodFlushWithThePlate", whole_plate, rod({0.3, 0.2, -1}, 0.5, 2), kPi / 4},
      {"RodAsThickAsThePlate", whole_plate, rod({0.3, 0.2, 0}, 0.5, 1), kPi / 4},
      {"RodOnTheBorder", whole_plate, rod({2, 0, 1}, 0.5, 1)},
      {"RodInTheBorder", whole_plate, rod({2, 0, 0}, 0.5, 1), kPi / 8},
      {"RodOnRod", whole, rod({0, 0, 1}, 1, 1)},
      {"RodOnTurnedRod", whole, turned_rod({0, 0, 1}, 1, 1, 1)},
      {"RodOnAnEllipse", whole, elliptic_rod(1, 1.003, 0.997), 0, kOverEllipses},
      {"ThinRodOnRod", whole, rod({0, 0, 1}, 0.4, 1)},
      {"RodInRod", whole, rod({0, 0, 0.5}, 1, 1), kPi / 2},
      {"RodInTurnedRod", whole, turned_rod({0, 0, 0.5}, 1, 1, 1), kPi / 2},
      {"EqualRods", whole, whole, kPi},
      {"EqualTurnedRods", whole, turned_rod(kOrigin, 1, 1, 2), kPi},
      {"HalfRods", half, turning(half, gp::DZ(), kPi)},
      {"HalfRodInRod", whole, turning(half, gp::DZ(), 0.5), kPi / 2},
      {"QuarterRods", quarter, turning(quarter, gp::DZ(), kPi / 4), kPi / 8},
      {"RodLyingOnAPlate", whole_plate, rod({-1, 0, 1.5}, 0.5, 2, gp::DX())},
      {"LongRodLyingOnAPlate", whole_plate, rod({-3, 0, 1.5}, 0.5, 6, gp::DX())},
      {"RodBesideRod", whole, rod({2, 0, 0}, 1, 1)},
      // Along an edge of the end, and on beyond its corner.
      {"RodOnTheEndOfAPartOfARod", rod({0, 2, -0.5}, 2, 1.5),
       rod(kOrigin, 3, 2, gp::DY().Reversed(), 1.5 * kPi)},
      {"RodInABoxAtItsWall", whole_plate, rod({-1, 0, 0.6}, 0.4, 2, gp::DX()), 2 * kPi * 0.16},
      {"RodInACorner", whole_cube, rod({0.5, 0.5, 0}, 0.5, 1), kPi / 4},
  };
}

std::vector<SolidContact> ball_contacts() {
  const Maker whole = ball(kOrigin, 1), above = half_ball(0, kPi / 2);
  const Maker small = lifted(turning(ball(kOrigin, 0.5), kOblique, 0.7), {0.2, 0.1, 1.5});
  const double volume = 4 * kPi / 3;
  return {
      {"HalfBalls", above, half_ball(-kPi / 2, 0)},
      {"BallHalvedByABox", whole, boxed({-2, -2, 0}, {2, 2, 2}), volume / 2, 1e-8},
      {"BallHalvedThroughItsPoles", whole, boxed({-2, 0, -2}, {2, 2, 2}), volume / 2},
      {"BallHalvedAcrossItsSeam", whole, boxed({0, -2, -2}, {2, 2, 2}), volume / 2, 1e-8},
      {"EqualTurnedBalls", whole, turning(whole, kOblique, 0.7), volume},
      {"EqualBallsWithCommonPoles", whole, turning(whole, gp::DZ(), 0.7), volume},
      {"EqualTurnedHalfBalls", above, turning(above, gp::DZ(), 0.7), volume / 2},
      {"HalfBallInATurnedBall", above, turning(whole, kOblique, 0.7), volume / 2},
      {"BallOnAPlate", whole_plate, ball({0, 0, 1.5}, 0.5)},
      {"TurnedBallOnAPlate", whole_plate, small},
      {"BallToBall", whole, ball({2, 0, 0}, 1)},
      {"BallInABoxAtItsWall", whole_plate, ball({0, 0, 0.6}, 0.4), volume * 0.064},
      {"BallsWithACommonCornerOfPatches",
       lifted(turning(whole, gp_Dir(1, 1, 1), 2 * kPi / 3), {-0.5, 0, 0.5}),
       ball({0, 0, -0.5}, 0.5), lens(1, 0.5), 1e-7},
      {"BallInACube", whole_cube, ball({0.5, 0.5, 0.5}, 0.5), kPi / 6},
  };
}

std::vector<SolidContact> wedge_contacts() {
  const Maker half = wedge(kPi), quarter = wedge(kPi / 2), dome = wedge(kPi, 0),
              half_cone = cone(kOrigin, 1, 0, 1, kPi);
  return {
      {"WedgesTurnedRoundTheirPoles", half, turning(half, gp::DZ(), 0.7), 2 * (kPi - 0.7) / 3},
      {"WedgesSquareToEachOther", half, turning(half, gp::DZ(), kPi / 2), kPi / 3},
      {"WedgesBackToBack", half, turning(half, gp::DZ(), kPi)},
      {"WedgesWithTheirPolesInBorders", half, turning(half, gp::DY(), 0.7), 2 * kPi / 3},
      {"WedgesWithPolesOnPoles", half, turning(half, gp::DX(), kPi)},
      {"WedgesWithTheirAxesAcross", half, turning(half, gp::DX(), 0.7), 2 * (kPi - 0.7) / 3},
      {"QuartersRoundTheirPoles", quarter, turning(quarter, gp::DZ(), 0.7),
       2 * (kPi / 2 - 0.7) / 3},
      {"QuartersAcross", quarter, turning(quarter, gp::DX(), 0.7), (kPi - 0.7) / 3},
      {"QuartersFaceToFace", quarter, turning(quarter, gp::DX(), kPi)},
      {"DomesRoundTheirPole", dome, turning(dome, gp::DZ(), 0.7), (kPi - 0.7) / 3},
      {"DomesWithTheirPoleInABorder", dome, turning(dome, gp::DY(), kPi / 2), kPi / 6},
      {"HalfConesRoundTheirTip", half_cone, turning(half_cone, gp::DZ(), 0.7), (kPi - 0.7) / 6},
      {"HalfConesBackToBack", half_cone, turning(half_cone, gp::DZ(), kPi)},
      {"WedgeInABall", ball(kOrigin, 1), half, 2 * kPi / 3},
      {"WedgeInATurnedBall", turning(ball(kOrigin, 1), kOblique, 0.7), half, 2 * kPi / 3},
  };
}

std::vector<SolidContact> cone_and_ring_contacts() {
  const Maker half_ring = ring(kOrigin, 2, 0.5, kPi);
  const double wide_ring = 2 * kPi * kPi * 0.75 * 0.25 * 0.25;
  return {
      {"ConeOnAPlate", whole_plate, cone({0, 0, 1}, 0.5, 0.2, 1)},
      {"ConeInAPlate", whole_plate, cone(kOrigin, 0.5, 0.2, 1), kPi / 3 * (0.25 + 0.1 + 0.04)},
      {"ConeOnCone", frustum(0, 1), frustum(1, 1.5)},
      {"ConeInCone", frustum(0, 1), frustum(0.5, 1.5), kPi / 3 * (2.25 + 1.5 + 1) * 0.5},
      {"ConeOnItsTip", whole_plate, cone({0, 0, 1}, 0, 0.5, 1)},
      {"ConeWithItsTipInACorner", whole_cube, cone({1, 1, 1}, 0, 0.5, 1)},
      {"RingOnAPlate", whole_plate, ring({0, 0, 1.25}, 1, 0.25)},
      {"HalfRings", half_ring, turning(half_ring, gp::DZ(), kPi)},
      {"RingInABall", ball(kOrigin, 1), ring(kOrigin, 0.75, 0.25), wide_ring},
      {"ConeAtARim", cone({0, 0, -0.5}, 0.5, 0, 1), cone({0, 0.25, 0}, 0.5, 0.25, 1), kPi / 96},
      {"FrustumAtTwoRims", boxed({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}),
       cone({0.25, 0, -0.5}, 0.5, 0.25, 1), flattened_frustum(), kOverHyperbolas},
  };
}

std::vector<SolidContact> hole_and_corner_contacts() {
  return {
      {"PegInAHole", drilled_plate, rod(kOrigin, 0.5, 1)},
      {"TurnedPegInAHole", drilled_plate, turned_rod({0, 0, 0.5}, 0.5, 1, 1)},
      {"LongPegInAHole", drilled_plate, rod({0, 0, -1}, 0.5, 3)},
      {"HalfPegInAHole", drilled_plate, rod(kOrigin, 0.5, 1, gp::DZ(), kPi)},
      {"ThickPegInAHole", drilled_plate, rod(kOrigin, 1, 1), 0.75 * kPi},
      {"FlushAtAnInnerCorner", two_boxes, boxed({2, 0, 2}, {3, 2, 3}), 2},
      {"RoundedCubeInCube", whole_cube, rounded_cube, 1 - 0.25 * 0.25 * (4 - kPi)},
      {"CubeOnRoundedCube", rounded_cube, boxed({1, 0, 0}, {2, 1, 1})},
      {"CubeFlushWithRoundedCube", rounded_cube, boxed({0, 0, 0.5}, {1, 1, 1.5}),
       0.5 * (1 - 0.25 * 0.25 * (4 - kPi))},
  };
}

std::vector<SolidContact> spline_contacts() {
  const Maker corner =
      prism({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}, {0, 0, 1});
  return {
      {"SplineCubeOnCube", whole_cube, splines(boxed({1, 0, 0.5}, {2, 1, 1}))},
      {"SplineCubeInCube", whole_cube, splines(boxed({0.5, 0, 0.5}, {2, 1, 1})), 0.25},
      {"SplineRodOnAPlate", whole_plate, splines(rod({0, 0, 1}, 0.5, 1))},
      {"SplineRodInRod", rod(kOrigin, 1, 1), splines(rod({0, 0, 0.5}, 1, 1)), kPi / 2, 1e-7},
      {"BarAtASplineCorner", splines(corner), boxed({1, 1.2, 0}, {2.1, 1.8, 1})},
  };
}

// Between two squares, with spline surfaces.
TopoDS_Shape pyramid() {
  const auto square = [](double x, double z) {
    return BRepBuilderAPI_MakePolygon({-x, -x, z}, {x, -x, z}, {x, x, z}, {-x, x, z}, true).Wire();
  };
  const TopoDS_Wire low = square(0.5, -0.5), high = square(0.25, 0.5);
  BRepBuilderAPI_Sewing sewing;
  sewing.Add(BRepFill::Shell(low, high));
  for (const TopoDS_Wire& wire : {low, high}) sewing.Add(BRepBuilderAPI_MakeFace(wire).Face());
  sewing.Perform();
  return BRepBuilderAPI_MakeSolid(TopoDS::Shell(sewing.SewedShape())).Shape();
}

// A wall one unit thick at its top, that ends in an edge without an angle: x from 0 to a circle.
TopoDS_Shape cusp() {
  const gp_Pnt tip = kOrigin, far(1, 0, 1), near(0, 0, 1);
  const gp_Circ circle(gp_Ax2({1, 0, 0}, gp::DY(), gp_Dir(-1, 0, 0)), 1);
  BRepBuilderAPI_MakeWire outline;
  outline.Add(BRepBuilderAPI_MakeEdge(circle, tip, far));
  outline.Add(BRepBuilderAPI_MakeEdge(far, near));
  outline.Add(BRepBuilderAPI_MakeEdge(near, tip));
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Shape(), gp_Vec(0, 1, 0))
      .Shape();
}

// Edges that touch edges, or faces inside, or cut off what is thinner than the tolerance.
std::vector<SolidContact> touching_edges() {
  const Maker tall = cone({0, 0, -0.5}, 0.5, 0.25, 1);
  const double half = 0.25 * std::sqrt(3.0);
  const Maker hexagon = prism({{0.5, 0, -0.5},
                               {0.25, half, -0.5},
                               {-0.25, half, -0.5},
                               {-0.5, 0, -0.5},
                               {-0.25, -half, -0.5},
                               {0.25, -half, -0.5}},
                              {0, 0, 1});
  const Maker octant = [] {
    return BRepPrimAPI_MakeSphere(gp_Ax2(), 0.5, 0, kPi / 2, kPi / 2).Shape();
  };
  return {
      {"RingAtTheSeamOfAHollow", ring(kOrigin, 0.375, 0.125), hollow_cube},
      {"FrustumAtTheRimOfACone", cone({0, 0, -0.5}, 0.5, 0, 1), turning(tall, gp::DY(), kPi / 2)},
      {"PrismEdgesInABall", ball(kOrigin, 0.5), turning(hexagon, gp::DX(), 0.7)},
      {"PrismEdgesInARing", ring(kOrigin, 0.375, 0.125), hexagon},
      {"PrismEdgesInARod", rod({0, 0, -0.5}, 0.5, 1), turning(hexagon, gp::DX(), kPi / 2)},
      {"PrismEdgesAtACorner", turning(hexagon, gp::DY(), kPi / 4), turning(octant, gp::DZ(), kPi)},
      {"SlitAtACusp", cusp,
       lifted(turning(turning(boxed({-1, 0, -2}, {1.5, 2, 0}), gp::DX(), 0.5), gp::DZ(), 0.3),
              {0, 0.5, 1.8e-4})},
      {"PyramidEdgesInABall", ball(kOrigin, 0.5),
       turning(turning(pyramid, gp::DY(), kPi), gp::DX(), kPi / 4)},
  };
}

}  // namespace blossom::testing
