// SPDX-License-Identifier: LGPL-2.1-or-later
// What two planes, cylinders, cones, spheres or tori have in common by closed forms, where they lie
// to each other so that it is lines, conics, points and the crossings of pipes.

#pragma once

#include <optional>

#include "core/forms/elementary.h"
#include "core/forms/meetings/meeting.h"

namespace blossom {

/// The whole intersection of two surfaces in a ball.
///
/// Known are: planes with spheres; planes with cylinders, whatever the angle; planes through the
/// apex of a cone, or that cut one half of it in an ellipse; planes through the axis of a torus or
/// across it; two spheres; two cylinders whose axes are parallel, or cross and whose radii are
/// equal; cylinders, cones, spheres and tori round one axis; a sphere beside a cylinder; and pipes
/// of one radius, or a sphere and a pipe, that touch along a section of both.
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
