// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/contacts/high_order_nodes.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/not_zero.h"
#include "core/forms/evaluation.h"
#include "core/surfaces/contacts/contact_reach.h"
#include "core/surfaces/contacts/limits.h"
#include "core/surfaces/gap/contact_points.h"
#include "core/surfaces/gap/gap_model.h"
#include "core/surfaces/gap/node_form.h"

namespace blossom {
namespace {

constexpr double kWidest = 0.2;        // of the size: wider discs are no points,
constexpr double kNarrowest = 1e-4;    // and narrower ones nodes that need no disc
constexpr double kNextReach = 0.7;     // of a reach that is too wide for the expansion
constexpr double kPartReserve = 1.5;   // of the box on b over the corners of that on a
constexpr int kMoves = 8;              // of the point round which the gap is expanded; each settles
constexpr double kSettled = 1e-7;      // several digits. Of the reach
constexpr double kBesideNode = 0.02;   // radii: so far from it lower terms stay within a tolerance
constexpr double kBeside = 2;          // radii: curves that end so near have not been followed
constexpr std::size_t kArcSteps = 16;  // of an arc, between which its distance has one minimum
constexpr int kCutHalvings = 8;        // of a step: where beside the border an arm begins is free
constexpr double kArcReach = 2;        // of an arc's largest step: so far it leads from its chord

// Coordinates of unit length in the tangent plane of a patch, the first one along u: (1, 0) is
// (u1, 0) in parameters, (0, 1) is (u2, v2).
struct TangentFrame {
  double u1, u2, v2;

  explicit TangentFrame(const PatchJet& p) {
    const Vec3 e1 = unit(p.u), e2 = unit(cross(cross(p.u, p.v), p.u));
    u1 = 1 / norm(p.u);
    v2 = 1 / dot(p.v, e2);
    u2 = -u1 * dot(p.v, e1) * v2;
  }
  // False at a pole.
  bool is_regular() const { return std::isfinite(u1) && std::isfinite(u2) && std::isfinite(v2); }
  Vec2 parameters(const Vec2& x) const { return {x[0] * u1 + x[1] * u2, x[1] * v2}; }

  // The box of parameters round (u, v) that holds all within a distance.
  std::array<Interval, 2> box(double u, double v, double distance) const {
    const double hu = distance * std::hypot(u1, u2), hv = distance * std::abs(v2);
    return {Interval{u - hu, u + hu}, Interval{v - hv, v + hv}};
  }
};

struct HighOrderNode {
  ContactPoint at;
  Vec3 point;         // relative to the origin
  double radius = 0;  // of the disc, model units
};

// The search for the node that a point of contact lies near.
class NodeSearch {
 public:
  NodeSearch(SurfaceCells& a, SurfaceCells& b, double size, double tolerance)
      : a_(a), b_(b), size_(size), tolerance_(tolerance) {}

  // The gap is expanded anew round the node until its disc lies where the expansion holds.
  std::optional<HighOrderNode> near(const ContactPoint& start) const {
    const auto &patch_a = a_.tree(start.patch_a).patch(), &patch_b = b_.tree(start.patch_b).patch();
    ContactPoint at = start;
    double reach = kWidest * size_;
    for (int move = 0; move < kMoves; ++move) {
      const auto gap = gap_round(at, reach);
      if (!gap) return std::nullopt;
      reach = std::min(gap->reach / kNextReach, reach);
      const auto node = node_form(gap->terms, gap->rest, gap->reach, tolerance_, kWidest * size_);
      if (!node) return std::nullopt;
      const Vec2 by = gap->frame.parameters(node->at);
      const auto foot =
          foot_point(patch_a, patch_b, {at.x[0] + by[0], at.x[1] + by[1], at.x[2], at.x[3]}, 1);
      if (!foot) return std::nullopt;
      at.x = *foot;
      if (norm(node->at) <= kSettled * gap->reach) return node_at(at, node->radius);
    }
    return std::nullopt;
  }

 private:
  struct LocalGap {
    TaylorPolynomial terms;  // in the frame's coordinates
    TangentFrame frame;
    double rest, reach;  // model units
  };

