// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/contacts/contact_reach.h"

#include <algorithm>
#include <cmath>

#include "core/base/not_zero.h"
#include "core/base/unbounded.h"
#include "core/forms/evaluation.h"
#include "core/surfaces/contacts/limits.h"
#include "core/surfaces/gap/contact_points.h"

namespace blossom {
namespace {

// A contact is as wide as the tolerance, and a meridian's parameter turns by less than this many
// radians over a patch: a patch that moves no farther over its width is at a pole.
constexpr double kPoleWidth = 16;

// A border of a patch is one point if its derivative is no more than this part of the tolerance.
constexpr double kPoleRow = 1e-3;
constexpr double kWayReach = 0.5;  // of a patch: how far a foot may lie from where it is sought
constexpr std::size_t kMaxPatches = 16;      // between the border of a region and its middle
constexpr int kMaxHalvings = 3;              // of the way from there, see `reach_node`
constexpr std::array kAlong{0.0, 0.5, 1.0};  // where its derivative is looked at

// The point nearest to x, in space, on the lines along which the surfaces touch and cross.
std::optional<ContactPoint> nearest_on_lines(const PairSearchResult& found, SurfaceCells& a,
                                             const Vec3& x) {
  std::optional<ContactPoint> nearest;
  double least = kUnbounded;
  for (const FoundContact& line : found.contacts) {
    if (!line.contact.crosses) continue;
    const auto& patch = a.tree(line.patch_a).patch();
    const auto& path = line.contact.path;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      const Vec3 from = jet_at(patch, path[i][0], path[i][1], 1).point;
      const Vec3 step = jet_at(patch, path[i + 1][0], path[i + 1][1], 1).point - from;
      const double t =
          std::clamp(dot(x - from, step) / std::max(dot(step, step), kNotZero), 0.0, 1.0);
      const double gap = distance(x, from + step * t);
      if (gap >= least) continue;
      least = gap;
      ContactPoint p{line.patch_a, line.patch_b, {}, line.contact.gaps[i], true};
      for (std::size_t k = 0; k < 4; ++k) p.x[k] = (1 - t) * path[i][k] + t * path[i + 1][k];
      nearest = p;
    }
  }
  return nearest;
}

// True if the border of a patch on which one parameter is 0 or 1 is a single point.
bool is_point(const RationalBezierPatch& patch, bool free_u, double border, double tolerance) {
  return std::all_of(std::begin(kAlong), std::end(kAlong), [&](double t) {
    const PatchJet jet = free_u ? jet_at(patch, t, border, 1) : jet_at(patch, border, t, 1);
    return norm(free_u ? jet.u : jet.v) <= kPoleRow * tolerance;
  });
}

// The free parameters of a patch near a point, which is moved to the pole if that is a border.
std::array<bool, 2> move_to_pole(const RationalBezierPatch& patch, double& u, double& v,
                                 double reach, double tolerance) {
  const PatchJet here = jet_at(patch, u, v, 1);
  for (const bool free_u : {true, false}) {
    double& across = free_u ? v : u;
    const double border = across < 0.5 ? 0 : 1;
    const Vec3 pole = free_u ? point_at(patch, u, border) : point_at(patch, border, v);
    if (distance(pole, here.point) > reach || !is_point(patch, free_u, border, tolerance)) continue;
    across = border;
    return {free_u, !free_u};
  }
  const double most = kPoleWidth * tolerance;
  return {norm(here.u) <= most && norm(here.v) > most, norm(here.v) <= most && norm(here.u) > most};
}

// Gives a piece to the patch of one surface above the border along which it runs; its parameters
// there begin at `first`.
void move_above(CellContact& piece, const SurfaceCells& cells, int& patch, std::size_t first) {
  const BezierSurface& s = cells.surface();
  const int rows = s.patches.rows(), columns = s.patches.columns();
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    const bool along = std::ranges::all_of(
        piece.path, [&](const Point4& x) { return std::abs(x[first + k] - 1) <= kOnBorder; });
    const int span = k == 0 ? cells.span_u(patch) : cells.span_v(patch);
    const int count = k == 0 ? rows : columns;
    if (!along || (span + 1 == count && !(k == 0 ? s.closed_u : s.closed_v))) continue;
    const int step = (span + 1) % count - span;
    patch += k == 0 ? step * columns : step;
    for (Point4& x : piece.path) x[first + k] -= 1;
  }
}

