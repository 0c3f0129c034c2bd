// SPDX-License-Identifier: LGPL-2.1-or-later
// What two planes, cylinders, cones, spheres or tori have in common by closed forms, where they lie
// to each other so that it is lines, conics and points.

#pragma once

#include <optional>
#include <vector>

#include "core/forms/conic.h"
#include "core/forms/elementary.h"

namespace blossom {

/// What distances count as nothing; model units.
struct MeetingLimits {
  double exact = 0;    ///< axes and centres that lie on each other do so within this; where nothing
                       ///< touches, also if that keeps all curves within half a contact
  double contact = 0;  ///< surfaces that pass each other no farther apart, or deeper, touch
};

/// A line or conic in which two surfaces cross, or along which they touch.
struct MeetingCurve {
  Conic conic;  ///< a line goes on without end
  bool tangential = false;
  double gap = 0;  ///< of a contact: how far the surfaces are apart there, or reach into each other
  std::vector<double> nodes{};  ///< parameters, increasing, where it crosses others of the meeting
};

/// A point in which two surfaces touch.
struct MeetingPoint {
  Vec3 point;
  double gap = 0;
};

/// A point in which curves cross: the surfaces touch there.
struct MeetingNode {
  Vec3 point;
  double gap = 0;    ///< of the surfaces, where axes and radii count as one that differ
  double reach = 0;  ///< so far off the point may curves then bend from one branch to the other
};

struct ElementaryMeeting {
  std::vector<MeetingCurve> curves;
  std::vector<MeetingPoint> points;
  std::vector<MeetingNode> nodes{};
};

/// The whole intersection of two surfaces in a ball.
///
/// Known are: planes with spheres; planes with cylinders, whatever the angle; planes through the
/// apex of a cone, or that cut one half of it in an ellipse; planes through the axis of a torus or
/// across it; two spheres; two cylinders whose axes are parallel, or cross and whose radii are
/// equal; cylinders, cones, spheres and tori round one axis; and a sphere beside a cylinder.
/// Surfaces that touch, or nearly, do so in one point or curve, half way between them: where they
/// reach into each other by no more than the limit, what they cross in lies within the square root
/// of it, and the contact stands for all that.
///
/// ball      holds all that counts of both
/// returns   nothing if the surfaces lie in another way to each other, are one within the limit of
///           contacts, or are planes both
std::optional<ElementaryMeeting> elementary_meeting(const Elementary& a, const Elementary& b,
                                                    const Ball& ball, const MeetingLimits& limits);

}  // namespace blossom
