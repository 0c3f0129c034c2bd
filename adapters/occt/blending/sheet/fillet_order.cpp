// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/sheet/fillet_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <set>
#include <utility>

#include "adapters/occt/blending/strips/run_profiles.h"

namespace blossom::occt {
namespace {

// Sharp edges at a vertex: where there are more, what the first fillet leaves of the vertex is no
// simpler, and all are joined in one corner.
constexpr std::size_t kOrdered = 3;
constexpr std::array<std::size_t, 2> kAlternating{
    4, 6};  // but for two and two, and three and three, that alternate

// Groups of edges as the classes of a partition, and which come before which. Chamfers of all edges
// of a vertex are made at once: they turn by an angle there and go on in none that comes later.
class Order {
 public:
  Order(const BodyEdges& body, const FilletEdges& edges, const FilletOptions& options);
  std::vector<FilletEdges> groups(const FilletEdges& edges) const;
  using Rules = std::vector<std::pair<int, int>>;  // which edge comes before which
  std::map<std::size_t, int> groups_after(const Rules& rules) const;
  std::map<std::size_t, std::set<std::size_t>> led_to(const Rules& rules) const;
  Rules settled(const Rules& rules, const FilletEdges& edges) const;

 private:
  std::size_t class_of(int edge) const {
    return classes_[static_cast<std::size_t>(places_.at(edge))];
  }
  void unite(int a, int b);

