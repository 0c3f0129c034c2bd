// SPDX-License-Identifier: LGPL-2.1-or-later
// Contacts of strips in the parameters of their faces: which edges they go over or run along, where
// they lie inside, and where those of two strips cross.

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <vector>

#include "adapters/occt/blending/body_edges.h"
#include "adapters/occt/blending/strips/rolled_strip.h"
#include "core/math/vec.h"

namespace blossom::occt {

/// A contact's meeting with an edge of its face.
struct ContactMeeting {
  double t = 0;  ///< of the strip
  double edge_parameter = 0;
};

/// The meeting of a contact with an edge of its face that is nearest to `near`, by t.
///
/// side   of the strip: 0 or 1
/// use    of the edge, in the contact's face
std::optional<ContactMeeting> meeting_with(const BodyEdges& body, const RolledStrip& strip,
                                           std::size_t side, const EdgeUseInFace& use, double near);

/// Whether a contact at a parameter lies inside of its face.
bool lies_inside(const BodyEdges& body, const RolledContact& contact, double t);

/// Whether the parameters of a face's surface, or others whole periods beside, lie inside of its
/// trims.
bool lies_inside(const BodyEdges& body, int face, const Vec2& uv);

/// Whether a contact lies there, or on the border.
bool lies_on(const BodyEdges& body, const RolledContact& contact, double t);

/// Where a contact goes over an edge of its face.
struct ContactCrossing {
  double t = 0;  ///< of the strip
  const EdgeUseInFace* use = nullptr;
  double edge_parameter = 0;
  bool keep_after = true;  ///< what stays of the edge lies beyond the parameter
  bool leaves = true;      ///< the face, as t grows
};

/// All crossings of a contact with the edges of its face but those left out, by t. Where it runs
/// along the border it goes over none, unless it leaves the face at an end of that.
std::vector<ContactCrossing> contact_crossings(const BodyEdges& body, const RolledStrip& strip,
                                               std::size_t side, const std::set<int>& left_out);

/// The crossings of a contact with one edge of its face, by t, as the face's chart has them: not
/// within the tolerance of the edge.
std::vector<ContactCrossing> chart_crossings(const BodyEdges& body, const RolledStrip& strip,
                                             std::size_t side, const EdgeUseInFace& use);

/// Whether a line in the chart of a face, over [0, 1], meets an edge of the face between its ends,
/// or one lies in what the line cuts off from the face's corner, but for seams and the two edges
/// of the corner.
bool meets_border(const BodyEdges& body, const Handle(Geom2d_Curve) & line, const VertexSector& at,
                  const DirectedEdge& next);

/// Where the contacts of two strips cross on the face that they have in common: t of both, nearest
/// to given ones.
std::optional<std::array<double, 2>> contacts_cross(const BodyEdges& body, const RolledStrip& a,
                                                    std::size_t side_a, double near_a,
                                                    const RolledStrip& b, std::size_t side_b,
                                                    double near_b);

}  // namespace blossom::occt
