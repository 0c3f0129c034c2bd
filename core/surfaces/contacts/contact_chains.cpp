// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/contacts/contact_chains.h"

#include <algorithm>
#include <cmath>

#include "core/base/not_zero.h"
#include "core/base/unbounded.h"
#include "core/forms/evaluation.h"
#include "core/surfaces/contacts/contact_extent.h"
#include "core/surfaces/contacts/contact_reach.h"
#include "core/surfaces/contacts/high_order_nodes.h"
#include "core/surfaces/contacts/limits.h"
#include "core/surfaces/contacts/near_misses.h"
#include "core/surfaces/gap/contact_points.h"
#include "core/surfaces/pairs/regular_contact.h"

namespace blossom {
namespace {

constexpr double kOnePoint = 1e-8;          // of the size: ends of pieces this close are one point
constexpr double kBesides = 1e-5;           // of the size: points of contact this close are one
constexpr std::size_t kClosestStarts = 24;  // pairs tried for a cluster's closest point
constexpr double kOnPath = 0.02;     // of the shorter one's length: pieces this close are the same
constexpr double kRounding = 1e-15;  // of the size
constexpr double kMinReach = 1e-3;   // of the size: how far off a contact's centre may be

class Joiner {
 public:
  Joiner(PairSearchResult& found, SurfaceCells& a, SurfaceCells& b, double size, double tolerance)
      : found_(found), a_(a), b_(b), size_(size), tolerance_(tolerance) {}

  std::vector<ContactChain> run(std::vector<CriticalCluster>& clusters) {
    move_above_borders(found_, a_, b_);
    drop_repeated();
    const std::size_t ends = 2 * found_.contacts.size();
    partner_.assign(ends, -1);
    arms_.resize(ends);
    for (std::size_t i = 0; i < found_.arcs.size(); ++i) {
      const auto& contact = found_.arcs[i].contact;
      // A branch starts where a contact stops, and the other way round.
      if (contact[0] >= 0) arms_[2 * static_cast<std::size_t>(contact[0]) + 1].push_back(2 * i);
      if (contact[1] >= 0) arms_[2 * static_cast<std::size_t>(contact[1])].push_back(2 * i + 1);
    }
    pair_ends();
    std::vector<ContactChain> chains;
    used_.assign(found_.contacts.size(), false);
    for (std::size_t e = 0; e < ends; ++e)
      if (partner_[e] < 0 && !used_[e / 2]) chains.push_back(walk(e));
    for (std::size_t e = 0; e < ends; e += 2)
      if (!used_[e / 2]) chains.push_back(walk(e));
    drop_near_misses(chains, found_, a_, b_, tolerance_);
    const ContactExtent extent(a_, size_, tolerance_);
    for (ContactChain& chain : chains) extent.measure(chain);
    const std::size_t clusters_from = chains.size();
    std::erase_if(clusters, [&](const CriticalCluster& cluster) {
      const double most = cluster.within_tolerance ? kPointCluster * size_ : tolerance_;
      const bool point = !cluster.singular && diagonal(cluster.box) <= most;
      if (point) chains.push_back(contact_of(cluster));
      return point;
    });
    extent.measure_across(chains, clusters_from);
    merge_points(chains);
    absorb_points(chains);
    gather_at_high_order_nodes(chains, clusters, found_, a_, b_, size_, tolerance_);
    for (ContactChain& chain : chains) {
      if (chain.curve)
        add_arcs(chain);
      else if (!chain.high_order)
        chain.centre = centre_of(chain);
    }
    add_tangential_arms(chains);
    return chains;
  }

 private:
  // Parameters over the whole surface a.
  Vec2 over_a(const FoundContact& piece, const Point4& x) const {
    return {a_.span_u(piece.patch_a) + x[0], a_.span_v(piece.patch_a) + x[1]};
  }

