// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/pairs/border_roots.h"

#include <algorithm>
#include <cmath>

#include "core/base/unbounded.h"
#include "core/cells/pair_model.h"
#include "core/forms/evaluation.h"
#include "core/math/index.h"
#include "core/surfaces/gap/newton.h"
#include "core/surfaces/pairs/arc_bend.h"
#include "core/surfaces/pairs/arc_stretches.h"

namespace blossom {
namespace {

constexpr double kBorderSlack = 4e-11;  // a root this close to a face is on it; fraction of a patch
constexpr int kKrawczykSteps = 16;
constexpr int kFirstSteps = 3;           // of them before Newton's method
constexpr double kAlongSlack = 0.02;     // of a cell, from the face that an arc may run along
constexpr double kPartSlack = 1e-9;      // a root this close to a part is in it; of a cell
constexpr double kSumSlack = 1e-12;      // covers the rounding of places in a cell
constexpr double kTangentToFace = 1e-6;  // slower than this across a face means undecided
constexpr double kRootNoise = 1e-13;     // of a root at least; fraction of a patch

struct Root {
  Point4 x;
  Point4 noise;    // bounds on the rounding of its parameters
  Point4 tangent;  // in the cells' own parameters
};

// The kernel of J, with `along` growing.
Point4 tangent_of(const JacobianColumns& j, int along) {
  Point4 tangent{};
  for (int k = 0; k < 4; ++k) {
    const auto kept = kept_columns(k);
    const auto column = [&](std::size_t i) { return j[static_cast<std::size_t>(kept[i])]; };
    const double minor = dot(column(0), cross(column(1), column(2)));
    tangent[static_cast<std::size_t>(k)] = k % 2 == 0 ? minor : -minor;
  }
  if (tangent[static_cast<std::size_t>(along)] < 0)
    for (double& t : tangent) t = -t;
  return tangent;
}

// The points of a cell's border: the first or last row or column of its net.
struct Border {
  std::array<double, 3 * (kMaxDegree + 1)> points;
  int count = 0;
};

Border border_of(const Cell& cell, const NetShape& shape, bool across_u, bool high) {
  Border border;
  border.count = across_u ? shape.columns : shape.rows;
  const int step = across_u ? 1 : shape.columns;
  const int first = !high ? 0 : across_u ? (shape.rows - 1) * shape.columns : shape.columns - 1;
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < border.count; ++i)
      border.points[static_cast<std::size_t>(k * border.count + i)] =
          cell.hull[k * shape.plane_size() + first + i * step];
  return border;
}

bool outside(double low, double high, double other_low, double other_high) {
  return low > other_high || high < other_low;
}

// True if the border curve of one cell proves not to meet the other cell.
bool border_apart(const Border& border, double margin, const Cell& other) {
  const double* p = border.points.data();
  const int n = border.count;
  for (int k = 0; k < 3; ++k) {
    const auto [low, high] = std::minmax_element(p + k * n, p + (k + 1) * n);
    if (outside(*low - margin, *high + margin, other.low[k], other.high[k])) return true;
  }
  const Vec3& normal = other.plane.normal;
  double low = 0, high = 0;
  for (int i = 0; i < n; ++i) {
    const double h = normal[0] * p[i] + normal[1] * p[i + n] + normal[2] * p[i + 2 * n];
    low = i == 0 ? h : std::min(low, h);
    high = i == 0 ? h : std::max(high, h);
  }
  return outside(low - 2 * margin, high + 2 * margin, other.plane.low, other.plane.high);
}

// Of the box of a pair: where one of the four parameters has its lowest or highest value.
struct BoxFace {
  int axis;
  bool high;
};

class PairBorder {
 public:
  PairBorder(const CellTree& tree_a, const Cell& a, const CellTree& tree_b, const Cell& b,
             const JacobianBounds& bounds, int along)
      : tree_a_(tree_a),
        a_(a),
        tree_b_(tree_b),
        b_(b),
        along_(along),
        graph_(bounds.minor(along)),
        box_(box_of(a, b)) {}

