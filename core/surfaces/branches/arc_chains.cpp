// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/branches/arc_chains.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/forms/evaluation.h"

namespace blossom {
namespace {

// Border points found from two sides agree to rounding; twice the slack of one side.
constexpr double kJoin = 2 * kSamePoint;

// A free parameter of a point near a pole is known so well at least; fraction of a patch.
constexpr double kPoleJoin = 1e-5;

// Parameters over a whole surface: index of the span plus the local parameter.
Point4 over_surfaces(const SurfaceCells& a, const SurfaceCells& b, int patch_a, int patch_b,
                     const Point4& x) {
  return {a.span_u(patch_a) + x[0], a.span_v(patch_a) + x[1], b.span_u(patch_b) + x[2],
          b.span_v(patch_b) + x[3]};
}

Point4 mirrored(const Point4& p) { return {p[2], p[3], p[0], p[1]}; }

bool same(const Point4& p, const Point4& q) {
  for (std::size_t i = 0; i < 4; ++i)
    if (std::abs(p[i] - q[i]) > kJoin) return false;
  return true;
}

// An end of an arc: 2 * arc for `from`, 2 * arc + 1 for `to`.
class Graph {
 public:
  Graph(const PairSearchResult& found, const SurfaceCells& a, const SurfaceCells& b,
        const std::vector<ContactChain>& contacts)
      : found_(found),
        a_(a),
        b_(b),
        spans_{a.surface().patches.rows(), a.surface().patches.columns(),
               b.surface().patches.rows(), b.surface().patches.columns()} {
    points_.reserve(2 * found.arcs.size());
    for (const FoundArc& arc : found.arcs)
      for (const Point4& x : {arc.arc.from, arc.arc.to})
        points_.push_back(over_surfaces(a, b, arc.patch_a, arc.patch_b, x));
    vertex_.assign(points_.size(), -1);
    join_ends();
    join_near_poles();
    for (const auto& join : found.joins) merge(join[0], join[1]);
    contact_of_.assign(points_.size(), -1);
    for (std::size_t c = 0; c < contacts.size(); ++c) add_contact(contacts[c], static_cast<int>(c));
    drop_shortest(contacts);
  }

  std::vector<ArcEnd> loose() const {
    std::vector<ArcEnd> ends;
    for (std::size_t e = 0; e < points_.size(); ++e)
      if (!dropped_[e / 2] && contact_of_[e] < 0 && ends_at(e).size() != 2 &&
          (!on_border(e) || runs_along_border(e)) && !is_swapped(e))
        ends.push_back(e);
    return ends;
  }

  std::vector<Chain> chains(const std::vector<CriticalCluster>& clusters) {
    std::vector<Chain> result;
    used_ = dropped_;
    for (std::size_t e = 0; e < points_.size(); ++e)
      if (!used_[e / 2] && (ends_at(e).size() != 2 || contact_of_[e] >= 0))
        result.push_back(walk(e, clusters));
    for (std::size_t e = 0; e < points_.size(); e += 2)
      if (!used_[e / 2]) result.push_back(walk(e, clusters));
    return result;
  }

 private:
  const std::vector<std::size_t>& ends_at(std::size_t end) const {
    return ends_[static_cast<std::size_t>(vertex_[end])];
  }

  // Points near each other have near values of one generic linear function.
  void join_ends() {
    const auto value = [&](std::size_t e) {
      const Point4& p = points_[e];
      return p[0] + 0.6180339887 * p[1] + 0.4142135623 * p[2] + 0.2360679774 * p[3];
    };
    std::vector<std::pair<double, std::size_t>> order;
    order.reserve(points_.size());
    ends_.reserve(points_.size());
    for (std::size_t e = 0; e < points_.size(); ++e)
      if (!found_.arcs[e / 2].dropped) order.emplace_back(value(e), e);
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < order.size(); ++i) {
      const std::size_t e = order[i].second;
      for (std::size_t j = i; j-- > 0 && order[i].first - order[j].first <= 3 * kJoin;)
        if (same(points_[e], points_[order[j].second])) {
          vertex_[e] = vertex_[order[j].second];
          break;
        }
      if (vertex_[e] < 0) {
        vertex_[e] = static_cast<int>(ends_.size());
        ends_.emplace_back().reserve(2);
      }
      ends_[static_cast<std::size_t>(vertex_[e])].push_back(e);
    }
  }

