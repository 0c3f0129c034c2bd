// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves that are lines or conics are written as what they are, with both pcurves on their
// parameter.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_Line.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_Plane.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/convert/curves.h"
#include "adapters/occt/intersection.h"
#include "adapters/occt/intersection_edges.h"
#include "adapters/occt/plane_section.h"
#include "adapters/occt/trim.h"

namespace blossom::occt {
namespace {

constexpr double kPi = std::numbers::pi;
const gp_Pnt O(0, 0, 0);
const gp_Dir X(1, 0, 0), Y(0, 1, 0), Z(0, 0, 1);

gp_Dir tilted(double angle) { return {std::sin(angle), 0, std::cos(angle)}; }

TopoDS_Face plane(const gp_Pnt& at, const gp_Dir& normal, double half = 20) {
  return BRepBuilderAPI_MakeFace(new Geom_Plane(at, normal), -half, half, -half, half, 1e-7).Face();
}

TopoDS_Face cylinder(const gp_Pnt& at, const gp_Dir& axis, double r, double half = 10) {
  return BRepBuilderAPI_MakeFace(new Geom_CylindricalSurface(gp_Ax3(at, axis), r), 0, 2 * kPi,
                                 -half, half, 1e-7)
      .Face();
}

// With its apex in the origin and 30 degrees between axis and generators.
TopoDS_Face cone(double height) {
  const double angle = kPi / 6;
  return BRepBuilderAPI_MakeFace(new Geom_ConicalSurface(gp_Ax3(O, Z), angle, 0), 0, 2 * kPi, 0,
                                 height / std::cos(angle), 1e-7)
      .Face();
}

TopoDS_Face sphere(const gp_Pnt& at, double r) {
  return faces_of(BRepPrimAPI_MakeSphere(at, r).Shape()).front();
}

// The largest distance at equal parameters between a curve and the images of its pcurves; near
// nodes spans are short.
double same_parameter_gap(const EdgeCurves& edge, const TopoDS_Face& a, const TopoDS_Face& b) {
  constexpr int kSteps = 32;  // a span
  const Handle(Geom_Surface) on_a = BRep_Tool::Surface(a), on_b = BRep_Tool::Surface(b);
  double gap = 0;
  for (int k = 1; k < edge.pcurve_a->NbKnots(); ++k)
    for (int i = 0; i <= kSteps; ++i) {
      const double t = at(Interval{edge.pcurve_a->Knot(k), edge.pcurve_a->Knot(k + 1)},
                          static_cast<double>(i) / kSteps);
      const gp_Pnt p = edge.curve->Value(t);
      const gp_Pnt2d x = edge.pcurve_a->Value(t), y = edge.pcurve_b->Value(t);
      gap = std::max(
          {gap, p.Distance(on_a->Value(x.X(), x.Y())), p.Distance(on_b->Value(y.X(), y.Y()))});
    }
  return gap;
}

// The curves of two faces, checked for what every conic keeps.
std::vector<Handle(Geom_Curve)> curves_of(const TopoDS_Face& a, const TopoDS_Face& b) {
  std::vector<Handle(Geom_Curve)> curves;
  for (const FaceIntersection& pair : intersect({a}, {b}).pairs)
    for (std::size_t i = 0; i < pair.edges.size(); ++i) {
      const EdgeCurves& edge = pair.edges[i];
      const Deviation& d = pair.found.curves[i].deviation;
      const double gap = same_parameter_gap(edge, a, b);
      EXPECT_TRUE(d.proven);
      EXPECT_LE(gap, std::max(d.a, d.b) + 1e-12);  // evaluation rounds, too
      EXPECT_LE(std::max(d.a, d.b), 2 * std::max(gap, 1e-9));
      EXPECT_LE(gap, 3e-8);  // a fit's share of the tolerance
      EXPECT_EQ(edge.curve->FirstParameter(), edge.pcurve_a->FirstParameter());
      EXPECT_EQ(edge.curve->LastParameter(), edge.pcurve_b->LastParameter());
      EXPECT_TRUE(BRepCheck_Analyzer(BRepBuilderAPI_MakeEdge(edge.curve).Edge()).IsValid());
      curves.push_back(edge.curve);
    }
  return curves;
}

template <class Kind>
Handle(Kind) as(const Handle(Geom_Curve) & curve) {
  return Handle(Kind)::DownCast(basis_of(curve));
}

bool is_whole(const Handle(Geom_Curve) & curve) {
  return curve->LastParameter() - curve->FirstParameter() == 2 * kPi &&
         curve->Value(curve->FirstParameter()).Distance(curve->Value(curve->LastParameter())) <
             1e-14;
}

TEST(Conics, APlaneCutsASphereInAWholeCircle) {
  for (const double angle : {0.0, 0.3, 1.1}) {
    const auto curves = curves_of(plane({0.3, 0.1, 0.5}, tilted(angle)), sphere(O, 2));
    ASSERT_EQ(curves.size(), 1u);
    const auto circle = Handle(Geom_Circle)::DownCast(curves[0]);  // and not a part of one
    ASSERT_FALSE(circle.IsNull());
    EXPECT_TRUE(circle->IsClosed() && circle->IsPeriodic() && is_whole(curves[0]));
    const double off = 0.3 * std::sin(angle) + 0.5 * std::cos(angle);
    EXPECT_NEAR(circle->Radius(), std::sqrt(4 - off * off), 1e-12);
    EXPECT_LE(circle->Location().Distance(gp_Pnt(off * std::sin(angle), 0, off * std::cos(angle))),
              1e-12);
  }
}

TEST(Conics, APlaneCutsACylinderInAWholeEllipse) {
  for (const double angle : {0.2, 0.8, 1.5}) {
    const auto curves = curves_of(plane({0, 0, 1}, tilted(angle), 80), cylinder(O, Z, 2, 60));
    ASSERT_EQ(curves.size(), 1u);
    const auto ellipse = as<Geom_Ellipse>(curves[0]);
    ASSERT_FALSE(ellipse.IsNull());
    EXPECT_TRUE(is_whole(curves[0]));
    EXPECT_NEAR(ellipse->MajorRadius(), 2 / std::cos(angle), 1e-10);
    EXPECT_NEAR(ellipse->MinorRadius(), 2, 1e-11);
    EXPECT_LE(ellipse->Location().Distance({0, 0, 1}), 1e-10);
  }
}

TEST(Conics, PlanesAlongTheAxisCutACylinderInTwoLines) {
  for (const TopoDS_Face& face : {plane({0.7, 0, 0}, X), plane(O, X), plane(O, gp_Dir(1, 2, 0))}) {
    const auto curves = curves_of(face, cylinder(O, Z, 2));
    ASSERT_EQ(curves.size(), 2u);
    for (const auto& curve : curves) {
      const auto line = as<Geom_Line>(curve);
      ASSERT_FALSE(line.IsNull());
      EXPECT_TRUE(line->Lin().Direction().IsParallel(Z, 1e-13));
      EXPECT_NEAR(curve->LastParameter() - curve->FirstParameter(), 20, 1e-12);
    }
  }
}

TEST(Conics, PlanesCutAConeInEveryConic) {
  const TopoDS_Face given = cone(10);
  const double slope = std::tan(kPi / 6);

  const auto ellipse = curves_of(plane({0, 0, 4}, tilted(0.35), 40), given);
  ASSERT_EQ(ellipse.size(), 1u);
  EXPECT_FALSE(as<Geom_Ellipse>(ellipse[0]).IsNull());

  const auto circle = curves_of(plane({0, 0, 4}, Z, 40), given);
  ASSERT_EQ(circle.size(), 1u);
  ASSERT_FALSE(as<Geom_Circle>(circle[0]).IsNull());
  EXPECT_NEAR(as<Geom_Circle>(circle[0])->Radius(), 4 * slope, 1e-12);

  // z = 2 - x / slope is parallel to a generator. Both halves end on the seam.
  const auto parabola_halves = curves_of(plane({0, 0, 2}, {1 / slope, 0, 1}, 60), given);
  EXPECT_EQ(parabola_halves.size(), 2u);
  for (const auto& curve : parabola_halves) {
    const auto parabola = as<Geom_Parabola>(curve);
    ASSERT_FALSE(parabola.IsNull());
    EXPECT_NEAR(parabola->Focal(), slope / 2, 1e-9);
    EXPECT_LE(parabola->Location().Distance({slope, 0, 1}), 1e-9);
  }
  // x = 1: (z slope)^2 - y^2 = 1.
  const auto hyperbola_halves = curves_of(plane({1, 0, 0}, X, 40), given);
  EXPECT_EQ(hyperbola_halves.size(), 2u);
  for (const auto& curve : hyperbola_halves) {
    const auto hyperbola = as<Geom_Hyperbola>(curve);
    ASSERT_FALSE(hyperbola.IsNull());
    EXPECT_NEAR(hyperbola->MajorRadius(), 1 / slope, 1e-8);
    EXPECT_NEAR(hyperbola->MinorRadius(), 1, 1e-8);
  }
}

TEST(Conics, EqualCylindersCrossInTwoEllipses) {
  for (const double angle : {kPi / 2, kPi / 3, kPi / 6}) {
    const double half = 2.5 / std::sin(angle / 2) + 2;
    std::map<int, double> turns;  // of the long and of the short ellipse
    for (const auto& curve :
         curves_of(cylinder(O, Z, 2, half), cylinder(O, tilted(angle), 2, half))) {
      const auto ellipse = as<Geom_Ellipse>(curve);
      ASSERT_FALSE(ellipse.IsNull());
      EXPECT_NEAR(ellipse->MinorRadius(), 2, 1e-9);
      const double major = ellipse->MajorRadius(), shorter = 2 / std::cos(angle / 2),
                   longer = 2 / std::sin(angle / 2);
      EXPECT_LE(std::min(std::abs(major - shorter), std::abs(major - longer)), 1e-9);
      const bool upright =
          std::abs(ellipse->Elips().XAxis().Direction().Dot(tilted(angle / 2 + kPi / 2))) > 0.99;
      turns[upright] += curve->LastParameter() - curve->FirstParameter();
    }
    ASSERT_EQ(turns.size(), 2u);
    for (const auto& [which, turn] : turns) EXPECT_NEAR(turn, 2 * kPi, 1e-2);  // less the nodes
  }
}

TEST(Conics, AreFoundOnToriAndSplinesToo) {
  const TopoDS_Face torus = faces_of(BRepPrimAPI_MakeTorus(5, 2).Shape()).front();
  for (const gp_Dir& normal : {Z, gp_Dir(1, 0.4, 0), gp_Dir(0.4, 0, std::sqrt(0.84))}) {
    const auto circles = curves_of(plane(O, normal), torus);
    EXPECT_GE(circles.size(), 2u);
    for (const auto& curve : circles) EXPECT_FALSE(as<Geom_Circle>(curve).IsNull());
  }

  const TopoDS_Face spline = faces_of(BRepBuilderAPI_NurbsConvert(sphere(O, 2)).Shape()).front();
  const auto curves = curves_of(plane({0.1, 0.2, 0.3}, tilted(0.7)), spline);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_FALSE(as<Geom_Circle>(curves[0]).IsNull());
}

TEST(Conics, AreNotSeenInOtherCurves) {
  for (const auto& [a, b] : {std::pair{cylinder({1, 0.2, 0}, Z, 1.5), sphere(O, 2)},
                             {cylinder(O, Z, 2), cylinder(O, X, 1.9)}})
    for (const FaceIntersection& pair : intersect({a}, {b}).pairs)
      for (const IntersectionCurve& curve : pair.found.curves) EXPECT_FALSE(curve.conic);
}

// A circle that the trims of a face cut into parts, one of them through its start.
TEST(Conics, StayWhatTheyAreWhenTheyAreClipped) {
  const TopoDS_Face square =
      faces_of(BRepPrimAPI_MakeBox(gp_Pnt(-1.8, -1.8, 0), 3.6, 3.6, 1).Shape())[4];
  for (const double turn : {0.0, 0.9}) {
    const gp_Ax3 axes(gp_Pnt(0, 0, 0.5), Z, gp_Dir(std::cos(turn), std::sin(turn), 0));
    const TopoDS_Face round =
        BRepBuilderAPI_MakeFace(new Geom_CylindricalSurface(axes, 2), 0, 2 * kPi, -3, 3, 1e-7)
            .Face();
    const auto curves = curves_of(square, round);
    ASSERT_GE(curves.size(), 4u);
    double sum = 0;
    for (const auto& curve : curves) {
      ASSERT_FALSE(as<Geom_Circle>(curve).IsNull());
      sum += 2 * (curve->LastParameter() - curve->FirstParameter());
      EXPECT_GE(curve->FirstParameter(), 0);
      EXPECT_LT(curve->FirstParameter(), 2 * kPi);
    }
    EXPECT_NEAR(sum, 4 * kPi - 16 * std::acos(0.9), 1e-7);
  }
}

std::map<GeomAbs_CurveType, int> types_of_edges(const TopoDS_Shape& shape) {
  std::map<GeomAbs_CurveType, int> types;
  for (TopExp_Explorer it(shape, TopAbs_EDGE); it.More(); it.Next())
    if (!BRep_Tool::Degenerated(TopoDS::Edge(it.Current())))
      ++types[BRepAdaptor_Curve(TopoDS::Edge(it.Current())).GetType()];
  return types;
}

TEST(Conics, AreEdgesOfTrimmedFaces) {
  const TopoDS_Face disc = plane({0, 0, 0.4}, tilted(0.5), 8), tube = cylinder(O, Z, 2);
  const TrimResult trimmed = trim({{1, disc}}, {{{tube}, {}}});
  ASSERT_EQ(trimmed.pieces.size(), 2u);
  int ellipses = 0;
  for (const TrimPiece& piece : trimmed.pieces) {
    EXPECT_TRUE(BRepCheck_Analyzer(piece.shape).IsValid());
    ellipses += types_of_edges(piece.shape)[GeomAbs_Ellipse];
  }
  EXPECT_GE(ellipses, 2);
}

TEST(Conics, AreWiresOfPlaneSections) {
  const auto faces = faces_of(BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -5), Z), 2, 10).Shape());
  const PlaneSection oblique = plane_section(faces, {{0, 0, 0}, unit(Vec3{0.5, 0, 1})});
  const TopoDS_Compound wires = compound_of(oblique);
  EXPECT_TRUE(BRepCheck_Analyzer(wires).IsValid());
  EXPECT_EQ(types_of_edges(wires), (std::map<GeomAbs_CurveType, int>{{GeomAbs_Ellipse, 1}}));
  const TopoDS_Compound along = compound_of(plane_section(faces, {{0.3, 0, 0}, {1, 0, 0}}));
  EXPECT_TRUE(BRepCheck_Analyzer(along).IsValid());
  EXPECT_EQ(types_of_edges(along), (std::map<GeomAbs_CurveType, int>{{GeomAbs_Line, 4}}));
}

// So fine a circle would be thousands of pieces: it is searched for like any curve.
TEST(Conics, FinerThanPiecesCanBeAreNoneAndNoCrash) {
  const TopoDS_Shape drill =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(5, 5, -1), gp::DZ()), 2, 4).Shape();
  const TopoDS_Face top = BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 1), gp::DZ()), 0, 10, 0, 10);
  IntersectionOptions options;
  options.tolerances.point = 1e-14;
  options.budget = 1000;
  const ShapeIntersection found = intersect({top}, faces_of(drill), options);
  EXPECT_FALSE(found.status == Status::Complete && found.pairs.empty());
}

}  // namespace
}  // namespace blossom::occt
