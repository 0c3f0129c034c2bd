// SPDX-License-Identifier: LGPL-2.1-or-later
// The constrained Delaunay triangulation of points in the plane, with exact predicates, and the
// region that its borders go round.

#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <map>
#include <utility>
#include <vector>

#include "core/math/vec.h"

namespace blossom {

/// How often more a side, by its ends, is walked on than back.
using SideWindings = std::map<std::pair<int, int>, int>;

/// Points are numbered as they come. Three far corners, numbered after the first points, hold all.
///
/// Source: de Berg et al. 2008, chapter 9; sides are forced in by flips as in Sloan 1993.
class ConstrainedDelaunay {
 public:
  static constexpr int kNone = -1;

  struct Face {
    std::array<int, 3> corner;  ///< counter-clockwise
    std::array<int, 3> beside;  ///< the face across the side opposite to a corner
    std::array<bool, 3> fixed;  ///< whether that side is a border
    bool inside = false;        ///< of the region, once that is marked
  };

  /// throws   InvalidInput if two points are equal, or a triangle far round all is not finite
  explicit ConstrainedDelaunay(std::vector<Vec2> points);

  const std::vector<Face>& faces() const { return faces_; }
  const Vec2& point(int i) const { return points_[static_cast<std::size_t>(i)]; }
  int point_count() const { return static_cast<int>(points_.size()); }

  /// Makes the straight way between two points a side. False, and nothing is fixed, if it crosses
  /// a fixed side or passes through a point; `obstacle` is that side.
  bool fix(int from, int to, std::pair<int, int>& obstacle);

  /// Marks the faces that the borders, all of them fixed, go round once. False, and nothing is
  /// marked, if they go round some more often or backwards, or do not agree.
  bool mark_region(const SideWindings& windings);

  /// A face that holds the point, by a walk from the one that was made or found last.
  int locate(const Vec2& point);

  /// Whether a point lies in that face of the region, on no fixed side and in no corner.
  bool may_insert(const Vec2& point, int face) const;

  /// Adds a point, which lies in that face and on no fixed side. Faces that change have it for a
  /// corner. The number of the point.
  /// throws   InvalidInput if it is a corner of the face
  int insert(const Vec2& point, int face);

  /// Calls `visit(face)` for all faces at a point inside of the region's border.
  template <class Visit>
  void for_each_face_at(int point, Visit visit) const;

 private:
  // The side from `a` to `b`, and the face on its left when it was noted.
  struct DoubtfulSide {
    int a = 0, b = 0, face = 0;
  };

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  static std::size_t next(std::size_t k) { return k == 2 ? 0 : k + 1; }
  static std::size_t previous(std::size_t k) { return k == 0 ? 2 : k - 1; }
  static std::size_t corner_of(const Face& face, int point) {
    return face.corner[0] == point ? 0 : face.corner[1] == point ? 1 : 2;
  }

  std::pair<int, std::size_t> side_between(int a, int b) const;
  std::pair<int, std::size_t> side_of(int face, int a, int b) const;
  int turn(int a, int b, int c) const;
  bool is_flat(int face) const;
  bool lies_between(int a, int b, int point) const;
  bool crosses(int a, int b, int c, int d) const;
  void replace_neighbour(int face, int old, int by);
  void note_corners(int face);
  void divide(int point, int face);
  bool is_convex_across(int face, std::size_t k) const;
  int opposite(int face, std::size_t k) const;
  void flip(int face, std::size_t k);
  void restore(int face, std::size_t k);
  bool crossed_sides(int from, int to, std::deque<std::pair<int, int>>& crossed,
                     std::pair<int, int>& obstacle) const;
  bool ahead(int from, int to, int point) const;
  void set_fixed(int from, int to);
  std::vector<int> winding_numbers(const SideWindings& windings, int outermost) const;

  std::vector<Vec2> points_;
  std::vector<Face> faces_;
  std::vector<int> face_at_;  // some face at a point
  int first_far_ = 0;         // of the far corners
  int last_ = 0;              // face
  std::vector<DoubtfulSide> doubtful_;
};

template <class Visit>
void ConstrainedDelaunay::for_each_face_at(int point, Visit visit) const {
  const int first = face_at_[at(point)];
  for (int face = first; face != kNone;) {
    visit(face);
    const Face& f = faces_[at(face)];
    face = f.beside[next(corner_of(f, point))];
    if (face == first) return;
  }
}

}  // namespace blossom