  // Near a pole a parameter hardly moves points, and is known no better than that. Ends that are
  // single for this reason are one if their points are.
  void join_near_poles() {
    std::vector<std::size_t> single;
    for (std::size_t e = 0; e < points_.size(); ++e)
      if (!found_.arcs[e / 2].dropped && ends_at(e).size() == 1 && !on_border(e))
        single.push_back(e);
    for (std::size_t i = 0; i < single.size(); ++i) {
      const Point4 reach = join_reach(single[i]);
      for (std::size_t j = 0; j < single.size(); ++j) {
        const std::size_t e = single[i], f = single[j];
        if (e / 2 == f / 2 || ends_at(e).size() != 1 || ends_at(f).size() != 1) continue;
        bool near = true;
        for (std::size_t k = 0; k < 4; ++k)
          near = near && std::abs(points_[e][k] - points_[f][k]) <= reach[k];
        if (near) merge(e, f);
      }
    }
  }

  // How far a parameter may be off without moving the point more than the other one does by kJoin.
  Point4 join_reach(std::size_t end) const {
    const FoundArc& arc = found_.arcs[end / 2];
    const Point4& x = end_of(found_, end);
    const auto jet_of = [](const SurfaceCells& cells, int patch, double u, double v) {
      return jet_at(cells.surface().patches.values()[static_cast<std::size_t>(patch)], u, v, 1);
    };
    const auto reach = [](const Vec3& own, const Vec3& other) {
      return std::min(kJoin * std::max(1.0, norm(other) / norm(own)), kPoleJoin);
    };
    const PatchJet a = jet_of(a_, arc.patch_a, x[0], x[1]);
    const PatchJet b = jet_of(b_, arc.patch_b, x[2], x[3]);
    return {reach(a.u, a.v), reach(a.v, a.u), reach(b.u, b.v), reach(b.v, b.u)};
  }

  void merge(std::size_t e, std::size_t f) {
    const int to = vertex_[e], from = vertex_[f];
    if (to == from || to < 0 || from < 0) return;
    for (const std::size_t end : ends_[static_cast<std::size_t>(from)]) {
      vertex_[end] = to;
      ends_[static_cast<std::size_t>(to)].push_back(end);
    }
    ends_[static_cast<std::size_t>(from)].clear();
  }

  // Two arms of a point pass through it, as at a cusp, if no parameter jumps; more of them end
  // there, and so do those of a tangential curve.
  void add_contact(const ContactChain& contact, int index) {
    std::vector<std::size_t> arms(contact.arms[0]);
    arms.insert(arms.end(), contact.arms[1].begin(), contact.arms[1].end());
    if (!contact.curve && !contact.parted && arms.size() == 2) return merge(arms[0], arms[1]);
    for (const std::size_t end : arms) contact_of_[end] = index;
  }

  // An arc across the corner of a cell may be so short that its ends are one point. Its neighbours
  // join there without it.
  void drop_shortest(const std::vector<ContactChain>& contacts) {
    dropped_.reserve(found_.arcs.size());
    for (const FoundArc& arc : found_.arcs) dropped_.push_back(arc.dropped);
    std::vector<bool> arm(found_.arcs.size(), false);
    for (const ContactChain& contact : contacts)
      for (const auto& side : contact.arms)
        for (const std::size_t end : side) arm[end / 2] = true;
    for (std::size_t i = 0; i < found_.arcs.size(); ++i) {
      if (dropped_[i]) continue;
      auto& ends = ends_[static_cast<std::size_t>(vertex_[2 * i])];
      if (arm[i] || vertex_[2 * i] != vertex_[2 * i + 1] || ends.size() <= 2) continue;
      std::erase_if(ends, [&](std::size_t end) { return end / 2 == i; });
      dropped_[i] = true;
    }
  }

  Chain walk(std::size_t first, const std::vector<CriticalCluster>& clusters) {
    Chain chain;
    std::size_t end = first;
    while (true) {
      used_[end / 2] = true;
      chain.links.push_back({static_cast<int>(end / 2), end % 2 == 0});
      const std::size_t far = end ^ 1;
      const auto& there = ends_at(far);
      if (there.size() != 2 || contact_of_[far] >= 0) {
        chain.ends = {end_kind(first, clusters), end_kind(far, clusters)};
        return chain;
      }
      const std::size_t next = there[0] == far ? there[1] : there[0];
      if (used_[next / 2]) {
        chain.closed = true;
        return chain;
      }
      end = next;
    }
  }

  bool is_swapped(std::size_t end) const {
    return std::find(found_.swapped.begin(), found_.swapped.end(), end) != found_.swapped.end();
  }

  // True if parameter i is at the first or last end of its range.
  bool at_border(std::size_t end, std::size_t i) const {
    return points_[end][i] <= kJoin || points_[end][i] >= spans_[i] - kJoin;
  }

