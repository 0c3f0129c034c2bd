// SPDX-License-Identifier: LGPL-2.1-or-later
// Planes, cylinders, cones, spheres and tori as sets of points, and how far two of them are apart.
//
// Files keep a surface that two parts have in common twice, with other frames and rounded digits.
// Whether two such surfaces are one is told by a bound on their distance.

#pragma once

#include "core/math/vec.h"

namespace blossom {

enum class ElementaryKind { Plane, Cylinder, Cone, Sphere, Torus };

/// With d(x, S) the distance of a point from a set:
///
///   plane      { x : n (x - centre) = 0 },              n = axis
///   cylinder   { x : d(x, line through centre along axis) = radius }
///   cone       both halves round the axis; centre: the apex, angle: between axis and rulings
///   sphere     { x : |x - centre| = radius }
///   torus      { x : d(x, circle round centre) = minor }, the circle's radius: radius
struct Elementary {
  ElementaryKind kind = ElementaryKind::Plane;
  Vec3 centre;
  Vec3 axis{0, 0, 1};  ///< a unit vector; of a sphere without meaning
  double radius = 0;   ///< model units
  double minor = 0;    ///< likewise
  double angle = 0;    ///< in (0, pi / 2)
};

/// Such a surface in its natural parameters, lengths in model units and angles in radians. With
/// e(u) = cos u x + sin u y:
///
///   plane      O + u x + v y
///   cylinder   O + R e(u) + v z
///   cone       O + (R + v sin a) e(u) + v cos a z
///   sphere     O + R cos v e(u) + R sin v z
///   torus      O + (R + r cos v) e(u) + r sin v z
struct ElementaryChart {
  ElementaryKind kind = ElementaryKind::Plane;
  Vec3 origin{};
  Vec3 x{1, 0, 0};  ///< orthonormal, right- or left-handed
  Vec3 y{0, 1, 0};
  Vec3 z{0, 0, 1};
  double radius = 0;  ///< R
  double minor = 0;   ///< r
  double angle = 0;   ///< a, in (-pi / 2, pi / 2)
};

/// The part of a vector that is perpendicular to a unit vector.
inline Vec3 across(const Vec3& vector, const Vec3& axis) {
  return vector - dot(vector, axis) * axis;
}

/// How far a point is above a surface, and the direction in which that grows: a unit vector.
struct Height {
  double value = 0;
  Vec3 rise;
};

/// The distance of a point from a surface but for its sign, which changes where the point crosses
/// it. Of a cone the nearer half counts, and its rulings go on beyond the apex. On an axis, in the
/// centre of a sphere and on the ring of a torus the direction is one of many, or nothing.
Height height_over(const Elementary& surface, const Vec3& point);

/// A ball in space.
struct Ball {
  Vec3 centre;
  double radius = 0;
};

/// A bound on the distance of the points of one surface in a ball from the other surface.
///
/// The distance from a set that moves changes by no more than the set does, so it is summed over
/// the moves that take one surface to the other. With s the sine of the angle between the axes, c
/// and r the ball's centre and radius, q the point of a's axis, or of a's plane, next to c:
///
///   plane      d(q, b) + s r
///   cylinder   d(q, axis of b) + s (r + |q - c|) + |difference of radii|
///   cone       |difference of apexes| + (t + |difference of angles|) (r + |c - apex|)
///   sphere     |difference of centres| + |difference of radii|
///   torus      |difference of centres| + t radius + |differences of both radii|
///
/// where t <= pi s / 2 is the angle between the axes, turned to less than a right one. A cone is
/// off the plane through its apex by no more than (r + |c - apex|) / tan angle, which makes one
/// that is nearly flat a plane.
///
/// returns   infinite for surfaces of two other kinds; roundings are added
double distance_bound(const Elementary& a, const Elementary& b, const Ball& ball);

}  // namespace blossom
