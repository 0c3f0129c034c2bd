// SPDX-License-Identifier: LGPL-2.1-or-later
// Pairs of elementary surfaces that other kernels got wrong once, with the answers that geometry
// gives: what touches, crosses itself or runs over seams and poles.
//
// Cases bugNNNNN are those of Open CASCADE's own tests of that name; the others are named after
// what they show and come from issues of Open CASCADE, FreeCAD, Oblikovati, brepkit and ogeom-rs.
// Besides the counts, points of the intersection found on a grid of the first surface's parameters
// have to lie on the curves or in the listed places.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax3.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/convert/surfaces.h"
#include "adapters/occt/intersection.h"
#include "core/surface_intersection.h"
#include "tests/support/intersection_checks.h"
#include "tests/support/random.h"
#include "tests/support/surface_changes.h"

namespace blossom::occt {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr Interval kTurn{0, 2 * kPi};

// A surface over a box, and the distance to the unbounded one with a sign.
struct Side {
  BezierSurface surface;
  std::function<double(const gp_Pnt&)> off{};
};

gp_Ax3 frame(const gp_Pnt& at, const gp_Dir& axis, const gp_Dir& x) { return {at, axis, x}; }
gp_Ax3 frame(const gp_Pnt& at, const gp_Dir& axis) { return {at, axis}; }

double from_axis(const gp_Ax3& f, const gp_Pnt& p) {
  return gp_Vec(f.Location(), p).Crossed(gp_Vec(f.Direction())).Magnitude();
}
double along_axis(const gp_Ax3& f, const gp_Pnt& p) {
  return gp_Vec(f.Location(), p).Dot(gp_Vec(f.Direction()));
}

Side cylinder(const gp_Ax3& f, double r, Interval v, Interval u = kTurn) {
  return {bezier_surface(new Geom_CylindricalSurface(f, r), {u, v}),
          [=](const gp_Pnt& p) { return from_axis(f, p) - r; }};
}

// v is the height along the axis.
Side cone(const gp_Ax3& f, double half_angle, double r, Interval height) {
  const double c = std::cos(half_angle), t = std::tan(half_angle);
  return {
      bezier_surface(new Geom_ConicalSurface(f, half_angle, r),
                     {kTurn, {height.from / c, height.to / c}}),
      [=](const gp_Pnt& p) { return c * (from_axis(f, p) - std::abs(r + t * along_axis(f, p))); }};
}

Side sphere(const gp_Pnt& at, double r) {
  return {bezier_surface(new Geom_SphericalSurface(frame(at, gp::DZ()), r),
                         {kTurn, {-kPi / 2, kPi / 2}}),
          [=](const gp_Pnt& p) { return at.Distance(p) - r; }};
}

Side torus(const gp_Ax3& f, double major, double minor) {
  return {bezier_surface(new Geom_ToroidalSurface(f, major, minor), {kTurn, kTurn}),
          [=](const gp_Pnt& p) {
            return std::hypot(from_axis(f, p) - major, along_axis(f, p)) - minor;
          }};
}

Side plane(const gp_Ax3& f, Interval u, Interval v) {
  return {bezier_surface(new Geom_Plane(f), {u, v}),
          [=](const gp_Pnt& p) { return along_axis(f, p); }};
}

bool in_one_place(const SurfaceIntersection& found, const Vec3& p, const Vec3& q) {
  constexpr double kSlack = 1e-3;
  return std::any_of(found.places.begin(), found.places.end(), [&](const Place& place) {
    SurfaceIntersection alone;
    alone.places = {place};
    return testing::in_some_place(alone, p, kSlack) && testing::in_some_place(alone, q, kSlack);
  });
}

// Curves that meet at their ends, or end in the same place, are one branch.
int branches(const SurfaceIntersection& found) {
  constexpr double kApart = 1e-6;
  std::vector<std::size_t> parent(found.curves.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i];
    return i;
  };
  const auto ends = [&](std::size_t i) {
    const auto& samples = found.curves[i].samples;
    return std::array{samples.front().point, samples.back().point};
  };
  for (std::size_t i = 0; i < parent.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (const Vec3& p : ends(i))
        for (const Vec3& q : ends(j))
          if (distance(p, q) < kApart || in_one_place(found, p, q)) parent[root(i)] = root(j);
  int count = 0;
  for (std::size_t i = 0; i < parent.size(); ++i) count += parent[i] == i;
  return count;
}

double total_length(const SurfaceIntersection& found) {
  double sum = 0;
  for (const IntersectionCurve& curve : found.curves) sum += curve.length;
  return sum;
}

// Sign changes of the second surface's distance along the grid lines of the first one.
std::vector<Vec3> points_on_both(const BezierSurface& a,
                                 const std::function<double(const gp_Pnt&)>& off) {
  constexpr int kLines = 60, kSteps = 400, kHalvings = 50;
  std::vector<Vec3> points;
  const Interval u{a.u_knots.front(), a.u_knots.back()}, v{a.v_knots.front(), a.v_knots.back()};
  for (const bool along_u : {true, false})
    for (int line = 0; line < kLines; ++line) {
      const auto place = [&](double t) {
        const double s = (line + 0.5) / kLines;
        return point_at(a, along_u ? Vec2{at(u, t), at(v, s)} : Vec2{at(u, s), at(v, t)});
      };
      const auto value = [&](double t) {
        const Vec3 p = place(t);
        return off({p[0], p[1], p[2]});
      };
      for (int k = 0; k < kSteps; ++k) {
        double low = double(k) / kSteps, high = (k + 1.0) / kSteps;
        const bool sign = value(low) < 0;
        if ((value(high) < 0) == sign) continue;
        for (int i = 0; i < kHalvings; ++i) {
          const double middle = 0.5 * (low + high);
          ((value(middle) < 0) == sign ? low : high) = middle;
        }
        points.push_back(place(low));
      }
    }
  return points;
}

struct Case {
  const char* name;
  Side a, b;
  int branches;
  int nodes = 0;
  int points = 0;
  int tangential = 0;
  Status status = Status::Complete;
  double length = 0;                                 ///< 0: not compared
  std::function<bool(const Vec3&)> on_both_boxes{};  ///< where b's box cuts the intersection
};

const gp_Pnt O(0, 0, 0);
const gp_Dir X(1, 0, 0), Y(0, 1, 0), Z(0, 0, 1);

std::vector<Case> cylinder_pairs() {
  return {
      {"bug23178",
       cylinder(frame({4.999999999813, 1.35836143386791, 0.20975890778078}, {-1, 0, 0}, {0, 0, 1}),
                10, {-40, 40}),
       cylinder(frame({9.999999999813, 9.1401960568287, 0.11837300583107},
                      {0, -0.75870713028692, 0.651431877061437},
                      {0, -0.651431877061437, -0.75870713028692}),
                5, {-40, 40}),
       1, 1, 0, 0, Status::Tolerance},
      {"bug28222_2",
       cylinder(frame({-35, 13.3706576198285, 30.5814570420266},
                      {0, -0.258819045102521, -0.965925826289068},
                      {0, 0.965925826289068, -0.258819045102521}),
                11, {-20, 80}),
       cylinder(frame(O, X, {0, 0, -1}), 16.5, {-60, 0}), 2},
      {"bug30082_2",
       cylinder(frame({-106.471129473161, -64.3442185874231, -19.25}, X, {0, 0, -1}), 0.25,
                {-30, 0}),
       cylinder(frame({-124.971129473161, -67.0942185874231, -20.5}, Z, X), 3, {-3, 5}), 1, 1, 0, 0,
       Status::Tolerance},
      {"bug25782_2", cylinder(frame(O, gp_Dir(12, 35, 47)), 5, {-20, 20}),
       cylinder(frame({3, 2, 8}, gp_Dir(12, 35, 47)), 4, {-50, 50}), 2, 0, 0, 0, Status::Complete,
       80},
      {"bug21750",
       cylinder(frame({1031.3339148728076, -113.25868616662650, 56.152387686082520},
                      {-0.86602540378443815, 0.5, 0}, {-0.5, -0.86602540378443815, 0}),
                76.5, {-50, 50}),
       cylinder(frame({1017.0706583606553, -103.24955863669388, 56.152387686082548},
                      {0.86602540378443815, -0.5, 0}, {0.5, 0.86602540378443815, 0}),
                76.5, {-100, 100}),
       2, 0, 0, 0, Status::Complete, 200},
      {"bug32850",
       cylinder(frame({25.8071575178163, 0, -373.974517822281}, Y,
                      {-1.73024882663956e-06, 0, 0.999999999998503}),
                408.974517822893, {-146.010003766057, 2146.01000376606}, {0, 0.0225015452057227}),
       cylinder(frame({0, 1974.19284248218, -373.974517822281}, X,
                      {0, 1.73024882663956e-06, 0.999999999998503}),
                408.974517822893, {-146.010003766057, 946.010003766057}, {0, 0.0225015452057227}),
       1, 1, 0, 0, Status::Tolerance, 0, [](const Vec3& p) { return p[1] < 1974.192; }},
      {"bug31552",
       cylinder(frame({0, 557.800010681152, 0}, Z, Y), 347.850006103516, {-39.957, 39.957},
                {3.2385, 6.28319}),
       cylinder(
           frame({5.45639675193397, 189.209310035068, 0}, {-0.254420004160252, 0.96709382248213, 0},
                 {0.96709382248213, 0.254420004160252, 0}),
           88.5, {0, 10.0002}, {6.19592, 6.37045}),
       1, 0, 0, 0, Status::Complete, 0,
       [](const Vec3& p) { return p[0] > 5.5 && std::abs(p[2]) < 7.71; }},
      {"bug27937_2",
       Side{bezier_surface(
           new Geom_SurfaceOfLinearExtrusion(
               new Geom_Ellipse(gp_Ax2(O, Z), 6.03031367203927, 3.11993062568844), Z),
           {kTurn, {-5, 5}})},
       cylinder(frame(O, X), 0.249128788767645, {-10, 10}), 2},
  };
}

std::vector<Case> torus_and_cone_pairs() {
  return {
      {"bug27227", torus(frame(O, Z), 100, 20), torus(frame(O, {0, -1, 0}), 100, 20), 2, 4, 0, 0,
       Status::Tolerance},
      {"bug29807_i5002",
       cone(frame({11.4307383137554, 3.49999999999979, -89.7537975119388}, Z, X),
            80.000725670142287 * kPi / 180, 9.45659107381736, {-5, 5}),
       cone(frame({-3.6479413426839, -11.578679656441, -89.9782110643133}, Z, Y), 5 * kPi / 180,
            0.250951325477062, {-2, 20}),
       1},
      {"bug33244",
       cone(frame({-1.11630646267172, -4.54487349779333, 13.2493435203532},
                  {-1.05794851588922e-07, -1.39278337794573e-08, 0.999999999999994},
                  {0.999999999999994, 5.91645678915759e-31, 1.05794851588922e-07}),
            0.785398163360967, 0.560000000061149, {-10, 10}),
       cone(frame({-2.08647872350287e-07, -5.78732475509323, 13.2493436211},
                  {-1.05794850062242e-07, -1.39278350756825e-08, 0.999999999999994},
                  {0.999999999999995, 0, 1.05794850062242e-07}),
            0.785398163396248, 0.785398163396248, {-20, 20}),
       2},
      {"bug21494", cone(frame(O, Z), -std::atan(1.5), 15, {0, 10}), sphere(O, 10), 1, 0, 1, 0,
       Status::Tolerance, 2 * kPi * 15 * (1 - 125.0 / 325)},
      {"bug26008", sphere({78.4160443343, 8.94293392454, 70.9553808628}, 6.5),
       sphere({82.5593917073, 4.52613090823, 76.3299967}, 3.5), 1},
      {"bug23177_1", torus(frame(O, Z), 100, 10), plane(frame(O, Y, X), {-150, 150}, {-50, 50}), 2,
       0, 0, 0, Status::Tolerance, 40 * kPi},
  };
}

std::vector<Case> pairs_that_nearly_touch() {
  return {
      {"thick_and_thin_cylinder", cylinder(frame(O, Z), 2, {-5, 5}),
       cylinder(frame({0, 2, 0}, X), 0.5, {0, 4}), 1, 0, 0, 0, Status::Tolerance, 0,
       [](const Vec3& p) { return p[0] > 0; }},
      {"cylinder_and_half_sphere", cylinder(frame(O, Z), 50, {0, 200}), sphere({60, 0, 100}, 50),
       1},
      {"tube_and_cylinder_of_one_radius", torus(frame(O, Z), 5, 1.5),
       cylinder(frame({5, 0, 0}, Z), 1.5, {-3, 3}), 1, 2, 0, 0, Status::Tolerance},
      {"torus_and_cylinder_to_its_outside", torus(frame(O, Z), 5, 1.5),
       cylinder(frame({4, 0, 0}, Z), 2.5, {-3, 3}), 1, 1, 0, 0, Status::Tolerance},
      {"spheres_side_by_side", sphere(O, 3), sphere({5, 0, 0}, 2), 0, 0, 1, 0, Status::Tolerance},
      {"cylinders_with_a_neck", cylinder(frame(O, Z), 3, {-5, 5}),
       cylinder(frame(O, X), 3 - 3.6e-5, {-5, 5}), 2},
      {"sphere_and_cylinder_almost_coaxial", sphere(O, 2),
       cylinder(frame({1e-3, 0, 0}, Z), 2, {-3, 3}), 1, 0, 0, 0, Status::Tolerance},
      {"cone_through_its_apex_and_sphere", cone(frame(O, Z), std::atan(0.5), 0.5, {-3, 3}),
       sphere({0, 0, -0.9}, 1), 2},
      {"torus_and_plane", torus(frame(O, Z), 3, 1), plane(frame({0, 0, 0.5}, Z), {-5, 5}, {-5, 5}),
       2, 0, 0, 0, Status::Complete, 12 * kPi},
      {"spheres_inside_each_other", sphere(O, 2), sphere({0.999, 0, 0}, 1), 0},
  };
}

std::vector<Case> pairs_over_seams_and_poles() {
  return {
      {"sphere_and_plane_along_its_seam", sphere(O, 1), plane(frame(O, Y, X), {-2, 2}, {-2, 2}), 1,
       0, 0, 0, Status::Tolerance, 2 * kPi},
      {"sphere_and_plane_through_both_poles", sphere(O, 1),
       plane(frame(O, {std::sin(0.5), std::cos(0.5), 0}), {-2, 2}, {-2, 2}), 1, 0, 0, 0,
       Status::Tolerance, 2 * kPi},
      {"sphere_and_plane_through_one_pole", sphere(O, 1),
       plane(frame({0, 0, 1}, {1, 0.3, 0.4}), {-3, 3}, {-3, 3}), 1, 0, 0, 0, Status::Tolerance,
       2 * kPi * std::sqrt(1 - 0.16 / 1.25)},
      {"sphere_through_both_poles_of_another", sphere(O, 1), sphere({1, 0, 0}, std::sqrt(2.0)), 1,
       0, 0, 0, Status::Tolerance, 2 * kPi},
      {"cone_and_plane_through_its_apex", cone(frame(O, Z), std::atan(0.5), 0.5, {-1, 3}),
       plane(frame(O, Y, X), {-3, 3}, {-3, 3}), 1, 0, 0, 0, Status::Tolerance, 4 * std::sqrt(5.0)},
      {"bug26576_4",
       Side{bezier_surface(
           new Geom_SurfaceOfRevolution(
               new Geom_TrimmedCurve(new Geom_Circle(gp_Ax2({1.5, 3.125, 0}, Z), 0.25), 0, kPi),
               gp_Ax1({1.5, 3.125, 0}, {-1, 0, 0})),
           {kTurn, {0, kPi}})},
       plane(frame({3.48352775473762, 1.7282347013387, 0}, {0, 0, -1}, {-1, 0, 0}), {0, 4},
             {-3, 3}),
       1, 0, 0, 0, Status::Tolerance, 0.5 * kPi},
  };
}

std::vector<Case> pairs_that_touch() {
  return {
      {"viviani", sphere(O, 2), cylinder(frame({1, 0, 0}, Z), 1, {-3, 3}), 1, 1, 0, 0,
       Status::Tolerance, 2 * 7.6404},
      {"bug29972_3_a_tenth_as_large", torus(frame({-12.7, 8.4, 10}, {0, 0, -1}, X), 2.3, 1),
       cylinder(frame({-13.2, 6.15500556793564, 13.1}, {0, 0, -1}, X), 1, {0, 6}), 1, 2, 0, 0,
       Status::Tolerance, 15.3523},
      {"torus_and_plane_on_top", torus(frame(O, Z), 3, 1),
       plane(frame({0, 0, 1}, Z), {-5, 5}, {-5, 5}), 1, 0, 0, 1, Status::Tolerance, 6 * kPi},
      {"sphere_in_cylinder", sphere(O, 1), cylinder(frame(O, Z), 1, {-2, 2}), 1, 0, 0, 1,
       Status::Tolerance, 2 * kPi},
      {"torus_and_cylinder_inside", torus(frame(O, Z), 5, 1.5), cylinder(frame(O, Z), 3.5, {-3, 3}),
       1, 0, 0, 1, Status::Tolerance, 7 * kPi},
      {"perpendicular_unit_cylinders", cylinder(frame(O, Z), 1, {-2, 2}),
       cylinder(frame(O, X), 1, {-2, 2}), 1, 2, 0, 0, Status::Tolerance, 2 * 7.6404},
  };
}

const std::vector<Case>& cases() {
  static const std::vector<Case> all = [] {
    std::vector<Case> joined;
    for (const auto& some : {cylinder_pairs(), torus_and_cone_pairs(), pairs_that_nearly_touch(),
                             pairs_over_seams_and_poles(), pairs_that_touch()})
      joined.insert(joined.end(), some.begin(), some.end());
    return joined;
  }();
  return all;
}

class KnownPairs : public ::testing::TestWithParam<int> {
 protected:
  const Case& row() const { return cases()[static_cast<std::size_t>(GetParam())]; }
};

void expect_answer(const SurfaceIntersection& found, const Case& row) {
  const auto tangential = std::count_if(found.curves.begin(), found.curves.end(),
                                        [](const auto& curve) { return curve.tangential; });
  EXPECT_EQ(weaker(found.status, row.status), row.status);  // at least
  EXPECT_EQ(branches(found), row.branches);
  EXPECT_EQ(static_cast<int>(found.nodes.size()), row.nodes);
  EXPECT_EQ(static_cast<int>(found.points.size()), row.points);
  EXPECT_EQ(tangential, row.tangential);
  EXPECT_TRUE(found.overlaps.empty());
  if (row.length > 0) {
    EXPECT_NEAR(total_length(found), row.length, 1e-3 * row.length);  // nodes are left out
  }
}

void expect_on_both(const SurfaceIntersection& found, const BezierSurface& a,
                    const BezierSurface& b) {
  for (const IntersectionCurve& curve : found.curves) {
    EXPECT_LE(std::max({curve.deviation.a, curve.deviation.b, curve.deviation.between}), 1.01e-7);
    for (const SurfacePoint& sample : curve.samples) {
      EXPECT_LE(distance(point_at(a, sample.uv_a), sample.point), 1e-9);
      EXPECT_LE(distance(point_at(b, sample.uv_b), sample.point), 1e-9);
    }
  }
}

void expect_all_of(const std::vector<Vec3>& points, const SurfaceIntersection& found) {
  constexpr double kSlack = 1e-6;
  const testing::CurveDistance curves(found);
  for (const Vec3& p : points)
    EXPECT_TRUE(curves.to(p) <= kSlack || testing::in_some_place(found, p, kSlack))
        << p[0] << " " << p[1] << " " << p[2] << " is missed by " << curves.to(p);
}

TEST_P(KnownPairs, AreRightInBothOrders) {
  const Side &a = row().a, &b = row().b;
  std::vector<Vec3> points =
      b.off ? points_on_both(a.surface, b.off) : points_on_both(b.surface, a.off);
  if (row().on_both_boxes)
    std::erase_if(points, [&](const Vec3& p) { return !row().on_both_boxes(p); });

  const SurfaceIntersection there = intersect(a.surface, b.surface);
  const SurfaceIntersection back = intersect(b.surface, a.surface);

  expect_answer(there, row());
  expect_on_both(there, a.surface, b.surface);
  expect_all_of(points, there);
  expect_answer(back, row());
  expect_on_both(back, b.surface, a.surface);
  expect_all_of(points, back);
}

// Between a curve and the images of its chart curves, at many places. The proven bound may be
// larger along a seam that rounding makes the chart curve cross.
double largest_gap(const IntersectionCurve& curve, const BezierSurface& a, const BezierSurface& b) {
  constexpr int kSteps = 5000;
  double gap = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const double t = i * curve.curve.knots.back() / kSteps;
    const Vec3 p = point_at(curve.curve, t);
    gap = std::max({gap, distance(p, point_at(a, point_at(curve.chart_a, t))),
                    distance(p, point_at(b, point_at(curve.chart_b, t)))});
  }
  return gap;
}