  // The surface on whose border an end of a single arc lies.
  std::optional<CurveEnd> on_border(std::size_t end) const {
    if (ends_at(end).size() != 1) return std::nullopt;
    if (at_border(end, 0) || at_border(end, 1)) return CurveEnd::BorderA;
    if (at_border(end, 2) || at_border(end, 3)) return CurveEnd::BorderB;
    const FoundArc& arc = found_.arcs[end / 2];
    const Point4& x = end_of(found_, end);
    if (a_.outside(arc.patch_a, {x[0], x[0]}, {x[1], x[1]}) ||
        b_.outside(arc.patch_b, {x[2], x[2]}, {x[3], x[3]}))
      return CurveEnd::Trim;
    return std::nullopt;
  }

  // An arc that runs along a border lies on it all the way: it is no reason to end there.
  bool runs_along_border(std::size_t end) const {
    const BezierSurface &a = a_.surface(), &b = b_.surface();
    const std::array closed{a.closed_u, a.closed_v, b.closed_u, b.closed_v};
    bool along = false;
    for (std::size_t i = 0; i < 4; ++i) {
      if (!at_border(end, i)) continue;
      if (!closed[i] && !found_.arcs[end / 2].arc.runs_along_border) return false;
      if (std::abs(points_[end][i] - points_[end ^ 1][i]) > kJoin) return false;
      along = true;
    }
    return along;
  }

  ChainEnd end_kind(std::size_t end, const std::vector<CriticalCluster>& clusters) const {
    if (contact_of_[end] >= 0) return {CurveEnd::Place, -1, contact_of_[end]};
    if (is_swapped(end)) return {CurveEnd::Closed, -1, -1};
    if (const auto border = on_border(end)) return {*border, -1, -1};
    const Point4& p = points_[end];
    for (std::size_t c = 0; c < clusters.size(); ++c)
      for (const int i : clusters[c].pairs)
        if (in_pair(found_.critical[static_cast<std::size_t>(i)], p))
          return {CurveEnd::Place, static_cast<int>(c), -1};
    return {CurveEnd::Place, -1, -1};
  }

  // Of a surface with itself either way round.
  bool in_pair(const CriticalPair& pair, const Point4& p) const {
    return holds(pair, p) || (&a_ == &b_ && holds(pair, mirrored(p)));
  }

  bool holds(const CriticalPair& pair, const Point4& p) const {
    Point4 low, high;
    for (std::size_t i = 0; i < 4; ++i) {
      low[i] = pair.box[i].from;
      high[i] = pair.box[i].to;
    }
    low = over_surfaces(a_, b_, pair.patch_a, pair.patch_b, low);
    high = over_surfaces(a_, b_, pair.patch_a, pair.patch_b, high);
    for (std::size_t i = 0; i < 4; ++i)
      if (p[i] < low[i] - kJoin || p[i] > high[i] + kJoin) return false;
    return true;
  }

  const PairSearchResult& found_;
  const SurfaceCells& a_;
  const SurfaceCells& b_;
  const std::array<int, 4> spans_;  // by parameter
  std::vector<Point4> points_;
  std::vector<int> vertex_;                     // of an end
  std::vector<std::vector<std::size_t>> ends_;  // of a vertex
  std::vector<int> contact_of_;                 // of an end, or -1
  std::vector<bool> dropped_;                   // arcs
  std::vector<bool> used_;
};

void mirror(FoundArc& arc) {
  std::swap(arc.patch_a, arc.patch_b);
  std::swap(arc.box[0], arc.box[2]);
  std::swap(arc.box[1], arc.box[3]);
  arc.arc.from = mirrored(arc.arc.from);
  arc.arc.to = mirrored(arc.arc.to);
  arc.arc.direction = mirrored(arc.arc.direction);
}

// Two ends of different arcs that are one point, perhaps with its sides exchanged.
struct EndMatch {
  std::size_t end, other;
  bool exchanged;
};

class SideAgreement {
 public:
  SideAgreement(PairSearchResult& found, const SurfaceCells& cells) : found_(found) {
    for (const FoundArc& arc : found.arcs)
      for (const Point4& x : {arc.arc.from, arc.arc.to})
        points_.push_back(over_surfaces(cells, cells, arc.patch_a, arc.patch_b, x));
    find_matches();
    drop_corner_contacts(cells);
  }