  // All roots on the eight faces; false if some face stays undecided. Faces along which the arc
  // itself runs have no roots of their own.
  bool find(std::vector<Root>& roots) {
    std::vector<BoxFace> met;
    for (int axis = 0; axis < 4; ++axis)
      for (const bool high : {false, true})
        if (!are_disjoint({axis, high})) met.push_back({axis, high});
    if (met.empty()) return true;
    model_.emplace(tree_a_, a_, tree_b_, b_);
    if (model_->are_disjoint(0)) return true;
    arc_.emplace(*model_, along_);
    std::vector<Point4> points;
    // What fails most comes first: faces that may hold more than one root.
    if (const ArcStretch& all = arc_->stretch(1); !all.empty)
      std::stable_partition(met.begin(), met.end(), [&](const BoxFace& face) {
        return face.axis != along_ && !all.bounds->minor(face.axis).regular;
      });
    for (const BoxFace& face : met) {
      const std::size_t before = points.size();
      if (face.axis == along_ ? decide_end(face, points) : decide(face, 1, points)) {
        met_[index(face.axis)][face.high] = points.size() > before;
        continue;
      }
      if (face.axis == along_) return false;
      points.resize(before);
      if (touches(face, points)) continue;
      points.resize(before);
      if (!runs_along(face)) return false;
      sliding_[index(face.axis)][face.high] = true;
    }
    return std::ranges::all_of(points, [&](const Point4& x) { return add(roots, x); });
  }

  // Does the arc run on inside the box in the direction `sign` of its tangent?
  bool enters(const Root& root, double sign) const {
    for (std::size_t i = 0; i < 4; ++i)
      for (const bool high : {false, true}) {
        if (!at_face(root, i, high)) continue;
        const double inward =
            is_touch(root, i, high) ? touch_[i][high] : (high ? -sign : sign) * root.tangent[i];
        if (inward < 0) return false;
      }
    return true;
  }

  bool runs_along_border() const {
    return std::any_of(sliding_.begin(), sliding_.end(),
                       [](const auto& s) { return s[0] || s[1]; });
  }

  // Where an arc that seems to run along a face, but bends away from it, is nearest to it.
  const std::optional<Point4>& touch() const { return nearest_; }

  // The border that the arcs run along and a neighbour has, too: an upper one if there is.
  void set_shared_border(const SurfaceBorders& borders, CellArc& arc) const {
    for (std::size_t i = 0; i < 4; ++i)
      if (sliding_[i][0] || (sliding_[i][1] && !borders.high[i])) {
        arc.shared_border = static_cast<int>(i);
        arc.upper = sliding_[i][1];
        if (arc.upper) return;
      }
  }

  // True if the arc runs along a border that is one point in space: the pole of a sphere.
  bool stays_at_pole(const CellArc& arc) const {
    Point4 middle;
    for (std::size_t i = 0; i < 4; ++i) middle[i] = 0.5 * (arc.from[i] + arc.to[i]);
    const auto point = [&](const Point4& x) { return point_at(tree_a_.patch(), x[0], x[1]); };
    const Vec3 start = point(arc.from);
    const double reach = std::max(distance(start, point(middle)), distance(start, point(arc.to)));
    return runs_along_border() && reach <= 16 * std::max(a_.margin, b_.margin);
  }

 private:
  static double side_of(const BoxFace& face) { return face.high ? 0.5 : -0.5; }

  double place_of(const BoxFace& face) const {
    const Interval& range = box_[index(face.axis)];
    return face.high ? range.to : range.from;
  }

  // True if the border curve of its cell proves that the face holds no root.
  bool are_disjoint(const BoxFace& face) const {
    return face.axis < 2 ? border_apart(border_of(a_, tree_a_.shape(), face.axis == 0, face.high),
                                        a_.margin, b_)
                         : border_apart(border_of(b_, tree_b_.shape(), face.axis == 2, face.high),
                                        b_.margin, a_);
  }

  static bool off(const PairPart& part, const BoxFace& face) {
    return std::abs(part.middle[index(face.axis)] - side_of(face)) >
           part.radius[index(face.axis)] + kSumSlack;
  }

  // A face across the arc's parameter: at most one root.
  bool decide_end(const BoxFace& face, std::vector<Point4>& points) {
    const ArcStretch& all = arc_->stretch(1);
    if (all.empty) return true;
    const Minor minor = all.bounds->minor(along_);
    return decide_in(all.part, minor.regular ? minor : graph_, face, points);
  }

