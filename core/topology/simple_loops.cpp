// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/topology/simple_loops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "core/math/interval.h"
#include "core/plane/loops.h"

namespace blossom {
namespace {

// Of a curve over [0, 1]: its pieces are then as short as parameters near 1 are rounded.
constexpr int kHalvings = 52;
// A choice: at some 0.3 us each they take as long as BRepCheck takes for an edge, about.
constexpr std::size_t kTestsPerSpan = 1000;
// Radians between cones. A choice: a gap of rounding stays far below any tolerance.
constexpr double kMinAngle = 1e-2;
// A choice, of lengths by the chart's derivatives at a corner: where these grow by more in the
// reach of the vertex, by samples, nothing is said.
constexpr double kLengthMargin = 2;

// How many tests of pieces are left for a face. Curves that run beside each other just over the
// margin would take as many as they are longer than it.
class TestBudget {
 public:
  explicit TestBudget(std::size_t spans) : left_(kTestsPerSpan * spans) {}

  bool spend() { return left_ > 0 && left_-- > 0; }

 private:
  std::size_t left_;
};

TestBudget budget_of(const FaceTrims& trims) {
  std::size_t spans = 0;
  for (const auto& loop : trims.loops)
    for (const Coedge& coedge : loop) spans += coedge.curve.spans.size();
  return TestBudget(spans);
}

// A part of a loop in the order of its walk.
struct LoopPiece {
  PlanarBezier curve;
  PlanarBox box;
  std::size_t before = 0, after = 0;  // the pieces that it shares its ends with
  int vertex = -1;                    // where it begins, if a coedge does