  // Difference of parameters of a, across the seam of a closed surface if that is shorter.
  Vec2 difference(const Vec2& p, const Vec2& q) const {
    Vec2 d = p - q;
    const BezierSurface& s = a_.surface();
    if (s.closed_u) d[0] = std::remainder(d[0], s.patches.rows());
    if (s.closed_v) d[1] = std::remainder(d[1], s.patches.columns());
    return d;
  }

  double length_over_a(const FoundContact& piece) const {
    const auto& path = piece.contact.path;
    double sum = 0;
    for (std::size_t k = 0; k + 1 < path.size(); ++k)
      sum += norm(difference(over_a(piece, path[k + 1]), over_a(piece, path[k])));
    return sum;
  }

  // True if all of piece i lies on piece j. A contact along a border of cells is found from both
  // sides.
  bool repeats(const FoundContact& i, const FoundContact& j) const {
    const auto& path = j.contact.path;
    const double reach = kOnPath * std::min(length_over_a(i), length_over_a(j));
    return std::all_of(i.contact.path.begin(), i.contact.path.end(), [&](const Point4& x) {
      for (std::size_t k = 0; k + 1 < path.size(); ++k) {
        const Vec2 run = difference(over_a(j, path[k + 1]), over_a(j, path[k]));
        const Vec2 to = difference(over_a(i, x), over_a(j, path[k]));
        const double t = std::clamp(dot(to, run) / std::max(dot(run, run), kNotZero), 0.0, 1.0);
        if (norm(to - t * run) <= reach) return true;
      }
      return false;
    });
  }

  // Over a, moved by so many of its periods, and widened.
  Box box_over_a(const FoundContact& piece, const Vec2& shift, double margin) const {
    Box box;
    for (const Point4& x : piece.contact.path) {
      const Vec2 p = over_a(piece, x) + shift;
      box = joined(box, {{p[0], p[1], 0}, {p[0], p[1], 0}});
    }
    return widened(box, margin);
  }

  // For each piece the others that it may repeat, in order: those whose boxes over a it meets.
  std::vector<std::vector<std::size_t>> beside() const {
    const auto& pieces = found_.contacts;
    std::vector<std::vector<std::size_t>> result(pieces.size());
    std::vector<Box> boxes;
    for (const FoundContact& piece : pieces)
      boxes.push_back(box_over_a(piece, {}, kOnPath * length_over_a(piece)));
    const BoxTree tree(boxes);
    const BezierSurface& s = a_.surface();
    const int turns_u = s.closed_u ? 1 : 0, turns_v = s.closed_v ? 1 : 0;
    for (int u = -turns_u; u <= turns_u; ++u)
      for (int v = -turns_v; v <= turns_v; ++v) {
        const Vec2 shift{static_cast<double>(u * s.patches.rows()),
                         static_cast<double>(v * s.patches.columns())};
        for (std::size_t i = 0; i < pieces.size(); ++i) boxes[i] = box_over_a(pieces[i], shift, 0);
        BoxTree(boxes).for_each_meeting(tree, [&](int i, int j) {
          if (i != j) result[static_cast<std::size_t>(i)].push_back(static_cast<std::size_t>(j));
        });
      }
    for (auto& others : result) std::sort(others.begin(), others.end());
    return result;
  }

  void drop_repeated() {
    auto& pieces = found_.contacts;
    std::vector<int> goes_to(pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) goes_to[i] = static_cast<int>(i);
    const std::vector<std::vector<std::size_t>> others = beside();
    for (std::size_t i = 0; i < pieces.size(); ++i)
      for (const std::size_t j : others[i]) {
        if (goes_to[j] != static_cast<int>(j) || !repeats(pieces[i], pieces[j])) continue;
        goes_to[i] = static_cast<int>(j);
        break;
      }
    std::vector<FoundContact> kept;
    std::vector<int> place(pieces.size(), -1);
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (goes_to[i] == static_cast<int>(i)) {
        place[i] = static_cast<int>(kept.size());
        kept.push_back(std::move(pieces[i]));
      }
    pieces = std::move(kept);
    for (FoundArc& arc : found_.arcs)
      for (int& contact : arc.contact)
        if (contact >= 0)
          contact = place[static_cast<std::size_t>(goes_to[static_cast<std::size_t>(contact)])];
  }

