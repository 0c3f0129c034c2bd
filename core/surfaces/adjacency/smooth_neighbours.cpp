// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/adjacency/smooth_neighbours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "core/base/parallel.h"
#include "core/cells/cell_pair.h"
#include "core/cells/direction_cones.h"
#include "core/forms/evaluation.h"
#include "core/math/interval.h"
#include "core/surfaces/adjacency/cell_descent.h"
#include "core/surfaces/adjacency/limits.h"
#include "core/surfaces/adjacency/patch_sides.h"
#include "core/surfaces/pairs/exact_borders.h"

namespace blossom {
namespace {

constexpr double kSmoothSine = 1e-3;            // of the angle between normals all along a border
constexpr int kNormals = 5;                     // that are compared along it
constexpr int kMaxProofHalvings = 12;           // halvings of a patch in a proof, and
constexpr int kMaxPairs = 1024;                 // pairs of cells
constexpr std::size_t kPairGrain = 128;         // pairs that one thread looks at in a row
constexpr double kDirectionSlack = 1e-12;       // of directions of length about 1, for roundings
constexpr double kWeightRounding = 0x1p-50;     // of quotients of weights, and
constexpr double kParameterRounding = 0x1p-50;  // of what a side's parameter is on the other, and

struct CommonSide {
  PatchSide a, b;
  bool reversed = false;  // b's runs the other way
  double ratio = 1;       // of their parameters, as of `parameter_ratio`
  double gap = 0;         // between points of one parameter
  bool smooth = false;    // the normals are the same along it; otherwise it is a crease

  double on_a(double t) const {
    const double s = reversed ? 1 - t : t;
    return ratio * s / (1 - s + ratio * s);
  }
  double on_b(double t) const {
    const double s = t / (t + ratio * (1 - t));
    return reversed ? 1 - s : s;
  }
};

struct CommonCorner {
  Vec2 a, b;
  double gap = 0;
};

// Sides in one pole.
struct CommonPole {
  PatchSide a, b;
  double gap = 0;
};

const RationalBezierPatch& patch_of(const SurfaceCells& cells, int patch) {
  return cells.surface().patches.values()[static_cast<std::size_t>(patch)];
}

// The derivatives of a patch at a place on its border, by the direction from the first patch to the
// second: that of the first one leads to the border, that of the second one away from it.
struct Slopes {
  Vec3 u, v, normal;
};

Slopes slopes_at(const RationalBezierPatch& patch, const Vec2& x, bool leads_away) {
  const PatchJet jet = jet_at(patch, x[0], x[1], 1);
  const auto sign = [&](double t) { return (t == 1) == leads_away ? -1.0 : 1.0; };
  return {sign(x[0]) * jet.u, sign(x[1]) * jet.v, cross(jet.u, jet.v)};
}

bool is_smooth(const Slopes& p, const Slopes& q) {
  return norm(cross(p.normal, q.normal)) < kSmoothSine * norm(p.normal) * norm(q.normal);
}

VectorBounds turned(const VectorBounds& x, bool back) {
  return back ? VectorBounds{-x.middle, x.radius} : x;
}

Interval hull(const Interval& x, double t) { return hull(x, Interval{t, t}); }

// Two patches, and the proof that they meet in what they have in common alone.
class Neighbours {
 public:
  // nearest   borders this near each other are common
  Neighbours(SurfaceCells& a, int patch_a, SurfaceCells& b, int patch_b, double nearest)
      : a_(patch_of(a, patch_a)), b_(patch_of(b, patch_b)), nearest_(nearest) {
    const std::vector<PatchSide> of_a = outer_sides(a, patch_a), of_b = outer_sides(b, patch_b);
    if (of_a.empty() || of_b.empty()) return;
    find_corners(of_a, of_b);
    if (corners_.empty()) return;
    find_poles(of_a, of_b);
    find_sides(of_a, of_b);
  }

