// SPDX-License-Identifier: LGPL-2.1-or-later
// Common regions of trimmed faces, by their areas in space and in both charts.

#include "adapters/occt/coincidence/trimmed_overlaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/intersection.h"

namespace blossom::occt {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kChords = 1e-3;  // relative: areas of polygons with 128 corners a circle

TopoDS_Wire circle(double x, double y, double r, double up) {
  return BRepBuilderAPI_MakeWire(
      BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(x, y, 0), gp_Dir(0, 0, up)), r)));
}

TopoDS_Face disc(double x, double y, double r) {
  return BRepBuilderAPI_MakeFace(gp_Pln(), circle(x, y, r, 1));
}

TopoDS_Face square(double from, double to) {
  return BRepBuilderAPI_MakeFace(gp_Pln(), from, to, from, to);
}

TopoDS_Face with_hole(const TopoDS_Face& face, double x, double y, double r) {
  BRepBuilderAPI_MakeFace maker(face);
  maker.Add(circle(x, y, r, -1));
  return maker.Face();
}

// The upper half of a disc.
TopoDS_Face half_disc(double r) {
  const gp_Pnt from(r, 0, 0), to(-r, 0, 0);
  BRepBuilderAPI_MakeWire wire(
      BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp::Origin(), gp::DZ()), r), 0, kPi));
  wire.Add(BRepBuilderAPI_MakeEdge(to, from));
  return BRepBuilderAPI_MakeFace(gp_Pln(), wire);
}

// The disc of a surface's chart.
TopoDS_Face chart_disc(const Handle(Geom_Surface) & surface, double u, double v, double r) {
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(
      new Geom2d_Circle(gp_Ax2d(gp_Pnt2d(u, v), gp_Dir2d(1, 0)), r), surface);
  BRepLib::BuildCurves3d(edge);
  return BRepBuilderAPI_MakeFace(surface, BRepBuilderAPI_MakeWire(edge));
}

Handle(Geom_Surface) cylinder() { return new Geom_CylindricalSurface(gp_Ax3(), 1); }

Handle(Geom_BezierSurface) hill() {
  TColgp_Array2OfPnt poles(1, 4, 1, 4);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      poles(i + 1, j + 1) = gp_Pnt(i, j, 0.3 * std::sin(1.3 * i) * std::cos(0.9 * j));
  return new Geom_BezierSurface(poles);
}

// The square from -1 to 1, which ends where its unit disc touches it.
Handle(Geom_BezierSurface) tile() {
  TColgp_Array2OfPnt poles(1, 2, 1, 2);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) poles(i + 1, j + 1) = gp_Pnt(2 * i - 1, 2 * j - 1, 0);
  return new Geom_BezierSurface(poles);
}

// The lens that two unit circles at a distance of 1 have in common.
const double kLens = 2 * kPi / 3 - std::sqrt(3.0) / 2;

struct Pair {
  const char* name;
  TopoDS_Face a, b;
  double area_a, area_b;  // in the charts, all regions together
  std::size_t regions;
  Status status = Status::Complete;  // what is recognised and apart by rounding is exact
};

