// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces and faces to Bezier patches: the same points at the same parameters.

#include "adapters/occt/convert/surfaces.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <GeomAPI.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp.hxx>
#include <gp_Pln.hxx>
#include <gp_Trsf.hxx>

#include "adapters/occt/base/errors.h"
#include "core/base/unbounded.h"
#include "core/forms/algebra/conversion.h"
#include "tests/adapters/occt/convert/surfaces_samples.h"
#include "tests/support/measures.h"

namespace blossom::occt {
namespace {

using testing::NamedSurface;
using testing::Random;
using testing::uniform;

using testing::gap;
using testing::kPi;
/// Largest distance to the surface at equal parameters, over random places and all corners.
double largest_gap(const BezierSurface& found, const Handle(Geom_Surface) & surface,
                   const ParameterBox& box, Random& random) {
  double largest = 0;
  for (int k = 0; k < 300; ++k) {
    const double s = k < 4 ? k % 2 : uniform(random, 0, 1);
    const double t = k < 4 ? k / 2 : uniform(random, 0, 1);
    const double u = at(box.u, s), v = at(box.v, t);
    largest = std::max(largest, gap(point_at(found, {u, v}), surface->Value(u, v)));
  }
  return largest;
}

double size_of(const BezierSurface& surface) {
  double size = 0;
  for (const RationalBezierPatch& patch : surface.patches.values())
    for (const Vec4& p : patch.points.values())
      size = std::max(size, max_norm(Vec3{p[0], p[1], p[2]} * (1 / p[3])));
  return size;
}

class EverySurface : public ::testing::TestWithParam<int> {};

TEST_P(EverySurface, HasTheSamePointsAtTheSameParameters) {
  Random random(static_cast<unsigned>(GetParam()));
  for (const NamedSurface& sample : testing::all_surfaces(random)) {
    const BezierSurface found = bezier_surface(sample.surface, sample.box);
    ASSERT_NO_THROW(validate(found, "found")) << sample.name;
    const double largest = largest_gap(found, sample.surface, sample.box, random);
    if (sample.exact) {
      EXPECT_EQ(found.error, 0) << sample.name;
      EXPECT_LE(largest, 64 * 0x1p-53 * size_of(found)) << sample.name;
    } else {
      EXPECT_GT(found.error, 0) << sample.name;
      EXPECT_LE(found.error, 1e-7) << sample.name;
      EXPECT_LE(largest, found.error) << sample.name;
    }
  }
}

TEST_P(EverySurface, HasNeighboursThatShareTheirBorderBitForBit) {
  Random random(static_cast<unsigned>(GetParam()));
  for (const NamedSurface& sample : testing::all_surfaces(random)) {
    const BezierSurface found = bezier_surface(sample.surface, sample.box);
    const int n = found.patches(0, 0).degree_u(), m = found.patches(0, 0).degree_v();
    for (int r = 0; r < found.patches.rows(); ++r)
      for (int c = 0; c < found.patches.columns(); ++c) {
        const Grid<Vec4>& net = found.patches(r, c).points;
        for (int j = 0; j <= m && r > 0; ++j)
          EXPECT_EQ(net(0, j), found.patches(r - 1, c).points(n, j)) << sample.name;
        for (int i = 0; i <= n && c > 0; ++i)
          EXPECT_EQ(net(i, 0), found.patches(r, c - 1).points(i, m)) << sample.name;
      }
  }
}

TEST_P(EverySurface, BecomesOneSplineWithTheSameShape) {
  Random random(static_cast<unsigned>(GetParam()));
  for (const NamedSurface& sample : testing::all_surfaces(random)) {
    const BezierSurface found = bezier_surface(sample.surface, sample.box);
    const Handle(Geom_BSplineSurface) spline = to_occt(found);
    const double rounding = 64 * 0x1p-53 * size_of(found);
    for (int k = 0; k < 40; ++k) {
      const int r = k % found.patches.rows(), c = k / 7 % found.patches.columns();
      const Interval u{found.u_knots[static_cast<std::size_t>(r)],
                       found.u_knots[static_cast<std::size_t>(r + 1)]};
      const Interval v{found.v_knots[static_cast<std::size_t>(c)],
                       found.v_knots[static_cast<std::size_t>(c + 1)]};
      const double s = uniform(random, 0, 1), t = uniform(random, 0, 1);
      const Vec3 on_found =
          point_at(found, {parameter_at(found.u_law, u, s), parameter_at(found.v_law, v, t)});
      EXPECT_LE(gap(on_found, spline->Value(at(u, s), at(v, t))), rounding) << sample.name;
    }
  }
}

TEST_P(EverySurface, GoesThroughMonomialFormWithinTheStatedBound) {
  Random random(static_cast<unsigned>(GetParam()));
  for (const NamedSurface& sample : testing::all_surfaces(random))
    for (const Origin origin : {Origin::Start, Origin::Middle}) {
      const RationalBezierPatch patch = bezier_surface(sample.surface, sample.box).patches(0, 0);
      const Handle(Geom_BezierSurface) occt = to_occt(patch);
      const RationalBezierPatch net = from_occt(*occt);
      const RationalBezierPatch back = from_occt(*to_occt(bezier_form(monomial_form(net, origin))));
      double largest = 0, size = 0;
      for (int i = 0; i < net.points.rows(); ++i)
        for (int j = 0; j < net.points.columns(); ++j) {
          largest = std::max(largest, max_norm(back.points(i, j) - net.points(i, j)));
          size = std::max(size, max_norm(net.points(i, j)));
        }
      EXPECT_LE(largest, round_trip_error(net.degree_u(), net.degree_v(), origin) * size)
          << sample.name;
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, EverySurface, ::testing::Range(1, 6));

TEST(BezierSurfaceRoundTrip, KeepsEveryBitOfPolynomialSurfaces) {
  Random random(7);
  for (int n = 1; n <= 9; ++n) {
    const auto surface = testing::random_bezier_surface(random, n, 10 - n, false);
    const RationalBezierPatch patch = from_occt(*surface);
    const Handle(Geom_BezierSurface) back = to_occt(patch);
    ASSERT_FALSE(back->IsURational() || back->IsVRational());
    for (int i = 1; i <= n + 1; ++i)
      for (int j = 1; j <= 11 - n; ++j)
        EXPECT_EQ(back->Pole(i, j).Distance(surface->Pole(i, j)), 0);
    EXPECT_EQ(from_occt(*back), patch);
  }
}

TEST(BezierSurfaceRoundTrip, KeepsEveryBitWhenWeightsArePowersOfTwo) {
  Random random(8);
  const auto surface = testing::random_bezier_surface(random, 3, 3, false);
  surface->SetWeight(2, 2, 4);
  surface->SetWeight(3, 1, 0.125);
  const Handle(Geom_BezierSurface) back = to_occt(from_occt(*surface));
  for (int i = 1; i <= 4; ++i)
    for (int j = 1; j <= 4; ++j) {
      EXPECT_EQ(back->Pole(i, j).Distance(surface->Pole(i, j)), 0);
      EXPECT_EQ(back->Weight(i, j), surface->Weight(i, j));
    }
}

TEST(BezierSurfaceRoundTrip, MovesRationalPointsByOneUlpAtMostAndThenNoMore) {
  Random random(9);
  int moved = 0;
  for (int k = 0; k < 20; ++k) {
    const auto surface = testing::random_bezier_surface(random, 4, 4, true);
    const Handle(Geom_BezierSurface) once = to_occt(from_occt(*surface));
    const Handle(Geom_BezierSurface) twice = to_occt(from_occt(*once));
    for (int i = 1; i <= 5; ++i)
      for (int j = 1; j <= 5; ++j) {
        EXPECT_EQ(once->Weight(i, j), surface->Weight(i, j));
        for (int c = 1; c <= 3; ++c) {
          const double x = surface->Pole(i, j).Coord(c), y = once->Pole(i, j).Coord(c);
          EXPECT_LE(std::abs(y - x), std::abs(std::nextafter(x, 2 * x) - x));
          EXPECT_EQ(twice->Pole(i, j).Coord(c), y);
          moved += x != y;
        }
      }
  }
  EXPECT_LT(moved, 20 * 75 / 5);
}

TEST(BezierSurfaceOf, NaturalBezierSurfaceHasItsPointsBitForBit) {
  Random random(10);
  for (const bool rational : {false, true}) {
    const auto surface = testing::random_bezier_surface(random, 4, 3, rational);
    const BezierSurface found = bezier_surface(surface, {{0, 1}, {0, 1}});
    ASSERT_EQ(found.patches.rows() * found.patches.columns(), 1);
    EXPECT_EQ(found.patches(0, 0), from_occt(*surface));
    EXPECT_EQ(found.rational, rational);
  }
}

TEST(BezierSurfaceOf, QuarterCylinderHasHandComputedNet) {
  const Handle(Geom_Surface) cylinder = new Geom_CylindricalSurface(gp_Ax3(), 2);
  const BezierSurface found = bezier_surface(cylinder, {{0, kPi / 2}, {0, 3}});
  ASSERT_EQ(found.patches.rows(), 1);
  const Grid<Vec4>& net = found.patches(0, 0).points;
  EXPECT_EQ(net(0, 0), (Vec4{2, 0, 0, 1}));
  EXPECT_EQ(net(2, 1), (Vec4{0, 2, 3, 1}));
  EXPECT_NEAR(net(1, 0)[3], std::sqrt(0.5), 1e-16);
  EXPECT_NEAR(net(1, 0)[0] / net(1, 0)[3], 2, 1e-15);
  EXPECT_NEAR(net(1, 0)[1] / net(1, 0)[3], 2, 1e-15);
}

TEST(BezierSurfaceOf, OffsetOfARevolutionOrAnExtrusionIsOneToo) {
  const Handle(Geom_Curve) ellipse = new Geom_Ellipse(gp_Ax2(gp_Pnt(5, 0, 0), gp::DY()), 3, 1.5);
  const ParameterBox box{{0, 1}, {0, 1}};
  const auto offset = [&](const Handle(Geom_Surface) & swept) {
    return bezier_surface(new Geom_OffsetSurface(swept, 0.3), box);
  };
  const BezierSurface turned = offset(new Geom_SurfaceOfRevolution(ellipse, gp::OZ()));
  EXPECT_EQ(turned.patches.rows(), 1);
  EXPECT_EQ(turned.patches(0, 0).points.rows(), 3) << "a circular arc is of degree 2";
  const BezierSurface moved = offset(new Geom_SurfaceOfLinearExtrusion(ellipse, gp::DY()));
  EXPECT_EQ(moved.patches.columns(), 1);
  EXPECT_EQ(moved.patches(0, 0).points.columns(), 2);
  EXPECT_LE(std::max(turned.error, moved.error), Tolerances{}.point);
}

TEST(BezierSurfaceOf, SaysWhereASurfaceIsClosed) {
  const auto closed = [](const Handle(Geom_Surface) & surface, const ParameterBox& box) {
    const BezierSurface found = bezier_surface(surface, box);
    return std::pair(found.closed_u, found.closed_v);
  };
  const Interval turn{0, 2 * kPi};
  const Handle(Geom_Surface) sphere = new Geom_SphericalSurface(gp_Ax3(), 2);
  EXPECT_EQ(closed(sphere, {turn, {-kPi / 2, kPi / 2}}), std::pair(true, false));
  EXPECT_EQ(closed(sphere, {{0, 6}, {-kPi / 2, kPi / 2}}), std::pair(false, false));
  Random random(11);
  const auto spline = testing::random_spline_surface(random, false, true, false);
  EXPECT_EQ(closed(spline, {{0.2, 2.6}, {-1, 2}}), std::pair(true, false));
  EXPECT_EQ(closed(spline, {{0.2, 2.5}, {-1, 2}}), std::pair(false, false));
}

TEST(BezierSurfaceOf, ClosedSurfaceEndsInTheBitsItBeganWith) {
  const Handle(Geom_Surface) sphere = new Geom_SphericalSurface(testing::tilted_frame(), 2);
  const BezierSurface found = bezier_surface(sphere, {{1, 1 + 2 * kPi}, {-1, 1}});
  const Grid<Vec4>& first = found.patches(0, 0).points;
  const Grid<Vec4>& last = found.patches(found.patches.rows() - 1, 0).points;
  for (int j = 0; j <= 2; ++j) EXPECT_EQ(first(0, j), last(2, j));
}

std::string refusal(const Handle(Geom_Surface) & surface, const ParameterBox& box) {
  try {
    bezier_surface(surface, box);
  } catch (const BadModel& error) {
    return error.what();
  }
  return "accepted";
}

TEST(BezierSurfaceOf, RefusesBoxesThatAreEmptyEndlessOrOutside) {
  const Handle(Geom_Surface) plane = new Geom_Plane(gp_Ax3());
  Random random(12);
  const Handle(Geom_Surface) bezier = testing::random_bezier_surface(random, 2, 2, false);
  EXPECT_EQ(refusal(plane, {{0, kInfinity}, {0, 1}}), "the parameter box in u is not finite");
  EXPECT_EQ(refusal(plane, {{0, 1}, {-2e100, 2e100}}), "the parameter box in v is not finite");
  EXPECT_EQ(refusal(plane, {{0, 1}, {1, 1}}),
            "the parameter box in v is empty: [1.000000, 1.000000]");
  EXPECT_EQ(refusal(bezier, {{0, 1.5}, {0, 1}}),
            "the parameter box in u, [0.000000, 1.500000], leaves the natural bounds "
            "[0.000000, 1.000000]");
  EXPECT_EQ(refusal(nullptr, {{0, 1}, {0, 1}}), "there is no surface");
}

TEST(BezierSurfaceOf, RefusesNumbersThatAreNone) {
  Random random(13);
  const auto bezier = testing::random_bezier_surface(random, 2, 2, false);
  bezier->SetPole(2, 3, gp_Pnt(0, std::nan(""), 0));
  EXPECT_EQ(refusal(bezier, {{0, 1}, {0, 1}}), "control point (2, 3) is not finite");
  const Handle(Geom_Surface) sphere = new Geom_SphericalSurface(gp_Ax3(), kInfinity);
  EXPECT_EQ(refusal(sphere, {{0, 1}, {0, 1}}), "a number of the surface is not finite");
}

TopoDS_Face first_face(const TopoDS_Shape& shape) {
  return TopoDS::Face(TopExp_Explorer(shape, TopAbs_FACE).Current());
}

TEST(BezierSurfaceOfAFace, StandsWhereItsLocationPutsIt) {
  gp_Trsf move;
  move.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 0)), 0.7);
  const TopoDS_Face face = first_face(BRepPrimAPI_MakeSphere(2, 0.3, 1.0, 2.0).Shape());
  const TopoDS_Face moved = TopoDS::Face(face.Moved(TopLoc_Location(move)));
  const BezierSurface before = bezier_surface(face), after = bezier_surface(moved);
  ASSERT_EQ(before.u_knots, after.u_knots);
  Random random(14);
  const ParameterBox box = parameter_box(face);
  for (int k = 0; k < 50; ++k) {
    const Vec2 uv{at(box.u, uniform(random, 0, 1)), at(box.v, uniform(random, 0, 1))};
    const Vec3 p = point_at(before, uv);
    EXPECT_LE(gap(point_at(after, uv), gp_Pnt(p[0], p[1], p[2]).Transformed(move)), 1e-14);
  }
}