std::array<int, 4> spans_of(const SurfaceCells& a, const SurfaceCells& b, int patch_a,
                            int patch_b) {
  return {a.span_u(patch_a), a.span_v(patch_a), b.span_u(patch_b), b.span_v(patch_b)};
}

// By parameter: spans in a turn of a closed surface, 0 if it is open.
std::array<int, 4> periods_of(const SurfaceCells& a, const SurfaceCells& b) {
  const BezierSurface &sa = a.surface(), &sb = b.surface();
  return {sa.closed_u ? sa.patches.rows() : 0, sa.closed_v ? sa.patches.columns() : 0,
          sb.closed_u ? sb.patches.rows() : 0, sb.closed_v ? sb.patches.columns() : 0};
}

// A parameter of one span in units of another one: of its width too if they are neighbours, since
// the surface goes on there by the knots. Of two spans in a turn that are not alike it is not known
// over which of their borders the way goes: they keep their own units.
double in_span_of(const std::vector<double>& knots, int from, int to, int period, double x) {
  if (std::abs(from - to) != 1 || period == 2) return x + from - to;
  const auto width = [&](int span) {
    const auto i = static_cast<std::size_t>(span);
    return knots[i + 1] - knots[i];
  };
  const double scale = width(from) / width(to);
  return from > to ? 1 + scale * x : scale * (x - 1);
}

// A parameter of a span if it lies in it, perhaps a period away.
std::optional<double> in_span(double t, int period) {
  for (const int shift : {0, period, -period})
    if (t + shift >= -kOnBorder && t + shift <= 1 + kOnBorder)
      return std::clamp(t + shift, 0.0, 1.0);
  return std::nullopt;
}

// Where the way from a point beside the patches to one in them comes into them; nothing if the
// point is in them already.
std::optional<Point4> entry_of(const Point4& from, const Point4& to) {
  double t = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const double out = from[k] < -kOnBorder ? -from[k] : from[k] > 1 + kOnBorder ? from[k] - 1 : 0;
    if (out > 0) t = std::max(t, out / std::max(std::abs(to[k] - from[k]), out));
  }
  if (t == 0) return std::nullopt;
  Point4 x;
  for (std::size_t k = 0; k < 4; ++k) x[k] = std::clamp((1 - t) * from[k] + t * to[k], 0.0, 1.0);
  return x;
}

double apart(const Point4& p, const Point4& q) {
  double most = 0;
  for (std::size_t k = 0; k < 4; ++k) most = std::max(most, std::abs(p[k] - q[k]));
  return most;
}

// The point, if it is in the patches whose parameters it has.
std::optional<Point4> within_patch(Point4 x) {
  for (double& t : x) {
    if (!(t >= -kOnBorder && t <= 1 + kOnBorder)) return std::nullopt;
    t = std::clamp(t, 0.0, 1.0);
  }
  return x;
}

}  // namespace

Point4 in_patches(const SurfaceCells& a, const SurfaceCells& b, int from_a, int from_b,
                  const Point4& x, const ContactPoint& to) {
  const auto periods = periods_of(a, b);
  const BezierSurface &sa = a.surface(), &sb = b.surface();
  return {in_span_of(sa.u_knots, a.span_u(from_a), a.span_u(to.patch_a), periods[0], x[0]),
          in_span_of(sa.v_knots, a.span_v(from_a), a.span_v(to.patch_a), periods[1], x[1]),
          in_span_of(sb.u_knots, b.span_u(from_b), b.span_u(to.patch_b), periods[2], x[2]),
          in_span_of(sb.v_knots, b.span_v(from_b), b.span_v(to.patch_b), periods[3], x[3])};
}

void move_above_borders(PairSearchResult& found, const SurfaceCells& a, const SurfaceCells& b) {
  for (FoundContact& piece : found.contacts) {
    move_above(piece.contact, a, piece.patch_a, 0);
    move_above(piece.contact, b, piece.patch_b, 2);
  }
}

