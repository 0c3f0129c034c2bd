// SPDX-License-Identifier: LGPL-2.1-or-later
// One pair of faces: what is known of it without a search, the search, and what trims leave of it.

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/faces/face_list.h"
#include "adapters/occt/faces/face_trims.h"
#include "adapters/occt/faces/pairs/equal_faces.h"
#include "adapters/occt/faces/pairs/shared_edges.h"
#include "adapters/occt/faces/pairs/touched_planes.h"
#include "adapters/occt/intersection.h"

namespace blossom::occt {

/// Whether the edges and vertices that two faces share belong to their intersection.
enum class Shared { Listed, LeftOut };

/// Of a face with itself where both are the same object. Pairs may be asked for at the same time.
/// Keeps references; the clock of the limits starts when it is made.
class PairIntersector {
 public:
  /// copies    of faces of a in b
  /// touched   by faces of either
  PairIntersector(const FaceList& faces_a, const FaceList& faces_b, const FaceCopies& copies,
                  const TouchedPlanes& touched, Shared shared, const IntersectionOptions& options)
      : faces_a_(faces_a),
        faces_b_(faces_b),
        copies_(copies),
        touched_(touched),
        shared_(shared),
        options_(options) {}

  FaceIntersection of(const std::pair<int, int>& pair) const;

  /// Grows with the time that a pair takes.
  std::size_t size_of(const std::pair<int, int>& pair) const;

  /// What is known of a pair's faces in the other order, where both are copies of each other's.
  FaceIntersection exchanged(FaceIntersection known, const std::pair<int, int>& pair) const;

 private:
  void add_shapes(const FaceData& a, const FaceData& b, FaceIntersection& result) const;
  std::array<TrimShapes, 2> shapes_of(const FaceIntersection& pair) const;
  void add_whole_face(const FaceMatch& match, FaceIntersection& result) const;
  void leave_open(FaceIntersection& result) const;
  void search(FaceIntersection& result) const;
  void trust_approximations(double error, SurfaceIntersection& found) const;
  bool is_settled_by_neighbours(const FaceData& a, const FaceData& b,
                                const std::vector<SharedEdge>& edges,
                                FaceIntersection& result) const;
  std::optional<double> gap_of_one_surface(std::size_t i, std::size_t j) const;
  SurfaceIntersection on_surface_of_both(const std::pair<int, int>& pair,
                                         const std::vector<SharedEdge>& edges, double gap,
                                         double within) const;
  std::optional<std::vector<Touch>> find_known(std::size_t i, std::size_t j,
                                               const std::vector<SharedEdge>& edges, double within,
                                               SurfaceIntersection& found) const;
  bool is_settled_by_closed_forms(std::size_t i, std::size_t j,
                                  const std::vector<SharedEdge>& edges, double within,
                                  SurfaceIntersection& found) const;
  std::vector<Touch> clip_known(std::size_t i, std::size_t j, SurfaceIntersection& found) const;
  std::vector<Touch> find_between(std::size_t i, std::size_t j,
                                  const std::vector<SharedEdge>& edges,
                                  SurfaceIntersection& found) const;
  SurfaceIntersection between(std::size_t i, std::size_t j,
                              const std::vector<SharedEdge>& edges) const;
  SurfaceIntersection found_between(std::size_t i, std::size_t j,
                                    const std::vector<SharedEdge>& edges) const;
  IntersectionOptions options_for(const FaceData& a, const FaceData& b,
                                  const std::vector<SharedEdge>& edges) const;
  static void add_edges(const std::vector<SharedEdge>& edges, FaceIntersection& result);
  void add_edge_contacts(const TopoDS_Face& a, const TopoDS_Face& b, SurfaceIntersection& found,
                         std::vector<Touch>& touches) const;
  void add_pole_contacts(std::size_t i, std::size_t j, const SurfaceIntersection& found,
                         std::vector<Touch>& touches) const;
  void add_overlaps(std::size_t i, std::size_t j, const std::vector<Overlap>& whole,
                    SurfaceIntersection& found) const;

  const FaceList& faces_a_;
  const FaceList& faces_b_;
  const FaceCopies& copies_;
  const TouchedPlanes& touched_;
  Shared shared_;
  const IntersectionOptions& options_;
  const SharedLimit limit_{options_};
};

}  // namespace blossom::occt
