// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/plane/arrangement.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <ranges>
#include <string>
#include <utility>
#include <vector>

#include "core/base/errors.h"

namespace blossom {
namespace {

// Arms whose directions differ by less are ordered by curvature. Radians; the end of a fitted
// curve has its direction about this well.
constexpr double kSameDirection = 1e-7;

// Of the longest piece of a path: so near its end nothing tells where it goes.
constexpr double kNoise = 1e-5;

// Arms that differ by more do not touch. Radians; a choice, which saves work alone.
constexpr double kSmallTurn = 0.1;

// Of Newton's method, to where a nearly straight start of an arc is so far on.
constexpr int kSteps = 4;

// A half-edge as a number: arc * 2, plus 1 when reversed.
using Walk = std::size_t;

Walk walk_of(std::size_t arc, bool reversed) { return 2 * arc + (reversed ? 1 : 0); }
Walk twin(Walk walk) { return walk ^ 1u; }
HalfEdge half_edge(Walk walk) { return {static_cast<int>(walk / 2), walk % 2 == 1}; }

// How a half-edge leaves its vertex.
struct Arm {
  Walk walk = 0;
  double angle = 0;      ///< in (-pi, pi]
  double curvature = 0;  ///< to the left positive
  double secant = 0;     ///< turn from the direction to a point farther on, to the left positive
  const PlanarPath* path = nullptr;
  std::size_t lead = 0;  ///< its first piece that leads away, counted from the vertex
  Vec2 start{};          ///< where that begins