bool jumps(const Point4& p, const Point4& q, const SurfaceCells& a, const SurfaceCells& b) {
  const auto &grid_a = a.surface().patches, &grid_b = b.surface().patches;
  const std::array spans{grid_a.rows(), grid_a.columns(), grid_b.rows(), grid_b.columns()};
  for (std::size_t k = 0; k < 4; ++k)
    if (std::abs(p[k] - q[k]) > 0.5 * spans[k]) return true;
  return false;
}

bool in_contact(SurfaceCells& a, SurfaceCells& b, const ContactPoint& p, const ContactPoint& q,
                double tolerance) {
  Point4 end = in_patches(a, b, q.patch_a, q.patch_b, q.x, p);
  const auto periods = periods_of(a, b);
  for (std::size_t k = 0; k < 4; ++k)  // the shorter way, across a seam perhaps
    if (periods[k] > 0) end[k] = p.x[k] + std::remainder(end[k] - p.x[k], periods[k]);
  const auto &patch_a = a.tree(p.patch_a).patch(), &patch_b = b.tree(p.patch_b).patch();
  for (const double t : {0.25, 0.5, 0.75}) {
    Point4 x;
    for (std::size_t k = 0; k < 4; ++k) x[k] = (1 - t) * p.x[k] + t * end[k];
    const auto foot = foot_point(patch_a, patch_b, x, kPolishReach);
    if (!foot || std::abs(signed_gap(patch_a, patch_b, *foot)) > kAttachGap * tolerance)
      return false;
  }
  return true;
}

bool runs_in_contact(SurfaceCells& a, SurfaceCells& b, const FoundArc& arc, double tolerance) {
  const ContactPoint from{arc.patch_a, arc.patch_b, arc.arc.from};
  const ContactPoint to{arc.patch_a, arc.patch_b, arc.arc.to};
  return arc.arc.tangential && in_contact(a, b, from, to, tolerance);
}

ContactArm arm_of(const PairSearchResult& found, const SurfaceCells& a, const SurfaceCells& b,
                  ArcEnd end, const ContactPoint& contact) {
  const FoundArc& arc = found.arcs[end / 2];
  const auto here = [&](const Point4& x) {
    return in_patches(a, b, arc.patch_a, arc.patch_b, x, contact);
  };
  return end % 2 == 0 ? ContactArm{here(arc.arc.to), here(arc.arc.from)}
                      : ContactArm{here(arc.arc.from), here(arc.arc.to)};
}

ArcEnd reach_contact(PairSearchResult& found, const SurfaceCells& a, const SurfaceCells& b,
                     ArcEnd end, const ContactPoint& to) {
  FoundArc& arc = found.arcs[end / 2];
  Point4& x = end % 2 == 0 ? arc.arc.from : arc.arc.to;
  if (arc.patch_a == to.patch_a && arc.patch_b == to.patch_b) {
    x = to.x;
    for (std::size_t k = 0; k < 4; ++k) arc.arc.direction[k] = arc.arc.to[k] - arc.arc.from[k];
    return end;
  }
  Point4 start = in_patches(a, b, arc.patch_a, arc.patch_b, x, to);
  const auto entry = entry_of(start, to.x);
  if (entry && apart(*entry, to.x) > kOnBorder) {
    const auto here = within_patch(
        in_patches(a, b, to.patch_a, to.patch_b, *entry, {arc.patch_a, arc.patch_b, {}}));
    if (!here) return end;
    x = *here;
    for (std::size_t k = 0; k < 4; ++k) arc.arc.direction[k] = arc.arc.to[k] - arc.arc.from[k];
    start = *entry;
  } else if (entry || apart(start, to.x) <= kOnBorder) {
    return end;  // the contact is a point of the border, where the end is
  }
  FoundArc link{to.patch_a, to.patch_b, kNoBox, {start, to.x}, {-1, -1}};
  for (std::size_t k = 0; k < 4; ++k) link.arc.direction[k] = to.x[k] - start[k];
  found.joins.push_back({end, 2 * found.arcs.size()});
  found.arcs.push_back(link);
  return 2 * found.arcs.size() - 1;
}