  // Where the arc crosses another face: stretch by stretch, until it keeps off the face or crosses
  // it one way only. False if some stretch stays undecided.
  bool decide(const BoxFace& face, std::size_t number, std::vector<Point4>& points) {
    const ArcStretch& s = arc_->stretch(number);
    if (s.empty || off(s.part, face)) return true;
    const Minor across = s.bounds->minor(face.axis);
    if (across.regular && decide_in(s.part, across, face, points)) return true;
    if (2 * number < ArcStretches::kCount)
      return decide(face, 2 * number, points) && decide(face, 2 * number + 1, points);
    if (arc_->narrow_again(number)) return decide(face, number, points);
    undecided_ = number;
    return false;
  }

  // The minor is regular in the part, so it holds at most one root on the face: found means done.
  bool decide_in(PairPart part, const Minor& minor, const BoxFace& face,
                 std::vector<Point4>& points) const {
    const PairPart all = part;
    const VectorBounds none{};
    part.middle[index(face.axis)] = side_of(face);
    part.radius[index(face.axis)] = 0;
    for (int step = 0; step < kFirstSteps; ++step)
      if (!narrow(part, minor, face.axis, none, part.middle, model_->gap(part.middle))) return true;
    if (const auto root = root_near(part, all, face.axis)) {
      points.push_back(*root);
      return true;
    }
    for (int step = 0; step < kKrawczykSteps; ++step)
      if (!narrow(part, minor, face.axis, none, part.middle, model_->gap(part.middle))) return true;
    return false;
  }

  // True if the arc touches the face in a corner of the box, where it passes another face, and
  // meets it nowhere else but in roots: over the stretch from the corner on it bends one way.
  bool touches(const BoxFace& face, std::vector<Point4>& points) {
    double inward = 0;
    for (std::size_t number = ArcStretches::kCount / 2; number < ArcStretches::kCount; ++number) {
      const ArcStretch& s = arc_->stretch(number);
      if (s.empty || off(s.part, face)) continue;
      const Minor across = s.bounds->minor(face.axis);
      if (across.regular && decide_in(s.part, across, face, points)) continue;
      const auto bend = bend_over(*model_, s, along_, face.axis);
      if (!bend || !(bend->from > 0 || bend->to < 0)) return false;
      const auto corner = touched_corner(s.part, face);
      if (!corner) return false;
      points.push_back(*corner);
      const double side = (bend->from > 0) == face.high ? -1 : 1;
      if (inward != 0 && inward != side) return false;
      inward = side;
    }
    touch_[index(face.axis)][face.high] = inward;
    met_[index(face.axis)][face.high] = true;
    return inward != 0;
  }

  // A root on another face, within the part, that is one on this face, too, across which the arc
  // hardly moves there.
  std::optional<Point4> touched_corner(const PairPart& part, const BoxFace& face) const {
    for (int axis = 0; axis < 4; ++axis)
      for (const bool high : {false, true}) {
        if (axis == face.axis || off(part, {axis, high})) continue;
        PairPart start = part;
        start.middle[index(axis)] = side_of({axis, high});
        const auto x = root_near(start, part, axis);
        if (!x || leaves(*x, face.axis)) continue;
        const double distance = std::abs((*x)[index(face.axis)] - place_of(face));
        if (distance <= noise_at(*x)[index(face.axis)]) return x;
      }
    return std::nullopt;
  }

  // Whether the arc meets a face there as `touches` found.
  bool is_touch(const Root& root, std::size_t i, bool high) const {
    return touch_[i][high] != 0 && std::abs(root.tangent[i]) < kTangentToFace;
  }

  // The root on a face that Newton's method finds, if it is in the part.
  std::optional<Point4> root_near(const PairPart& start, const PairPart& part, int axis) const {
    auto x = newton(tree_a_.patch(), tree_b_.patch(), model_->parameters(start.middle), axis, box_);
    if (!x || !inside(*x)) return std::nullopt;
    std::optional<Point4> noise;
    for (std::size_t i = 0; i < 4; ++i) {
      const double z = ((*x)[i] - at(box_[i], 0.5)) / length(box_[i]);
      const double off = std::abs(z - part.middle[i]) - part.radius[i];
      if (off <= kPartSlack + kBorderSlack / length(box_[i])) continue;
      if (!noise) noise = noise_at(*x);
      if (off > (*noise)[i] / length(box_[i])) return std::nullopt;
    }
    return x;
  }

