// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/regions/delaunay/constrained_delaunay.h"

#include <algorithm>
#include <cmath>

#include "core/base/errors.h"
#include "core/base/not_zero.h"
#include "core/regions/delaunay/plane_predicates.h"

namespace blossom {
namespace {

constexpr double kFarAway = 64;  // corners of the triangle round all points, in sizes of their box

}  // namespace

ConstrainedDelaunay::ConstrainedDelaunay(std::vector<Vec2> points) : points_(std::move(points)) {
  Vec2 low = points_.front(), high = low;
  for (const Vec2& p : points_)
    for (int k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  const Vec2 middle = 0.5 * (low + high);
  const double size = kFarAway * std::max({high[0] - low[0], high[1] - low[1], kNotZero});
  first_far_ = static_cast<int>(points_.size());
  points_.push_back(middle + Vec2{-size, -size});
  points_.push_back(middle + Vec2{size, -size});
  points_.push_back(middle + Vec2{0, size});
  for (const Vec2& p : points_)
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]))
      throw InvalidInput("points are too far apart for a triangle round them");
  faces_.push_back({{first_far_, first_far_ + 1, first_far_ + 2}, {kNone, kNone, kNone}, {}});
  face_at_.assign(points_.size(), 0);
  for (int i = 0; i < first_far_; ++i) divide(i, locate(points_[at(i)]));
}

bool ConstrainedDelaunay::fix(int from, int to, std::pair<int, int>& obstacle) {
  std::deque<std::pair<int, int>> crossed;
  if (!crossed_sides(from, to, crossed, obstacle)) return false;
  std::vector<std::pair<int, int>> made;
  while (!crossed.empty()) {
    const auto [a, b] = crossed.front();
    crossed.pop_front();
    const auto [face, k] = side_between(a, b);
    if (!is_convex_across(face, k)) {
      crossed.push_back({a, b});
      continue;
    }
    flip(face, k);
    const int c = faces_[at(face)].corner[1], d = faces_[at(face)].corner[2];
    if (crosses(from, to, c, d))
      crossed.push_back({c, d});
    else
      made.push_back({c, d});
  }
  set_fixed(from, to);
  for (const auto& [a, b] : made) {
    const auto [face, k] = side_between(a, b);
    if (face != kNone) restore(face, k);
  }
  return true;
}

// The face on the left of the side from `a` to `b`, and the corner opposite to the side.
std::pair<int, std::size_t> ConstrainedDelaunay::side_between(int a, int b) const {
  // Round a counter-clockwise, and clockwise if that ends at the outermost border.
  for (const bool back : {false, true}) {
    int face = face_at_[at(a)];
    const int first = face;
    do {
      const Face& f = faces_[at(face)];
      const std::size_t k = corner_of(f, a);
      if (f.corner[next(k)] == b) return {face, previous(k)};
      face = f.beside[back ? previous(k) : next(k)];
    } while (face != kNone && face != first);
    if (face != kNone) break;
  }
  return {kNone, 0};
}

// The same where `face` most likely has that side: a corner may have very many faces.
std::pair<int, std::size_t> ConstrainedDelaunay::side_of(int face, int a, int b) const {
  const Face& f = faces_[at(face)];
  for (std::size_t k = 0; k < 3; ++k)
    if (f.corner[next(k)] == a && f.corner[previous(k)] == b) return {face, k};
  return side_between(a, b);
}

int ConstrainedDelaunay::turn(int a, int b, int c) const {
  return orientation(points_[at(a)], points_[at(b)], points_[at(c)]);
}

bool ConstrainedDelaunay::is_flat(int face) const {
  const Face& f = faces_[at(face)];
  return turn(f.corner[0], f.corner[1], f.corner[2]) == 0;
}
bool ConstrainedDelaunay::lies_between(int a, int b, int point) const {
  return dot(points_[at(a)] - points_[at(point)], points_[at(b)] - points_[at(point)]) < 0;
}

bool ConstrainedDelaunay::crosses(int a, int b, int c, int d) const {
  return c != a && c != b && d != a && d != b && turn(a, b, c) * turn(a, b, d) < 0 &&
         turn(c, d, a) * turn(c, d, b) < 0;
}