namespace {

// The patches beyond the border through which a straight way leaves the present ones, with the
// point of that border; the goal if it is in the present ones.
struct StraightStep {
  Point4 x;                          // in the present patches
  std::optional<ContactPoint> next;  // the same in the next ones, nothing at the goal
};

std::optional<StraightStep> step_towards(const SurfaceCells& a, const SurfaceCells& b,
                                         const ContactPoint& from, const ContactPoint& to) {
  const Point4 goal = in_patches(a, b, to.patch_a, to.patch_b, to.x, from);
  double t = 1;
  std::size_t axis = 4;
  for (std::size_t k = 0; k < 4; ++k) {
    const double border = goal[k] > 1 + kOnBorder ? 1 : goal[k] < -kOnBorder ? 0 : goal[k];
    const double at = border == goal[k] ? 1 : (border - from.x[k]) / (goal[k] - from.x[k]);
    if (at < t) {
      t = std::max(at, 0.0);
      axis = k;
    }
  }
  StraightStep step;
  for (std::size_t k = 0; k < 4; ++k)
    step.x[k] = std::clamp((1 - t) * from.x[k] + t * goal[k], 0.0, 1.0);
  if (axis == 4) return step;
  auto spans = spans_of(a, b, from.patch_a, from.patch_b);
  const auto period = periods_of(a, b);
  const int count[]{a.surface().patches.rows(), a.surface().patches.columns(),
                    b.surface().patches.rows(), b.surface().patches.columns()};
  spans[axis] += goal[axis] > 1 ? 1 : -1;
  if (period[axis] > 0) spans[axis] = (spans[axis] + period[axis]) % period[axis];
  if (spans[axis] < 0 || spans[axis] >= count[axis]) return std::nullopt;
  step.next = ContactPoint{spans[0] * count[1] + spans[1], spans[2] * count[3] + spans[3], step.x};
  step.next->x[axis] = goal[axis] > 1 ? 0 : 1;
  return step;
}

FoundArc arc_between(const ContactPoint& from, const Point4& to) {
  FoundArc arc{from.patch_a, from.patch_b, kNoBox, {from.x, to}, {-1, -1}};
  for (std::size_t k = 0; k < 4; ++k) arc.arc.direction[k] = to[k] - from.x[k];
  return arc;
}

// True if the surfaces meet, but for rounding, on the straight way in their patches.
bool meet_along(SurfaceCells& a, SurfaceCells& b, const FoundArc& way, double tolerance) {
  const auto &patch_a = a.tree(way.patch_a).patch(), &patch_b = b.tree(way.patch_b).patch();
  for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    Point4 x;
    for (std::size_t k = 0; k < 4; ++k) x[k] = (1 - t) * way.arc.from[k] + t * way.arc.to[k];
    const auto foot = foot_point(patch_a, patch_b, x, kWayReach);
    if (!foot || std::abs(signed_gap(patch_a, patch_b, *foot)) > kRoundingGap * tolerance)
      return false;
  }
  return true;
}

// Adds the straight arcs that lead to the goal; false, and nothing is added, if the surfaces leave
// each other on the way.
bool lead_straight(std::vector<FoundArc>& ways, SurfaceCells& a, SurfaceCells& b,
                   const ContactPoint& from, const ContactPoint& to, double tolerance) {
  std::vector<FoundArc> straight;
  for (std::optional<ContactPoint> at = from; at;) {
    const auto step = step_towards(a, b, *at, to);
    if (!step || straight.size() == kMaxPatches) return false;
    FoundArc way = arc_between(*at, step->x);
    way.arc.straight = true;
    if (!meet_along(a, b, way, tolerance)) return false;
    if (apart(at->x, step->x) > kOnBorder) straight.push_back(way);
    at = step->next;
  }
  ways.insert(ways.end(), straight.begin(), straight.end());
  return true;
}

// The arc along which the surfaces cross half the way to the goal, if it is in the same patches.
std::optional<FoundArc> half_way(SurfaceCells& a, SurfaceCells& b, const ContactPoint& from,
                                 const ContactPoint& to) {
  const Point4 goal = in_patches(a, b, to.patch_a, to.patch_b, to.x, from);
  FoundArc way = arc_between(from, goal);
  for (std::size_t k = 0; k < 4; ++k) way.arc.to[k] = 0.5 * (from.x[k] + goal[k]);
  const auto middle = curve_point(a.tree(from.patch_a).patch(), b.tree(from.patch_b).patch(),
                                  way.arc.to, way.arc.direction, 0.5 * apart(from.x, goal));
  const auto inside = middle ? within_patch(*middle) : std::nullopt;
  if (!inside) return std::nullopt;
  way.arc.to = *inside;
  return way;
}

}  // namespace