  bool reversed() const { return walk % 2 == 1; }
};

// Pieces of a path counted from one of its ends.
const PlanarBezier& piece_from(const PlanarPath& path, bool reversed, std::size_t i) {
  return path[reversed ? path.size() - 1 - i : i];
}

// The first piece that leads away from an end of a path: what shorter ones do there is noise, as
// where a span of a surface has the width of rounding.
std::size_t leading_piece(const PlanarPath& path, bool reversed) {
  const Vec2 end = reversed ? end_of(path) : start_of(path);
  double size = 0;
  for (const PlanarBezier& curve : path)
    size =
        std::max(size, distance(projected(curve.points.back()), projected(curve.points.front())));
  for (std::size_t i = 0; i < path.size(); ++i) {
    const PlanarBezier& curve = piece_from(path, reversed, i);
    const Vec2 far = projected(reversed ? curve.points.front() : curve.points.back());
    if (distance(far, end) > kNoise * size) return i;
  }
  return 0;
}

Arm arm_of(const ChartArc& arc, Walk walk) {
  const bool reversed = walk % 2 == 1;
  const std::size_t lead = leading_piece(arc.path, reversed);
  const PlanarBezier& curve = piece_from(arc.path, reversed, lead);
  const double sign = reversed ? -1 : 1;
  const double start = reversed ? 1 : 0;
  constexpr double kStandsStill =
      1e-9;  // part of a quarter of the piece: no direction but rounding
  constexpr double kBesideVertex =
      1e-4;  // part of the piece: from there the direction is taken then
  const PlanarJet jet = jet_at(curve, start);
  const Vec2 far = jet_at(curve, reversed ? 0.75 : 0.25).point - jet.point;
  Vec2 direction = sign * jet.first;
  double curvature = 0;
  if (norm(direction) > kStandsStill * norm(far))
    curvature = cross(direction, jet.second) / std::pow(norm(direction), 3);
  else
    direction = jet_at(curve, reversed ? 1 - kBesideVertex : kBesideVertex).point - jet.point;
  return {walk,      std::atan2(direction[1], direction[0]),
          curvature, std::atan2(cross(direction, far), dot(direction, far)),
          &arc.path, lead,
          jet.point};
}

Vec2 direction_of(const Arm& arm) { return {std::cos(arm.angle), std::sin(arm.angle)}; }

// The piece of an arm that is so far from the vertex along a direction; null if the arm ends or
// turns back before. The first ones may be short, as a crossing may lie beside a knot.
const PlanarBezier* piece_at(const Arm& arm, const Vec2& along, double distance) {
  double before = 0;
  for (std::size_t i = arm.lead; i < arm.path->size(); ++i) {
    const PlanarBezier& piece = piece_from(*arm.path, arm.reversed(), i);
    const Vec2 far = projected(arm.reversed() ? piece.points.front() : piece.points.back());
    const double reached = dot(far - arm.start, along);
    if (reached >= distance) return &piece;
    if (reached <= before) return nullptr;
    before = reached;
  }
  return nullptr;
}

// How far to the left of a direction an arm is, so far from the vertex along it, which it reaches.
double offset_at(const Arm& arm, const Vec2& along, double distance) {
  const PlanarBezier& piece = *piece_at(arm, along, distance);
  double t = arm.reversed() ? 1 : 0;
  for (int i = 0; i < kSteps; ++i) {
    const PlanarJet jet = jet_at(piece, t);
    t = std::clamp(t + (distance - dot(jet.point - arm.start, along)) / dot(jet.first, along), 0.0,
                   1.0);
  }
  return cross(along, jet_at(piece, t).point - arm.start);
}

// How far an arm goes along a direction before it turns back.
double reach_along(const Arm& arm, const Vec2& along) {
  double reached = 0;
  for (std::size_t i = arm.lead; i < arm.path->size(); ++i) {
    const PlanarBezier& piece = piece_from(*arm.path, arm.reversed(), i);
    const Vec2 far = projected(arm.reversed() ? piece.points.front() : piece.points.back());
    const double next = dot(far - arm.start, along);
    if (next <= reached) break;
    reached = next;
  }
  return reached;
}

// How far from the vertex the order of two neighbouring arms is to be read, if they touch there and
// the left one is on the right beyond; else 0. As arcs do not cross, it is told by where they are
// farther apart than the tolerance for the first time, or by half the way along the shorter one.
double touch_length(const Arm& right, const Arm& left, double tolerance) {
  const double turn = left.angle - right.angle;
  if (turn <= 0 || turn > kSmallTurn) return 0;
  const Vec2 along = direction_of(right);
  const double half = 0.5 * std::min(reach_along(right, along), reach_along(left, along));
  const auto apart = [&](double length) {
    return offset_at(left, along, length) - offset_at(right, along, length);
  };
  for (double length = 2 * tolerance / turn; length > 0 && length < half; length *= 2)
    if (const double here = apart(length); std::abs(here) > tolerance) return here < 0 ? length : 0;
  return half > 0 && apart(half) < 0 ? half : 0;
}

// Orders arms of one direction that begin beside each other, as far apart as their vertex covers,
// from right to left: as they do not cross, half the way along the shortest tells. False if all
// begin in one place but for the tolerance.
bool order_beside(std::span<Arm> arms, double tolerance) {
  const Vec2 along = direction_of(arms.front());
  const auto start = [&](const Arm& arm) { return cross(along, arm.start - arms.front().start); };
  const auto [low, high] = std::ranges::minmax(arms | std::views::transform(start));
  if (high - low <= tolerance) return false;
  double reach = reach_along(arms.front(), along);
  for (const Arm& arm : arms) reach = std::min(reach, reach_along(arm, along));
  if (!(reach > 0)) return false;
  std::vector<std::pair<double, Arm>> placed;
  for (const Arm& arm : arms)
    placed.emplace_back(start(arm) + offset_at(arm, along, 0.5 * reach), arm);
  std::ranges::sort(placed, {}, [](const auto& each) { return each.first; });
  for (std::size_t i = 0; i < arms.size(); ++i) arms[i] = placed[i].second;
  return true;
}

// Whether two neighbouring arms begin so far beside each other that, by their directions, the left
// one still lies on the right half the way along the shorter one.
bool change_sides_later(const Arm& right, const Arm& left, double tolerance) {
  const Vec2 along = direction_of(right);
  const double beside = cross(along, right.start - left.start), turn = left.angle - right.angle;
  if (beside <= tolerance || turn > 0.25 * std::numbers::pi) return false;
  const double reach = std::min(reach_along(right, along), reach_along(left, along));
  return 2 * beside >= reach * std::tan(turn);
}

// Orders arms of about one direction from right to left, so far from the vertex.
void order_at(double distance, std::span<Arm> arms) {
  const Vec2 along = direction_of(arms.front());
  std::vector<std::pair<double, Arm>> placed;
  for (const Arm& arm : arms) placed.emplace_back(offset_at(arm, along, distance), arm);
  std::sort(placed.begin(), placed.end(), [](const auto& a, const auto& b) {
    return std::pair(a.first, a.second.secant) < std::pair(b.first, b.second.secant);
  });
  for (std::size_t i = 0; i < arms.size(); ++i) arms[i] = placed[i].second;
}

// Orders arms of one direction from right to left. As they do not cross, half the way along the
// shortest tells, if they are farther from each other there than the tolerance; else how they bend,
// which at the end of a fitted curve is told less well; and if they bend alike, or turn back at
// once, a point farther on.
void order_by_bend(std::span<Arm> arms, double tolerance) {
  const Vec2 along = direction_of(arms.front());
  double reach = reach_along(arms.front(), along);
  for (const Arm& arm : arms) reach = std::min(reach, reach_along(arm, along));
  for (Arm& arm : arms)
    if (reach > 0) arm.secant = offset_at(arm, along, 0.5 * reach) / reach;
  std::sort(arms.begin(), arms.end(), [reach, tolerance](const Arm& a, const Arm& b) {
    if (std::abs(a.secant - b.secant) * reach > tolerance) return a.secant < b.secant;
    const double size = std::max(std::abs(a.curvature), std::abs(b.curvature));
    const double apart = std::abs(a.curvature - b.curvature);
    if (apart > kSameDirection * size && (!(reach > 0) || apart * reach > kSameDirection))
      return a.curvature < b.curvature;
    return a.secant < b.secant;
  });
}

// Counter-clockwise round the vertex. The circle is opened in its widest gap, so that arms with
// the same direction stay together.
void order(std::vector<Arm>& arms, double tolerance) {
  const auto by_angle = [](const Arm& a, const Arm& b) { return a.angle < b.angle; };
  std::sort(arms.begin(), arms.end(), by_angle);
  std::size_t first = 0;
  double widest = arms.front().angle + 2 * std::numbers::pi - arms.back().angle;
  for (std::size_t i = 1; i < arms.size(); ++i)
    if (arms[i].angle - arms[i - 1].angle > widest) {
      widest = arms[i].angle - arms[i - 1].angle;
      first = i;
    }
  for (std::size_t i = 0; i < first; ++i) arms[i].angle += 2 * std::numbers::pi;
  std::sort(arms.begin(), arms.end(), by_angle);
  for (std::size_t low = 0, high = 0; low < arms.size(); low = high) {
    double touch = 0;  // where all of these arms are ordered, if any two touch
    for (high = low + 1; high < arms.size(); ++high) {
      const double length = touch_length(arms[high - 1], arms[high], tolerance);
      if (length == 0 && arms[high].angle - arms[high - 1].angle >= kSameDirection &&
          !change_sides_later(arms[high - 1], arms[high], tolerance))
        break;
      touch = std::max(touch, length);
    }
    const std::span<Arm> alike = std::span(arms).subspan(low, high - low);
    const Vec2 along = direction_of(alike.front());
    const bool all_reach = std::ranges::all_of(
        alike, [&](const Arm& arm) { return piece_at(arm, along, touch) != nullptr; });
    if (touch > 0 && all_reach)
      order_at(touch, alike);
    else if (!order_beside(alike, tolerance))
      order_by_bend(alike, tolerance);
  }
}

int vertex_count(std::span<const ChartArc> arcs) {
  int count = 0;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    if (arcs[i].path.empty() || std::min(arcs[i].from, arcs[i].to) < 0)
      throw InvalidInput("cycles: arc " + std::to_string(i) + " has no path or a negative vertex");
    count = std::max({count, arcs[i].from + 1, arcs[i].to + 1});
  }
  return count;
}

constexpr Walk kNone = static_cast<Walk>(-1);

// The half-edge that follows each half-edge: of all that leave its end, the one next clockwise
// from its twin.
std::vector<Walk> successors(std::span<const ChartArc> arcs, const std::vector<bool>& left_out,
                             double tolerance) {
  std::vector<std::vector<Arm>> stars(static_cast<std::size_t>(vertex_count(arcs)));
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    if (left_out[i]) continue;
    const Walk forward = walk_of(i, false), backward = walk_of(i, true);
    stars[static_cast<std::size_t>(arcs[i].from)].push_back(arm_of(arcs[i], forward));
    stars[static_cast<std::size_t>(arcs[i].to)].push_back(arm_of(arcs[i], backward));
  }
  std::vector<Walk> next(2 * arcs.size(), kNone);
  for (std::vector<Arm>& star : stars) {
    if (star.empty()) continue;
    order(star, tolerance);
    for (std::size_t k = 0; k < star.size(); ++k) {
      const std::size_t clockwise = (k + star.size() - 1) % star.size();
      next[twin(star[k].walk)] = star[clockwise].walk;
    }
  }
  return next;
}