  std::map<int, int> places_;         // of edges
  std::vector<std::size_t> classes_;  // by place
  Rules before_, before_asked_;       // by all edges at a vertex, by those that have fillets
};

// Whether edges cannot be one run over the end of another: they do not have all the same ball, or
// have laws, even such that agree at the vertex, which go along each edge and over no others.
bool differ(const std::vector<int>& edges, const FilletOptions& options) {
  return std::ranges::any_of(edges, [&](int each) {
    const EdgeRadius of = options.radius_of(each);
    return !is_same(of, options.radius_of(edges.front())) || (of.law && edges.size() > 1);
  });
}

// Of three edges that have balls, the one with a larger ball than the two others, whose balls are
// alike; 0 for none.
int with_larger_ball(const std::vector<int>& edges, const FilletOptions& options) {
  if (edges.size() != 3 || options.own.empty() || options.setback) return 0;
  std::array<double, 3> radii{};
  for (std::size_t i = 0; i < 3; ++i) {
    const EdgeRadius of = options.radius_of(edges[i]);
    if (of.law) return 0;
    radii[i] = of.radius;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const double a = radii[(i + 1) % 3], b = radii[(i + 2) % 3];
    if (a == b && radii[i] > a) return edges[i];
  }
  return 0;
}

// Whether an edge is concave, or convex; those that have fillets are known.
bool is_of_kind(const BodyEdges& body, const FilletEdges& edges, int edge, bool concave) {
  if (const auto known = edges.find(edge); known != edges.end()) return known->second == concave;
  double angle = 0;
  return edge_kind(body, edge, angle) == (concave ? EdgeKind::Concave : EdgeKind::Convex);
}

// Whether two or three edges of either kind alternate round a vertex, all with fillets that come to
// each other. Once those of one kind are made two others go on smoothly in each other, along the
// ends of these; three go on along these to a corner of their own.
bool alternates(const BodyEdges& body, const FilletEdges& edges,
                const std::vector<VertexSector>& ring) {
  if (std::ranges::count(kAlternating, ring.size()) == 0) return false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const DirectedEdge& next = ring[(i + 1) % ring.size()].half;
    const auto own = edges.find(ring[i].half.edge), other = edges.find(next.edge);
    if (own == edges.end() || other == edges.end() || own->second == other->second) return false;
    if (!is_narrow(body, ring[i], next)) return false;
  }
  return true;
}

Order::Order(const BodyEdges& body, const FilletEdges& edges, const FilletOptions& options) {
  for (const auto& [edge, concave] : edges) places_.emplace(edge, static_cast<int>(places_.size()));
  classes_.resize(places_.size());
  std::iota(classes_.begin(), classes_.end(), std::size_t{0});
  for (const auto& [edge, concave] : edges)
    for (const bool at_start : {true, false}) {
      std::vector<int> alike, others;
      std::size_t of_kind = 0, of_other_kind = 0;  // with edges that have no fillet
      const std::vector<VertexSector> ring = body.round({edge, at_start});
      for (const VertexSector& each : ring) {
        const auto known = edges.find(each.half.edge);
        const bool has_fillet = known != edges.end();
        if (has_fillet) (known->second == concave ? alike : others).push_back(known->first);
        if (is_of_kind(body, edges, each.half.edge, concave)) ++of_kind;
        if (is_of_kind(body, edges, each.half.edge, !concave)) ++of_other_kind;
      }
      const bool has_all = alike.size() + others.size() == ring.size();
      if ((options.chamfer && has_all) ||
          (!others.empty() && (differ(alike, options) || differ(others, options)))) {
        for (const std::vector<int>* of : {&alike, &others})
          for (const int each : *of) unite(edge, each);
        continue;
      }
      if (const int larger = ring.size() == 3 ? with_larger_ball(alike, options) : 0) {
        for (const int each : alike)
          if (each != larger && edge != larger) unite(edge, each);
        if (edge == larger)
          for (const int each : alike)
            if (each != larger)
              for (Rules* of : {&before_, &before_asked_}) of->emplace_back(edge, each);
        continue;
      }
      for (const int each : alike) unite(edge, each);
      if (alternates(body, edges, ring)) {
        for (const int each : others)
          if (concave)
            for (Rules* of : {&before_, &before_asked_}) of->emplace_back(edge, each);
        continue;
      }
      if (of_kind + of_other_kind > kOrdered) {
        for (const int each : others) unite(edge, each);
        continue;
      }
      const auto comes_first = [concave](std::size_t alike_count, std::size_t other_count) {
        return alike_count == 1 && (other_count > 1 || (other_count == 1 && concave));
      };
      for (const int each : others) {
        if (comes_first(of_kind, of_other_kind)) before_.emplace_back(edge, each);
        if (comes_first(alike.size(), others.size())) before_asked_.emplace_back(edge, each);
      }
    }
}

void Order::unite(int a, int b) {
  const std::size_t kept = class_of(a), lost = class_of(b);
  std::ranges::replace(classes_, lost, kept);
}

// How many groups come after each class at least, by the longest way of rules from it; empty if
// rules contradict each other.
std::map<std::size_t, int> Order::groups_after(const Rules& rules) const {
  std::map<std::size_t, int> level;
  for (const std::size_t each : classes_) level[each] = 0;
  bool changed = true;
  for (std::size_t round = 0; changed; ++round) {
    if (round > level.size()) return {};
    changed = false;
    for (const auto& [a, b] : rules) {
      const std::size_t first = class_of(a), second = class_of(b);
      if (first == second) return {};
      if (level[first] > level[second]) continue;
      level[first] = level[second] + 1;
      changed = true;
    }
  }
  return level;
}

// The classes that come after each by rules, also over others.
std::map<std::size_t, std::set<std::size_t>> Order::led_to(const Rules& rules) const {
  std::map<std::size_t, std::set<std::size_t>> next, to;
  for (const auto& [a, b] : rules) next[class_of(a)].insert(class_of(b));
  for (const auto& [from, first] : next) {
    std::set<std::size_t>& after = to[from];
    std::vector<std::size_t> open(first.begin(), first.end());
    while (!open.empty()) {
      const std::size_t each = open.back();
      open.pop_back();
      if (!after.insert(each).second) continue;
      if (const auto known = next.find(each); known != next.end())
        open.insert(open.end(), known->second.begin(), known->second.end());
    }
  }
  return to;
}

// Rules that lead back to where they begin ask for edges of either kind before such of the other.
// Either order can be made: at a corner where the pair of one kind comes before the lone edge of
// the other, that ends in what they meet in. The kind that more of these rules ask for comes first,
// the concave one if as many do, and the others are given up.
Order::Rules Order::settled(const Rules& rules, const FilletEdges& edges) const {
  const auto to = led_to(rules);
  const auto goes = [&](std::size_t a, std::size_t b) {
    const auto known = to.find(a);
    return known != to.end() && known->second.count(b) > 0;
  };
  const auto is_circular = [&](const std::pair<int, int>& rule) {
    return goes(class_of(rule.second), class_of(rule.first));
  };
  const auto circle_of = [&](std::size_t of) {  // the least class that it leads to and back
    std::size_t least = of;
    for (const std::size_t each : to.at(of))
      if (goes(each, of)) least = std::min(least, each);
    return least;
  };
  const auto is_of_two_kinds = [&](const std::pair<int, int>& rule) {
    return is_circular(rule) && edges.at(rule.first) != edges.at(rule.second);
  };
  // By circle: how many more rules ask for the concave kind first than for the convex one.
  std::map<std::size_t, int> balances;
  for (const auto& rule : rules)
    if (is_of_two_kinds(rule))
      balances[circle_of(class_of(rule.first))] += edges.at(rule.first) ? 1 : -1;
  Rules kept;
  for (const auto& rule : rules) {
    if (class_of(rule.first) == class_of(rule.second)) continue;  // they are made at once
    const bool concave = edges.at(rule.first);
    const int balance = is_of_two_kinds(rule) ? balances.at(circle_of(class_of(rule.first))) : 0;
    if (!is_of_two_kinds(rule) || (concave ? balance >= 0 : balance < 0)) kept.push_back(rule);
  }
  return kept;
}

// Each as late as can be: those that are to be in no group before others are made at once with all
// that they may come to meet where blends go on along the ends of others.
std::vector<FilletEdges> Order::groups(const FilletEdges& edges) const {
  std::map<std::size_t, int> after = groups_after(before_);
  if (after.empty()) after = groups_after(before_asked_);
  if (after.empty()) after = groups_after(settled(before_asked_, edges));
  if (after.empty()) return {edges};
  std::map<int, FilletEdges> sorted;
  for (const auto& [edge, concave] : edges)
    sorted[-after.at(class_of(edge))].emplace(edge, concave);
  std::vector<FilletEdges> groups;
  for (auto& [of, group] : sorted) groups.push_back(std::move(group));
  return groups;
}

}  // namespace

std::vector<FilletEdges> fillet_order(const BodyEdges& body, const FilletEdges& edges,
                                      const FilletOptions& options) {
  return Order(body, edges, options).groups(edges);
}

}  // namespace blossom::occt