  // True if there is something in common and one patch goes on in the other there, with the same
  // normals or across a crease that is exactly one curve; otherwise there is nothing to prove.
  bool go_on() const {
    return !(sides_.empty() && corners_.empty() && poles_.empty()) && longest_jump() <= nearest_ &&
           std::ranges::all_of(sides_, [&](const CommonSide& s) { return goes_on(s); }) &&
           std::ranges::all_of(poles_, [&](const CommonPole& p) { return is_apart(p); }) &&
           std::ranges::all_of(corners_, [&](const CommonCorner& c) { return goes_on(c); });
  }

  // Whether it is proven, for the parts that count. The certificate tells what it took.
  bool proof(CellTree& tree_a, CellTree& tree_b, const Axes& axes) {
    tree_a_ = &tree_a;
    tree_b_ = &tree_b;
    axes_ = axes;
    slopes_a_ = slopes_of(tree_a);
    slopes_b_ = slopes_of(tree_b);
    for (const CommonPole& common : poles_) {
      const Vec3 pole = projected(side_points(tree_a.patch(), common.a).front());
      put_pole(slopes_a_, at_poles_a_, common.a, pole);
      put_pole(slopes_b_, at_poles_b_, common.b, pole);
    }
    return prove(0, 0);
  }

  const std::vector<CommonSide>& sides() const { return sides_; }
  const std::vector<CommonCorner>& corners() const { return corners_; }
  const std::vector<CommonPole>& poles() const { return poles_; }
  const Certificate& certificate() const { return certificate_; }

 private:
  struct Pole {
    PatchSide side;
    Vec3 point;
  };

  static SlopeNets slopes_of(const CellTree& tree) {
    return slope_nets(tree.patch(), tree.shape().planes == 4, tree.given_rounding());
  }

  static void put_pole(SlopeNets& nets, std::vector<Pole>& poles, const PatchSide& side,
                       const Vec3& pole) {
    nets = slope_nets(with_pole(nets.points, side, pole), nets.rational, nets.given_rounding);
    poles.push_back({side, pole});
  }

  static bool is_on(const Vec2& corner, const PatchSide& side) {
    return corner[static_cast<int>(side.across)] == side.value();
  }

  void find_corners(const std::vector<PatchSide>& of_a, const std::vector<PatchSide>& of_b) {
    const auto is_outer = [](const Vec2& corner, const std::vector<PatchSide>& sides) {
      return std::ranges::any_of(sides, [&](const PatchSide& side) { return is_on(corner, side); });
    };
    for (const Vec2& p : kCorners)
      for (const Vec2& q : kCorners)
        if (is_outer(p, of_a) && is_outer(q, of_b))
          if (const auto gap = gap_between({&corner_point(a_, p), 1}, {&corner_point(b_, q), 1}))
            corners_.push_back({p, q, *gap});
  }

  // The proof is about patches whose poles are exact, so a path jumps by what their points moved.
  // What is a pole is no side, and its ends are no corners.
  void find_poles(const std::vector<PatchSide>& of_a, const std::vector<PatchSide>& of_b) {
    for (const PatchSide& a : of_a) {
      const Vec3 pole = projected(side_points(a_, a).front());
      const auto moved_a = pole_gap(a_, a, pole, nearest_);
      if (!moved_a) continue;
      for (const PatchSide& b : of_b)
        if (const auto moved_b = pole_gap(b_, b, pole, nearest_)) {
          poles_.push_back({a, b, *moved_a + *moved_b});
          moved_ += *moved_a + *moved_b;
        }
    }
    std::erase_if(corners_, [&](const CommonCorner& corner) {
      return std::ranges::any_of(poles_, [&](const CommonPole& pole) {
        return is_on(corner.a, pole.a) && is_on(corner.b, pole.b);
      });
    });
  }

  // No path jumps by more.
  double longest_jump() const {
    double gap = 0;
    for (const CommonSide& side : sides_) gap = std::max(gap, side.gap);
    for (const CommonCorner& corner : corners_) gap = std::max(gap, corner.gap);
    return gap + moved_;
  }

