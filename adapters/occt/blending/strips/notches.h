// SPDX-License-Identifier: LGPL-2.1-or-later
// Holes and notches of a face on the way of a ball.
//
// Over them the ball has nothing below its contact, and rolls on as if the face went on; the strip
// is cut by what bounds the hole.

#pragma once

#include <cstddef>
#include <vector>

#include "adapters/occt/blending/body_edges.h"
#include "adapters/occt/blending/strips/face_contacts.h"
#include "adapters/occt/blending/strips/rolled_strip.h"

namespace blossom::occt {

/// Where a contact leaves its face over a sharp edge and comes back over one.
struct Notch {
  ContactCrossing leaves, enters;  ///< by t: the first is less

  bool has(double t) const { return t == leaves.t || t == enters.t; }
};

/// All notches of a strip's contact, by t.
///
/// all   crossings of the contact with the edges of its face, by t
std::vector<Notch> notches(const BodyEdges& body, const RolledStrip& strip, std::size_t side,
                           std::vector<ContactCrossing> all);

/// Whether the faces at an edge go on smoothly where a contact goes over it.
bool is_smooth_at(const BodyEdges& body, const ContactCrossing& crossing);

/// Whether a contact goes over the seam of its face.
bool is_seam_at(const BodyEdges& body, const ContactCrossing& crossing);

}  // namespace blossom::occt