// Poles and seams stay where they are on the surfaces, but no longer along the axes.
TEST_P(KnownPairs, AreTheSameTurnedAndScaled) {
  constexpr double kScale = 0.1, kTolerance = 1e-8;
  if (row().length == 0) GTEST_SKIP() << "its length is not known";
  testing::Random random(17);
  testing::Motion motion = testing::random_motion(random);
  motion.scale = kScale;
  const BezierSurface a = moved(row().a.surface, motion), b = moved(row().b.surface, motion);

  for (const auto& [first, second] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
    const SurfaceIntersection found =
        intersect(*first, *second, {.tolerances = {.point = kTolerance}});

    EXPECT_LE(found.status, Status::Tolerance);
    EXPECT_EQ(branches(found), row().branches);
    EXPECT_EQ(static_cast<int>(found.nodes.size()), row().nodes);
    EXPECT_EQ(static_cast<int>(found.points.size()), row().points);
    EXPECT_NEAR(total_length(found), kScale * row().length, 1e-3 * kScale * row().length);
    for (const IntersectionCurve& curve : found.curves)
      // Chart curves of tangential ones are fitted less closely, and say so.
      EXPECT_LE(largest_gap(curve, *first, *second),
                curve.tangential
                    ? std::max({kTolerance, curve.deviation.a, curve.deviation.b}) + 1e-12
                    : kTolerance);
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, KnownPairs, ::testing::Range(0, static_cast<int>(cases().size())),
                         [](const auto& which) {
                           return std::string(cases()[static_cast<std::size_t>(which.param)].name);
                         });

// A disc of the plane y = 0 and a half cylinder beyond it.
TEST(KnownSolids, ADiscAndAHalfCylinderApartDoNotMeet) {
  const TopoDS_Face disc = BRepBuilderAPI_MakeFace(
      gp_Pln(O, Y), BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(O, Y), 10))));
  const TopoDS_Face half = BRepBuilderAPI_MakeFace(
      new Geom_CylindricalSurface(frame({20, 0, 0}, Y), 2), 0, kPi, -5, 5, 1e-7);

  EXPECT_TRUE(intersect({disc}, {half}).pairs.empty());
  EXPECT_TRUE(intersect({half}, {disc}).pairs.empty());
}

}  // namespace
}  // namespace blossom::occt