std::vector<Pair> pairs() {
  const TopoDS_Face turned = BRepBuilderAPI_MakeFace(
      gp_Pln(gp_Ax3(gp_Pnt(1, 1, 0), gp_Dir(0, 0, 1), gp_Dir(1, 2, 0))), circle(2, 2, 1, 1));
  const TopoDS_Wire triangle =
      BRepBuilderAPI_MakePolygon(gp_Pnt(-1, -1, 0), gp_Pnt(2, 1, 0), gp_Pnt(1, 3, 0), true);
  const TopoDS_Face wall = BRepBuilderAPI_MakeFace(cylinder(), 0, 2 * kPi, 0, 2, 1e-7);
  const Handle(Geom_BezierSurface) whole = hill(), part = hill();
  part->Segment(0.3, 1, 0, 0.7);
  const double lens_of_hill = 0.09 * (2 * std::acos(1 / 3.0) - 2 / 3.0 * std::sqrt(8.0) / 3);
  const TopoDS_Wire wedge =
      BRepBuilderAPI_MakePolygon(gp_Pnt(0, 0, 0), gp_Pnt(2, -1.2, 0), gp_Pnt(2, 1.2, 0), true);
  const double sector = std::atan(0.6);
  // It leaves the tile on each side, and is back before long.
  const double wide = 1.001, over = std::acos(1 / wide);
  const double rounded = wide * wide * (kPi - 4 * over + 4 * std::sin(over) * std::cos(over));
  const gp_Dir between(std::cos(kPi / 64), std::sin(kPi / 64), 0);
  const TopoDS_Wire rim = BRepBuilderAPI_MakeWire(
      BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp::Origin(), gp::DZ(), between), wide)));
  return {
      {"a disc of a tile and edges that leave it", chart_disc(tile(), 0.5, 0.5, 0.5),
       BRepBuilderAPI_MakeFace(gp_Pln(), wedge), sector / 4, sector, 1},
      {"a disc a little wider than a tile", BRepBuilderAPI_MakeFace(tile(), 1e-7),
       BRepBuilderAPI_MakeFace(gp_Pln(), rim), rounded / 4, rounded, 1},
      {"a disc in a square", square(0, 4), disc(2, 2, 1), kPi, kPi, 1},
      {"a disc over a side", square(0, 4), disc(4, 2, 1), kPi / 2, kPi / 2, 1},
      {"two discs", disc(0, 0, 1), disc(1, 0, 1), kLens, kLens, 1},
      {"two large discs", disc(0, 0, 4e4), disc(4e4, 0, 4e4), 1.6e9 * kLens, 1.6e9 * kLens, 1},
      {"equal discs", disc(0, 0, 1), disc(0, 0, 1), kPi, kPi, 1},
      {"a hole and its disc", with_hole(square(0, 4), 2, 2, 1), disc(2, 2, 1), 0, 0, 0},
      {"a hole in a disc", with_hole(square(0, 4), 2, 2, 1), disc(2, 2, 1.5), 1.25 * kPi,
       1.25 * kPi, 1},
      {"two holes", with_hole(square(0, 4), 1, 1, 0.5), with_hole(square(0, 4), 3, 3, 0.5),
       16 - kPi / 2, 16 - kPi / 2, 1},
      {"holes that cross", with_hole(square(0, 6), 2.5, 3, 1), with_hole(square(1, 7), 3.5, 3, 1),
       25 - 2 * kPi + kLens, 25 - 2 * kPi + kLens, 1},
      {"a circle and nearly the same one", half_disc(1), disc(3e-9, 2e-9, 1 + 1e-9), kPi / 2,
       kPi / 2, 1, Status::Tolerance},
      {"rings of nearly the same circles", with_hole(half_disc(2), 0, 1, 0.5),
       with_hole(disc(2e-9, 3e-9, 2 - 1e-9), 3e-9, 1, 0.5 + 1e-9), 1.75 * kPi, 1.75 * kPi, 1,
       Status::Tolerance},
      {"another frame", square(0, 4), turned, kPi, kPi, 1},
      {"discs apart in one plane", disc(0, 0, 1), disc(1.5, 1.5, 1), 0, 0, 0},
      {"a triangle", square(0, 4), BRepBuilderAPI_MakeFace(triangle, true), 3.25, 3.25, 1},
      {"a patch of a wall", wall, chart_disc(cylinder(), 2, 1, 0.5), kPi / 4, kPi / 4, 1},
      {"a patch over the end", wall, chart_disc(cylinder(), 2, 2, 0.5), kPi / 8, kPi / 8, 1},
      {"patches of walls", chart_disc(cylinder(), 1, 1, 0.5), chart_disc(cylinder(), 1.5, 1, 0.5),
       kLens / 4, kLens / 4, 1},
      {"copies of a patch", chart_disc(whole, 0.4, 0.5, 0.3), chart_disc(hill(), 0.6, 0.5, 0.3),
       lens_of_hill, lens_of_hill, 1},
      // The parameters of the part are (u - 0.3) / 0.7 and v / 0.7.
      {"a part of a patch", chart_disc(whole, 0.6, 0.4, 0.2), BRepBuilderAPI_MakeFace(part, 1e-7),
       0.04 * kPi, 0.04 * kPi / 0.49, 1, Status::Tolerance},
  };
}

double area_of(const Overlap& region, Vec2 SurfacePoint::*uv) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < region.boundary.size(); ++i) {
    const Vec2 &p = region.boundary[i].*uv, &q = region.boundary[i + 1].*uv;
    sum += 0.5 * (p[0] * q[1] - p[1] * q[0]);
  }
  return sum;
}

std::vector<Overlap> regions_of(const TopoDS_Face& a, const TopoDS_Face& b,
                                Status status = Status::Complete) {
  const ShapeIntersection all = intersect({a}, {b});
  EXPECT_EQ(all.status, status) << ::testing::PrintToString(all.certificate.reasons);
  return all.pairs.empty() ? std::vector<Overlap>{} : all.pairs[0].found.overlaps;
}

void expect_on_both(const Overlap& region, const TopoDS_Face& a, const TopoDS_Face& b) {
  for (const SurfacePoint& x : region.boundary)
    for (const auto& [face, uv] : {std::pair{a, x.uv_a}, std::pair{b, x.uv_b}}) {
      const gp_Pnt p = BRep_Tool::Surface(face)->Value(uv[0], uv[1]);
      ASSERT_LE(distance(Vec3{p.X(), p.Y(), p.Z()}, x.point), 1e-7);
    }
}

