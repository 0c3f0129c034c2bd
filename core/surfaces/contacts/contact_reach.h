// SPDX-License-Identifier: LGPL-2.1-or-later
// What belongs to a contact because the surfaces stay in contact on the way to it.

#pragma once

#include <array>
#include <optional>

#include "core/cells/surface_cells.h"
#include "core/surfaces/contacts/contact_chain.h"
#include "core/surfaces/gap/contact_points.h"
#include "core/surfaces/pairs/pair_search_result.h"

namespace blossom {

/// Tolerances: surfaces this near on the way between two points of contact stay together.
inline constexpr double kAttachGap = 4;

/// A point of one pair of patches in the parameters of the pair of `to`.
Point4 in_patches(const SurfaceCells& a, const SurfaceCells& b, int from_a, int from_b,
                  const Point4& x, const ContactPoint& to);

/// Pieces of contact along a border of patches are found from both sides of it, now from one and
/// now from the other: they are given to the patches above.
void move_above_borders(PairSearchResult& found, const SurfaceCells& a, const SurfaceCells& b);

/// True if two points near each other lie on two sides of a seam.
bool jumps(const Point4& p, const Point4& q, const SurfaceCells& a, const SurfaceCells& b);

/// True if the surfaces stay within a few tolerances of each other between two points of contact,
/// as far as points in between tell.
bool in_contact(SurfaceCells& a, SurfaceCells& b, const ContactPoint& p, const ContactPoint& q,
                double tolerance);

/// The same between the ends of a tangential arc; false for any other.
bool runs_in_contact(SurfaceCells& a, SurfaceCells& b, const FoundArc& arc, double tolerance);

/// The arc that ends at a contact, in the parameters of the contact's patches.
ContactArm arm_of(const PairSearchResult& found, const SurfaceCells& a, const SurfaceCells& b,
                  ArcEnd end, const ContactPoint& contact);

/// Lengthens an arc to a contact: moves its end, to the border of the contact's patches if it lies
/// in others beside them, and adds an arc in these if the contact is no point of the border.
/// Returns the end that is at the contact then.
ArcEnd reach_contact(PairSearchResult& found, const SurfaceCells& a, const SurfaceCells& b,
                     ArcEnd end, const ContactPoint& to);

/// The same from the border of the disc of a node of order n, in which the surfaces stay in
/// contact: by straight arcs in the parameters of a, through all patches between. A branch that
/// bends is followed half the way to the node, and again, until the rest is straight but for
/// rounding: what a chord is off by falls with the square of its length, and the gap there with its
/// power n + 1. So three halvings turn the kDiscGap tolerances of the disc into less than rounding.
/// Where that is not so the arm passes by the node: it ends on the border, and its end is returned
/// as it is.
///
/// tolerance   model units
ArcEnd reach_node(PairSearchResult& found, SurfaceCells& a, SurfaceCells& b, ArcEnd end,
                  const ContactPoint& to, double tolerance);

/// A point that a surface has under all values of one of its parameters.
struct Pole {
  ContactPoint point;
  std::array<bool, 4> free{};  ///< by parameter: all its values give this point
};

/// The pole of a surface that a contact lies at; nothing if both surfaces are regular there.
///
/// length, tolerance   of the contact; model units
std::optional<Pole> pole_near(SurfaceCells& a, SurfaceCells& b, const ContactPoint& contact,
                              double length, double tolerance);

/// The pole as the end of an arc sees it: under the free parameters that the end has, and in its
/// patches, if the pole lies in them.
ContactPoint in_patches_of(const PairSearchResult& found, ArcEnd end, const Pole& pole,
                           const SurfaceCells& a, const SurfaceCells& b);

/// Takes out the critical pairs beside which a line of contact passes, if such a line was found
/// there: all they may hold belongs to it.
///
/// tolerance   model units
void drop_beside_contacts(PairSearchResult& found, SurfaceCells& a, SurfaceCells& b,
                          double tolerance);

}  // namespace blossom
