// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/strips/end_curves.h"

#include <cmath>

#include <gtest/gtest.h>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <gp_Ax3.hxx>

#include "adapters/occt/base/points.h"
#include "core/math/vec.h"

namespace blossom::occt {
namespace {

TopoDS_Face bare_plane(const Vec3& origin, const Vec3& normal, const Vec3& u) {
  TopoDS_Face face;
  const gp_Ax3 frame(pnt(origin), dir(normal), dir(u));
  BRep_Builder().MakeFace(face, new Geom_Plane(frame), Precision::Confusion());
  return face;
}

// As in a real model, where a wall of 0.07 meets a plane 13 621 from its origin.
TEST(WallCurve, OfPlanesIsTheirLineHoweverFarTheirOriginsAre) {
  const double tilt = 0.0301446, turn = 0.0442424;
  const Vec3 u{-std::cos(tilt), 0, std::sin(tilt)}, up{std::sin(tilt), 0, std::cos(tilt)};
  const Vec3 from{68.7322246, -13.026662, -104.74247};
  const Vec3 aside{0, 1, 0}, way = std::cos(turn) * aside + std::sin(turn) * u;
  const Vec3 to = from + 0.0748065 * way;
  const TopoDS_Face face = bare_plane(from - 99.058 * u + 13621.1 * aside, -up, u);
  const TopoDS_Face wall = bare_plane(from - 0.0748065 * up, cross(way, up), up + 0.1 * way);
  const double reach = 1e-6;
  const auto curve = wall_curve_between(wall, face, from, to, reach);
  ASSERT_TRUE(curve);
  const auto end = [&](bool first) {
    const double x = first == curve->forward ? curve->range.from : curve->range.to;
    const gp_Pnt2d on_face = curve->on_face->Value(x), on_wall = curve->on_strip->Value(x);
    const gp_Pnt p = curve->curve->Value(x);
    const gp_Pnt q = BRep_Tool::Surface(face)->Value(on_face.X(), on_face.Y());
    const gp_Pnt r = BRep_Tool::Surface(wall)->Value(on_wall.X(), on_wall.Y());
    EXPECT_LT(p.Distance(q), 1e-10);
    EXPECT_LT(p.Distance(r), 1e-10);
    return vec(p.XYZ());
  };
  EXPECT_LT(distance(end(true), from), 1e-10);
  EXPECT_LT(distance(end(false), to), 1e-10);
}

TEST(WallCurve, IsNoneWherePlanesDoNotMeetOrPointsAreAside) {
  const TopoDS_Face floor = bare_plane({0, 0, 0}, {0, 0, 1}, {1, 0, 0});
  const TopoDS_Face above = bare_plane({0, 0, 1}, {0, 0, 1}, {1, 0, 0});
  const TopoDS_Face wall = bare_plane({0, 0, 0}, {0, 1, 0}, {1, 0, 0});
  EXPECT_FALSE(wall_curve_between(above, floor, {0, 0, 0}, {1, 0, 0}, 1e-6));
  EXPECT_FALSE(wall_curve_between(wall, floor, {0, 0, 0.1}, {1, 0, 0}, 1e-6));
  EXPECT_FALSE(wall_curve_between(wall, floor, {0, 0, 0}, {1, 0.1, 0}, 1e-6));
  EXPECT_TRUE(wall_curve_between(wall, floor, {0, 0, 0}, {1, 0, 0}, 1e-6));
}

}  // namespace
}  // namespace blossom::occt
