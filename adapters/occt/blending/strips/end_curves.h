// SPDX-License-Identifier: LGPL-2.1-or-later
// Where strips, and contacts in space, meet the faces, edges and strips at their ends.

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>

#include "adapters/occt/blending/body_edges.h"
#include "adapters/occt/blending/strips/rolled_strip.h"
#include "core/math/interval.h"
#include "core/math/vec.h"

namespace blossom::occt {

/// Where a strip narrows to a point in a vertex.
struct NarrowEnd {
  double t = 0;     ///< of the strip
  double off = 0;   ///< how far its contacts are from the vertex there
  double room = 0;  ///< and how far they may be
};

/// The end of a strip in a vertex in which the faces on both sides of its edge meet smoothly, to
/// within the tolerance; nothing if it is not narrow there.
///
/// tolerance   model units
std::optional<NarrowEnd> narrow_end(const BodyEdges& body, const RolledStrip& strip,
                                    const DirectedEdge& half, double tolerance);

/// Where an edge goes through a strip.
struct EdgeThrough {
  double edge_parameter = 0;
  double t = 0, w = 0;  ///< of the strip
  Vec3 point;
};

/// All places where an edge goes through a strip.
///
/// part   of t in which the strip is looked at
std::vector<EdgeThrough> edge_through(const RolledStrip& strip, const Interval& part,
                                      const BodyEdges& body, int edge);

/// A piece of the curve in which a strip and the surface of a face meet.
struct EndCurve {
  Handle(Geom_Curve) curve;
  Handle(Geom2d_Curve) on_strip, on_face;  ///< with its parameter
  Interval range;                          ///< increasing
  bool forward = true;                     ///< whether it runs as was asked
};

/// The piece between two points that are near the curve; nothing if no curve comes as near to both
/// as `reach`.
///
/// part    of t in which the strip is looked at
std::optional<EndCurve> curve_between(const RolledStrip& strip, const Interval& part,
                                      const TopoDS_Face& face, const Vec3& from, const Vec3& to,
                                      double reach);

/// The same where the piece is known to lie inside of the face's trims.
std::optional<EndCurve> curve_in_face(const RolledStrip& strip, const Interval& part,
                                      const TopoDS_Face& face, const Vec3& from, const Vec3& to,
                                      double reach);

/// The same of two strips; `on_face` is on the other one.
std::optional<EndCurve> curve_between(const RolledStrip& strip, const Interval& part,
                                      const RolledStrip& other, const Interval& other_part,
                                      const Vec3& from, const Vec3& to, double reach);

/// Where a contact goes through another strip: its t nearest to `near`.
std::optional<double> contact_through(const RolledStrip& of, std::size_t side, double near,
                                      const RolledStrip& other, const Interval& other_part);

/// Where a contact goes through the surface of a face: its t nearest to `near`.
///
/// part   of t in which the contact is looked at
std::optional<double> contact_through(const RolledStrip& of, std::size_t side, double near,
                                      const TopoDS_Face& face, const Interval& part);

/// Where the edge of two faces, if it went on past a vertex of it, would go through a strip: the
/// nearest place in which the strip and the surfaces of both faces meet. Nothing if it is not
/// between the contacts.
std::optional<EdgeThrough> grown_through(const RolledStrip& strip, const Interval& part,
                                         const TopoDS_Face& a, const TopoDS_Face& b,
                                         const Vec3& vertex);

/// Where two strips that run into each other leave a face that both come to: the common point of
/// the three surfaces nearest to the vertex, between the contacts of both, or beside one by no more
/// than `reach`. By the parameters of the first.
std::optional<EdgeThrough> mitre_through(const RolledStrip& strip, const Interval& part,
                                         const RolledStrip& other, const Interval& other_part,
                                         const TopoDS_Face& face, const Vec3& vertex, double reach);

/// The piece of the curve in which the surfaces of two faces meet; `on_strip` is in the parameters
/// of the wall.
std::optional<EndCurve> wall_curve_between(const TopoDS_Face& wall, const TopoDS_Face& face,
                                           const Vec3& from, const Vec3& to, double reach);

}  // namespace blossom::occt