  std::optional<LocalGap> gap_round(const ContactPoint& at, double most) const {
    const CellTree &tree_a = a_.tree(at.patch_a), &tree_b = b_.tree(at.patch_b);
    const PatchJet p = jet_at(tree_a.patch(), at.x[0], at.x[1], 1);
    const TangentFrame frame(p), frame_b(jet_at(tree_b.patch(), at.x[2], at.x[3], 1));
    if (!frame.is_regular() || !frame_b.is_regular()) return std::nullopt;
    for (double reach = most; reach >= kNarrowest * size_; reach *= kNextReach) {
      const auto part = frame.box(at.x[0], at.x[1], reach);
      const double corner = 0.5 * (norm(p.u) * length(part[0]) + norm(p.v) * length(part[1]));
      const auto part_b = frame_b.box(at.x[2], at.x[3], kPartReserve * corner);
      const auto chart = graph_chart(tree_b, part_b[0], part_b[1], 0);
      if (!chart) continue;
      const auto model = gap_model(tree_a, tree_a.piece(part[0], part[1])[0], tree_b, *chart);
      if (!model || !(model->gap_error[0] < kDiscGap * tolerance_)) continue;
      const double u = 2 / length(part[0]), v = 2 / length(part[1]);
      return LocalGap{turned(model->gap, {frame.u1 * u, 0}, {frame.u2 * u, frame.v2 * v}), frame,
                      model->gap_error[0], reach};
    }
    return std::nullopt;
  }

  // The node in its patches: where each patch is a piece of a spline of low degree they agree about
  // its place no better than about the terms of its order.
  std::optional<HighOrderNode> node_at(ContactPoint at, double radius) const {
    const auto &patch_a = a_.tree(at.patch_a).patch(), &patch_b = b_.tree(at.patch_b).patch();
    const Vec3 found = point_at(patch_a, at.x[0], at.x[1]);
    at.x = moved_into(patch_a, patch_b, at.x, kPolishReach);
    at.gap = std::abs(signed_gap(patch_a, patch_b, at.x));
    const Vec3 point = point_at(patch_a, at.x[0], at.x[1]);
    if (distance(point, found) > kBesideNode * radius) return std::nullopt;
    return HighOrderNode{at, point, radius};
  }

  SurfaceCells& a_;
  SurfaceCells& b_;
  const double size_, tolerance_;
};

// What lies in the disc of one node.
class Disc {
 public:
  Disc(const HighOrderNode& node, SurfaceCells& a, SurfaceCells& b, double tolerance)
      : node_(node), a_(a), b_(b), tolerance_(tolerance) {
    gathered_.path = {node.at};
    gathered_.centre = node.at;
    gathered_.high_order = true;
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
    const bool spurious = !part.closed && (cut[0] || cut[1]) && is_dead(0) && is_dead(1) &&
                          part.length <= kBeside * node_.radius;
    if (part.path.size() < 2 || spurious)
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

  // Arcs within the disc are dropped; those that come into it or pass through it are cut at its
  // border, where the node's arms begin.
  void take_arcs(std::vector<ContactChain>& chains, PairSearchResult& found) {
    std::vector<ArcEnd> arms;
    for (std::size_t i = 0, count = found.arcs.size(); i < count; ++i)
      if (!found.arcs[i].dropped) take_arc(i, found, arms);
    const auto is_taken = [&](ArcEnd end) {
      return found.arcs[end / 2].dropped || std::ranges::find(arms, end) != arms.end();
    };
    for (ContactChain& chain : chains)
      for (auto& side : chain.arms) std::erase_if(side, is_taken);
    std::erase_if(gathered_.arms[0], is_taken);
    gathered_.arms[0].insert(gathered_.arms[0].end(), arms.begin(), arms.end());
  }

  void take_arc(std::size_t index, PairSearchResult& found, std::vector<ArcEnd>& arms) {
    const FoundArc arc = found.arcs[index];
    if (!comes_near(arc)) return;
    const auto ends = [&](const Point4& x) { return ContactPoint{arc.patch_a, arc.patch_b, x}; };
    // What leads from a border within the disc begins there, and tangential arcs are whole.
    const bool from = holds(ends(arc.arc.from)), to = holds(ends(arc.arc.to));
    const bool whole = arc.arc.tangential || from != holds(point(arc.patch_a, arc.arc.from)) ||
                       to != holds(point(arc.patch_a, arc.arc.to));
    const auto parts = whole ? whole_arc(arc, from, to) : parts_outside(arc);
    found.arcs[index].dropped = parts.empty();
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const std::size_t i = k == 0 ? index : found.arcs.size();
      if (k > 0) found.arcs.push_back(arc);
      found.arcs[i].arc.from = parts[k].from;
      found.arcs[i].arc.to = parts[k].to;
      for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
        if (!parts[k].cut[side]) continue;
        found.arcs[i].contact[side] = -1;
        arms.push_back(2 * i + side);
        const Vec3 p = point(arc.patch_a, side == 0 ? parts[k].from : parts[k].to);
        gathered_.box = joined(gathered_.box, {p, p});
      }
    }
  }

  struct ArcPart {
    Point4 from, to;
    std::array<bool, 2> cut;  // by end: it is at the disc
  };