  // True if the box meets the arc, and only along the given face, as far as points of it tell.
  bool runs_along(const BoxFace& face) {
    const PairPart& last = arc_->stretch(undecided_).part;
    if (std::abs(last.middle[index(face.axis)] - side_of(face)) > kAlongSlack) return false;
    for (std::size_t number = ArcStretches::kCount / 2; number < ArcStretches::kCount; ++number)
      if (const ArcStretch& s = arc_->stretch(number); !s.empty && off(s.part, face)) return false;
    int on_face = 0;
    double least = 2 * kSamePoint;
    Interval slopes{kUnbounded, -kUnbounded};
    for (std::size_t number = ArcStretches::kCount / 2; number < ArcStretches::kCount; ++number) {
      const ArcStretch& s = arc_->stretch(number);
      if (s.empty) continue;
      const auto x =
          newton(tree_a_.patch(), tree_b_.patch(), model_->parameters(s.part.middle), along_, box_);
      if (!x) return false;
      if (!inside(*x)) continue;
      const double slack = std::max(kBorderSlack, noise_at(*x)[index(face.axis)]);
      const double distance = std::abs((*x)[index(face.axis)] - place_of(face));
      if (distance > slack || leaves(*x, face.axis)) return false;
      ++on_face;
      const Point4 t = tangent_of(jacobian_at(*x), along_);
      const double slope = t[index(face.axis)] / t[index(along_)];
      slopes = {std::min(slopes.from, slope), std::max(slopes.to, slope)};
      if (distance >= least) continue;
      least = distance;
      nearest_ = *x;
    }
    if (length(slopes) * length(box_[index(along_)]) <= kRootNoise) nearest_.reset();
    return on_face > 1;
  }

  // True if the arc moves across a face as seen in the box: within a tiny one it may stay near all
  // the same.
  bool leaves(const Point4& x, int across) const {
    const Point4 t = tangent_of(jacobian_at(x), along_);
    return std::abs(t[index(across)]) * length(box_[index(along_)]) >
           kTangentToFace * std::abs(t[index(along_)]) * length(box_[index(across)]);
  }

  // True if the face is no farther along the arc than one point is large, in any parameter: an arc
  // that comes to a face slowly crosses it far from where it is near.
  bool at_face(const Root& root, std::size_t i, bool high) const {
    const double off = std::abs(root.x[i] - (high ? box_[i].to : box_[i].from));
    if (sliding_[i][high] || off > kSamePoint) return false;
    // An arc that hardly moves across a face and is proven not to meet it runs beside it.
    if (!met_[i][high] && std::abs(root.tangent[i]) < kTangentToFace) return false;
    return off <= root.noise[i] || off * speed(root) <= kSamePoint * rate(root, i);
  }

  // Of a root's parameters along the arc, and of the fastest one. At a pole parameters move where
  // points do not.
  double rate(const Root& root, std::size_t i) const {
    return std::abs(root.tangent[i]) * length(box_[i]);
  }

  double speed(const Root& root) const {
    double largest = 0;
    for (std::size_t i = 0; i < 4; ++i)
      if (root.noise[i] < kSamePoint) largest = std::max(largest, rate(root, i));
    return largest;
  }

  // True if the arc passes outside of the box there and crosses its face elsewhere.
  bool beyond(const Root& root) const {
    for (std::size_t i = 0; i < 4; ++i)
      for (const bool high : {false, true}) {
        const double off = high ? root.x[i] - box_[i].to : box_[i].from - root.x[i];
        if (off > 0 && !sliding_[i][high] && !at_face(root, i, high)) return true;
      }
    return false;
  }

  bool inside(const Point4& x) const {
    const auto off = [&](std::size_t i) {
      return std::max(box_[i].from - x[i], x[i] - box_[i].to);
    };
    const double worst = std::max({off(0), off(1), off(2), off(3)});
    if (worst <= kBorderSlack || worst > kSamePoint) return worst <= kBorderSlack;
    const Point4 noise = noise_at(x);
    for (std::size_t i = 0; i < 4; ++i)
      if (off(i) > std::max(kBorderSlack, noise[i])) return false;
    return true;
  }