TEST(TrimmedOverlaps, HaveTheAreasThatBothTrimsLeave) {
  for (const Pair& row : pairs())
    for (const bool swapped : {false, true}) {
      SCOPED_TRACE(std::string(row.name) + (swapped ? ", swapped" : ""));
      const TopoDS_Face &a = swapped ? row.b : row.a, &b = swapped ? row.a : row.b;
      const std::vector<Overlap> regions = regions_of(a, b, row.status);
      EXPECT_EQ(regions.size(), row.regions);
      double area_a = 0, area_b = 0;
      for (const Overlap& region : regions) {
        expect_on_both(region, a, b);
        area_a += area_of(region, &SurfacePoint::uv_a);
        area_b += area_of(region, &SurfacePoint::uv_b);
      }
      const double wanted_a = swapped ? row.area_b : row.area_a;
      const double wanted_b = swapped ? row.area_a : row.area_b;
      EXPECT_NEAR(area_a, wanted_a, kChords * wanted_a);
      EXPECT_NEAR(area_b, wanted_b, kChords * wanted_b);
    }
}

// The wall's seam is an edge of it, so it divides what lies on both sides.
TEST(TrimmedOverlaps, ASeamOfTheFirstFaceDividesThem) {
  const TopoDS_Face wall = BRepBuilderAPI_MakeFace(cylinder(), 0, 2 * kPi, 0, 2, 1e-7);
  const TopoDS_Face patch = chart_disc(cylinder(), 0, 1, 0.5);
  for (const auto& [a, b, count] : {std::tuple{wall, patch, 2u}, std::tuple{patch, wall, 1u}}) {
    const std::vector<Overlap> regions = regions_of(a, b);
    ASSERT_EQ(regions.size(), count);
    double area = 0;
    for (const Overlap& region : regions) area += area_of(region, &SurfacePoint::uv_a);
    EXPECT_NEAR(area, kPi / 4, kChords);
  }
}

// A disc that a plane holds within 3 tolerances, and one that leaves it there.
TEST(TrimmedOverlaps, AreDividedWhereEdgesLieWithinReach) {
  const TopoDS_Face floor = square(-2, 2);
  for (const double up : {1.5e-7, 3e-7, 6e-7}) {
    const gp_Dir normal(up, 0, 1);
    const gp_Circ rim(gp_Ax2(gp_Pnt(0.3, 0.1, 0), normal), 1);
    const TopoDS_Face tilted = BRepBuilderAPI_MakeFace(
        gp_Pln(gp_Pnt(0.3, 0.1, 0), normal), BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(rim)));
    for (const auto& [a, b] : {std::pair{floor, tilted}, std::pair{tilted, floor}})
      EXPECT_NE(intersect({a}, {b}).status, Status::Stopped) << up;
  }
}

// A face turned over sees the region from below: its loops run the other way in its own chart.
TEST(TrimmedOverlaps, LieOnTheLeftInTheFirstChart) {
  const TopoDS_Face over = BRepBuilderAPI_MakeFace(
      gp_Pln(gp_Ax3(gp_Pnt(0, 0, 0), gp_Dir(0, 0, -1))), circle(2, 2, 1, -1));
  const std::vector<Overlap> regions = regions_of(square(0, 4), over);
  ASSERT_EQ(regions.size(), 1u);
  EXPECT_NEAR(area_of(regions[0], &SurfacePoint::uv_a), kPi, kChords * kPi);
  EXPECT_NEAR(area_of(regions[0], &SurfacePoint::uv_b), -kPi, kChords * kPi);
}

// What the trims leave is not known then, and the region is a listed place.
TEST(TrimmedOverlaps, AreNotClippedOnceTheWorkIsCancelled) {
  const TopoDS_Face a = disc(0, 0, 1), b = disc(1, 0, 1);
  int questions = 0;
  const ShapeIntersection whole =
      intersect({a}, {b}, {.cancelled = [&] { return ++questions < 0; }});
  ASSERT_EQ(whole.status, Status::Complete);
  ASSERT_GE(questions, 20);  // trims are followed over the other face

  for (int last = 1; last <= questions; last += 3) {
    int asked = 0;
    const ShapeIntersection found =
        intersect({a}, {b}, {.cancelled = [&] { return ++asked >= last; }});
    EXPECT_EQ(found.status, Status::Stopped);
    for (const FaceIntersection& pair : found.pairs) {
      EXPECT_FALSE(pair.found.places.empty());
      EXPECT_TRUE(pair.found.overlaps.empty());
      const auto& reasons = pair.found.certificate.reasons;
      EXPECT_NE(std::find(reasons.begin(), reasons.end(), "cancelled"), reasons.end());
    }
  }
}

TEST(TrimmedOverlaps, SayWhyTheyStopped) {
  const IntersectionOptions options{.cancelled = [] { return true; }};
  const TrimmedOverlaps found =
      trimmed_overlaps(disc(0, 0, 1), disc(1, 0, 1), {}, 1e-7, WorkLimit(options));
  EXPECT_FALSE(found.complete);
  EXPECT_STREQ(found.stopped, "cancelled");
  EXPECT_TRUE(found.regions.empty());
}

}  // namespace
}  // namespace blossom::occt
