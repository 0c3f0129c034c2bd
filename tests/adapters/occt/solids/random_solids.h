// SPDX-License-Identifier: LGPL-2.1-or-later
// Pairs of simple solids in random places, as people put them: aligned, touching, tangent, nearly
// so, turned, scaled and far from the origin.

#pragma once

#include <string>

#include <TopoDS_Shape.hxx>
#include <gp_Trsf.hxx>

#include "core/math/vec.h"
#include "tests/support/random.h"

namespace blossom::testing {

enum class Simple { Box, Cylinder, Cone, Sphere, Torus, Prism };

/// A solid in its own place, and where it is put. Lengths are model units.
///
///   Box       a x b x c, one corner in the origin
///   Cylinder  radius a, height c along z
///   Cone      radius a at z = 0 and b at z = c
///   Sphere    radius a
///   Torus     radius a of the ring, b of the tube
///   Prism     `corners` corners on a circle of radius a, height c
struct SimpleSolid {
  Simple kind = Simple::Box;
  double a = 1, b = 1, c = 1;
  int corners = 0;
  gp_Trsf place{};

  /// Made in its size, so that tolerances are those of all new shapes whatever the scale.
  TopoDS_Shape shape() const { return shape_in({}); }
  TopoDS_Shape shape_in(const gp_Trsf& world) const;
  double volume() const;  ///< by closed form, at its place
  double area() const;    ///< likewise
  /// Whether a point, in the space that the solid is put into, is inside.
  bool holds(const Vec3& point) const;
  std::string words() const;
};

struct SolidJob {
  SimpleSolid a, b;
  gp_Trsf world{};  ///< of both
  double off = 0;   ///< how far moved out of a place in which they may touch, model units
  double turn = 0;  ///< how far turned out of it, radians

  TopoDS_Shape first() const { return a.shape_in(world); }
  TopoDS_Shape second() const { return b.shape_in(world); }
  bool nearly() const { return off != 0 || turn != 0; }
  double scale() const { return world.ScaleFactor(); }
  std::string words() const;
};

SolidJob random_job(Random& random);

/// A solid for chains of operations: near the origin, of the size of 1 to 4.
SimpleSolid random_tool(Random& random);

/// About the volume of what both have in common, by counting points, with the expected error.
struct CountedVolume {
  double volume = 0, error = 0;
};
CountedVolume counted_common(const SolidJob& job);

/// The first thing that BRepCheck or `soundness` says against a shape; empty if it is sound.
std::string unsound(const TopoDS_Shape& shape);

/// The value of an environment variable.
int setting(const char* name, int otherwise);

}  // namespace blossom::testing