TEST(ParameterBox, IsExactlyNaturalForNaturalFaces) {
  Random random(15);
  const auto spline = testing::random_spline_surface(random, false, false, true);
  const ParameterBox box = parameter_box(BRepBuilderAPI_MakeFace(spline, 1e-7).Face());
  EXPECT_EQ(box.u, (Interval{-1, 2.5}));
  EXPECT_EQ(box.v, (Interval{3, 5.5}));
  const ParameterBox side = parameter_box(first_face(BRepPrimAPI_MakeCylinder(1, 4).Shape()));
  EXPECT_EQ(side.u, (Interval{0, 2 * kPi}));
  EXPECT_EQ(side.v, (Interval{0, 4}));
}

TEST(ParameterBox, SnapsTrimsThatAreMeantToBeNatural) {
  Random random(16);
  const auto spline = testing::random_spline_surface(random, false, false, false);
  const ParameterBox box = parameter_box(
      BRepBuilderAPI_MakeFace(spline, -1 + 1e-10, 2.5 - 1e-10, 0.3 - 1e-11, 1.5, 1e-9).Face());
  EXPECT_EQ(box.u, (Interval{-1, 2.5}));
  EXPECT_EQ(box.v.from, 0.3);
  EXPECT_NEAR(box.v.to, 1.5, 1e-12);
}

