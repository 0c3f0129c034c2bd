// SPDX-License-Identifier: LGPL-2.1-or-later
// One edge divided where it meets a shape, and where its pieces lie to that.

#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Bnd_Box.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>

#include "adapters/occt/base/shared_limit.h"
#include "core/base/status.h"
#include "core/math/interval.h"
#include "core/math/vec.h"
#include "core/results/options.h"

namespace blossom::occt {

/// How a piece of an edge, or a vertex, lies to a shape: on one of its faces, edges and vertices,
/// or inside of one of its closed solids.
enum class WireSide { Outside, On, Inside };

struct WirePiece {
  Interval range;  ///< parameters of the edge
  WireSide side = WireSide::Outside;
};

/// Pieces from end to end, which meet where the edge and the shape have a point in common.
struct DividedEdge {
  Status status = Status::Complete;  ///< of the intersections
  std::vector<WirePiece> pieces;
  std::string obstacle;              ///< why the sides of pieces are not known; empty if they are
  std::vector<std::string> reasons;  ///< why the status is not complete
};

/// A common point at which no common stretch begins or ends.
struct MetPoint {
  double parameter = 0;
  TopoDS_Shape on;  ///< vertex, edge or face: of several that of least dimension
};

/// A piece that lies on the shape.
struct MetStretch {
  Interval range;
  TopoDS_Shape on;  ///< an edge or a face
};

/// What an edge and the shape have in common.
struct MetEdge {
  Status status = Status::Complete;
  std::vector<MetPoint> points;       ///< by increasing parameter
  std::vector<MetStretch> stretches;  ///< likewise
  std::vector<std::string> reasons;
};

struct EdgeMeetings;
struct EdgeObstacles;
struct ObstacleChart;

/// Divides edges by all faces, edges and vertices of a shape, whatever it is made of.
///
/// What is nearer than the tolerance, or than what the two state of which one is asked about the
/// other, is a common point. Common points that the edge does not leave by more than that between
/// them are one, and the ends of the edge come first.
class EdgeDivider {
 public:
  /// shape     kept
  /// solids    the closed ones in it
  /// options   kept by reference; their limits are those of all questions together
  EdgeDivider(const TopoDS_Shape& shape, const std::vector<TopoDS_Solid>& solids,
              const IntersectionOptions& options);
  ~EdgeDivider();

  /// edge     has a curve in space
  /// throws   BadModel if a face that it comes near cannot be converted
  ///
  /// Once a limit is reached the status is Stopped, and there are no pieces.
  DividedEdge divide(const TopoDS_Edge& edge);

  /// Likewise its points and stretches in common with the shape, whose inside does not count.
  MetEdge meet(const TopoDS_Edge& edge);

  /// Nothing if rays do not tell.
  std::optional<WireSide> side_of(const TopoDS_Vertex& vertex);

 private:
  EdgeMeetings meetings_of(const TopoDS_Edge& edge);
  double within(const Bnd_Box& a, const Bnd_Box& b) const;
  void meet_faces(const TopoDS_Edge& edge, EdgeMeetings& met);
  void meet_edges(const TopoDS_Edge& edge, EdgeMeetings& met);
  void meet_vertices(EdgeMeetings& met) const;
  TopoDS_Shape below(const EdgeMeetings& met, const Interval& piece);
  std::optional<WireSide> side_of(const EdgeMeetings& met, const Interval& piece);
  const ObstacleChart& chart_of(std::size_t face);
  bool lies_on(std::size_t face, const Vec3& point, double reach);
  std::optional<WireSide> side_in_solids(const Vec3& point);

  std::unique_ptr<EdgeObstacles> shape_;
  double tolerance_;
  SharedLimit limit_;
};

}  // namespace blossom::occt
