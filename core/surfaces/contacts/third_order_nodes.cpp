// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/contacts/third_order_nodes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/forms/evaluation.h"
#include "core/surfaces/contacts/contact_reach.h"
#include "core/surfaces/contacts/limits.h"
#include "core/surfaces/gap/contact_points.h"

namespace blossom {
namespace {

constexpr int kSteps = 8;             // of Newton's method: of a cubic form the first one is exact
constexpr double kSettled = 1e-8;     // fraction of a patch; the next step is its square
constexpr double kDifference = 1e-4;  // step of a difference quotient, likewise
constexpr double kReach = 0.05;       // how far a foot may move, likewise
constexpr double kOutside = 0.2;      // how far a step may lead out of the patch, likewise
constexpr double kWidest = 0.2;       // of the size: wider discs are no points
constexpr double kDiscGap = 8;        // tolerances: what is below one may be read off up to here
constexpr double kBeside = 2;         // radii: curves that end so near have not been followed
constexpr int kDirections = 360;      // looked at in half a turn of the form
constexpr int kSpokes = 24;           // on which the gap is compared with it,
constexpr double kAlike = 0.5;        // of the form: it may differ by so much
constexpr int kHalvings = 8;          // of a disc in which it differs by more

// Second derivatives of the gap, by (u, v): uu, uv, vv.
using Hessian = std::array<double, 3>;

Vec3 normal_at(const RationalBezierPatch& b, const Point4& x) {
  const PatchJet q = jet_at(b, x[2], x[3], 1);
  return cross(q.u, q.v);
}

Hessian hessian_at(const RationalBezierPatch& a, const RationalBezierPatch& b, const Point4& x) {
  const Vec3 n = normal_at(b, x);
  const double uu = bend_between(a, b, x, {1, 0}), vv = bend_between(a, b, x, {0, 1});
  const double both = bend_between(a, b, x, {1, 1}), scale = 1 / norm(n);
  return {scale * uu, 0.5 * scale * (both - uu - vv), scale * vv};
}

// A binary form of degree three of directions in the tangent plane.
struct CubicForm {
  std::array<double, 4> c{};

  double operator()(double x, double y) const {
    return c[0] * x * x * x + c[1] * x * x * y + c[2] * x * y * y + c[3] * y * y * y;
  }
};

// Coordinates of unit length in the tangent plane of a patch, the first one along u: (1, 0) is
// (u1, 0) in parameters, (0, 1) is (u2, v2).
struct Frame {
  double u1, u2, v2;

  explicit Frame(const PatchJet& p) {
    const Vec3 e1 = unit(p.u), e2 = unit(cross(cross(p.u, p.v), p.u));
    u1 = 1 / norm(p.u);
    v2 = 1 / dot(p.v, e2);
    u2 = -u1 * dot(p.v, e1) * v2;
  }
  Vec2 parameters(double x, double y) const { return {x * u1 + y * u2, y * v2}; }
};

struct ThirdOrderNode {
  ContactPoint at;
  Vec3 point;         // relative to the origin
  double radius = 0;  // of the disc, model units
};

// The search for the node that a point of contact lies near.
class NodeSearch {
 public:
  NodeSearch(SurfaceCells& a, SurfaceCells& b, double size, double tolerance)
      : a_(a), b_(b), size_(size), tolerance_(tolerance) {}

  std::optional<ThirdOrderNode> near(const ContactPoint& start) const {
    const auto &patch_a = a_.tree(start.patch_a).patch(), &patch_b = b_.tree(start.patch_b).patch();
    std::optional<Point4> x = start.x;
    for (int step = 0; x && step < kSteps; ++step) {
      const auto slope = slopes(patch_a, patch_b, *x);
      if (!slope) return std::nullopt;
      const Hessian h = hessian_at(patch_a, patch_b, *x);
      const auto move = least_squares(*slope, h);
      if (!move) return std::nullopt;
      Point4 next = *x;
      for (std::size_t k : {std::size_t{0}, std::size_t{1}}) {
        next[k] -= (*move)[static_cast<int>(k)];
        if (!(next[k] >= -kOutside && next[k] <= 1 + kOutside)) return std::nullopt;
      }
      x = foot_point(patch_a, patch_b, next, 1);
      if (x && std::max(std::abs((*move)[0]), std::abs((*move)[1])) <= kSettled)
        return node_at({start.patch_a, start.patch_b, *x}, *slope);
    }
    return std::nullopt;
  }

