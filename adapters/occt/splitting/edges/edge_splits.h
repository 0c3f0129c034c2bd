// SPDX-License-Identifier: LGPL-2.1-or-later
// Splitting the edges of a model once for all faces that share them.
//
// First every face tells where its cuts meet its edges; then each edge is split, and all its
// faces take the same pieces, so that shells stay sewn.

#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include "core/math/interval.h"

namespace blossom::occt {

/// A piece of an edge between two neighbouring splits.
struct EdgePiece {
  TopoDS_Edge edge;  ///< forward; the edge itself when it is not split
  Interval range;    ///< increasing, the edge's own parameters
  int from = 0;      ///< splits at the ends, see EdgeSplits
  int to = 0;
};

/// The largest sampled distance between an edge's curve and its images on its surfaces, model
/// units.
double image_deviation(const TopoDS_Edge& edge, int samples);

/// A forward edge on a part of another one between two vertices, with its curves.
TopoDS_Edge piece_of(const TopoDS_Edge& edge, const Interval& range, const TopoDS_Vertex& from,
                     const TopoDS_Vertex& to);

class EdgeSplits {
 public:
  /// Numbers of an edge's own vertices among its splits; new ones follow.
  static constexpr int kFirst = 0;
  static constexpr int kLast = 1;

  /// tolerance  splits of an edge closer than this, or than the edge's own tolerance, are one, and
  ///            a few of the edge's tolerances when different faces ask for them; likewise a split
  ///            and a vertex. Model units.
  explicit EdgeSplits(double tolerance) : tolerance_(tolerance) {}

  /// Asks for a split and returns its number, which may be that of an older one or of a vertex.
  /// face          the face that asks
  /// uncertainty   how far from the parameter's point the split may lie as well; model units
  /// inverse_sine  1 / sin of the angle at which the edge is met: so many times farther apart may
  ///               splits that different faces ask for be one; at least 1
  int add(const TopoDS_Edge& edge, double parameter, const TopoDS_Face& face,
          double uncertainty = 0, double inverse_sine = 1);

  /// The vertex of a split gets at least this tolerance, model units, once pieces are made: what
  /// is near it until then does not depend on who asked first.
  void widen(const TopoDS_Edge& edge, int split, double tolerance);

  /// What the vertex of a split covers so far: its tolerance, or what it is to be widened to.
  double covered(const TopoDS_Edge& edge, int split) const;

  /// Says that all along an interval of its parameters the edge is in one place, as where it
  /// touches a face: whatever is asked for there after this is the nearest split that is there
  /// already, one that edges meet in before others. Its vertex is widened to cover it.
  void add_uncertain(const TopoDS_Edge& edge, const Interval& at);

  /// Whether anybody asked for a split inside of the edge.
  bool is_split(const TopoDS_Edge& edge) const;

  /// The vertex of a split, or of an end of any edge. The same object every time.
  TopoDS_Vertex vertex(const TopoDS_Edge& edge, int split) const;

  /// The edge's own parameter of a split.
  double parameter(const TopoDS_Edge& edge, int split) const;

  /// Whether a split is a vertex of the edge or no face asked for it first: edges that meet, which
  /// tell where more exactly than cuts do.
  bool is_known(const TopoDS_Edge& edge, int split) const;

  /// How many splits an edge has, its own vertices among them.
  int count(const TopoDS_Edge& edge) const;

  /// Says that two vertices, of different shapes, are one.
  void unite(const TopoDS_Vertex& a, const TopoDS_Vertex& b);

  /// Whether two vertices are the same or were united, perhaps over others.
  bool are_one(const TopoDS_Vertex& a, const TopoDS_Vertex& b) const;

  /// All that were united.
  const std::vector<std::pair<TopoDS_Vertex, TopoDS_Vertex>>& united() const { return united_; }

  /// The pieces, by increasing parameter. The same objects every time; no split of the edge can
  /// be added any more.
  const std::vector<EdgePiece>& pieces(const TopoDS_Edge& edge);

 private:
  struct Split {
    double parameter = 0;
    TopoDS_Vertex vertex;
    TopoDS_Face face;  // that asked for it first; none for the edge's own vertices
  };
  struct Record {
    TopoDS_Edge edge;  ///< forward
    std::vector<Split> splits;
    std::vector<EdgePiece> pieces;
    std::vector<Interval> uncertain{};
  };
  int split_in_uncertain(const Record& of, double parameter) const;
  Record& record(const TopoDS_Edge& edge);
  const Record* find(const TopoDS_Edge& edge) const;
  double reach(const Record& of, const Split& split, const TopoDS_Face& face,
               double inverse_sine) const;

  double tolerance_;
  std::vector<std::pair<TopoDS_Vertex, double>> widened_;
  TopTools_IndexedMapOfShape index_;
  std::vector<Record> records_;
  std::vector<std::pair<TopoDS_Vertex, TopoDS_Vertex>> united_;
  TopTools_IndexedMapOfShape vertices_;  // that were united
  std::vector<std::size_t> classes_;     // of these; equal where they are one
};

}  // namespace blossom::occt