  bool is_pole(const PatchSide& a, const PatchSide& b) const {
    return std::ranges::any_of(poles_,
                               [&](const CommonPole& pole) { return pole.a == a || pole.b == b; });
  }

  // The ends of common sides are no corners of their own.
  void find_sides(const std::vector<PatchSide>& of_a, const std::vector<PatchSide>& of_b) {
    for (const PatchSide& a : of_a)
      for (const PatchSide& b : of_b) {
        if (is_pole(a, b)) continue;
        const std::vector<Vec4> p = side_points(a_, a);
        std::vector<Vec4> q = side_points(b_, b);
        for (const bool reversed : {false, true}) {
          if (reversed) std::ranges::reverse(q);
          CommonSide side{a, b, reversed};
          if (!make_common(p, q, side)) continue;
          side.smooth = is_smooth_along(side);
          sides_.push_back(side);
        }
      }
    std::erase_if(corners_, [&](const CommonCorner& corner) {
      return std::ranges::any_of(sides_, [&](const CommonSide& side) {
        return is_on(corner.a, side.a) && is_on(corner.b, side.b);
      });
    });
  }

  // Nearly the same points, or exactly one curve.
  bool make_common(const std::vector<Vec4>& p, const std::vector<Vec4>& q, CommonSide& side) const {
    if (const auto gap = gap_between(p, q)) {
      side.gap = *gap;
      return true;
    }
    const bool ends = gap_between({&p.front(), 1}, {&q.front(), 1}) &&
                      gap_between({&p.back(), 1}, {&q.back(), 1});
    const auto ratio = ends ? parameter_ratio(p, q) : std::nullopt;
    if (ratio) side.ratio = *ratio;
    return ratio.has_value();
  }

  // A bound on the distance of points of one parameter, if the curves are near enough.
  std::optional<double> gap_between(std::span<const Vec4> p, std::span<const Vec4> q) const {
    if (p.size() != q.size()) return std::nullopt;
    if (std::ranges::equal(p, q)) return 0.0;
    const Vec3 centre = projected(q[0]);
    double gap = 0, radius = 0, change = 0, largest = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      gap = std::max(gap, distance(projected(p[i]), projected(q[i])));
      if (!(gap <= nearest_)) return std::nullopt;
      for (const Vec4& x : {p[i], q[i]}) {
        radius = std::max(radius, distance(projected(x), centre));
        largest = std::max(largest, max_norm(projected(x)));
      }
      const double quotient = p[i][3] * q[0][3] / (q[i][3] * p[0][3]);
      change = std::max({change, std::abs(quotient - 1), std::abs(1 / quotient - 1)});
    }
    change += kWeightRounding;
    gap += 2 * change / (1 - std::min(change, 0.5)) * radius + kPointRounding * largest;
    return gap <= nearest_ ? std::optional(gap) : std::nullopt;
  }

  // Whether a test of the slopes of both patches holds at samples of a side.
  template <class Test>
  bool all_along(const CommonSide& side, const Test& test) const {
    for (int k = 0; k < kNormals; ++k) {
      const double t = k / (kNormals - 1.0);
      const bool at_pole = std::ranges::any_of(
          poles_, [&](const auto& pole) { return is_on(side.a.at(t), pole.a); });
      if (!at_pole &&
          !test(slopes_at(a_, side.a.at(t), false), slopes_at(b_, side.b.at(side.on_b(t)), true)))
        return false;
    }
    return true;
  }

  bool is_smooth_along(const CommonSide& side) const { return all_along(side, is_smooth); }

  bool goes_on(const CommonSide& side) const {
    const auto leads_on = [&](const Slopes& p, const Slopes& q) {
      const Vec3 along = unit(side.a.across == 0 ? p.v : p.u);
      const Vec3 to = side.a.across == 0 ? p.u : p.v, from = side.b.across == 0 ? q.u : q.v;
      return dot(to - along * dot(to, along), from - along * dot(from, along)) > 0;
    };
    const auto turns = [](const Slopes& p, const Slopes& q) { return !is_smooth(p, q); };
    if (side.smooth) return all_along(side, leads_on);
    return side.gap + moved_ == 0 && (all_along(side, leads_on) || all_along(side, turns));
  }

