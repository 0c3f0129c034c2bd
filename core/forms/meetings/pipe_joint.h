// SPDX-License-Identifier: LGPL-2.1-or-later
// Pipes of one radius, straight or bent, that touch each other along a circle: a cylinder and a
// torus, or two tori, as where an elbow begins. Beside the circle they cross in curves that have a
// closed form, too.

#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/forms/elementary.h"
#include "core/math/interval.h"
#include "core/math/vec.h"

namespace blossom {

/// The circle along which two pipes touch: a section of both.
struct PipeJoint {
  Vec3 centre;
  Vec3 axis;                  ///< a unit vector: both pipes run along it there
  double radius = 0;          ///< model units
  std::array<Vec3, 2> bends;  ///< how either turns: to the centre of its bend, 1 / its radius long
  double gap = 0;             ///< how far the surfaces are from where the closed form has them
};

/// A curve in which pipes cross beside their joint, over a turn of its parameter.
///
/// With Z the axis, k the bend of one pipe and l of the other, d = l - k, F = d / |d| and u a unit
/// vector across Z, a point of the first pipe is
///
///   P = centre + r u + (w / 2) k + z Z,     z^2 = w (1 - r k u - w k^2 / 4)
///
/// where w = |P - centre|^2 - r^2, which is 0 on the joint alone. It is of the other pipe, too,
/// where w = (4 r / |d|) F u. So the curve is one loop through two points of the joint, opposite to
/// each other, with F u = sin^2 t; or two loops through one of them each, where pipes go on beside
/// each other all round their bends: these have the angle about the bend as parameter.
///
/// Derived here: with L = x k and h = |k| / 2, a pipe is w (1 - L) + h^2 w^2 = z^2. The difference
/// of two such equations is w times that of a sphere or plane.
struct PipeCrossing {
  PipeJoint joint;
  int bend = 0;                 ///< of which pipe k is
  Vec3 towards;                 ///< F
  double reach = 0;             ///< 4 r / |d|; square of model units
  int loop = 0;                 ///< 0: the one through both points; else 1 or -1
  std::vector<double> nodes{};  ///< parameters, increasing, of its points on the joint
};

/// The point at a parameter, and the first two derivatives there.
std::array<Vec3, 3> jet_at(const PipeCrossing& crossing, double t);

/// The length between two parameters, model units; to 1e-12 of its size.
double arc_length(const PipeCrossing& crossing, const Interval& range);

/// The joint of two pipes, if they have one, and are not one.
///
/// exact     within which they lie as the closed form has them; model units
/// returns   nothing for other surfaces or positions, also where both bend so nearly alike that
///           they hardly leave each other
std::optional<PipeJoint> pipe_joint(const Elementary& a, const Elementary& b, double exact);

/// All that the pipes of a joint have in common beside it: one loop or two.
///
/// returns   nothing where the pipes touch, or nearly, on the far side of their bends: the loop
///           passes itself there
std::vector<PipeCrossing> crossings_beside(const PipeJoint& joint);

}  // namespace blossom