// The number of each half-edge's cycle; kNone for half-edges left out.
struct Walked {
  std::vector<std::size_t> cycle_of;
  std::vector<Cycle> cycles;
};

Walked walked(const std::vector<Walk>& next) {
  Walked result{std::vector<std::size_t>(next.size(), kNone), {}};
  for (Walk start = 0; start < next.size(); ++start) {
    if (next[start] == kNone || result.cycle_of[start] != kNone) continue;
    Cycle cycle;
    for (Walk walk = start; result.cycle_of[walk] == kNone; walk = next[walk]) {
      result.cycle_of[walk] = result.cycles.size();
      cycle.push_back(half_edge(walk));
    }
    result.cycles.push_back(std::move(cycle));
  }
  return result;
}

Vec2 start_of(std::span<const ChartArc> arcs, const HalfEdge& edge) {
  const PlanarPath& path = arcs[static_cast<std::size_t>(edge.arc)].path;
  return edge.reversed ? end_of(path) : start_of(path);
}

Vec2 end_of(std::span<const ChartArc> arcs, const HalfEdge& edge) {
  return start_of(arcs, HalfEdge{edge.arc, !edge.reversed});
}

}  // namespace

Cycles cycles(std::span<const ChartArc> arcs, double tolerance) {
  std::vector<bool> left_out(arcs.size(), false);
  Cycles result;
  Walked all = walked(successors(arcs, left_out, tolerance));
  for (std::size_t i = 0; i < arcs.size(); ++i)
    if (!arcs[i].border && all.cycle_of[walk_of(i, false)] == all.cycle_of[walk_of(i, true)]) {
      left_out[i] = true;
      result.dangling.push_back(static_cast<int>(i));
    }
  if (!result.dangling.empty()) all = walked(successors(arcs, left_out, tolerance));
  result.cycles = std::move(all.cycles);
  return result;
}

double signed_area(std::span<const ChartArc> arcs, const Cycle& cycle) {
  const Vec2 origin = start_of(arcs, cycle.front());
  double sum = 0;
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const double along = area_along(arcs[static_cast<std::size_t>(cycle[i].arc)].path, origin);
    sum += cycle[i].reversed ? -along : along;
    const Vec2 from = end_of(arcs, cycle[i]);
    const Vec2 to = start_of(arcs, cycle[(i + 1) % cycle.size()]);
    sum += 0.5 * cross(from - origin, to - origin);
  }
  return sum;
}

bool encloses(std::span<const ChartArc> arcs, const Cycle& cycle, const Vec2& point) {
  int sum = 0;
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const int crossed = ray_crossings(arcs[static_cast<std::size_t>(cycle[i].arc)].path, point);
    sum += cycle[i].reversed ? -crossed : crossed;
    sum +=
        ray_crossings(end_of(arcs, cycle[i]), start_of(arcs, cycle[(i + 1) % cycle.size()]), point);
  }
  return sum != 0;
}

}  // namespace blossom