  Vec2 first() const { return projected(curve.points.front()); }
  Vec2 last() const { return projected(curve.points.back()); }
};

LoopPiece piece_of(PlanarBezier curve, int vertex) {
  LoopPiece piece{std::move(curve), {}};
  piece.box = box_of(piece.curve.points);
  piece.vertex = vertex;
  return piece;
}

// Whether the curve goes on in the direction of its chord: its derivative lies in the convex cone
// of all differences of its control points, later ones minus earlier ones.
bool goes_on(const PlanarBezier& curve) {
  const auto& points = curve.points;
  const Vec2 chord = projected(points.back()) - projected(points.front());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = i + 1; k < points.size(); ++k)
      if (!(dot(chord, projected(points[k]) - projected(points[i])) > 0)) return false;
  return true;
}

// False if that many halvings do not do, as at a cusp, or no test is left.
bool add_pieces(const PlanarBezier& curve, int vertex, int halvings, TestBudget& tests,
                std::vector<LoopPiece>& all) {
  if (!tests.spend()) return false;
  if (goes_on(curve)) {
    all.push_back(piece_of(curve, vertex));
    return true;
  }
  return halvings > 0 &&
         add_pieces(bezier_piece(curve, {0, 0.5}), vertex, halvings - 1, tests, all) &&
         add_pieces(bezier_piece(curve, {0.5, 1}), -1, halvings - 1, tests, all);
}

PlanarPath path_of(const Coedge& coedge) {
  const Interval domain = coedge.curve.domain();
  return bezier_pieces(coedge.curve, coedge.reversed ? Interval{domain.to, domain.from} : domain);
}

// Whether all points of b are beyond those of a by a line along the chord of a, or across it.
bool parts(const PlanarBezier& a, const PlanarBezier& b, double margin) {
  const Vec2 chord = projected(a.points.back()) - projected(a.points.front());
  const double length = norm(chord);
  if (!(length > 0)) return false;
  const Vec2 along = (1 / length) * chord, across{-along[1], along[0]};
  for (const Vec2& way : {across, along}) {
    const auto range = [&](const PlanarBezier& curve) {
      Interval heights{dot(way, projected(curve.points.front())), 0};
      heights.to = heights.from;
      for (const Vec3& point : curve.points) {
        const double height = dot(way, projected(point));
        heights = {std::min(heights.from, height), std::max(heights.to, height)};
      }
      return heights;
    };
    const Interval of_a = range(a), of_b = range(b);
    if (of_a.to + margin < of_b.from || of_b.to + margin < of_a.from) return true;
  }
  return false;
}

// False if that many halvings of the two together do not do, or no test is left.
bool are_apart(const PlanarBezier& a, const PlanarBezier& b, double margin, int halvings,
               TestBudget& tests) {
  if (!tests.spend()) return false;
  const PlanarBox of_a = box_of(a.points), of_b = box_of(b.points);
  if (are_disjoint(of_a, of_b, margin) || parts(a, b, margin) || parts(b, a, margin)) return true;
  if (halvings == 0) return false;
  const bool first = distance(of_a.low, of_a.high) >= distance(of_b.low, of_b.high);
  const PlanarBezier& longer = first ? a : b;
  return std::ranges::all_of(std::array{Interval{0, 0.5}, Interval{0.5, 1}}, [&](const auto& half) {
    return are_apart(bezier_piece(longer, half), first ? b : a, margin, halvings - 1, tests);
  });
}

// The directions from an apex to points: within the range round a middle one, radians.
struct Cone {
  double middle = 0;
  Interval range{0, 0};
};

double turned_between(double from, double to) {
  return std::remainder(to - from, 2 * std::numbers::pi);
}

// Nothing of points that are all in the apex, or on all sides of it.
std::optional<Cone> cone_of(const PlanarBezier& curve, bool from_end) {
  const Vec2 apex = projected(from_end ? curve.points.back() : curve.points.front());
  const Vec2 chord = projected(from_end ? curve.points.front() : curve.points.back()) - apex;
  if (norm(chord) == 0) return std::nullopt;
  Cone cone{std::atan2(chord[1], chord[0])};
  for (const Vec3& point : curve.points) {
    const Vec2 way = projected(point) - apex;
    if (way[0] == 0 && way[1] == 0) continue;
    if (!(dot(way, chord) > 0)) return std::nullopt;
    const double off = turned_between(cone.middle, std::atan2(way[1], way[0]));
    cone.range = {std::min(cone.range.from, off), std::max(cone.range.to, off)};
  }
  return cone;
}

// The angle between two cones; negative if they overlap.
double angle_between(const Cone& a, const Cone& b) {
  double turn = turned_between(a.middle, b.middle);
  if (turn < 0) turn += 2 * std::numbers::pi;
  return std::min(turn + b.range.from - a.range.to,
                  2 * std::numbers::pi - turn - b.range.to + a.range.from);
}

// How far from the end of a piece, at most, it meets the next one, which begins there; nothing if
// no bound is found.
std::optional<double> reach_of_meeting(const PlanarBezier& a, const PlanarBezier& b, double margin,
                                       int halvings, TestBudget& tests) {
  if (!tests.spend()) return std::nullopt;
  const auto cone_a = cone_of(a, true), cone_b = cone_of(b, false);
  if (!cone_a || !cone_b) return std::nullopt;
  const double angle = angle_between(*cone_a, *cone_b);
  if (angle >= kMinAngle) {
    const double gap = distance(projected(a.points.back()), projected(b.points.front()));
    return gap / std::sin(std::min(angle, 0.5 * std::numbers::pi));
  }
  if (halvings == 0) return std::nullopt;
  const PlanarBezier far_a = bezier_piece(a, {0, 0.5}), near_a = bezier_piece(a, {0.5, 1}),
                     near_b = bezier_piece(b, {0, 0.5}), far_b = bezier_piece(b, {0.5, 1});
  if (!are_apart(far_a, near_b, margin, halvings, tests) ||
      !are_apart(far_a, far_b, margin, halvings, tests) ||
      !are_apart(near_a, far_b, margin, halvings, tests))
    return std::nullopt;
  return reach_of_meeting(near_a, near_b, margin, halvings - 2, tests);
}

// The coedges of a loop as the walk takes them; none if it passes a corner twice.
std::vector<const Coedge*> in_order(const std::vector<Coedge>& loop) {
  std::vector<const Coedge*> order{&loop.front()};
  while (order.size() < loop.size()) {
    const auto follows = [&](const Coedge& next) { return next.from == order.back()->to; };
    const auto next = std::ranges::find_if(loop, follows);
    if (next == loop.end() || std::ranges::count_if(loop, follows) > 1 || &*next == order.front())
      return {};
    order.push_back(&*next);
  }
  return order;
}

// With the straight way over the gap between its ends.
bool encloses(const PlanarPath& loop, const Vec2& point) {
  return ray_crossings(loop, point) + ray_crossings(end_of(loop), start_of(loop), point) != 0;
}

class LoopsProof {
 public:
  LoopsProof(const FaceTrims& trims, double margin)
      : trims_(trims), margin_(margin), tests_(budget_of(trims)) {}

  Nesting nesting() {
    const bool apart =
        std::ranges::all_of(trims_.loops, [&](const auto& loop) { return add(loop); }) &&
        neighbours_meet_in_corners() && others_are_apart();
    return apart ? nesting_of_parted() : Nesting::InDoubt;
  }

 private:
  // Four pieces at least: none shares a corner with both of those that end at a gap, but they.
  bool add(const std::vector<Coedge>& loop) {
    std::vector<LoopPiece> ring;
    for (const Coedge* coedge : in_order(loop)) {
      int vertex = coedge->start;
      for (const PlanarBezier& curve : path_of(*coedge))
        if (!add_pieces(curve, std::exchange(vertex, -1), kHalvings, tests_, ring)) return false;
    }
    if (ring.empty()) return false;
    while (ring.size() < 4) {
      std::vector<LoopPiece> halves;
      for (const LoopPiece& piece : ring) {
        halves.push_back(piece_of(bezier_piece(piece.curve, {0, 0.5}), piece.vertex));
        halves.push_back(piece_of(bezier_piece(piece.curve, {0.5, 1}), -1));
      }
      ring = std::move(halves);
    }
    const std::size_t begin = pieces_.size(), end = begin + ring.size();
    for (std::size_t i = begin; i < end; ++i) {
      ring[i - begin].before = i == begin ? end - 1 : i - 1;
      ring[i - begin].after = i + 1 == end ? begin : i + 1;
    }
    std::ranges::move(ring, std::back_inserter(pieces_));
    ends_.push_back(end);
    return true;
  }