 private:
  using Slopes = std::array<Hessian, 2>;  // of the second derivatives, by u and by v

  static std::optional<Slopes> slopes(const RationalBezierPatch& a, const RationalBezierPatch& b,
                                      const Point4& x) {
    Slopes result;
    for (std::size_t k : {std::size_t{0}, std::size_t{1}}) {
      Point4 before = x, after = x;
      before[k] -= kDifference;
      after[k] += kDifference;
      const auto p = foot_point(a, b, before, kReach), q = foot_point(a, b, after, kReach);
      if (!p || !q) return std::nullopt;
      const Hessian low = hessian_at(a, b, *p), high = hessian_at(a, b, *q);
      for (std::size_t i = 0; i < 3; ++i) result[k][i] = (high[i] - low[i]) / (2 * kDifference);
    }
    return result;
  }

  // The move (u, v) that comes nearest to changing the second derivatives by `h`.
  static std::optional<Vec2> least_squares(const Slopes& slope, const Hessian& h) {
    const auto product = [](const Hessian& p, const Hessian& q) {
      return p[0] * q[0] + 2 * p[1] * q[1] + p[2] * q[2];
    };
    const double uu = product(slope[0], slope[0]), uv = product(slope[0], slope[1]),
                 vv = product(slope[1], slope[1]);
    const double u = product(slope[0], h), v = product(slope[1], h);
    constexpr double kOneDirection = 1e-12;  // square of the sine between both: 1e-6 radians
    const double determinant = uu * vv - uv * uv;
    if (!(determinant > kOneDirection * uu * vv)) return std::nullopt;
    return Vec2{(u * vv - v * uv) / determinant, (v * uu - u * uv) / determinant};
  }

  // The node, if the gap within its disc is that of the cubic form alone but for a tolerance.
  std::optional<ThirdOrderNode> node_at(ContactPoint at, const Slopes& slope) const {
    const auto &patch_a = a_.tree(at.patch_a).patch(), &patch_b = b_.tree(at.patch_b).patch();
    if (std::ranges::any_of(at.x, [](double t) { return !(t >= 0 && t <= 1); }))
      return std::nullopt;
    at.gap = std::abs(signed_gap(patch_a, patch_b, at.x));
    if (!(at.gap <= kRoundingGap * tolerance_)) return std::nullopt;
    const PatchJet p = jet_at(patch_a, at.x[0], at.x[1], 1);
    const CubicForm form = form_of(p, slope);
    double radius = radius_of(form);
    if (!(radius <= kWidest * size_)) return std::nullopt;
    for (int halvings = 0; !follows(form, at, radius); radius *= 0.5)
      if (++halvings > kHalvings) return std::nullopt;
    const Vec3 n = unit(normal_at(patch_b, at.x));
    const double tilt = norm(cross(n, unit(cross(p.u, p.v))));
    const Hessian h = hessian_at(patch_a, patch_b, at.x);
    const double bend = std::max(std::abs(h[0]) / dot(p.u, p.u), std::abs(h[2]) / dot(p.v, p.v));
    if (!(tilt * radius <= tolerance_ && bend * radius * radius <= tolerance_)) return std::nullopt;
    return ThirdOrderNode{at, p.point, radius};
  }

