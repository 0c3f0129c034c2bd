// SPDX-License-Identifier: LGPL-2.1-or-later
// Splitting one face along cuts.

#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <TopoDS_Face.hxx>

#include "adapters/occt/faces/face_trims.h"
#include "adapters/occt/splitting/edges/edge_splits.h"
#include "adapters/occt/trim_tool.h"
#include "core/base/tolerances.h"
#include "core/base/work_limit.h"
#include "core/forms/conic.h"
#include "core/forms/spline.h"
#include "core/plane/pieces.h"

namespace blossom::occt {

class SurfaceProjector;

/// A curve that a face is to be cut along. The two splines share their parameter, and the conic.
struct FaceCut {
  Spline curve;           ///< in space
  Spline2 chart;          ///< in the face's own parameters
  double tolerance = 0;   ///< of the edges that come of it; at least what OCCT asks for is taken
  double least_sine = 1;  ///< of the angle between the face and what cuts it
  std::optional<Conic> conic{};  ///< what the edges become in space; null: the spline
  bool may_repeat = false;       ///< where other cuts run as well, which is not noted then
  /// How far apart cuts may end, at the first and the last end, that end in one node; model units.
  std::array<double, 2> node_reach{};
};

/// The curve of a cut in space, what its edges become, and a point of it.
Handle(Geom_Curve) space_curve(const FaceCut& cut);
Vec3 space_point(const FaceCut& cut, double t);

/// A piece of a cut on the border of a piece of the face.
struct CutUse {
  int cut = 0;  ///< index of the cut
  Interval at;  ///< parameters of the cut; walked from-to, the piece of the face is on the left
  TopoDS_Edge edge;    ///< in the wire of the piece
  bool along = false;  ///< the edge is one of the face's own, or a piece of it
};

struct FacePiece {
  TopoDS_Face face;  ///< oriented as the face it comes from
  std::vector<CutUse> cuts;
  std::vector<TopoDS_Edge> imprints;  ///< internal edges of the face
};

/// A piece of an edge of another shape, and the edge that takes its place in a face.
struct CoincidentEdge {
  TopoDS_Edge piece;  ///< as EdgeSplits has it
  TopoDS_Edge edge;  ///< same curve and parameters, with a chart curve on the face and its vertices
};

struct FaceSplit {
  std::vector<FacePiece> pieces;
  std::vector<std::string> notes;            ///< cuts that were left out, and why
  std::vector<CoincidentEdge> coincident{};  ///< that bound pieces, or that cuts repeat
  /// Where cuts repeat others, or a coincident edge: the edge of the first, along the others; and
  /// that edge itself, used by the first cut, where it bounds no piece since the cuts are the two
  /// sides of a slit.
  std::vector<CutUse> repeats{};
};

/// A place where a cut is divided.
struct CutStop {
  double parameter = 0;    ///< of the cut
  TopoDS_Vertex vertex;    ///< of the split of a wire's edge; null inside of the face
  double uncertainty = 0;  ///< how far from the vertex the cut may be divided, chart coordinates
};

/// Splits a face in three steps, each for all faces of a model before the next, so that all have
/// told where they meet their edges before an edge is split:
///
///   FaceSplitter splitter(face, cuts, splits, tolerance);   // where cuts cross wires
///   splitter.settle();                                      // loose ends, crossings of cuts
///   FaceSplit split = splitter.split();                     // the pieces
///
/// Cuts are clipped to the inside of the face. They may cross each other, seams and wires, end
/// anywhere, and end in one another. What does not divide the face is left out or imprinted, and
/// noted. A run along an existing edge divides nothing either, but is reported as a use of the cut.
/// Seams stay edges: pieces on the two sides of a seam are joined by it, not merged. Internal edges
/// of the face are cut by the cuts, stay where they divide nothing, and bound pieces where they do.
class FaceSplitter {
 public:
  /// tolerance   points of cuts and edges closer than this are one; model units
  /// limit       asked between searches for crossings here and in `settle`; null: none. Kept.
  /// throws      BadModel as `face_trims`; Failure when the limit is reached, `settle` too
  FaceSplitter(const TopoDS_Face& face, std::vector<FaceCut> cuts, EdgeSplits& splits,
               double tolerance, const WorkLimit* limit = nullptr);

  /// Takes ends that stop just short of a wire to it, preferably where a neighbour splits the same
  /// edge already, and finds where cuts cross each other.
  void settle();

  /// Divides cuts, and an edge of another shape that lies in the face, where they meet beside the
  /// ends of cuts: there that shape, whose faces make the cuts, touches itself. Call it before
  /// `settle`.
  void meet_cuts(const TopoDS_Edge& lying);

