// SPDX-License-Identifier: LGPL-2.1-or-later
// The strip that a ball leaves as it rolls along an edge of a body.

#pragma once

#include <array>
#include <functional>
#include <optional>

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopoDS_Face.hxx>

#include "adapters/occt/blending/body_edges.h"
#include "adapters/occt/blending/strips/ball_supports.h"
#include "adapters/occt/fillet.h"
#include "core/math/interval.h"
#include "core/math/vec.h"

namespace blossom::occt {

/// What a strip is like across and along its edge.
struct StripProfile {
  double radius = 1;  ///< of the ball; the largest with a law
  /// Radii along the forward edge, over [0, 1] in proportion to its parameter.
  std::optional<RadiusLaw> law{};
  FilletSection section{};

  bool is_ball() const { return !law && section.kind == SectionKind::Circle; }
};

/// The distances of a chamfer's borders from the edge, on the face to the left of the forward edge
/// and on the right, or the angle at one of them.
struct ChamferProfile {
  std::array<double, 2> distance{1, 1};
  std::optional<double> angle{};  ///< between the chamfer and the face of side `given`
  std::size_t given = 0;          ///< the other distance follows from the angle
};

/// Where the strip touches one of the two faces. Curves have the strip's parameter t.
struct RolledContact {
  int face = 0;
  Handle(Geom_Curve) curve;
  Handle(Geom2d_Curve) chart;  ///< in the parameters of the face's surface
  double w = 0;                ///< the strip's other parameter
};

/// A strip with parameters t along the edge, growing as the forward edge runs, and w across.
struct RolledStrip {
  int edge = 0;
  bool concave = false;
  double radius = 0;    ///< model units; the largest, or a chamfer's larger distance
  bool is_ball = true;  ///< its sections are circles of that radius
  Handle(Geom_Surface) surface;
  bool along_u = true;                    ///< whether t is the surface's u
  bool outward = true;                    ///< whether du x dv points out of the material
  bool closed = false;                    ///< the edge is; the range is once round then
  Handle(Geom_Curve) spine;               ///< the centre of the ball, by t
  std::array<RolledContact, 2> contacts;  ///< of the face to the left of the forward edge, right
  Interval range;                         ///< of t; further than the edge where it is open
  Interval edge_range;                    ///< t of the sections through the edge's ends
  /// The edges at the far side of a narrow face on which the ball leans in place of touching it, by
  /// contact; 0: it touches. The contact then runs along the edge, as a curve of that face.
  std::array<int, 2> held{};
  /// Likewise the bends of what it rolls on; the contact is a curve of the face that stays behind.
  std::array<int, 2> bend{};

  /// The same strip over another range inside of `most`; none where the range is all there is.
  std::function<RolledStrip(const Interval&)> over{};
  Interval most{};
  /// Whether the ball has a radius of curvature of a face at the least and the largest of these,
  /// and so cannot go on.
  std::array<bool, 2> pinched{};
  /// Of a closed strip along an edge that is not: what of it is beside the edge.
  std::function<RolledStrip()> opened{};

  Vec2 chart(double t, double w) const { return along_u ? Vec2{t, w} : Vec2{w, t}; }
  /// The chart curves of a contact, by t, and of a section, by w.
  Handle(Geom2d_Curve) contact_line(double w) const;
  Handle(Geom2d_Curve) section_line(double t) const;
  /// The bare surface as a face, without wires.
  TopoDS_Face bare_face() const;
};

/// The strip along a line or circle whose faces are the same all along: planes and cylinders along
/// a line; planes, cylinders, cones, spheres and tori round one axis. A piece of a cylinder, torus
/// or sphere. Nothing for other edges.
///
/// In the plane across the edge each face is a line or a circle, and the centre of the ball is
/// where their parallels at the distance of the radius cross, next to the edge.
///
/// concave   whether the edge is
/// held      edges on which the ball leans in place of touching the face to the left of the forward
///           edge, or right; 0: none. They have to be parallel to the edge, or circles round its
///           axis.
/// throws    FilletRefused if there is no such ball
std::optional<RolledStrip> swept_strip(const BodyEdges& body, int edge, bool concave, double radius,
                                       const std::array<int, 2>& held = {});

/// The strip along any other edge: the ball is traced along both surfaces, which go on past the
/// trims, and past natural borders as their outer spans do.
///
/// throws    FilletRefused if there is no such ball, or it is too large for a face's curvature
RolledStrip traced_strip(const BodyEdges& body, int edge, bool concave,
                         const StripProfile& profile);

/// The strip of a ball that is known to touch two faces, both ways from there; t grows the way it
/// goes.
///
/// edge      in whose place it is, for refusals and names
/// throws    as `traced_strip`
RolledStrip traced_strip(const BodyEdges& body, const BallPlace& place, int edge, bool concave,
                         const StripProfile& profile);

/// Where a strip that lies in the planes across an edge, as chamfers and fillets by a law do, goes
/// on over another face than the edge's.
struct GuidedPlace {
  int edge = 0;                  ///< in the planes across which it lies
  std::array<int, 2> faces{};    ///< of the contacts, to the left of the forward edge and right
  std::array<Vec2, 2> charts{};  ///< near the contacts there
  double at = 0;                 ///< the edge's parameter
  bool ahead = true;             ///< the strip goes on to where that grows
};

/// The strip of a ball of radii by a law on these faces, both ways from there.
///
/// throws    as `traced_strip`
RolledStrip traced_strip(const BodyEdges& body, const GuidedPlace& place, bool concave,
                         const StripProfile& profile);

/// The strip of a chamfer: in each plane across the edge the chord between the points of both faces
/// that have the given distances from the edge. Planes, cylinders and cones are written as such.
///
/// throws    FilletRefused where a face has no such points
RolledStrip chamfer_strip(const BodyEdges& body, int edge, bool concave,
                          const ChamferProfile& profile);

/// The same on other faces than the edge's, from the place on as far as the ends of longer strips
/// go past an edge.
RolledStrip chamfer_strip(const BodyEdges& body, const GuidedPlace& place, bool concave,
                          const ChamferProfile& profile);

}  // namespace blossom::occt