ArcEnd reach_node(PairSearchResult& found, SurfaceCells& a, SurfaceCells& b, ArcEnd end,
                  const ContactPoint& to, double tolerance) {
  const FoundArc& arm = found.arcs[end / 2];
  ContactPoint from{arm.patch_a, arm.patch_b, end_of(found, end)};
  std::vector<FoundArc> ways;
  for (int halvings = 0; !lead_straight(ways, a, b, from, to, tolerance); ++halvings) {
    if (halvings == kMaxHalvings || arm.arc.tangential) return end;
    const auto way = half_way(a, b, from, to);
    if (!way) return end;
    ways.push_back(*way);
    from.x = way->arc.to;
  }
  for (const FoundArc& way : ways) {
    found.joins.push_back({end, 2 * found.arcs.size()});
    found.arcs.push_back(way);
    end = 2 * found.arcs.size() - 1;
  }
  return end;
}

std::optional<Pole> pole_near(SurfaceCells& a, SurfaceCells& b, const ContactPoint& contact,
                              double length, double tolerance) {
  const double reach = length + kAttachGap * tolerance;
  const auto &patch_a = a.tree(contact.patch_a).patch(), &patch_b = b.tree(contact.patch_b).patch();
  Pole pole{contact, {}};
  Point4& x = pole.point.x;
  const auto free_a = move_to_pole(patch_a, x[0], x[1], reach, tolerance);
  const auto free_b = move_to_pole(patch_b, x[2], x[3], reach, tolerance);
  pole.free = {free_a[0], free_a[1], free_b[0], free_b[1]};
  const bool at_a = free_a[0] || free_a[1], at_b = free_b[0] || free_b[1];
  if (!at_a && !at_b) return std::nullopt;
  if (!at_b) x = foot_point(patch_a, patch_b, x, kPolishReach).value_or(x);
  if (!at_a) {
    const auto foot = foot_point(patch_b, patch_a, {x[2], x[3], x[0], x[1]}, kPolishReach);
    if (foot) x = {(*foot)[2], (*foot)[3], x[2], x[3]};
  }
  pole.point.gap = distance(point_at(patch_a, x[0], x[1]), point_at(patch_b, x[2], x[3]));
  return pole;
}

ContactPoint in_patches_of(const PairSearchResult& found, ArcEnd end, const Pole& pole,
                           const SurfaceCells& a, const SurfaceCells& b) {
  const FoundArc& arc = found.arcs[end / 2];
  const Point4& x = end_of(found, end);
  ContactPoint goal = pole.point;
  auto spans = spans_of(a, b, goal.patch_a, goal.patch_b);
  const auto own = spans_of(a, b, arc.patch_a, arc.patch_b);
  const auto period = periods_of(a, b);
  for (std::size_t k = 0; k < 4; ++k) {
    const auto same =
        pole.free[k] ? std::optional(x[k]) : in_span(goal.x[k] + spans[k] - own[k], period[k]);
    if (!same) continue;
    goal.x[k] = *same;
    spans[k] = own[k];
  }
  goal.patch_a = spans[0] * a.surface().patches.columns() + spans[1];
  goal.patch_b = spans[2] * b.surface().patches.columns() + spans[3];
  return goal;
}

void drop_beside_contacts(PairSearchResult& found, SurfaceCells& a, SurfaceCells& b,
                          double tolerance) {
  std::erase_if(found.critical, [&](const CriticalPair& pair) {
    if (!pair.beside) return false;
    const ContactPoint start{pair.patch_a, pair.patch_b, *pair.beside};
    const Vec3 x = jet_at(a.tree(pair.patch_a).patch(), start.x[0], start.x[1], 1).point;
    const auto goal = nearest_on_lines(found, a, x);
    return goal && in_contact(a, b, start, *goal, tolerance);
  });
}

}  // namespace blossom