  /// Says that an edge of another shape lies in the face, in whole or in parts. All its splits at
  /// the borders of the face have to be asked for, and their vertices united with the borders',
  /// before `split`. Its pieces inside of the face divide it as cuts do; those along borders or
  /// outside, and those that divide nothing, are left out. Vertices of such edges that are at one
  /// place, as where a body touches itself, are united.
  /// reach   what of the edge is so near the surface lies in it; model units
  /// along   where it runs along edges of the face, between splits
  void add_coincident(const TopoDS_Edge& edge, double reach, const std::vector<Interval>& along);

  /// Where a settled cut ends, meets wires or other cuts, by increasing parameter. For the face on
  /// the other side of the cut, which is to be divided at the same places.
  std::vector<CutStop> stops(int cut) const;

  /// Says that the border's vertex `stop.vertex` of the other face, where the cut ends there, is
  /// one with that of this face's border, if it ends there as well. Call it for all faces before
  /// `meet`: what is one for two faces is one for all.
  void unite_borders(int cut, const CutStop& stop);

  /// Records that on the other face this cut ends at the border's vertex `stop.vertex`. If this
  /// face has a stop of the cut within that vertex's tolerance or the uncertainty, both are one
  /// vertex, even where the edges' tolerances took them farther apart. Call it for all stops, then
  /// `tidy`, then `divide`.
  void meet(int cut, const CutStop& stop);

  /// Removes all but one of the neighbouring stops that `meet` made one vertex.
  void tidy();

  /// Divides a settled cut where the other face has a stop, unless this face has one there. Stops
  /// at one vertex of the other face become one vertex here, whatever its edges' tolerances.
  void divide(int cut, const CutStop& stop);

  /// The pieces. When nothing divides the face, no edge is split and nothing imprinted, it is the
  /// face itself.
  FaceSplit split(OpenCuts open = OpenCuts::LeaveOut);

 private:
  // Where arcs meet: a split of a coedge (its ends among them) or, without one, a node inside.
  // Internal edges are coedges of one more loop.
  struct Vertex {
    Vec2 point;
    int loop = -1, coedge = -1, split = -1;
    TopoDS_Vertex shape = {};  // of nodes, once an edge needed it
    double uncertainty = 0;    // how far from the point lies what is this vertex as well
    double touch = 0;          // in space, how far from it cuts that touch in it cross as well
  };
  // A cut as it lies over the face, moved by whole periods.
  struct LiftedCut {
    int cut = 0;
    Vec2 shift;
    PlanarCurve curve;
    std::vector<TrimRun> runs;
    std::vector<std::pair<double, int>> stops;  // parameters and vertices
    std::vector<double> met;                    // parameters of stops on the other side's borders
    std::vector<TrimMeeting> touches;           // of wires, whose places are the least certain
  };
  // An edge of another shape in the chart of the face.
  struct CoincidentCurve {
    Handle(Geom_Curve) curve;
    Handle(Geom2d_Curve) image;  // in the surface's parameters
    PlanarCurve chart;           // in chart coordinates
    double tolerance = 0;        // of the edge here
  };
  // What an arc of the arrangement stands for.
  struct Origin {
    TopoDS_Edge edge;                  // walked along the arc
    std::vector<CutUse> uses;          // of cuts, along the arc
    int lifted_cut = -1;               // of cuts only
    int loop = -1;                     // of borders and internal edges
    TopoDS_Edge piece = {};            // of coincident edges: what the edge stands for
    std::vector<CutUse> repeats = {};  // of cuts that repeat this cut or coincident edge
  };

  PlanarCurve chart_of(const FaceCut& cut) const;
  void add_lifted_cuts();
  void widen_touch(const LiftedCut& lifted_cut, const TrimMeeting& meeting, int vertex);
  void add_wire_stops(LiftedCut& lifted_cut);
  void add_wire_stop(LiftedCut& lifted_cut, const TrimMeeting& meeting);
  void add_end_stop(LiftedCut& lifted_cut, double end);
  bool add_known_stop(LiftedCut& lifted_cut, const TrimMeeting& meeting);
  bool has_stop(const LiftedCut& lifted_cut, double at) const;
  bool is_in_end_node(const LiftedCut& lifted_cut, double at) const;
  void add_crossings();
  void finish_stops(LiftedCut& lifted_cut);
  void tidy_stops(LiftedCut& lifted_cut, double reach) const;
  int stop_near(const LiftedCut& lifted_cut, double parameter, double reach) const;
  int met_stop(const LiftedCut& lifted_cut, const CutStop& stop) const;
  void tie(int vertex, const TopoDS_Vertex& other);
  int border_vertex(const TopoDS_Vertex& other, int on_this_side);
  bool are_images(int a, int b) const;
  void unite(int kept, int left);
  // Whether the curve stays within `reach` between the two parameters.
  static bool is_near(const PlanarCurve& curve, double s, double t, double reach);
  void unite_uncertain();
  void unite_loose_ends();
  int vertex_of(const TrimMeeting& meeting, double uncertainty, double inverse_sine = 1);
  double inverse_sine(const LiftedCut& lifted_cut, const TrimMeeting& meeting) const;
  int vertex_at_split(int loop, int coedge, int split);
  int node_near(const Vec2& point, double reach = 0);
  double reach(const LiftedCut& lifted_cut) const;
  const Coedge& coedge(int loop, int index) const;
  TopoDS_Edge edge_of(const Coedge& coedge) const { return shapes_.edge(coedge); }
  void note(int cut, const std::string& what);