  // Whether the inner ways that lead away from the pole are different ones.
  bool is_apart(const CommonPole& pole) const {
    const auto way = [](const RationalBezierPatch& patch, const PatchSide& side, int k) {
      const Slopes slopes = slopes_at(patch, side.at((k + 0.5) / kNormals), true);
      return unit(side.across == 0 ? slopes.u : slopes.v);
    };
    for (int i = 0; i < kNormals; ++i)
      for (int j = 0; j < kNormals; ++j)
        if (!(distance(way(a_, pole.a, i), way(b_, pole.b, j)) > kSmoothSine)) return false;
    return true;
  }

  bool goes_on(const CommonCorner& corner) const {
    const Slopes p = slopes_at(a_, corner.a, false), q = slopes_at(b_, corner.b, true);
    const Vec3 way = unit(p.u) + unit(p.v) + unit(q.u) + unit(q.v);
    return is_smooth(p, q) && dot(way, p.u) > 0 && dot(way, p.v) > 0 && dot(way, q.u) > 0 &&
           dot(way, q.v) > 0;
  }

  bool prove(int index_a, int index_b) {
    if (++pairs_ > kMaxPairs) return false;
    const Cell a = (*tree_a_)[index_a], b = (*tree_b_)[index_b];
    if (a.part == PartSide::Outside || b.part == PartSide::Outside) return true;
    const auto proves = [&](const auto& common) { return meet_only_in(common, a, b); };
    if (separated(a, b, tree_a_->shape().plane_size(), tree_b_->shape().plane_size()) ||
        std::ranges::any_of(sides_, proves) || std::ranges::any_of(corners_, proves) ||
        std::ranges::any_of(poles_, proves)) {
      count_excluded(a, b, certificate_);
      return true;
    }
    if (a.depth >= kMaxProofHalvings && b.depth >= kMaxProofHalvings) return false;
    const bool of_a = halves_first(a, b, kMaxProofHalvings);
    const int child = of_a ? tree_a_->split(index_a) : tree_b_->split(index_b);
    return of_a ? prove(child, index_b) && prove(child + 1, index_b)
                : prove(index_a, child) && prove(index_a, child + 1);
  }

  // Across the side, from a to b, nothing turns back. The path runs along it in a. At a crease,
  // however sharp, it is enough that its three directions stay independent: then only steps of no
  // length add up to nothing.
  bool meet_only_in(const CommonSide& side, const Cell& a, const Cell& b) const {
    std::array over_a{a.u, a.v}, over_b{b.u, b.v};
    const Interval along_b = over_b[side.b.along()];
    over_a[side.a.across] = hull(over_a[side.a.across], side.a.value());
    over_b[side.b.across] = hull(over_b[side.b.across], side.b.value());
    for (const double t : {along_b.from, along_b.to})
      for (const double rounding : {-kParameterRounding, kParameterRounding})
        over_a[side.a.along()] =
            hull(over_a[side.a.along()], std::clamp(side.on_a(t) + rounding, 0.0, 1.0));
    const auto p = slopes(slopes_a_, at_poles_a_, over_a);
    const auto q = slopes(slopes_b_, at_poles_b_, over_b);
    if (!side.smooth) {
      const VectorBounds &along = p[side.a.along()], &to = p[side.a.across],
                         &from = q[side.b.across];
      if (JacobianBounds({along, to, from, VectorBounds{}}).minor(3).regular) return true;
    }
    const DirectionCones cones =
        joined(DirectionCones{p[side.a.along()], turned(p[side.a.across], !side.a.high)},
               DirectionCones{turned(q[side.b.along()], side.reversed),
                              turned(q[side.b.across], side.b.high)});
    return side.gap + moved_ > 0 ? is_injective_with_jump(cones) : is_injective(cones);
  }