  void run() {
    turned_.assign(found_.arcs.size(), kUnknown);
    // Contacts know their arms as they were found.
    for (std::size_t i = 0; i < found_.arcs.size(); ++i) {
      const FoundArc& arc = found_.arcs[i];
      if (arc.arc.tangential || arc.contact != std::array{-1, -1}) turned_[i] = 0;
    }
    for (std::size_t i = 0; i < found_.arcs.size(); ++i)
      if (turned_[i] == 0) spread_from(i);
    for (std::size_t i = 0; i < found_.arcs.size(); ++i) {
      if (turned_[i] != kUnknown) continue;
      turned_[i] = 0;
      spread_from(i);
    }
    for (std::size_t e = 0; e < points_.size(); ++e)
      for (const EndMatch& match : matches_[e])
        if (match.exchanged != (turned_[e / 2] != turned_[match.other / 2])) {
          found_.swapped.push_back(e);
          break;
        }
    for (std::size_t i = 0; i < found_.arcs.size(); ++i)
      if (turned_[i] == 1) mirror(found_.arcs[i]);
  }

 private:
  static constexpr char kUnknown = 2;

  // Exchanging the sides keeps this value.
  static double value(const Point4& p) { return p[0] + p[2] + 0.6180339887 * (p[1] + p[3]); }

  void find_matches() {
    matches_.resize(points_.size());
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t e = 0; e < points_.size(); ++e) order.emplace_back(value(points_[e]), e);
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t j = i; j-- > 0 && order[i].first - order[j].first <= 4 * kJoin;)
        match(order[i].second, order[j].second);
  }

  void match(std::size_t e, std::size_t f) {
    if (e / 2 == f / 2) return;
    const bool direct = same(points_[e], points_[f]);
    if (!direct && !same(points_[e], mirrored(points_[f]))) return;
    matches_[e].push_back({e, f, !direct});
    matches_[f].push_back({f, e, !direct});
  }

  void drop_corner_contacts(const SurfaceCells& cells) {
    std::erase_if(found_.corner_contacts, [&](const CornerContact& corner_contact) {
      const Point4 p = over_surfaces(cells, cells, corner_contact.patch_a, corner_contact.patch_b,
                                     corner_contact.x);
      return std::any_of(points_.begin(), points_.end(),
                         [&](const Point4& q) { return same(p, q) || same(mirrored(p), q); });
    });
  }

  void spread_from(std::size_t first) {
    std::vector<std::size_t> waiting{first};
    while (!waiting.empty()) {
      const std::size_t arc = waiting.back();
      waiting.pop_back();
      for (const std::size_t e : {2 * arc, 2 * arc + 1})
        for (const EndMatch& match : matches_[e]) {
          char& turned = turned_[match.other / 2];
          if (turned != kUnknown) continue;
          turned = static_cast<char>(match.exchanged ? 1 - turned_[arc] : turned_[arc]);
          waiting.push_back(match.other / 2);
        }
    }
  }

  PairSearchResult& found_;
  std::vector<Point4> points_;
  std::vector<std::vector<EndMatch>> matches_;  // of an end
  std::vector<char> turned_;                    // 1: the arc's sides have to be exchanged
};

}  // namespace

void agree_on_sides(PairSearchResult& found, const SurfaceCells& cells) {
  SideAgreement(found, cells).run();
}

std::vector<Chain> chains_of(const PairSearchResult& found, const SurfaceCells& a,
                             const SurfaceCells& b, const std::vector<ContactChain>& contacts,
                             const std::vector<CriticalCluster>& clusters) {
  return Graph(found, a, b, contacts).chains(clusters);
}

std::vector<ArcEnd> loose_ends(const PairSearchResult& found, const SurfaceCells& a,
                               const SurfaceCells& b, const std::vector<ContactChain>& contacts) {
  return Graph(found, a, b, contacts).loose();
}

std::vector<CornerContact> lone_corner_contacts(const PairSearchResult& found,
                                                const SurfaceCells& a, const SurfaceCells& b) {
  if (found.corner_contacts.empty()) return {};
  std::vector<Point4> known;  // sorted
  for (const FoundArc& arc : found.arcs)
    for (const Point4& x : {arc.arc.from, arc.arc.to})
      known.push_back(over_surfaces(a, b, arc.patch_a, arc.patch_b, x));
  std::ranges::sort(known);
  std::vector<CornerContact> lone;
  for (const CornerContact& corner_contact : found.corner_contacts) {
    const Point4 p =
        over_surfaces(a, b, corner_contact.patch_a, corner_contact.patch_b, corner_contact.x);
    auto near = std::ranges::lower_bound(known, Point4{p[0] - 2 * kJoin});
    while (near != known.end() && (*near)[0] <= p[0] + 2 * kJoin && !same(p, *near)) ++near;
    if (near != known.end() && same(p, *near)) continue;
    known.insert(std::ranges::lower_bound(known, p), p);
    lone.push_back(corner_contact);
  }
  return lone;
}

}  // namespace blossom