int ConstrainedDelaunay::locate(const Vec2& point) {
  // Where sides are fixed a walk may go round in a circle; then every face is asked.
  std::size_t steps = 0;
  for (std::size_t k = 0, seen = 0; seen < 3 && steps <= faces_.size(); k = next(k)) {
    const Face& f = faces_[at(last_)];
    if (orientation(points_[at(f.corner[next(k)])], points_[at(f.corner[previous(k)])], point) <
            0 &&
        f.beside[k] != kNone) {
      last_ = f.beside[k];
      seen = 0;
      ++steps;
    } else {
      ++seen;
    }
  }
  if (steps <= faces_.size()) return last_;
  const auto holds = [&](const Face& f) {
    for (std::size_t k = 0; k < 3; ++k)
      if (orientation(points_[at(f.corner[k])], points_[at(f.corner[next(k)])], point) < 0)
        return false;
    return true;
  };
  return last_ = static_cast<int>(std::ranges::find_if(faces_, holds) - faces_.begin());
}

bool ConstrainedDelaunay::may_insert(const Vec2& point, int face) const {
  const Face& f = faces_[at(face)];
  if (!f.inside) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 &a = points_[at(f.corner[next(k)])], &b = points_[at(f.corner[previous(k)])];
    const int side = orientation(a, b, point);
    if (side < 0 || (side == 0 && f.fixed[k]) || a == point) return false;
  }
  return true;
}

int ConstrainedDelaunay::insert(const Vec2& point, int face) {
  points_.push_back(point);
  face_at_.push_back(face);
  divide(point_count() - 1, face);
  return point_count() - 1;
}

void ConstrainedDelaunay::replace_neighbour(int face, int old, int by) {
  if (face == kNone) return;
  for (int& beside : faces_[at(face)].beside)
    if (beside == old) {
      beside = by;
      return;
    }
}

void ConstrainedDelaunay::note_corners(int face) {
  for (const int corner : faces_[at(face)].corner) face_at_[at(corner)] = face;
}

void ConstrainedDelaunay::divide(int point, int face) {
  const Face f = faces_[at(face)];
  for (std::size_t k = 0; k < 3; ++k)
    if (points_[at(f.corner[k])] == points_[at(point)])
      throw InvalidInput("triangulate: two points are equal");
  const int b = static_cast<int>(faces_.size()), c = b + 1;
  faces_[at(face)] = {
      {point, f.corner[1], f.corner[2]}, {f.beside[0], b, c}, {f.fixed[0]}, f.inside};
  faces_.push_back(
      {{point, f.corner[2], f.corner[0]}, {f.beside[1], c, face}, {f.fixed[1]}, f.inside});
  faces_.push_back(
      {{point, f.corner[0], f.corner[1]}, {f.beside[2], face, b}, {f.fixed[2]}, f.inside});
  last_ = c;
  replace_neighbour(f.beside[1], face, b);
  replace_neighbour(f.beside[2], face, c);
  for (const int made : {face, b, c}) note_corners(made);
  // A point on a side leaves a flat face there, which the flip of that side takes away.
  for (const bool flat : {true, false})
    for (const int made : {face, b, c})
      if (faces_[at(made)].corner[0] == point && is_flat(made) == flat) restore(made, 0);
}

bool ConstrainedDelaunay::is_convex_across(int face, std::size_t k) const {
  const Face& f = faces_[at(face)];
  const int far = opposite(face, k);
  return turn(f.corner[k], f.corner[next(k)], far) > 0 &&
         turn(f.corner[k], far, f.corner[previous(k)]) > 0;
}

int ConstrainedDelaunay::opposite(int face, std::size_t k) const {
  const Face& other = faces_[at(faces_[at(face)].beside[k])];
  for (std::size_t i = 0; i < 3; ++i)
    if (other.beside[i] == face && other.corner[next(i)] == faces_[at(face)].corner[previous(k)])
      return other.corner[i];
  return kNone;
}

// The other diagonal of the two faces at side k: from corner k of `face` to the point across.
// Afterwards `face` has that point as corner 2, the old corner k as corner 1.
void ConstrainedDelaunay::flip(int face, std::size_t k) {
  const int beside = faces_[at(face)].beside[k];
  const Face f = faces_[at(face)], g = faces_[at(beside)];
  const int far = opposite(face, k);
  const std::size_t i = corner_of(g, far);
  const int p = f.corner[k], a = f.corner[next(k)], b = f.corner[previous(k)];
  // g: far, b, a.
  faces_[at(face)] = {{b, p, far},
                      {beside, g.beside[previous(i)], f.beside[next(k)]},
                      {false, g.fixed[previous(i)], f.fixed[next(k)]},
                      f.inside};
  faces_[at(beside)] = {{a, far, p},
                        {face, f.beside[previous(k)], g.beside[next(i)]},
                        {false, f.fixed[previous(k)], g.fixed[next(i)]},
                        g.inside};
  replace_neighbour(g.beside[previous(i)], beside, face);
  replace_neighbour(f.beside[previous(k)], face, beside);
  note_corners(face);
  note_corners(beside);
}

