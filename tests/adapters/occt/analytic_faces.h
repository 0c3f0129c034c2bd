// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces on planes, cylinders, cones, spheres and tori, and what their intersections have to be.

#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Ax3.hxx>

#include "adapters/occt/intersection.h"

namespace blossom::occt::analytic {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kSpin = 0.37;  // radians: turns seams and poles out of special positions
inline const gp_Pnt O(0, 0, 0);
inline const gp_Dir X(1, 0, 0), Y(0, 1, 0), Z(0, 0, 1);

inline gp_Dir tilted(double degrees) {
  return {std::sin(degrees * kPi / 180), 0, std::cos(degrees * kPi / 180)};
}

inline gp_Ax3 frame(const gp_Pnt& at, const gp_Dir& axis, double spin) {
  gp_Ax3 axes(at, axis);
  axes.Rotate(gp_Ax1(at, axis), spin);
  return axes;
}

inline TopoDS_Face face(const Handle(Geom_Surface) & surface, const Interval& u,
                        const Interval& v) {
  return BRepBuilderAPI_MakeFace(surface, u.from, u.to, v.from, v.to, 1e-7).Face();
}

inline constexpr Interval kTurn{0, 2 * kPi};

/// A face whose seam lies at an angle.
using Maker = std::function<TopoDS_Face(double spin)>;

inline Maker plane(const gp_Pnt& at, const gp_Dir& normal, double half = 20) {
  return [=](double spin) {
    return face(new Geom_Plane(frame(at, normal, spin)), {-half, half}, {-half, half});
  };
}

inline Maker cylinder(const gp_Pnt& at, const gp_Dir& axis, double r, double half = 10) {
  return [=](double spin) {
    return face(new Geom_CylindricalSurface(frame(at, axis, spin), r), kTurn, {-half, half});
  };
}

// 30 degrees between axis and generators, from the apex on if `low` is 0.
inline Maker cone(const gp_Pnt& apex, const gp_Dir& axis, double height, double low = 0) {
  return [=](double spin) {
    return face(new Geom_ConicalSurface(frame(apex, axis, spin), kPi / 6, 0), kTurn,
                {low / std::cos(kPi / 6), height / std::cos(kPi / 6)});
  };
}

inline Maker sphere(const gp_Pnt& at, double r, const gp_Dir& axis = Z) {
  return [=](double spin) {
    return face(new Geom_SphericalSurface(frame(at, axis, spin), r), kTurn, {-kPi / 2, kPi / 2});
  };
}

inline Maker torus(const gp_Pnt& at, double major, double minor, const gp_Dir& axis = Z) {
  return [=](double spin) {
    return face(new Geom_ToroidalSurface(frame(at, axis, spin), major, minor), kTurn, kTurn);
  };
}

inline double perimeter(double a, double b) {
  return 4 * std::max(a, b) *
         std::comp_ellint_2(std::sqrt(1 - std::pow(std::min(a, b) / std::max(a, b), 2)));
}

struct Row {
  std::string name;
  Maker a, b;
  double length = 0;
  int nodes = 0, points = 0, overlaps = 0;
  bool tangential = false;
};

inline void expect_row(const Row& row, const TopoDS_Face& a, const TopoDS_Face& b) {
  const ShapeIntersection found = intersect({a}, {b});
  std::size_t nodes = 0, points = 0, overlaps = 0;
  double length = 0, touching = 0;
  for (const FaceIntersection& pair : found.pairs) {
    nodes += pair.found.nodes.size();
    points += pair.found.points.size();
    overlaps += pair.found.overlaps.size();
    for (const IntersectionCurve& curve : pair.found.curves) {
      length += curve.length;
      touching += curve.tangential ? curve.length : 0;
      const Deviation& d = curve.deviation;
      EXPECT_LE(std::max({d.a, d.b, d.between}), curve.tangential ? 1e-6 : 1e-7);
    }
  }
  EXPECT_LE(found.status, Status::Tolerance);
  EXPECT_NEAR(length, row.length, (row.nodes > 0 ? 1e-3 : 1e-6) * row.length);  // less the nodes
  EXPECT_NEAR(touching, row.tangential ? row.length : 0, 1e-6 * row.length);
  EXPECT_EQ(static_cast<int>(nodes), row.nodes);
  EXPECT_EQ(static_cast<int>(points), row.points);
  EXPECT_EQ(static_cast<int>(overlaps), row.overlaps);
}

}  // namespace blossom::occt::analytic
