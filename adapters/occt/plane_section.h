// SPDX-License-Identifier: LGPL-2.1-or-later
// The section of a shape with a plane: curves on its faces, chained to wires over its edges.

#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_Curve.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "core/base/tolerances.h"
#include "core/results/options.h"
#include "core/results/result.h"

namespace blossom::occt {

/// The points x with normal . (x - point) = 0.
struct Plane {
  Vec3 point;   ///< model units
  Vec3 normal;  ///< of any length but 0
};

/// Where section curves end or a face only touches the plane.
struct SectionNode {
  Vec3 point;
  TopoDS_Shape on;     ///< the edge or vertex that it lies on; null inside of a face
  double reach = 0;    ///< farthest end of a curve that counts as this point, model units
  bool proven = true;  ///< of a point of an edge: edge and plane cross here, once
};

struct SectionCurve {
  int face = -1;     ///< place in the list of faces; of an edge, one of its faces; -1 without one
  TopoDS_Edge edge;  ///< not null: the curve is this edge, which lies in the plane
  Handle(Geom_Curve) curve;
  Interval range;                      ///< of the curve's parameter
  std::optional<Conic> conic;          ///< what the curve is, if a line or a conic; not of an edge
  Handle(Geom2d_BSplineCurve) pcurve;  ///< on the face, the same parameter; null along an edge
  std::array<int, 2> nodes{-1, -1};    ///< places in PlaneSection::nodes; of a loop, -1
  std::vector<Vec3> samples;           ///< in order, from the first node to the second
  bool closed = false;
  bool tangential = false;
  bool bounding = true;  ///< whether it bounds what plane and solid have in common: not where the
                         ///< solid only touches the plane, or lies on both sides of the curve
  double length = 0;     ///< model units
  double tolerance = 0;  ///< for an edge made of it, model units
  double deviation = 0;  ///< from face and plane, and of the chart curve's image; along an edge: 0
  bool deviation_proven = true;
};

struct CurveUse {
  std::size_t curve = 0;  ///< place in PlaneSection::curves
  bool forward = true;
};

/// Curves that follow each other from node to node.
struct SectionWire {
  std::vector<CurveUse> uses;
  bool closed = false;
  double length = 0;     ///< model units
  bool bounding = true;  ///< as its curves, all or none
  /// Of a closed wire: what it encloses, positive if it runs counter-clockwise seen from the tip of
  /// the normal. Off by no more than the length times how far the curves are off. Model units
  std::optional<double> area{};
};

struct SectionPlace {
  int face = 0;
  Place place;  ///< the second surface is the plane, its parameters are model units
};

struct PlaneSection {
  Status status = Status::Complete;  ///< the weakest of all faces
  std::vector<SectionCurve> curves;
  std::vector<SectionNode> nodes;
  std::vector<SectionWire> wires;    ///< every curve is in one
  std::vector<std::size_t> points;   ///< nodes that no curve comes near
  std::vector<int> faces_in_plane;   ///< within tolerance as a whole; their edges are curves
  std::vector<SectionPlace> places;  ///< what is not proven
  Certificate certificate;           ///< summed over all faces
  long faces_searched = 0;           ///< those whose control points lie on both sides
};

/// The section of faces with a plane.
///
///   (1) a face whose control points lie on one side, farther than the tolerance, has none: proven
///   (2) on other faces the curves are those of `intersect` with the plane, as certified
///   (3) an edge in the plane is one curve, however many faces have it
///   (4) a curve that ends on an edge ends in the node in which that edge meets the plane, which is
///       found once for all its faces
///   (5) closed wires that bound are the border of what the plane and a solid have in common, with
///       faces in the plane; what the plane only touches, or what lies inside, are wires of their
///       own
///
/// Edges without faces have points in common with the plane, or lie in it; what lies in it bounds
/// nothing. Of one that does in part, the ends of that part are nodes, and the status is
/// `tolerance`.
///
/// throws   BadModel if the normal is zero or a number is not finite, or if a face or an edge
/// cannot
///          be converted; the message has the face's place in the list
PlaneSection plane_section(const std::vector<TopoDS_Face>& faces, const Plane& plane,
                           const IntersectionOptions& options = {},
                           const std::vector<TopoDS_Edge>& edges = {});

/// Faces made ready for sections with many planes: what is converted for one serves all.
class SectionedFaces {
 public:
  /// throws   BadModel if a face cannot be used
  explicit SectionedFaces(std::vector<TopoDS_Face> faces, double tolerance = Tolerances{}.point,
                          std::vector<TopoDS_Edge> edges = {});
  ~SectionedFaces();
  SectionedFaces(SectionedFaces&&) noexcept;
  SectionedFaces& operator=(SectionedFaces&&) noexcept;

  const std::vector<TopoDS_Face>& faces() const;

  /// As plane_section.
  PlaneSection section(const Plane& plane, const IntersectionOptions& options = {});

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Turns closed wires so that, seen from the tip of the normal, outer ones run counter-clockwise
/// and holes clockwise: those inside of an odd number of others that bound. By polygons of samples.
void orient_wires(PlaneSection& section, const Plane& plane);

/// What bounding wires enclose, holes taken off, of a section whose wires are oriented: the area
/// that plane and solid have in common. Nothing if a wire that bounds is open. Model units
std::optional<double> bounded_area(const PlaneSection& section);

/// A wire of edges for each wire, which share their vertices, and a vertex for each point.
/// throws   Failure if Open CASCADE makes no edge
TopoDS_Compound compound_of(const PlaneSection& section);

}  // namespace blossom::occt