  int inner_loop() const { return static_cast<int>(trims_.loops.size()); }
  void add_inner_stops(LiftedCut& lifted_cut);
  int inner_vertex(int index, int split);
  TopoDS_Vertex shape_of(const Vertex& of) const;
  int vertex_of_shape(const TopoDS_Vertex& shape, const Vec2& point) const;
  int vertex_at_place(const TopoDS_Vertex& shape, const Vec2& point);
  bool add_inner_arcs();
  bool add_coincident_arcs();
  void add_coincident_arc(const EdgePiece& piece, double reach, const SurfaceProjector& feet);
  void split_pole_at(const TopoDS_Edge& edge, int loop, int index);
  CoincidentCurve coincident_curve(const TopoDS_Edge& edge, const SurfaceProjector& feet) const;
  TopoDS_Edge coincident_edge(const EdgePiece& piece, const CoincidentCurve& of, const Vec2& shift,
                              int from, int to);
  bool leads_to_end(const FaceCut& cut, double at, const TopoDS_Edge& edge) const;
  void meet_at(int cut, double at, const TopoDS_Vertex& shape);
  bool lies_in_face(const EdgePiece& piece, double reach, const SurfaceProjector& feet) const;
  std::vector<int> imprints_among(const std::vector<int>& arcs, OpenCuts open) const;

  void add_border_arcs();
  void add_border_arc(int loop, int index, const EdgePiece& piece);
  std::vector<CutUse> runs_along(int loop, int index, const EdgePiece& piece) const;
  bool add_cut_arcs();
  int arc_beside(const LiftedCut& lifted_cut, const std::pair<double, int>& from,
                 const std::pair<double, int>& to, bool border) const;
  bool add_cut_arc(const LiftedCut& lifted_cut, const std::pair<double, int>& from,
                   const std::pair<double, int>& to);
  TopoDS_Edge cut_edge(const LiftedCut& lifted_cut, const Interval& at, int from, int to);
  Handle(Geom2d_Curve) chart_of(const TopoDS_Edge& edge, const LiftedCut& lifted_cut) const;
  const TopoDS_Vertex& shape_of(int vertex, const LiftedCut& lifted_cut, double parameter);

  void make_edge(int arc);
  void imprint(std::vector<int> arcs, FacePiece& piece);
  void add_repeat(int arc, const LiftedCut& lifted_cut, const std::pair<double, int>& from,
                  const std::pair<double, int>& to);
  void add_repeats(const std::vector<int>& dangling, FaceSplit& result);
  FaceSplit divided(const ChartPieces& found, OpenCuts open);
  FaceSplit undivided(const std::vector<int>& imprinted = {});
  bool adds_up(const ChartPieces& found) const;
  void add_wire(const Cycle& cycle, FacePiece& piece) const;

  TopoDS_Face given_, face_;  // as it came, and turned forward
  FaceTrims trims_;
  TrimShapes shapes_;  // what the trims count
  std::vector<FaceCut> cuts_;
  EdgeSplits& splits_;
  double tolerance_;
  const WorkLimit* limit_;
  std::vector<Vertex> vertices_;                        // the corners of the wires first
  std::vector<std::pair<TopoDS_Vertex, int>> aliases_;  // of the other sides of cuts, and ours
  std::vector<LiftedCut> lifted_cuts_;
  struct Coincident {
    TopoDS_Edge edge;
    double reach = 0;
    std::vector<Interval> along;
  };
  std::vector<Coincident> coincident_;
  std::vector<ChartArc> arcs_;
  std::vector<Origin> origins_;  // one for each arc
  std::vector<std::string> notes_;
};

/// One face by itself.
FaceSplit split_face(const TopoDS_Face& face, const std::vector<FaceCut>& cuts,
                     double tolerance = Tolerances{}.point, OpenCuts open = OpenCuts::LeaveOut);

}  // namespace blossom::occt