// Flips the side, and those that this makes doubtful, until they are Delaunay.
void ConstrainedDelaunay::restore(int face, std::size_t k) {
  std::vector<DoubtfulSide>& doubtful = doubtful_;
  const auto doubt = [&](int number, std::size_t i) {
    const Face& f = faces_[at(number)];
    doubtful.push_back({f.corner[next(i)], f.corner[previous(i)], number});
  };
  doubt(face, k);
  while (!doubtful.empty()) {
    const auto [a, b, known] = doubtful.back();
    doubtful.pop_back();
    const auto [here, i] = side_of(known, a, b);
    if (here == kNone) continue;
    const Face& f = faces_[at(here)];
    if (f.fixed[i] || f.beside[i] == kNone) continue;
    const int far = opposite(here, i);
    if (is_flat(here) ? !lies_between(a, b, f.corner[i])
                      : in_circle(points_[at(f.corner[0])], points_[at(f.corner[1])],
                                  points_[at(f.corner[2])], points_[at(far)]) <= 0 ||
                            !is_convex_across(here, i))
      continue;
    const int across = f.beside[i];
    flip(here, i);
    for (const int changed : {here, across})
      for (const std::size_t side : {std::size_t{1}, std::size_t{2}}) doubt(changed, side);
  }
}

// All sides that the way from one point to another crosses, in order.
bool ConstrainedDelaunay::crossed_sides(int from, int to, std::deque<std::pair<int, int>>& crossed,
                                        std::pair<int, int>& obstacle) const {
  if (side_between(from, to).first != kNone) return true;
  int face = face_at_[at(from)];
  std::size_t k = corner_of(faces_[at(face)], from);
  for (;; face = faces_[at(face)].beside[next(k)], k = corner_of(faces_[at(face)], from)) {
    const Face& f = faces_[at(face)];
    const int right = turn(from, to, f.corner[next(k)]);
    if (right == 0 && ahead(from, to, f.corner[next(k)]))
      return obstacle = {f.corner[next(k)], kNone}, false;
    if (right < 0 && turn(from, to, f.corner[previous(k)]) > 0) break;
  }
  while (true) {
    const Face& f = faces_[at(face)];
    const int a = f.corner[next(k)], b = f.corner[previous(k)];
    obstacle = {a, b};
    if (f.fixed[k]) return false;
    crossed.push_back({a, b});
    const int far = opposite(face, k);
    if (far == to) return true;
    const int side = turn(from, to, far);
    if (side == 0) return obstacle = {far, kNone}, false;
    face = f.beside[k];
    // On to the side between `far` and the end that lies across the way from it.
    const Face& g = faces_[at(face)];
    k = corner_of(g, side > 0 ? b : a);
  }
}

bool ConstrainedDelaunay::ahead(int from, int to, int point) const {
  return dot(points_[at(point)] - points_[at(from)], points_[at(to)] - points_[at(from)]) > 0;
}

void ConstrainedDelaunay::set_fixed(int from, int to) {
  for (const auto& [a, b] : {std::pair{from, to}, std::pair{to, from}}) {
    const auto [face, k] = side_between(a, b);
    if (face != kNone) faces_[at(face)].fixed[k] = true;
  }
}

// How often the borders go round each face, from the outermost one inwards; none if they disagree.
std::vector<int> ConstrainedDelaunay::winding_numbers(const SideWindings& windings,
                                                      int outermost) const {
  constexpr int kUnseen = -1000;
  std::vector<int> winding(faces_.size(), kUnseen);
  std::vector<int> open{outermost};
  winding[at(outermost)] = 0;
  while (!open.empty()) {
    const int face = open.back();
    open.pop_back();
    const Face& f = faces_[at(face)];
    for (std::size_t k = 0; k < 3; ++k) {
      if (f.beside[k] == kNone) continue;
      int there = winding[at(face)];
      const auto border = windings.find({f.corner[next(k)], f.corner[previous(k)]});
      if (border != windings.end()) there -= border->second;
      int& known = winding[at(f.beside[k])];
      if (known != kUnseen && known != there) return {};
      if (known == kUnseen) open.push_back(f.beside[k]);
      known = there;
    }
  }
  return winding;
}

bool ConstrainedDelaunay::mark_region(const SideWindings& windings) {
  const std::vector<int> winding = winding_numbers(windings, face_at_[at(first_far_)]);
  if (winding.empty() || !std::ranges::all_of(winding, [](int w) { return w == 0 || w == 1; }))
    return false;
  for (std::size_t i = 0; i < faces_.size(); ++i) faces_[i].inside = winding[i] == 1;
  return true;
}

}  // namespace blossom
