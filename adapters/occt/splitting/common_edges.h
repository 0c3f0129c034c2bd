// SPDX-License-Identifier: LGPL-2.1-or-later
// The edges of two shapes that lie in faces of the other one, or run along its edges.
//
// Where faces coincide, or a face ends in another one, intersection curves are edges that are
// there already. These edges become cuts of the faces they lie in, as they are.

#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <Bnd_Box.hxx>
#include <NCollection_DataMap.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/intersection.h"
#include "adapters/occt/splitting/edges/edge_meetings.h"
#include "adapters/occt/splitting/edges/edge_splits.h"
#include "adapters/occt/splitting/edges/edge_union.h"
#include "adapters/occt/splitting/face_splitter.h"
#include "core/results/curve_surface_result.h"

namespace blossom::occt {

/// Edges of two shapes that keep within tolerance of each other.
struct EdgesAlong {
  TopoDS_Edge a, b;
  Interval at_a;  ///< increasing
  Interval at_b;  ///< the parameters of b at the ends of `at_a`; may decrease
};

/// A point in which an edge is tangential to a face of the other shape.
struct EdgeTouch {
  TopoDS_Edge edge;
  double at = 0;
};

/// A stretch of an edge that is one place of it: all of it is within tolerance of a face.
struct UncertainStretch {
  TopoDS_Edge edge;
  Interval at;
};

/// What of edges is taken for lying in a face of the other shape.
enum class EdgesLie {
  WhereFacesMeet,  ///< what keeps within `kLiesReach`
  Nearby,          ///< what keeps within `kLooseReach`, and whole edges within their own tolerances
};

class CommonEdges {
 public:
  CommonEdges(const std::vector<TopoDS_Face>& a, const std::vector<TopoDS_Face>& b,
              const IntersectionOptions& options, EdgesLie lying = EdgesLie::WhereFacesMeet);

  /// Takes over which edges and faces are known to be equal. Nothing is searched for such an edge
  /// in the faces that have its equals, where it lies, nor in others that have a copy in the solid
  /// of the edge: no solid is divided by itself. To be called before edges are added, and for
  /// solids only.
  void know_equal(const ShapeIntersection& found);

  /// Looks at the edges of two faces that meet: at all where the faces coincide, where intersection
  /// curves run along some, or some seem to lie in the other face.
  /// throws   LimitFailure if no time is left
  void add(const FaceIntersection& pair);

  /// Looks at all edges that may lie in faces by their own tolerances, which faces that miss each
  /// other may have.
  /// throws   LimitFailure if no time is left
  void add_loose();

  /// Looks for places in which edges of one face touch the other one: curves that cross edges there
  /// keep so near to them that they cannot tell where. Edges that the pair's curves stay clear of
  /// are left out. With no time left it does nothing.
  /// throws   BadModel as `intersect`
  void add_touches(const FaceIntersection& pair);

  /// The curves of the pair that run along an edge which lies in the other face; their place among
  /// the pair's.
  std::vector<std::size_t> curves_along(const FaceIntersection& pair) const;

  /// How near to a face of the other shape counts as in it for an edge; model units.
  double reach(const TopoDS_Edge& edge) const;

  /// The largest tolerance by which alone an edge lies in a face; 0 if none does.
  double loosest() const { return loosest_; }

  /// By face: edges of the other shape that lie in it.
  const std::vector<std::vector<TopoDS_Edge>>& in_a() const { return in_a_; }
  const std::vector<std::vector<TopoDS_Edge>>& in_b() const { return in_b_; }

  /// Where an edge of one shape runs along edges of a face of the other.
  std::vector<Interval> runs_along(const TopoDS_Edge& edge, const TopoDS_Face& face) const;

  /// Splits edges where they meet, and unites their vertices; and where they touch faces.
  void split(EdgeSplits& splits) const;

  /// Splits edges that run along each other at the same places. No more than once all that cuts ask
  /// for is known.
  void match(EdgeSplits& splits) const;

  /// Joins the pieces of edges that run along each other.
  /// returns   why some could not be joined; empty if all were
  std::string join(EdgeSplits& splits, EdgeUnion& joined) const;

  /// The chart curves of the second edge's faces for the first one, which runs along it.
  /// reversed   whether it runs against it: then what is walked forwards along a seam is its other
  ///            side
  /// throws     Failure if it does not within the tolerances of both
  TopoDS_Edge image(const TopoDS_Edge& first, const TopoDS_Edge& second, bool reversed) const;

 private:
  enum class Of { A, B };
  void ask_limit() const;
  Bnd_Box box_of(const TopoDS_Shape& shape, double margin);
  double most_reach(const TopoDS_Edge& edge) const;
  bool lies_on(const TopoDS_Edge& edge, const SurfaceProjector& feet);
  bool is_in(const TopoDS_Edge& edge, const TopoDS_Face& face, const SurfaceProjector& feet);
  void add_coincident(const std::vector<TopoDS_Edge>& edges, Of of, std::size_t face);
  void meet(const TopoDS_Edge& a, const TopoDS_Edge& b);
  CurveIntersection common_of(const TopoDS_Edge& a, const TopoDS_Edge& b, double tolerance) const;
  double meeting_tolerance(const TopoDS_Edge& a, const TopoDS_Edge& b) const;
  void meet_own(const TopoDS_Edge& edge, const TopoDS_Edge& other);
  void touch(const FaceIntersection& pair, Of whose);
  void touch(const TopoDS_Edge& edge, const TopoDS_Face& face, Of whose);
  void add_uncertain(const TopoDS_Edge& edge, const TopoDS_Face& face,
                     const std::vector<CurveSurfacePoint>& points);
  void add_uncertain_in(const Place& node, const std::vector<TopoDS_Edge>& edges);
  const std::vector<TopoDS_Face>& a_;
  const std::vector<TopoDS_Face>& b_;
  IntersectionOptions options_;
  const SharedLimit limit_{options_};
  double reach_;
  EdgesLie lying_;
  double loosest_ = 0;
  TopTools_MapOfShape loose_;  // edges that lie in a face by their own tolerances
  std::vector<std::vector<TopoDS_Edge>> in_a_, in_b_;
  NCollection_DataMap<TopoDS_Shape, Bnd_Box, TopTools_ShapeMapHasher> boxes_;
  // By edge of either shape: those of the other one which it is equal to.
  NCollection_DataMap<TopoDS_Shape, TopTools_MapOfShape, TopTools_ShapeMapHasher> equals_;
  TopTools_MapOfShape copied_;             // faces that are equal to one of the other shape
  TopTools_IndexedMapOfShape edges_;       // of both
  std::set<std::pair<int, int>> looked_;   // pairs of edges
  std::set<std::pair<int, int>> touched_;  // edges of a, faces of b from 1; of b, of a from -1 down
  std::vector<EdgesMeeting> meetings_;
  std::vector<EdgesAlong> along_;
  std::vector<EdgeTouch> touches_;
  std::vector<UncertainStretch> uncertain_;
};

}  // namespace blossom::occt