  // In coordinates of unit length in the tangent plane.
  static CubicForm form_of(const PatchJet& p, const Slopes& slope) {
    const Frame frame(p);
    const double u1 = frame.u1, u2 = frame.u2, v2 = frame.v2;
    const double uuu = slope[0][0], uuv = slope[1][0], uvv = slope[0][2], vvv = slope[1][2];
    CubicForm form;
    form.c[0] = uuu * u1 * u1 * u1 / 6;
    form.c[1] = (uuu * u1 * u1 * u2 + uuv * u1 * u1 * v2) / 2;
    form.c[2] = (uuu * u1 * u2 * u2 + 2 * uuv * u1 * u2 * v2 + uvv * u1 * v2 * v2) / 2;
    form.c[3] = (uuu * u2 * u2 * u2 + 3 * uuv * u2 * u2 * v2 + 3 * uvv * u2 * v2 * v2 +
                 vvv * v2 * v2 * v2) /
                6;
    return form;
  }

  // True if the gap is like the form within the radius, as far as points in all directions tell.
  bool follows(const CubicForm& form, const ContactPoint& at, double radius) const {
    const auto &patch_a = a_.tree(at.patch_a).patch(), &patch_b = b_.tree(at.patch_b).patch();
    const Frame frame(jet_at(patch_a, at.x[0], at.x[1], 1));
    const double most = kDiscGap * tolerance_;
    for (int i = 0; i < kSpokes; ++i) {
      const double t = 2 * std::numbers::pi * i / kSpokes, x = std::cos(t), y = std::sin(t);
      for (const double part : {0.3, 0.6, 1.0}) {
        const double r = part * radius;
        const Vec2 move = frame.parameters(r * x, r * y);
        Point4 start = at.x;
        for (int k = 0; k < 2; ++k) start[static_cast<std::size_t>(k)] += move[k];
        if (!(std::min(start[0], start[1]) >= 0 && std::max(start[0], start[1]) <= 1)) continue;
        const auto foot = foot_point(patch_a, patch_b, start, 1);
        if (!foot) return false;
        const double gap = signed_gap(patch_a, patch_b, *foot), model = form(r * x, r * y);
        if (std::abs(gap - model) > most + kAlike * std::abs(model)) return false;
      }
    }
    return true;
  }

  // So far from the node do the valleys of the form that are no contact stay within tolerance.
  double radius_of(const CubicForm& form) const {
    const auto size_at = [&](int i) {
      const double t = i * std::numbers::pi / kDirections;
      return std::abs(form(std::cos(t), std::sin(t)));
    };
    double radius = 0;
    for (int i = 0; i < kDirections; ++i) {
      const double value = size_at(i);
      if (value < size_at(i - 1) || value < size_at(i + 1)) continue;
      const double here = std::cbrt(kDiscGap * tolerance_ / value);
      if (here <= kWidest * size_) radius = std::max(radius, here);
    }
    return radius > 0 ? radius : 1e300;
  }

  SurfaceCells& a_;
  SurfaceCells& b_;
  const double size_, tolerance_;
};

// What lies in the disc of one node.
class Disc {
 public:
  Disc(const ThirdOrderNode& node, SurfaceCells& a, SurfaceCells& b, double tolerance)
      : node_(node), a_(a), b_(b), tolerance_(tolerance) {
    gathered_.path = {node.at};
    gathered_.centre = node.at;
    gathered_.third_order = true;
    gathered_.box = {node.point, node.point};
  }

  void gather(std::vector<ContactChain>& chains, std::vector<CriticalCluster>& clusters,
              PairSearchResult& found) {
    std::vector<ContactChain> outside;
    for (ContactChain& chain : chains) {
      if (chain.curve)
        divide(chain, outside);
      else if (holds(chain.box))
        take(chain);
      else
        outside.push_back(std::move(chain));
    }
    chains = std::move(outside);
    std::erase_if(clusters, [&](const CriticalCluster& cluster) {
      if (!holds(cluster.box)) return false;
      gathered_.box = joined(gathered_.box, cluster.box);
      return true;
    });
    take_arcs(chains, found);
    gathered_.length = diagonal(gathered_.box);
    chains.push_back(gathered_);
  }

 private:
  Vec3 point(int patch_a, const Point4& x) const {
    return point_at(a_.tree(patch_a).patch(), x[0], x[1]);
  }