  static std::vector<ArcPart> whole_arc(const FoundArc& arc, bool from, bool to) {
    if (from && to) return {};
    return {{arc.arc.from, arc.arc.to, {from, to}}};
  }

  // An arc is no loop and turns by less than a quarter: so far from its chord it does not lead.
  bool comes_near(const FoundArc& arc) const {
    const Vec3 p = point(arc.patch_a, arc.arc.from), run = point(arc.patch_a, arc.arc.to) - p;
    const double square = std::max(dot(run, run), kNotZero);
    const double t = std::clamp(dot(node_.point - p, run) / square, 0.0, 1.0);
    return distance(p + t * run, node_.point) <= node_.radius + norm(run);
  }

  std::vector<ArcPart> parts_outside(const FoundArc& arc) const {
    const auto depth = [&](double t) {
      return node_.radius - distance(point(arc.patch_a, on_arc(arc, t)), node_.point);
    };
    std::array<double, kArcSteps + 1> depths;
    for (std::size_t i = 0; i <= kArcSteps; ++i)
      depths[i] = depth(static_cast<double>(i) / kArcSteps);
    // Where the arc comes into the disc and leaves it, in turn.
    std::vector<double> cuts;
    const auto add = [&](double out, double in) {
      for (int i = 0; i < kCutHalvings; ++i) {
        const double middle = 0.5 * (out + in);
        (depth(middle) > 0 ? in : out) = middle;
      }
      cuts.push_back(out);
    };
    for (std::size_t i = 0; i < kArcSteps; ++i) {
      const double from = static_cast<double>(i) / kArcSteps, to = from + 1.0 / kArcSteps;
      const double a = depths[i], b = depths[i + 1];
      if ((a > 0) != (b > 0)) {
        add(a > 0 ? to : from, a > 0 ? from : to);
      } else if (a <= 0 && std::max(a, b) + run_length(arc) / kArcSteps > 0) {
        const double middle = deepest(depth, from, to);
        if (!(depth(middle) > 0)) continue;
        add(from, middle);
        add(to, middle);
      }
    }
    std::vector<ArcPart> parts;
    std::optional<double> from;
    if (!(depths[0] > 0)) from = 0;
    for (const double cut : cuts) {
      if (from) parts.push_back({on_arc(arc, *from), on_arc(arc, cut), {*from > 0, true}});
      from = from ? std::nullopt : std::optional(cut);
    }
    if (from) parts.push_back({on_arc(arc, *from), arc.arc.to, {*from > 0, false}});
    return parts;
  }

  double run_length(const FoundArc& arc) const {
    return distance(point(arc.patch_a, arc.arc.from), point(arc.patch_a, arc.arc.to));
  }

  // Where a function with one maximum on the interval has it, or near one of the ends.
  template <class Function>
  static double deepest(const Function& f, double low, double high) {
    for (int i = 0; i < kCutHalvings; ++i) {
      const double p = low + (high - low) / 3, q = high - (high - low) / 3;
      (f(p) < f(q) ? low : high) = f(p) < f(q) ? p : q;
    }
    return 0.5 * (low + high);
  }

  Point4 on_arc(const FoundArc& arc, double t) const {
    if (t <= 0) return arc.arc.from;
    if (t >= 1) return arc.arc.to;
    Point4 x;
    double reach = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      x[k] = (1 - t) * arc.arc.from[k] + t * arc.arc.to[k];
      reach = std::max(reach, std::abs(arc.arc.to[k] - arc.arc.from[k]));
    }
    const auto &patch_a = a_.tree(arc.patch_a).patch(), &patch_b = b_.tree(arc.patch_b).patch();
    const auto on = arc.arc.iso >= 0
                        ? point_on_iso_line(patch_a, patch_b, x, arc.arc.iso, kArcReach * reach)
                        : curve_point(patch_a, patch_b, x, arc.arc.direction, kArcReach * reach);
    return on.value_or(x);
  }

  const HighOrderNode& node_;
  SurfaceCells& a_;
  SurfaceCells& b_;
  const double tolerance_;
  ContactChain gathered_;
};

}  // namespace

void gather_at_high_order_nodes(std::vector<ContactChain>& chains,
                                std::vector<CriticalCluster>& clusters, PairSearchResult& found,
                                SurfaceCells& a, SurfaceCells& b, double size, double tolerance) {
  const NodeSearch search(a, b, size, tolerance);
  std::vector<HighOrderNode> nodes;
  const auto look_near = [&](const ContactPoint& start) {
    const auto node = search.near(start);
    if (!node) return;
    const auto is_same = [&](const HighOrderNode& other) {
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
  for (const HighOrderNode& node : nodes)
    Disc(node, a, b, tolerance).gather(chains, clusters, found);
}

}  // namespace blossom