  // Some direction grows from a to the corner and on to b.
  bool meet_only_in(const CommonCorner& corner, const Cell& a, const Cell& b) const {
    const auto p = slopes(slopes_a_, at_poles_a_, {hull(a.u, corner.a[0]), hull(a.v, corner.a[1])});
    const auto q = slopes(slopes_b_, at_poles_b_, {hull(b.u, corner.b[0]), hull(b.v, corner.b[1])});
    const std::array steps{turned(p[0], corner.a[0] == 0), turned(p[1], corner.a[1] == 0),
                           turned(q[0], corner.b[0] == 1), turned(q[1], corner.b[1] == 1)};
    Vec3 way;
    for (const VectorBounds& step : steps) way = way + unit(step.middle);
    way = unit(way);
    return std::ranges::all_of(steps, [&](const VectorBounds& step) {
      double least = dot(way, step.middle);
      for (int k = 0; k < 3; ++k) least -= std::abs(way[k]) * step.radius[k];
      const double longest = norm(step.middle) + norm(step.radius);
      return least > (corner.gap + moved_ > 0 ? std::max(kDirectionSlack, longest / kJumpReach)
                                              : kDirectionSlack);
    });
  }

  // What leads from the pole to a on one side of a plane, what leads to b on the other. Both are at
  // an angle with it, so that points which a jump makes one are near the pole.
  bool meet_only_in(const CommonPole& pole, const Cell& a, const Cell& b) const {
    const auto at_pole = [](const SlopeNets& nets, const PatchSide& side, const Cell& cell) {
      std::array over{cell.u, cell.v};
      over[side.across] = hull(over[side.across], side.value());
      return PolePart{nets, over[0], over[1], pole_side(side)};
    };
    const auto exact =
        std::ranges::find_if(at_poles_a_, [&](const Pole& x) { return x.side == pole.a; });
    return meet_in_pole_only(at_pole(slopes_a_, pole.a, a), at_pole(slopes_b_, pole.b, b),
                             exact->point, 1 / kJumpReach);
  }

  // Of a rectangle, at a pole those of the directions from there. At two poles nothing is known.
  std::array<VectorBounds, 2> slopes(const SlopeNets& nets, const std::vector<Pole>& poles,
                                     const std::array<Interval, 2>& over) const {
    const auto at_pole = std::ranges::find_if(poles, [&](const Pole& pole) {
      const Interval& across = over[pole.side.across];
      return across.from <= pole.side.value() && pole.side.value() <= across.to;
    });
    const DirectionCones cones =
        at_pole == poles.end() ? cones_of(nets, over[0], over[1], axes_)
                               : cones_at_pole(nets, over[0], over[1], pole_side(at_pole->side),
                                               at_pole->point, axes_);
    return {cones.u, cones.v};
  }

  const RationalBezierPatch& a_;
  const RationalBezierPatch& b_;
  const double nearest_;
  CellTree* tree_a_ = nullptr;
  CellTree* tree_b_ = nullptr;
  std::vector<CommonSide> sides_;
  std::vector<CommonCorner> corners_;
  std::vector<CommonPole> poles_;
  double moved_ = 0;  // by points of both patches together, to be poles
  std::vector<Pole> at_poles_a_, at_poles_b_;
  Axes axes_;
  SlopeNets slopes_a_, slopes_b_;
  int pairs_ = 0;  // tried
  Certificate certificate_;
};

std::array<Interval, 2> range_at(const Vec2& x) {
  return {Interval{x[0], x[0]}, Interval{x[1], x[1]}};
}

Point4 place_of(const Vec2& a, const Vec2& b) { return {a[0], a[1], b[0], b[1]}; }

FoundArc arc_along(const CommonSide& side, int patch_a, int patch_b) {
  FoundArc arc{patch_a, patch_b, {}, {}, {-1, -1}};
  arc.arc.from = place_of(side.a.at(0), side.b.at(side.on_b(0)));
  arc.arc.to = place_of(side.a.at(1), side.b.at(side.on_b(1)));
  for (std::size_t k = 0; k < 4; ++k) arc.arc.direction[k] = arc.arc.to[k] - arc.arc.from[k];
  arc.arc.tangential = side.smooth;
  arc.arc.iso = arc.arc.from[0] == arc.arc.to[0] ? 0 : 1;
  return arc;
}

}  // namespace