  const CellContact& contact(std::size_t i) const { return found_.contacts[i].contact; }

  Vec3 point(int patch_a, const Point4& x) const {
    return point_at(a_.tree(patch_a).patch(), x[0], x[1]);
  }

  Vec3 end_point(std::size_t end) const {
    const CellContact& c = contact(end / 2);
    return point(found_.contacts[end / 2].patch_a, end % 2 == 0 ? c.path.front() : c.path.back());
  }

  // Ends that leave their cell belong together if each is the other's nearest.
  void pair_ends() {
    std::vector<std::size_t> leaving;
    std::vector<Vec3> points;
    for (std::size_t e = 0; e < partner_.size(); ++e)
      if (contact(e / 2).leaves[e % 2]) {
        leaving.push_back(e);
        points.push_back(end_point(e));
      }
    std::vector<Box> boxes;
    for (const Vec3& p : points) boxes.push_back({p, p});
    const BoxTree tree(boxes);
    const auto nearest = [&](std::size_t i) {
      auto best = leaving.size();
      double least = kContactJoinRadius * size_;
      tree.for_each_near(points[i], least * least, [&](int found) {
        const auto j = static_cast<std::size_t>(found);
        const double gap = distance(points[i], points[j]);
        if (leaving[j] / 2 != leaving[i] / 2 && (gap < least || (gap == least && j < best))) {
          least = gap;
          best = j;
        }
        return least * least;
      });
      return best;
    };
    for (std::size_t i = 0; i < leaving.size(); ++i) {
      const std::size_t j = nearest(i);
      if (j < leaving.size() && nearest(j) == i)
        partner_[leaving[i]] = static_cast<int>(leaving[j]);
    }
  }

  // The points of a piece, beginning at one of its ends.
  std::vector<ContactPoint> points_from(std::size_t end) const {
    const FoundContact& piece = found_.contacts[end / 2];
    std::vector<ContactPoint> points;
    for (std::size_t k = 0; k < piece.contact.path.size(); ++k)
      points.push_back({piece.patch_a, piece.patch_b, piece.contact.path[k], piece.contact.gaps[k],
                        piece.contact.crosses});
    if (end % 2 == 1) std::reverse(points.begin(), points.end());
    return points;
  }

  // Appends the next piece to a path. Pieces may overlap: its points that lie behind the path's end
  // are left out, unless all do; then the contact turns there.
  void append(std::vector<ContactPoint> next, std::vector<ContactPoint>& path) const {
    auto first = next.begin();
    if (path.size() >= 2) {
      const ContactPoint &before = path[path.size() - 2], &last = path.back();
      const Vec3 end = point(last.patch_a, last.x), ahead = end - point(before.patch_a, before.x);
      first = std::find_if(next.begin(), next.end(), [&](const ContactPoint& p) {
        return dot(point(p.patch_a, p.x) - end, ahead) >= 0;
      });
      if (first == next.end()) first = next.begin();
      const bool same_patches = last.patch_a == first->patch_a && last.patch_b == first->patch_b;
      if (first != next.begin() && !same_patches) {  // it begins at the path's end then
        const Point4 x = in_patches(a_, b_, last.patch_a, last.patch_b, last.x, *first);
        const auto beside = [](double t) { return t < -kOnBorder || t > 1 + kOnBorder; };
        const bool beside_seam = std::any_of(x.begin(), x.end(), beside);
        first = beside_seam ? next.begin() : first - 1;
        if (!beside_seam) first->x = x;
      }
    }
    path.insert(path.end(), first, next.end());
  }