  JacobianColumns jacobian_at(const Point4& x) const {
    return jacobian_columns(jet_at(tree_a_.patch(), x[0], x[1], 1),
                            jet_at(tree_b_.patch(), x[2], x[3], 1));
  }

  Point4 noise_at(const Point4& x) const { return noise_of(jacobian_at(x)); }

  // A parameter is known to the rounding of points by the speed at which they move with it: near a
  // pole hardly at all.
  Point4 noise_of(const JacobianColumns& j) const {
    Point4 noise;
    for (std::size_t i = 0; i < 4; ++i)
      noise[i] = std::max(kRootNoise, std::min(model_->rounding()[0] / norm(j[i]), kSamePoint));
    return noise;
  }

  // False if the arc is too nearly tangent to a face it meets here.
  bool add(std::vector<Root>& roots, const Point4& x) const {
    for (const Root& known : roots) {
      double gap = 0;
      for (std::size_t i = 0; i < 4; ++i) gap = std::max(gap, std::abs(known.x[i] - x[i]));
      if (gap < kSamePoint) return true;
    }
    const JacobianColumns j = jacobian_at(x);
    Root root{x, noise_of(j), tangent_of(j, along_)};
    double largest = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      root.tangent[i] /= length(box_[i]);
      largest = std::max(largest, std::abs(root.tangent[i]));
    }
    if (!(largest > 0)) return false;
    for (double& t : root.tangent) t /= largest;
    if (beyond(root)) return true;
    for (std::size_t i = 0; i < 4; ++i)
      for (const bool high : {false, true})
        if (at_face(root, i, high) && std::abs(root.tangent[i]) < kTangentToFace &&
            !is_touch(root, i, high))
          return false;
    roots.push_back(root);
    return true;
  }

  const CellTree& tree_a_;
  const Cell& a_;
  const CellTree& tree_b_;
  const Cell& b_;
  const int along_;
  const Minor graph_;  // the minor that leaves `along` out
  const Box4 box_;
  std::optional<PairModel> model_;
  std::optional<ArcStretches> arc_;
  std::size_t undecided_ = 0;                     // the last stretch that was
  std::optional<Point4> nearest_;                 // to a face that the arc bends away from
  std::array<std::array<bool, 2>, 4> sliding_{};  // by parameter, low and high face
  std::array<std::array<bool, 2>, 4> met_{};      // likewise: the arc may cross the face
  // Likewise: 1 if the arc touches the face in a corner from inside, -1 from outside, 0 else.
  std::array<std::array<double, 2>, 4> touch_{};
};

}  // namespace

std::optional<PairArcs> arcs_in(const CellTree& tree_a, const Cell& a, const CellTree& tree_b,
                                const Cell& b, const JacobianBounds& bounds,
                                const SurfaceBorders& borders, int along) {
  PairBorder border(tree_a, a, tree_b, b, bounds, along);
  std::vector<Root> roots;
  if (!border.find(roots)) return std::nullopt;
  // An arc that touches the box from outside does not enter it: rounding decides whether they meet.
  if (roots.empty() && border.touch()) return PairArcs{{}, false, {*border.touch()}};
  const auto k = static_cast<std::size_t>(along);
  std::ranges::sort(roots, {}, [k](const Root& root) { return root.x[k]; });
  PairArcs found;
  bool open = false;
  for (const Root& root : roots) {
    const bool starts = border.enters(root, 1), stops = border.enters(root, -1);
    if (starts && stops) return std::nullopt;
    if (!starts && !stops) {
      found.corner_contacts.push_back(root.x);
      continue;
    }
    if (starts == open) return std::nullopt;
    Point4 direction{};
    direction[k] = 1;
    if (starts)
      found.arcs.push_back({root.x, root.x, direction, border.runs_along_border(), false});
    else
      found.arcs.back().to = root.x;
    open = starts;
  }
  if (open) return std::nullopt;
  for (CellArc& arc : found.arcs) border.set_shared_border(borders, arc);
  // What meets the other surface in nothing but its pole still meets it.
  std::erase_if(found.arcs, [&](const CellArc& arc) {
    const bool point = border.stays_at_pole(arc);
    if (point) found.corner_contacts.push_back(arc.from);
    return point;
  });
  found.along_border = border.runs_along_border() && !found.arcs.empty();
  return found;
}

}  // namespace blossom