  bool holds(const Vec3& p) const { return distance(p, node_.point) <= node_.radius; }
  // What goes from the node to a border of the surfaces stays, if it is no valley beside it.
  bool holds(const ContactPoint& p) const {
    return holds(point(p.patch_a, p.x)) && !(p.gap <= kRoundingGap * tolerance_ && on_border(p));
  }
  bool holds(const Box& box) const {
    return distance(0.5 * (box.low + box.high), node_.point) + 0.5 * diagonal(box) <=
           2 * node_.radius;
  }

  void take(const ContactChain& chain) {
    gathered_.box = joined(gathered_.box, chain.box);
    for (const auto& side : chain.arms)
      gathered_.arms[0].insert(gathered_.arms[0].end(), side.begin(), side.end());
  }

  // The parts of a tangential curve outside of the disc begin at the node; the rest is taken.
  void divide(ContactChain& chain, std::vector<ContactChain>& outside) {
    auto& path = chain.path;
    const auto inside = [&](const ContactPoint& p) { return holds(p); };
    if (chain.closed && std::ranges::any_of(path, inside)) {
      path.pop_back();
      std::ranges::rotate(path, std::ranges::find_if(path, inside));
      path.push_back(path.front());
      chain.closed = false;
    }
    ContactChain rest;
    for (const ContactPoint& p : path)
      if (inside(p)) widen(rest, p);
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}})
      if (!chain.closed && leads_here(chain, side)) std::swap(rest.arms[side], chain.arms[side]);
    take(rest);
    for (auto from = path.begin(); from != path.end();) {
      from = std::find_if_not(from, path.end(), inside);
      const auto to = std::find_if(from, path.end(), inside);
      if (from == to) break;
      const std::array cut{from != path.begin() || (!chain.closed && leads_here(chain, 0)),
                           to != path.end() || (!chain.closed && leads_here(chain, 1))};
      add_part(chain, {from, to}, cut, outside);
      from = to;
    }
  }

  // True if a curve ends in the disc, or beside it without a reason.
  bool leads_here(const ContactChain& curve, std::size_t side) const {
    const ContactPoint& end = side == 0 ? curve.path.front() : curve.path.back();
    const double d = distance(point(end.patch_a, end.x), node_.point);
    return holds(end) || (!on_border(end) && d <= kBeside * node_.radius &&
                          in_contact(a_, b_, end, node_.at, tolerance_));
  }

  // True for a point on a border of one of the surfaces.
  bool on_border(const ContactPoint& p) const {
    const BezierSurface &a = a_.surface(), &b = b_.surface();
    const std::array spans{a_.span_u(p.patch_a), a_.span_v(p.patch_a), b_.span_u(p.patch_b),
                           b_.span_v(p.patch_b)};
    const std::array counts{a.patches.rows(), a.patches.columns(), b.patches.rows(),
                            b.patches.columns()};
    const std::array closed{a.closed_u, a.closed_v, b.closed_u, b.closed_v};
    for (std::size_t k = 0; k < 4; ++k)
      if (!closed[k] && ((spans[k] == 0 && p.x[k] <= kOnBorder) ||
                         (spans[k] + 1 == counts[k] && p.x[k] >= 1 - kOnBorder)))
        return true;
    return false;
  }

  // cut   by end: it is at the disc
  void add_part(const ContactChain& chain, std::vector<ContactPoint> path,
                const std::array<bool, 2>& cut, std::vector<ContactChain>& outside) {
    ContactChain part = chain;
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
      if (!cut[side]) continue;
      part.arms[side].clear();
      part.leaves[side] = false;
      ContactPoint node = node_.at;
      const ContactPoint& next = side == 0 ? path.front() : path.back();
      if (next.patch_a != node.patch_a || next.patch_b != node.patch_b) continue;
      node.crosses = next.crosses;
      path.insert(side == 0 ? path.begin() : path.end(), node);
    }
    part.path = std::move(path);
    part.box = {};
    part.length = 0;
    for (std::size_t i = 0; i < part.path.size(); ++i) {
      widen(part, part.path[i]);
      if (i > 0) part.length += step(part.path[i - 1], part.path[i]);
    }
    const auto is_dead = [&](std::size_t side) {
      const ContactPoint& end = side == 0 ? part.path.front() : part.path.back();
      return cut[side] || (!on_border(end) && part.arms[side].empty());
    };
    const bool scrap = !part.closed && (cut[0] || cut[1]) && is_dead(0) && is_dead(1) &&
                       part.length <= kBeside * node_.radius;
    if (part.path.size() < 2 || scrap)
      take(part);
    else
      outside.push_back(std::move(part));
  }

  void widen(ContactChain& chain, const ContactPoint& p) const {
    const Vec3 x = point(p.patch_a, p.x);
    chain.box = joined(chain.box, {x, x});
  }

  double step(const ContactPoint& p, const ContactPoint& q) const {
    return distance(point(p.patch_a, p.x), point(q.patch_a, q.x));
  }

  // Arcs within the disc are dropped, those that come into it become the node's arms.
  void take_arcs(std::vector<ContactChain>& chains, PairSearchResult& found) {
    std::vector<ArcEnd> arms;
    for (std::size_t i = 0; i < found.arcs.size(); ++i) {
      FoundArc& arc = found.arcs[i];
      if (arc.dropped) continue;
      const Vec3 p = point(arc.patch_a, arc.arc.from), q = point(arc.patch_a, arc.arc.to);
      const bool from = holds({arc.patch_a, arc.patch_b, arc.arc.from}),
                 to = holds({arc.patch_a, arc.patch_b, arc.arc.to});
      if (from) gathered_.box = joined(gathered_.box, {p, p});
      if (to) gathered_.box = joined(gathered_.box, {q, q});
      arc.dropped = from && to;
      if (from != to) arms.push_back(from ? 2 * i : 2 * i + 1);
    }
    const auto is_taken = [&](ArcEnd end) {
      return found.arcs[end / 2].dropped || std::ranges::find(arms, end) != arms.end();
    };
    for (ContactChain& chain : chains)
      for (auto& side : chain.arms) std::erase_if(side, is_taken);
    std::erase_if(gathered_.arms[0], is_taken);
    gathered_.arms[0].insert(gathered_.arms[0].end(), arms.begin(), arms.end());
  }

  const ThirdOrderNode& node_;
  SurfaceCells& a_;
  SurfaceCells& b_;
  const double tolerance_;
  ContactChain gathered_;
};

}  // namespace