  ContactChain walk(std::size_t first) {
    ContactChain chain;
    const auto leaves = [&](std::size_t end) { return contact(end / 2).leaves[end % 2]; };
    chain.arms[0] = arms_[first];
    chain.leaves[0] = leaves(first);
    std::size_t end = first;
    while (true) {
      used_[end / 2] = true;
      append(points_from(end), chain.path);
      const std::size_t far = end ^ 1;
      if (partner_[far] < 0) {
        chain.arms[1] = arms_[far];
        chain.leaves[1] = leaves(far);
        return chain;
      }
      end = static_cast<std::size_t>(partner_[far]);
      if (used_[end / 2]) {
        chain.closed = end == first;
        return chain;
      }
    }
  }

  // The largest gap that may be nothing but rounding.
  double most_rounding() const { return kRoundingGap * tolerance_; }

  // A candidate for the point of a contact. Along branches all gaps are but rounding: among points
  // like those one with a common normal is the node that the branches go through.
  struct Closest {
    ContactPoint point;
    bool normal = false;  // common to both surfaces

    bool is_better_than(const Closest& other, double rounding) const {
      if (std::max(point.gap, other.point.gap) <= rounding && normal != other.normal) return normal;
      return point.gap < other.point.gap;
    }
  };

  // A point of least distance near a pair of cells: a crossing, where the surfaces are not
  // parallel, or a point with common normal.
  Closest closest_in(const CriticalPair& pair) const {
    const auto& patch_a = a_.tree(pair.patch_a).patch();
    const auto& patch_b = b_.tree(pair.patch_b).patch();
    Point4 middle;
    double reach = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      middle[k] = at(pair.box[k], 0.5);
      reach = std::max(reach, 1.5 * length(pair.box[k]));
    }
    Closest best{{pair.patch_a, pair.patch_b, middle, kUnbounded}};
    const auto consider = [&](const std::optional<Point4>& found, bool normal) {
      if (!found) return;
      const Point4 x = moved_into(patch_a, patch_b, *found, kPolishReach);
      ContactPoint p{pair.patch_a, pair.patch_b, x, 0};
      p.gap = distance(point(p.patch_a, p.x), point_at(patch_b, p.x[2], p.x[3]));
      const bool stays = distance(point(p.patch_a, *found), point(p.patch_a, x)) <= most_rounding();
      const Closest next{p, normal && stays};
      if (next.is_better_than(best, most_rounding())) best = next;
    };
    consider(middle, false);
    consider(collinear_normal_point(patch_a, patch_b, middle, reach), true);
    for (std::size_t k = 0; k < 4 && best.point.gap > 0; ++k) {
      Point4 plane{};
      plane[k] = 1;
      consider(curve_point(patch_a, patch_b, middle, plane, reach), false);
    }
    return best;
  }

  // The contact in a cluster of cells, at the closest point that a few of its pairs lead to.
  ContactChain contact_of(const CriticalCluster& cluster) const {
    ContactChain chain;
    chain.box = cluster.box;
    chain.length = diagonal(cluster.box);
    chain.regular = crosses_regularly(found_, cluster.pairs, a_, b_);
    Closest best;
    best.point.gap = kUnbounded;
    const auto consider = [&](int index) {
      const Closest next = closest_in(found_.critical[static_cast<std::size_t>(index)]);
      if (next.is_better_than(best, most_rounding())) best = next;
    };
    // Round a node the surfaces stay together longest, so its own cells are the widest.
    consider(*std::ranges::max_element(cluster.pairs, {}, [&](int index) {
      const auto& box = found_.critical[static_cast<std::size_t>(index)].box;
      return length(box[0]) * length(box[1]);
    }));
    const std::size_t step = cluster.pairs.size() / kClosestStarts + 1;
    for (std::size_t i = 0; i < cluster.pairs.size(); i += step) consider(cluster.pairs[i]);
    chain.path = {best.point};
    return chain;
  }

