// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/neighbours/coedge_stretch.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <queue>

#include "core/base/unbounded.h"
#include "core/math/functions/bisection.h"
#include "core/neighbours/limits.h"

namespace blossom {
namespace {

constexpr double kPast = 0.1;          // of a rectangle: so far past it an edge is followed
constexpr int kSideHalvings = 24;      // of two curves together, to see on which side one keeps
constexpr double kTooSmall = 0x1p-8;   // of a rectangle: so small pieces beside it may meet it
constexpr double kFootPiece = 0x1p-8;  // of a wire, in which its point nearest to another is sought
constexpr double kMinPiece = 0x1p-40;  // of a span, likewise
constexpr int kNewtonSteps = 8;
constexpr double kFar = 4;  // rectangles: what is so far from an edge is not beside it
constexpr int kBisections = 60;

double width(const PlanarBox& box, int k) { return box.high[k] - box.low[k]; }

bool meets(const PlanarBezier& piece, const PlanarBox& box, int halvings) {
  const PlanarBox own = box_of(piece.points);
  if (are_disjoint(own, box)) return false;
  if (halvings == 0 || holds(box, projected(piece.points.front())) ||
      holds(box, projected(piece.points.back())) ||
      distance(own.low, own.high) < kTooSmall * distance(box.low, box.high))
    return true;
  return meets(bezier_piece(piece, {0, 0.5}), box, halvings - 1) ||
         meets(bezier_piece(piece, {0.5, 1}), box, halvings - 1);
}

// Whether an edge between two of its parameters may meet a box.
bool meets(const Coedge& edge, const Interval& range, const PlanarBox& box) {
  for (std::size_t i = 0; i < edge.curve.spans.size(); ++i) {
    const PlanarSpan& span = edge.curve.spans[i];
    const Interval common{std::max(range.from, span.place.from), std::min(range.to, span.place.to)};
    if (!(common.from < common.to) || are_disjoint(edge.boxes[i], box)) continue;
    const Interval local{local_parameter(span.law, span.place, common.from),
                         local_parameter(span.law, span.place, common.to)};
    if (meets(bezier_piece(span.curve, local), box, kMaxHalvings)) return true;
  }
  return false;
}

// The derivative of a rational curve lies in the convex cone of all differences of its control
// points, later ones minus earlier ones.
bool grows(const PlanarBezier& piece, int k, double sign) {
  const auto& points = piece.points;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      if (!(sign * (projected(points[j])[k] - projected(points[i])[k]) > 0)) return false;
  return true;
}

double distance_to(const PlanarBox& box, const Vec2& p) {
  const auto off = [&](int k) { return std::max({box.low[k] - p[k], p[k] - box.high[k], 0.0}); };
  return std::hypot(off(0), off(1));
}

// Newton's method for the nearest point, from a parameter near its own.
double improved_foot(const PlanarCurve& curve, const Vec2& target, double t) {
  const Interval domain = curve.domain();
  for (int i = 0; i < kNewtonSteps; ++i) {
    const PlanarJet jet = jet_at(curve, t);
    const Vec2 off = jet.point - target;
    const double slope = dot(jet.first, jet.first) + std::max(0.0, dot(off, jet.second));
    if (!(slope > 0)) break;
    t = std::clamp(t - dot(off, jet.first) / slope, domain.from, domain.to);
  }
  return t;
}

// A parameter at which a coordinate has got past a value by no more than `precision`, going on
// from `start`; the end of the curve if it does not get there.
double reached(const PlanarCurve& curve, double start, int k, double value, double precision,
               int way) {
  const Interval domain = curve.domain();
  const double end = way > 0 ? domain.to : domain.from;
  const bool above = point_at(curve, start)[k] > value;
  const auto is_there = [&](double t) { return (point_at(curve, t)[k] > value) != above; };
  const double slope = std::abs(jet_at(curve, start).first[k]);
  double step = std::abs(point_at(curve, start)[k] - value) / slope, last = start;
  for (;;) {
    double next = start + way * step;
    if ((end - next) * way <= 0) next = end;
    if (is_there(next)) {
      const auto is_exact = [&] { return std::abs(point_at(curve, next)[k] - value) <= precision; };
      for (int i = 0; i < kBisections && !is_exact(); ++i) {
        const double middle = 0.5 * (last + next);
        (is_there(middle) ? next : last) = middle;
      }
      return next;
    }
    if (next == end) return end;
    last = next;
    step = std::max(2 * step, 1e-12 * length(domain));
  }
}

// Of a curve that is a graph over a coordinate: the parameter at a value of it.
double parameter_where(const PlanarCurve& curve, const Interval& range, int k, double value) {
  const bool rising = point_at(curve, range.to)[k] > point_at(curve, range.from)[k];
  const auto is_before = [&](double t) { return (point_at(curve, t)[k] > value) != rising; };
  return bisected(range, kBisections, is_before).from;
}

// Whether another curve is proven to keep on the inner side of a piece of a stretch, in as much of
// the box as both go along: by a line beside the piece, along its chord. It may begin or end on the
// line, as at a corner, but not run along it: the face may be on the other side then.
bool keeps_inside(const PlanarBezier& other, const PlanarBezier& piece,
                  const CoedgeStretch& stretch, const PlanarBox& box, int halvings) {
  const int k = stretch.along;
  const PlanarBox of_other = box_of(other.points), of_piece = box_of(piece.points);
  if (are_disjoint(of_other, box) || of_other.low[k] > of_piece.high[k] ||
      of_other.high[k] < of_piece.low[k])
    return true;
  const Vec2 chord = projected(piece.points.back()) - projected(piece.points.front());
  const double side = stretch.inner * (k == 0 ? chord[0] : -chord[1]) > 0 ? 1 : -1;
  double highest = -kUnbounded, lowest = kUnbounded, farthest = -kUnbounded;
  for (const Vec3& p : piece.points)
    highest = std::max(highest, side * cross(chord, projected(p) - of_piece.low));
  for (const Vec3& p : other.points) {
    const double height = side * cross(chord, projected(p) - of_piece.low);
    lowest = std::min(lowest, height);
    farthest = std::max(farthest, height);
  }
  if (lowest >= highest && farthest > highest) return true;
  if (halvings == 0) return false;
  const bool of_stretch = width(of_piece, k) > width(of_other, k);
  for (const Interval& half : {Interval{0, 0.5}, Interval{0.5, 1}})
    if (!(of_stretch ? keeps_inside(other, bezier_piece(piece, half), stretch, box, halvings - 1)
                     : keeps_inside(bezier_piece(other, half), piece, stretch, box, halvings - 1)))
      return false;
  return true;
}

// What other edges of a face do to a rectangle beside a stretch.
enum class Others { KeepOut, KeepInside, Cross };

Others others_at(const FaceTrims& trims, const Coedge& edge, const CoedgeStretch& stretch,
                 const PlanarBox& box) {
  Others all = Others::KeepOut;
  for (const auto& loop : trims.loops)
    for (const Coedge& other : loop) {
      if (&other == &edge) continue;
      for (std::size_t i = 0; i < other.boxes.size(); ++i) {
        const PlanarBezier& curve = other.curve.spans[i].curve;
        if (are_disjoint(other.boxes[i], box) || !meets(curve, box, kMaxHalvings)) continue;
        all = Others::KeepInside;
        if (stretch.shortfall > 0 ||
            !std::ranges::all_of(stretch.pieces, [&](const PlanarBezier& piece) {
              return keeps_inside(curve, piece, stretch, box, kSideHalvings);
            }))
          return Others::Cross;
      }
    }
  return all;
}

}  // namespace

// Pieces that may hold a nearer point are halved, nearest boxes first. On a line there is one foot.
double foot_on(const Coedge& edge, const Vec2& target) {
  if (edge.curve.spans.size() == 1 && edge.curve.spans.front().curve.degree() <= 1)
    return improved_foot(edge.curve, target, at(edge.curve.domain(), 0.5));
  struct Piece {
    double least = 0;  // distance of its box
    double size = 0;   // of its box
    std::size_t span = 0;
    Interval local{0, 1};
  };
  const auto is_farther = [](const Piece& a, const Piece& b) { return a.least > b.least; };
  std::priority_queue<Piece, std::vector<Piece>, decltype(is_farther)> pieces(is_farther);
  const auto add = [&](const PlanarBox& box, std::size_t span, const Interval& local) {
    pieces.push({distance_to(box, target), distance(box.low, box.high), span, local});
  };
  double largest = 0;
  for (std::size_t i = 0; i < edge.boxes.size(); ++i) {
    add(edge.boxes[i], i, {0, 1});
    largest = std::max(largest, distance(edge.boxes[i].low, edge.boxes[i].high));
  }
  for (;;) {
    const Piece piece = pieces.top();
    pieces.pop();
    const PlanarSpan& span = edge.curve.spans[piece.span];
    const double middle = 0.5 * (piece.local.from + piece.local.to);
    if (piece.size <= kFootPiece * largest || length(piece.local) < kMinPiece)
      return improved_foot(edge.curve, target, parameter_at(span.law, span.place, middle));
    for (const Interval& half :
         {Interval{piece.local.from, middle}, Interval{middle, piece.local.to}})
      add(box_of(bezier_piece(span.curve, half).points), piece.span, half);
  }
}

std::optional<CoedgeStretch> stretch_past(const Coedge& edge, const PlanarBox& box) {
  const double foot = foot_on(edge, 0.5 * (box.low + box.high));
  const PlanarJet at_foot = jet_at(edge.curve, foot);
  if (distance_to(box, at_foot.point) > kFar * distance(box.low, box.high)) return {};
  const Vec2 way = at_foot.first;
  CoedgeStretch stretch;
  stretch.along = std::abs(way[0]) >= std::abs(way[1]) ? 0 : 1;
  const int k = stretch.along;
  if (way[k] == 0) return {};
  const double sign = way[k] > 0 ? 1 : -1;
  const double past = kPast * width(box, k);
  const double low = box.low[k] - past, high = box.high[k] + past;
  stretch.range.from = reached(edge.curve, foot, k, sign > 0 ? low : high, 0.5 * past, -1);
  stretch.range.to = reached(edge.curve, foot, k, sign > 0 ? high : low, 0.5 * past, 1);
  if (!(stretch.range.from < stretch.range.to)) return {};
  stretch.pieces = bezier_pieces(edge.curve, stretch.range);
  if (stretch.pieces.empty()) return {};
  stretch.box = box_of(stretch.pieces.front().points);
  for (const PlanarBezier& piece : stretch.pieces) {
    if (!grows(piece, k, sign)) return {};
    stretch.box = united(stretch.box, box_of(piece.points));
  }
  stretch.shortfall =
      std::max({0.0, stretch.box.low[k] - box.low[k], box.high[k] - stretch.box.high[k]});
  const double walk = edge.reversed ? -sign : sign;
  stretch.inner = k == 0 ? walk : -walk;  // a face is on the left of its wires
  return stretch;
}

// An edge that keeps to the inner side leaves nothing of the face beyond the stretch. Where the
// stretch itself keeps out of the rectangle, that is on one side of it.
bool lies_beside(const FaceTrims& trims, const Coedge& edge, const CoedgeStretch& stretch,
                 const PlanarBox& box) {
  const Interval domain = edge.curve.domain();
  if (meets(edge, {domain.from, stretch.range.from}, box) ||
      meets(edge, {stretch.range.to, domain.to}, box))
    return false;
  const Others others = others_at(trims, edge, stretch, box);
  if (others == Others::Cross) return false;
  if (others == Others::KeepInside || meets(edge, stretch.range, box)) return true;
  const Vec2 centre = 0.5 * (box.low + box.high);
  if (!is_inside(trims, centre)) return true;
  const int k = stretch.along;
  const double t = parameter_where(edge.curve, stretch.range, k, centre[k]);
  return stretch.inner * (centre[1 - k] - point_at(edge.curve, t)[1 - k]) > 0;
}

}  // namespace blossom