TEST(ParameterBox, TakesWholeTurnsWhole) {
  const Handle(Geom_Surface) cylinder = new Geom_CylindricalSurface(gp_Ax3(), 2);
  const double end = 0.5 + 2 * kPi - 1e-9;
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(cylinder, 0.5, end, 0.0, 1.0, 1e-12);
  EXPECT_EQ(parameter_box(face).u, (Interval{0.5, 0.5 + 2 * kPi}));
  EXPECT_TRUE(bezier_surface(face).closed_u);
}

// As where a disc is turned into splines whose edge began half a turn before.
TEST(ParameterBox, HoldsAPeriodicSplineFromAnyOfItsPeriods) {
  const auto circle = GeomConvert::CurveToBSplineCurve(new Geom_Circle(gp::XOY(), 2));
  ASSERT_TRUE(circle->IsPeriodic());
  for (const double from : {-kPi, -1.0, 0.0, 2.0, 7.0}) {
    const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(circle, from, from + 2 * kPi);
    const TopoDS_Face face =
        BRepBuilderAPI_MakeFace(gp_Pln(), BRepBuilderAPI_MakeWire(edge).Wire()).Face();
    const Handle(Geom2d_Curve) image =
        new Geom2d_TrimmedCurve(GeomAPI::To2d(circle, gp_Pln()), from, from + 2 * kPi);
    BRep_Builder().UpdateEdge(edge, image, face, 1e-7);
    const ParameterBox box = parameter_box(face);
    for (const Interval& side : {box.u, box.v}) {
      EXPECT_LE(side.from, -2 + 1e-12) << from;
      EXPECT_GE(side.to, 2 - 1e-12) << from;
    }
  }
}

TEST(ParameterBox, RefusesFacesWithoutASurface) {
  EXPECT_THROW(parameter_box(TopoDS_Face()), BadModel);
  EXPECT_THROW(parameter_box(BRepBuilderAPI_MakeFace(gp_Pln()).Face()), BadModel);
}

}  // namespace
}  // namespace blossom::occt
