// SPDX-License-Identifier: LGPL-2.1-or-later
// What several steps of blends decide in the same way.

#pragma once

#include <numbers>

namespace blossom::occt {

/// Tolerances: what meets at one place may be so far apart. A choice: each of some three curves
/// that end there keeps to its surfaces within one tolerance, and their ends are cut at small
/// angles.
inline constexpr double kSamePlace = 10;

/// Faces that a contact, the border of a strip or the end of one may go over one after the other. A
/// choice: each of them is searched anew, and what has not arrived after so many goes round.
inline constexpr int kMaxFacesInARow = 16;

/// Radians: an edge at which faces turn by less is a bend of what a ball rolls on, and the ball
/// goes along an edge that makes a smaller angle with its way. A choice, half way between going on
/// and ending. Over others contacts roll as over notches, or come to an end.
inline constexpr double kMaxBend = 0.25 * std::numbers::pi;

/// Radii past the place where one contact leaves its face, so far the other one is followed to
/// where it leaves its own. Contacts are at most two radii apart; a border across both that makes
/// an angle alpha with the way lets them leave 2 cot(alpha) radii one after the other. A choice: 14
/// degrees.
inline constexpr double kEndRadii = 8;

}  // namespace blossom::occt
