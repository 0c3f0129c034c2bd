// SPDX-License-Identifier: LGPL-2.1-or-later
// Repairs of faces, made when they are asked for.
//
// Files and their readers leave edges whose curves are farther apart than they state, curves in the
// parameters of faces far off those in space, and edges that lack them. To find these takes longer
// than to read the file, so it is done for faces that are used, once.
//
// What is repaired of one face does not depend on which were asked for before. Tolerances are those
// that an edge, or the edges at a vertex, need on all of their faces, measured before any curve is
// changed. Curves are remade, and tolerances lowered for it, only where a tolerance is loose, and
// for all faces together that hang together by vertices of loose edges. If any edge lacks a curve,
// all faces are repaired at once, since making it may change its neighbours.

#pragma once

#include <functional>
#include <vector>

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "adapters/occt/base/shared_parts.h"
#include "adapters/occt/repair/edge_tolerances.h"
#include "adapters/occt/repair/loose_images.h"
#include "adapters/occt/repairs.h"

namespace blossom::occt {

/// Where the tolerances of a shape come from.
enum class StatedTolerances {
  Kept,    ///< the file states them: what they say is meant
  Raised,  ///< the reader measured them at a few points of each edge
};

/// Repairs a shape in place, face by face.
class Repairer {
 public:
  using Stop = std::function<void()>;

  Repairer(const TopoDS_Shape& shape, StatedTolerances stated);
  Repairer(const Repairer&) = delete;
  Repairer& operator=(const Repairer&) = delete;

  /// Repairs faces, by number, that were not repaired yet.
  /// stop      asked often; ends the work by an exception, after which what is left can be repaired
  /// returns   what was changed
  Repairs repair(const std::vector<int>& faces, const Stop& stop);

  /// The same for all faces, and for edges and vertices of no face.
  Repairs repair_all(const Stop& stop);

 private:
  // Numbers of faces in increasing order.
  using Group = std::vector<int>;

  bool is_loose(const TopoDS_Edge& edge);
  std::vector<TopoDS_Shape> loose_edges_at(const TopoDS_Face& face);
  Group group_of(int face);
  void repair_group(const Group& group, const Stop& stop);
  void raise_and_remake(const Group& group, const Stop& stop);
  template <class Part>
  void raise(const Part& part);
  void add_missing_curves();
  Repairs told();

  const TopoDS_Shape shape_;
  const StatedTolerances stated_;
  const SharedParts parts_;
  TopTools_IndexedMapOfShape faces_;
  NeededTolerances needs_;
  std::vector<bool> done_;  ///< by face number
  bool lacks_curves_;
  TopTools_IndexedMapOfShape raised_;  ///< edges and vertices, of all calls
  int told_ = 0;                       ///< how many of them earlier calls returned
  std::vector<RemadeImage> remade_;    ///< of this call
  std::vector<Repairs::MissingCurve> missing_;
  std::vector<int> failed_;  // faces
};

}  // namespace blossom::occt