void gather_at_third_order_nodes(std::vector<ContactChain>& chains,
                                 std::vector<CriticalCluster>& clusters, PairSearchResult& found,
                                 SurfaceCells& a, SurfaceCells& b, double size, double tolerance) {
  const NodeSearch search(a, b, size, tolerance);
  std::vector<ThirdOrderNode> nodes;
  const auto look_near = [&](const ContactPoint& start) {
    const auto node = search.near(start);
    if (!node) return;
    const auto is_same = [&](const ThirdOrderNode& other) {
      return distance(other.point, node->point) <= std::max(other.radius, node->radius);
    };
    if (std::ranges::none_of(nodes, is_same)) nodes.push_back(*node);
  };
  for (const ContactChain& chain : chains) {
    look_near(chain.path[chain.path.size() / 2]);
    if (!chain.curve) continue;
    look_near(chain.path.front());
    look_near(chain.path.back());
  }
  for (const CriticalCluster& cluster : clusters) {
    const CriticalPair& pair = found.critical[static_cast<std::size_t>(cluster.pairs.front())];
    ContactPoint middle{pair.patch_a, pair.patch_b, {}};
    for (std::size_t k = 0; k < 4; ++k) middle.x[k] = at(pair.box[k], 0.5);
    look_near(middle);
  }
  for (const ThirdOrderNode& node : nodes)
    Disc(node, a, b, tolerance).gather(chains, clusters, found);
}

}  // namespace blossom