NeighbourContacts take_neighbours(SurfaceCells& a, SurfaceCells& b, std::vector<StartPair>& pairs,
                                  double tolerance, const WorkLimit& limit) {
  std::vector<std::unique_ptr<Neighbours>> going_on(pairs.size());
  parallel_for(pairs.size(), kPairGrain, [&](std::size_t i) {
    const StartPair& pair = pairs[i];
    Neighbours neighbours(a, pair.patch_a, b, pair.patch_b, tolerance / kJumpReach);
    if (neighbours.go_on()) going_on[i] = std::make_unique<Neighbours>(std::move(neighbours));
  });
  NeighbourContacts found;
  std::optional<Axes> axes;
  const auto is_settled = [&](const StartPair& pair, Neighbours& neighbours) {
    if (limit.reached() != nullptr) return false;
    if (!axes) axes = axes_of(a.surface());
    if (!neighbours.proof(a.tree(pair.patch_a), b.tree(pair.patch_b), *axes)) return false;
    const Certificate& proven = neighbours.certificate();
    found.certificate.excluded += proven.excluded;
    found.certificate.depth = std::max(found.certificate.depth, proven.depth);
    found.certificate.rounding_bound =
        std::max(found.certificate.rounding_bound, proven.rounding_bound);
    const auto counts = [&](const std::array<Interval, 2>& of_a,
                            const std::array<Interval, 2>& of_b) {
      return !a.outside(pair.patch_a, of_a[0], of_a[1]) &&
             !b.outside(pair.patch_b, of_b[0], of_b[1]);
    };
    for (const CommonSide& side : neighbours.sides())
      if (counts(side.a.range(), side.b.range())) {
        found.arcs.push_back(arc_along(side, pair.patch_a, pair.patch_b));
        found.gap = std::max(found.gap, side.gap);
        found.touch = found.touch || side.smooth;
      }
    for (const CommonCorner& corner : neighbours.corners())
      if (counts(range_at(corner.a), range_at(corner.b))) {
        found.corner_contacts.push_back({pair.patch_a, pair.patch_b, place_of(corner.a, corner.b)});
        found.gap = std::max(found.gap, corner.gap);
      }
    // A common side tells of the pole that it runs into, if it counts itself.
    const auto ends_side = [&](const CommonPole& pole) {
      return std::ranges::any_of(neighbours.sides(), [&](const CommonSide& side) {
        return counts(side.a.range(), side.b.range()) && side.a.across != pole.a.across &&
               side.b.across != pole.b.across;
      });
    };
    for (const CommonPole& pole : neighbours.poles())
      if (!ends_side(pole) && counts(pole.a.range(), pole.b.range())) {
        found.corner_contacts.push_back(
            {pair.patch_a, pair.patch_b, place_of(pole.a.at(0), pole.b.at(0))});
        found.gap = std::max(found.gap, pole.gap);
      }
    return true;
  };
  std::vector<StartPair> others;
  others.reserve(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (!going_on[i] || !is_settled(pairs[i], *going_on[i])) others.push_back(pairs[i]);
  pairs = std::move(others);
  return found;
}

void add(const NeighbourContacts& neighbours, PairSearchResult& found) {
  found.arcs.insert(found.arcs.end(), neighbours.arcs.begin(), neighbours.arcs.end());
  found.corner_contacts.insert(found.corner_contacts.end(), neighbours.corner_contacts.begin(),
                               neighbours.corner_contacts.end());
  Certificate& of = found.certificate;
  of.excluded += neighbours.certificate.excluded;
  of.depth = std::max(of.depth, neighbours.certificate.depth);
  of.rounding_bound = std::max(of.rounding_bound, neighbours.certificate.rounding_bound);
}

}  // namespace blossom
