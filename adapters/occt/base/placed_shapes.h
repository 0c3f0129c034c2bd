// SPDX-License-Identifier: LGPL-2.1-or-later
// The faces, edges and vertices of a shape, each once, with their places apart from them.
//
// Composing placements for every sub-shape takes longer than all questions about a part; a place
// is composed once here for all sub-shapes that share it.

#pragma once

#include <cstddef>
#include <unordered_set>
#include <utility>
#include <vector>

#include <TopLoc_Location.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Trsf.hxx>

namespace blossom::occt {

/// A face, edge or vertex without its location.
struct PlacedShape {
  TopoDS_Shape shape;
  int place = 0;
};

class PlacedShapes {
 public:
  explicit PlacedShapes(const TopoDS_Shape& shape);

  /// In the order of TopExp::MapShapes.
  const std::vector<PlacedShape>& faces() const { return faces_; }
  const std::vector<PlacedShape>& edges() const { return edges_; }
  const std::vector<PlacedShape>& vertices() const { return vertices_; }

  const gp_Trsf& place_of(const PlacedShape& part) const {
    return moves_[static_cast<std::size_t>(part.place)];
  }
  /// The sub-shape where it is.
  TopoDS_Shape placed(const PlacedShape& part) const;

 private:
  struct Key {
    const TopoDS_TShape* shape;
    int place;
    bool operator==(const Key&) const = default;
  };
  struct Hash {
    std::size_t operator()(const Key& key) const;
  };

  void enter(const TopoDS_Shape& unplaced, int place);
  int composed(int place, const TopLoc_Location& location);

  std::vector<PlacedShape> faces_, edges_, vertices_;
  std::vector<TopLoc_Location> places_;
  std::vector<std::pair<int, TopLoc_Location>> origins_;  // of each place: where it was composed
  std::vector<gp_Trsf> moves_;
  std::unordered_set<Key, Hash> known_;
};

}  // namespace blossom::occt