  // Points of contact that lie next to each other, in several patches perhaps, are one.
  void merge_points(std::vector<ContactChain>& chains) const {
    for (std::size_t i = 0; i < chains.size(); ++i)
      for (std::size_t j = i + 1; j < chains.size(); ++j) {
        ContactChain &p = chains[i], &q = chains[j];
        if (p.curve || q.curve ||
            std::sqrt(squared_distance(p.box, q.box)) >
                0.5 * (p.length + q.length) + kBesides * size_)
          continue;
        p.path.insert(p.path.end(), q.path.begin(), q.path.end());
        for (std::size_t side = 0; side < 2; ++side)
          p.arms[side].insert(p.arms[side].end(), q.arms[side].begin(), q.arms[side].end());
        p.regular = p.regular && q.regular;
        p.length = std::max({p.length, q.length, diagonal(joined(p.box, q.box))});
        p.box = joined(p.box, q.box);
        chains.erase(chains.begin() + static_cast<std::ptrdiff_t>(j));
        j = i;
      }
  }

  // A point without branches from which the surfaces stay within a few tolerances up to a
  // tangential curve is part of it: its cells lie over another patch than the curve does. Where
  // curves end they may meet in it.
  void absorb_points(std::vector<ContactChain>& chains) const {
    for (ContactChain& chain : chains) {
      if (chain.curve || chain.arm_count() > 0 || chain.path.size() > 1) continue;
      const auto ends_here = [&](const ContactChain& c) {
        return c.curve && ends_at(c, chain.box);
      };
      const auto holds = [&](const ContactChain& c) { return c.curve && joins(chain, c); };
      const auto curve = std::ranges::find_if(chains, holds);
      if (curve == chains.end() || std::ranges::any_of(chains, ends_here)) continue;
      curve->box = joined(curve->box, chain.box);
      chain.path.clear();
    }
    std::erase_if(chains, [](const ContactChain& chain) { return chain.path.empty(); });
  }

  bool ends_at(const ContactChain& curve, const Box& box) const {
    const double most = kContactJoinRadius * size_;
    const auto beside = [&](const ContactPoint& end) {
      return squared_distance(box, point(end.patch_a, end.x)) <= most * most;
    };
    return !curve.closed && (beside(curve.path.front()) || beside(curve.path.back()));
  }

  bool joins(const ContactChain& chain, const ContactChain& curve) const {
    const ContactPoint& p = chain.path.front();
    const Vec3 x = point(p.patch_a, p.x);
    const auto gap = [&](const ContactPoint& q) { return distance(point(q.patch_a, q.x), x); };
    const ContactPoint& next = *std::ranges::min_element(curve.path, {}, gap);
    return gap(next) <= kPointCluster * size_ && in_contact(a_, b_, p, next, tolerance_);
  }