  bool neighbours_meet_in_corners() {
    return std::ranges::all_of(pieces_, [&](const LoopPiece& piece) {
      const LoopPiece& next = pieces_[piece.after];
      const auto reach = reach_of_meeting(piece.curve, next.curve, margin_, 2 * kHalvings, tests_);
      return reach && (next.vertex < 0 ? *reach <= margin_ : is_covered(next, *reach));
    });
  }

  SurfaceJet jet_at(const Vec2& place) const {
    return trims_.jet({place[0] / trims_.scale[0], place[1] / trims_.scale[1]});
  }

  // No length in space is more than this times that in the chart.
  double rate_of(const SurfaceJet& jet) const {
    return norm(jet.du) / trims_.scale[0] + norm(jet.dv) / trims_.scale[1];
  }

  // Whether the vertex where a piece begins covers a square of the chart round that place: by the
  // rate there, with a margin, that is not exceeded in the corners of the square.
  bool is_covered(const LoopPiece& piece, double reach) const {
    const FaceVertex& vertex = trims_.vertices[static_cast<std::size_t>(piece.vertex)];
    const Vec2 place = piece.first();
    const SurfaceJet jet = jet_at(place);
    const double rate = kLengthMargin * rate_of(jet);
    if (!(distance(jet.point, vertex.point) + rate * reach <= vertex.tolerance)) return false;
    if (reach == 0) return true;
    for (const double du : {-reach, reach})
      for (const double dv : {-reach, reach})
        if (!(rate_of(jet_at(place + Vec2{du, dv})) <= rate)) return false;
    return rate > 0;
  }

  // By increasing x, so that only those with a common range of it are looked at. The straight way
  // over a gap stays within its length of both pieces that end there, and one of these is none of
  // the neighbours of any third piece: what is apart from that by the gap more is apart from it.
  bool others_are_apart() {
    const double margin = margin_ + trims_.largest_gap;
    std::vector<std::size_t> order(pieces_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::sort(order, {}, [&](std::size_t i) { return pieces_[i].box.low[0]; });
    for (std::size_t m = 0; m < order.size(); ++m) {
      const LoopPiece& a = pieces_[order[m]];
      for (std::size_t n = m + 1; n < order.size(); ++n) {
        const LoopPiece& b = pieces_[order[n]];
        if (b.box.low[0] > a.box.high[0] + margin) break;
        if (a.before == order[n] || a.after == order[n] || are_disjoint(a.box, b.box, margin))
          continue;
        if (!are_apart(a.curve, b.curve, margin, 2 * kHalvings, tests_)) return false;
      }
    }
    return true;
  }

  PlanarPath path(std::size_t loop) const {
    PlanarPath path;
    for (std::size_t i = loop == 0 ? 0 : ends_[loop - 1]; i < ends_[loop]; ++i)
      path.push_back(pieces_[i].curve);
    return path;
  }

  // Loops that are apart are nested as any of their points are. An area of less than the margin
  // along the loop has no sign that gaps between coedges could not change.
  Nesting nesting_of_parted() const {
    std::optional<std::size_t> outer;
    std::vector<PlanarPath> paths;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      paths.push_back(path(i));
      const double area = area_along(paths[i], start_of(paths[i]));
      double around = 0;
      for (const PlanarBezier& curve : paths[i])
        around += distance(projected(curve.points.front()), projected(curve.points.back()));
      if (!(std::abs(area) > std::max(margin_, trims_.largest_gap) * around))
        return Nesting::InDoubt;
      if (area > 0 && std::exchange(outer, i)) return Nesting::InDoubt;
    }
    if (!outer) return Nesting::InDoubt;
    for (std::size_t i = 0; i < paths.size(); ++i)
      for (std::size_t k = 0; k < paths.size(); ++k)
        if (i != k && i != *outer && encloses(paths[k], start_of(paths[i])) != (k == *outer))
          return Nesting::HoleAstray;
    return Nesting::Sound;
  }

  const FaceTrims& trims_;
  const double margin_;
  TestBudget tests_;
  std::vector<LoopPiece> pieces_;
  std::vector<std::size_t> ends_;  // of loops among these
};

}  // namespace

Nesting nesting_of(const FaceTrims& trims, double margin) {
  return LoopsProof(trims, margin).nesting();
}

}  // namespace blossom