  // The tangential curve as arcs, piece by piece; ends of pieces that are one point are made so.
  void add_arcs(ContactChain& chain) {
    const std::size_t count = chain.path.size();
    const std::size_t first_arc = found_.arcs.size();
    for (std::size_t i = 0; i + 1 < count; ++i) {
      ContactPoint &p = chain.path[i], &q = chain.path[i + 1];
      const bool same_patches = p.patch_a == q.patch_a && p.patch_b == q.patch_b;
      const double step = distance(point(p.patch_a, p.x), point(q.patch_a, q.x));
      if (!same_patches || step <= kOnePoint * size_) {
        if (same_patches) q.x = p.x;
        continue;
      }
      FoundArc arc{p.patch_a, p.patch_b, kNoBox, {p.x, q.x}, {-1, -1}};
      for (std::size_t k = 0; k < 4; ++k) arc.arc.direction[k] = q.x[k] - p.x[k];
      arc.arc.tangential = true;
      arc.arc.crosses = p.crosses && q.crosses;
      found_.arcs.push_back(arc);
      if (found_.arcs.size() > first_arc + 1)
        join(2 * found_.arcs.size() - 3, 2 * found_.arcs.size() - 2);
    }
    if (found_.arcs.size() == first_arc) return;
    const ArcEnd from = 2 * first_arc, to = 2 * found_.arcs.size() - 1;
    if (chain.closed) join(to, from);
    // Branches that fork off become ends at the same place.
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}})
      if (!chain.arms[side].empty()) {
        const ContactPoint& end = side == 0 ? chain.path.front() : chain.path.back();
        const auto &patch_a = a_.tree(end.patch_a).patch(), &patch_b = b_.tree(end.patch_b).patch();
        // One that runs beside the contact ends there.
        for (ArcEnd& arm : chain.arms[side]) {
          if (leads_to(patch_a, patch_b, arm_of(found_, a_, b_, arm, end), end.x))
            arm = reach_contact(found_, a_, b_, arm, end);
          const FoundArc& arc = found_.arcs[arm / 2];  // what lies between is the contact's
          const Vec3 p = point(arc.patch_a, end_of(found_, arm));
          chain.box = joined(chain.box, {p, p});
        }
        chain.arms[side].push_back(side == 0 ? from : to);
      }
  }

  // Tangential curves that were led to a node of high order begin there.
  void add_tangential_arms(std::vector<ContactChain>& chains) const {
    for (ContactChain& chain : chains) {
      if (!chain.high_order) continue;
      for (ArcEnd end = 0; end < 2 * found_.arcs.size(); ++end) {
        const FoundArc& arc = found_.arcs[end / 2];
        const ContactPoint& node = chain.centre;
        if (arc.arc.tangential && arc.patch_a == node.patch_a && arc.patch_b == node.patch_b &&
            end_of(found_, end) == node.x)
          chain.arms[1].push_back(end);
      }
    }
  }

  // Makes two ends one, but not across the seam of a closed surface, where its parameters jump.
  void join(ArcEnd end, ArcEnd next) {
    const FoundArc &p = found_.arcs[end / 2], &q = found_.arcs[next / 2];
    const ContactPoint goal{q.patch_a, q.patch_b, end_of(found_, next)};
    const Point4 x = in_patches(a_, b_, p.patch_a, p.patch_b, end_of(found_, end), goal);
    if (!jumps(x, goal.x, a_, b_)) found_.joins.push_back({end, next});
  }

  // The closest point of those that the middle of the path and its own closest point lead to.
  ContactPoint centre_of(const ContactChain& chain) const {
    ContactPoint best = *std::min_element(
        chain.path.begin(), chain.path.end(),
        [](const ContactPoint& p, const ContactPoint& q) { return p.gap < q.gap; });
    const double reach = std::max(chain.length, kMinReach * size_);
    double least = best.gap + kRounding * size_;
    for (ContactPoint centre : {chain.path[chain.path.size() / 2], best}) {
      const auto &patch_a = a_.tree(centre.patch_a).patch(),
                 &patch_b = b_.tree(centre.patch_b).patch();
      const auto x = collinear_normal_point(patch_a, patch_b, centre.x, kPolishReach);
      if (!x || distance(point(centre.patch_a, *x), point(centre.patch_a, centre.x)) > reach)
        continue;
      centre.gap = std::abs(signed_gap(patch_a, patch_b, *x));
      if (centre.gap > least) continue;
      least = centre.gap;
      centre.x = *x;
      best = centre;
    }
    return best;
  }

  PairSearchResult& found_;
  SurfaceCells& a_;
  SurfaceCells& b_;
  const double size_, tolerance_;
  std::vector<int> partner_;               // by end of a piece: 2 * piece + side
  std::vector<std::vector<ArcEnd>> arms_;  // likewise
  std::vector<char> used_;
};

}  // namespace

std::vector<ContactChain> contact_chains(PairSearchResult& found, SurfaceCells& a, SurfaceCells& b,
                                         std::vector<CriticalCluster>& clusters, double size,
                                         double tolerance) {
  return Joiner(found, a, b, size, tolerance).run(clusters);
}

}  // namespace blossom
