// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/intersection/border_roots.h"

#include <algorithm>
#include <cmath>

#include "core/forms/evaluation.h"

namespace blossom {
namespace {

constexpr int kNewtonSteps = 12;
constexpr double kSettled = 1e-14;  // a Newton step below this is rounding; fraction of a patch
constexpr double kStalled = 1e-10;  // so is one below this that no longer shrinks: ill conditioned
constexpr double kBorderSlack = 4e-11;  // a root this close to a face is on it; fraction of a patch
constexpr int kKrawczykSteps = 16;
constexpr int kFirstSteps = 3;  // of them before Newton's method where no root is expected
constexpr int kModelSteps = 4;
constexpr int kModelSamples = 5;
constexpr double kSlidingSlack = 0.02;   // the same, of an arc that runs along a face
constexpr double kModelSlack = 0.1;      // of a pair, that a root of its model may be off
constexpr int kSlidingSamples = 9;       // points of an arc that must all lie on a face
constexpr double kTangentToFace = 1e-6;  // slower than this across a face means undecided

struct Root {
  Point4 x;
  Point4 tangent;  // in the cells' own parameters
};

using Columns = std::array<Vec3, 4>;

Columns jacobian(const PatchJet& a, const PatchJet& b) { return {a.u, a.v, -b.u, -b.v}; }

// Solves M y = r by Cramer's rule; nothing if M is singular.
std::optional<Vec3> solve(const Vec3& c0, const Vec3& c1, const Vec3& c2, const Vec3& r) {
  const Vec3 n = cross(c1, c2);
  const double d = dot(c0, n);
  if (d == 0 || !std::isfinite(1 / d)) return std::nullopt;
  return Vec3{dot(r, n) / d, dot(c0, cross(r, c2)) / d, dot(c0, cross(c1, r)) / d};
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

// Of a column among those that a minor keeps.
std::size_t position(const std::array<int, 3>& kept, int column) {
  return static_cast<std::size_t>(std::find(kept.begin(), kept.end(), column) - kept.begin());
}

enum class Found { Empty, Root, Undecided };

// Of the box of a pair: where one of the four parameters has its lowest or highest value.
struct BoxFace {
  int axis;
  bool high;
};

std::size_t index(int axis) { return static_cast<std::size_t>(axis); }

class PairBorder {
 public:
  PairBorder(const CellTree& tree_a, const Cell& a, const CellTree& tree_b, const Cell& b,
             const JacobianBounds& bounds)
      : tree_a_(tree_a), a_(a), tree_b_(tree_b), b_(b), bounds_(bounds), box_(box_of(a, b)) {
    const Point4 x = middle_of_box().middle;
    middle_a_ = jet_at(tree_a_.patch(), x[0], x[1], 2);
    middle_b_ = jet_at(tree_b_.patch(), x[2], x[3], 2);
  }

  // All roots on the eight faces; false if some face stays undecided. Faces along which the arc
  // itself runs have no roots of their own.
  bool find(std::vector<Root>& roots, int along) {
    std::vector<BoxFace> met;
    for (int axis = 0; axis < 4; ++axis)
      for (const bool high : {false, true})
        if (!apart({axis, high})) met.push_back({axis, high});
    minors_[index(along)] = bounds_.minor(along);
    for (const BoxFace& face : met)
      if (auto& minor = minors_[index(face.axis)]; !minor) minor = bounds_.minor(face.axis);
    // What fails most comes first: faces that may hold more than one root.
    std::stable_partition(met.begin(), met.end(),
                          [&](const BoxFace& face) { return !minors_[index(face.axis)]->regular; });
    std::vector<Point4> points;
    for (const BoxFace& face : met) {
      Point4 x;
      const Found found = decide(face, x);
      if (found == Found::Root) points.push_back(x);
      if (found != Found::Undecided) continue;
      if (face.axis == along || !slides_along(face, along)) return false;
      sliding_[index(face.axis)][face.high] = true;
    }
    return std::all_of(points.begin(), points.end(),
                       [&](const Point4& x) { return add(roots, x, along); });
  }

  // Does the arc run on inside the box in the direction `sign` of its tangent?
  bool enters(const Root& root, double sign) const {
    for (std::size_t i = 0; i < 4; ++i) {
      const double rate = sign * root.tangent[i];
      if (at_face(root.x, i, false) && rate < 0) return false;
      if (at_face(root.x, i, true) && rate > 0) return false;
    }
    return true;
  }

  bool slides() const {
    return std::any_of(sliding_.begin(), sliding_.end(),
                       [](const auto& s) { return s[0] || s[1]; });
  }

  // An arc along an upper border belongs to the neighbour, if there is one.
  bool belongs_elsewhere(const SurfaceBorders& borders) const {
    for (std::size_t i = 0; i < 4; ++i)
      if (sliding_[i][1] && !borders.high[i]) return true;
    return false;
  }

  // True if the arc runs along a border that is one point in space: the pole of a sphere.
  bool stays_at_pole(const CellArc& arc) const {
    Point4 middle;
    for (std::size_t i = 0; i < 4; ++i) middle[i] = 0.5 * (arc.from[i] + arc.to[i]);
    const auto point = [&](const Point4& x) { return point_at(tree_a_.patch(), x[0], x[1]); };
    const Vec3 start = point(arc.from);
    const double reach = std::max(distance(start, point(middle)), distance(start, point(arc.to)));
    return slides() && reach <= 16 * std::max(a_.margin, b_.margin);
  }

 private:
  // Part of the box: its middle, and half its widths as parts of the cells' for the kept columns.
  struct Part {
    Point4 middle;
    std::array<double, 3> radius{0.5, 0.5, 0.5};
  };

  // Of the arc, at one value of its parameter.
  struct ArcSample {
    std::optional<Part> part;  // where it may be; nothing if it is not there
    std::optional<Point4> point;
  };

  double place_of(const BoxFace& face) const {
    const Interval& range = box_[index(face.axis)];
    return face.high ? range.to : range.from;
  }

  // True if the border curve of its cell proves that the face holds no root.
  bool apart(const BoxFace& face) const {
    return face.axis < 2 ? border_apart(border_of(a_, tree_a_.shape(), face.axis == 0, face.high),
                                        a_.margin, b_)
                         : border_apart(border_of(b_, tree_b_.shape(), face.axis == 2, face.high),
                                        b_.margin, a_);
  }

  Found decide(const BoxFace& face, Point4& root) const {
    const int axis = face.axis;
    const Minor& minor = *minors_[index(axis)];
    if (!minor.regular) return Found::Undecided;
    Part part = middle_of_box();
    // Most faces hold no root: the mean value over the pair tells of many, the first steps of more.
    part.middle[index(axis)] = place_of(face);
    if (!narrow_by_mean_value(part, minor, face)) return Found::Empty;
    int step = 0;
    if (const auto start = model_root(part, axis); start && newton_to(root, *start, axis))
      return Found::Root;
    for (; step < kFirstSteps; ++step)
      if (!narrow(part, minor, axis)) return Found::Empty;
    if (newton_to(root, part.middle, axis)) return Found::Root;
    for (; step < kKrawczykSteps; ++step)
      if (!narrow(part, minor, axis)) return Found::Empty;
    return Found::Undecided;
  }

  // The minor is regular, so there is at most one root: found means done.
  bool newton_to(Point4& root, const Point4& start, int axis) const {
    const auto solution = newton(tree_a_.patch(), tree_b_.patch(), start, axis, box_);
    if (!solution || !inside(*solution)) return false;
    root = *solution;
    return true;
  }

  // A point near the root, if there seems to be one: where the quadratic polynomials that touch
  // the surfaces at the middles of the cells meet.
  std::optional<Point4> model_root(const Part& part, int axis) const {
    const auto kept = kept_columns(axis);
    const Point4 middle = middle_of_box().middle;
    Point4 x = part.middle;
    for (int step = 0; step < kModelSteps; ++step) {
      const PatchJet a = model_at(middle_a_, x[0] - middle[0], x[1] - middle[1]);
      const PatchJet b = model_at(middle_b_, x[2] - middle[2], x[3] - middle[3]);
      const Columns j = jacobian(a, b);
      const auto column = [&](std::size_t i) { return j[static_cast<std::size_t>(kept[i])]; };
      const auto delta = solve(column(0), column(1), column(2), a.point - b.point);
      if (!delta) return std::nullopt;
      for (int i = 0; i < 3; ++i)
        x[static_cast<std::size_t>(kept[static_cast<std::size_t>(i)])] -= (*delta)[i];
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const double slack = kModelSlack * length(box_[i]);
      if (!(x[i] >= box_[i].from - slack && x[i] <= box_[i].to + slack)) return std::nullopt;
    }
    return x;
  }

  static PatchJet model_at(const PatchJet& m, double u, double v) {
    const Vec3 by_u = u * m.uu + v * m.uv, by_v = u * m.uv + v * m.vv;
    return {m.point + u * m.u + v * m.v + 0.5 * (u * by_u + v * by_v),
            m.u + by_u,
            m.v + by_v,
            {},
            {},
            {}};
  }

  // False if the models of the surfaces meet somewhere in the box away from the face, or hardly at
  // all: then the pair is halved, where the models are better.
  bool may_slide(const BoxFace& face, int along) const {
    int met = 0;
    for (int i = 0; i < kModelSamples; ++i) {
      Part part = middle_of_box();
      part.middle[index(along)] = at(box_[index(along)], (i + 0.5) / kModelSamples);
      const auto x = model_root(part, along);
      if (!x) continue;
      const double off = std::abs((*x)[index(face.axis)] - place_of(face));
      if (off > kSlidingSlack * length(box_[index(face.axis)])) return false;
      ++met;
    }
    return met > 1;
  }

  // True if the box meets the arc, and only along the given face.
  bool slides_along(const BoxFace& face, int along) {
    if (!may_slide(face, along)) return false;
    const std::size_t column = position(kept_columns(along), face.axis);
    const double place = place_of(face), width = length(box_[index(face.axis)]);
    int on_face = 0;
    for (int i = 0; i < kSlidingSamples; ++i) {
      const ArcSample& sample = arc_sample(i, along);
      if (!sample.point) continue;
      const double off = std::abs(sample.part->middle[index(face.axis)] - place);
      if (off > sample.part->radius[column] * width + kBorderSlack ||
          std::abs((*sample.point)[index(face.axis)] - place) > kBorderSlack)
        return false;
      ++on_face;
    }
    return on_face > 1;
  }

  // Samples are made when first asked for, beginning in the middle: one off the face is enough.
  const ArcSample& arc_sample(int i, int along) {
    auto& sample = samples_[static_cast<std::size_t>(i)];
    if (sample) return *sample;
    sample.emplace();
    const int place = (kSlidingSamples / 2 + (i % 2 == 0 ? i / 2 : -(i + 1) / 2));
    Part part = middle_of_box();
    part.middle[index(along)] = at(box_[index(along)], (place + 0.5) / kSlidingSamples);
    if (!narrow(part, *minors_[index(along)], along)) return *sample;
    sample->part = part;
    sample->point = newton(tree_a_.patch(), tree_b_.patch(), part.middle, along, box_);
    if (sample->point && !inside(*sample->point)) sample->point.reset();
    return *sample;
  }

  bool at_face(const Point4& x, std::size_t i, bool high) const {
    return !sliding_[i][high] && std::abs(x[i] - (high ? box_[i].to : box_[i].from)) <= kSamePoint;
  }

  bool inside(const Point4& x) const {
    for (std::size_t i = 0; i < 4; ++i)
      if (x[i] < box_[i].from - kBorderSlack || x[i] > box_[i].to + kBorderSlack) return false;
    return true;
  }

  Vec3 on_a_at(const Point4& x) const { return point_at(tree_a_.patch(), x[0], x[1]); }
  Vec3 on_b_at(const Point4& x) const { return point_at(tree_b_.patch(), x[2], x[3]); }

  Part middle_of_box() const {
    Part part;
    for (std::size_t i = 0; i < 4; ++i) part.middle[i] = at(box_[i], 0.5);
    return part;
  }

  bool narrow(Part& part, const Minor& minor, int axis) const {
    return narrow(part, minor, axis, on_a_at(part.middle) - on_b_at(part.middle), rounding());
  }

  // The same for a face, from what is known at the middle of the pair: there F differs from its
  // value at the middle of the face by half of column `axis` of J somewhere between.
  bool narrow_by_mean_value(Part& part, const Minor& minor, const BoxFace& face) const {
    const VectorBounds& column = bounds_.column(face.axis);
    const Vec3 step = (face.high ? 0.5 : -0.5) * column.middle;
    return narrow(part, minor, face.axis, middle_a_.point - middle_b_.point + step,
                  0.5 * column.radius + 1e-15 * absolute(step) + rounding());
  }

  // Of F at a point: of sums over both directions, and the quotient by the weight.
  Vec3 rounding() const {
    const auto of = [](const CellTree& tree) {
      const NetShape& shape = tree.shape();
      return (evaluation_error(shape.rows) + evaluation_error(shape.columns)) * tree.scale();
    };
    const double r = of(tree_a_) + of(tree_b_);
    return {r, r, r};
  }

  // Any root in the box Y with middle y and radius r lies in y - C F(y) +- E r too, with F(y) in
  // f +- error. False if that does not meet Y, which has no root then.
  bool narrow(Part& part, const Minor& minor, int axis, const Vec3& f, const Vec3& error) const {
    const auto kept = kept_columns(axis);
    std::array<double, 3> next_radius{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto k = index(kept[i]);
      const double width = length(box_[k]);
      double shift = 0, spread = 0;
      for (std::size_t j = 0; j < 3; ++j) {
        const auto l = static_cast<int>(j);
        shift += minor.inverse[i][j] * f[l];
        spread += minor.spread[i][j] * part.radius[j] + std::abs(minor.inverse[i][j]) * error[l];
      }
      spread = spread * (1 + 1e-12) + 1e-14;
      const double middle = (part.middle[k] - box_[k].from) / width;
      const double low = std::max(middle - shift - spread, middle - part.radius[i]);
      const double high = std::min(middle - shift + spread, middle + part.radius[i]);
      if (low > high) return false;
      part.middle[k] = box_[k].from + 0.5 * (low + high) * width;
      next_radius[i] = 0.5 * (high - low);
    }
    part.radius = next_radius;
    return true;
  }

  // False if the arc is too nearly tangent to a face it meets here.
  bool add(std::vector<Root>& roots, const Point4& x, int along) const {
    for (const Root& known : roots) {
      double gap = 0;
      for (std::size_t i = 0; i < 4; ++i) gap = std::max(gap, std::abs(known.x[i] - x[i]));
      if (gap < kSamePoint) return true;
    }
    Root root{x, tangent_at(tree_a_.patch(), tree_b_.patch(), x, along)};
    double largest = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      root.tangent[i] /= length(box_[i]);
      largest = std::max(largest, std::abs(root.tangent[i]));
    }
    if (!(largest > 0)) return false;
    for (std::size_t i = 0; i < 4; ++i) {
      root.tangent[i] /= largest;
      if ((at_face(x, i, false) || at_face(x, i, true)) &&
          std::abs(root.tangent[i]) < kTangentToFace)
        return false;
    }
    roots.push_back(root);
    return true;
  }

  const CellTree& tree_a_;
  const Cell& a_;
  const CellTree& tree_b_;
  const Cell& b_;
  const JacobianBounds& bounds_;
  Box4 box_;
  PatchJet middle_a_, middle_b_;  // at the middles of both cells
  std::array<std::optional<Minor>, 4> minors_;
  std::array<std::array<bool, 2>, 4> sliding_{};  // by parameter, low and high face
  std::array<std::optional<ArcSample>, kSlidingSamples> samples_;
};

}  // namespace

Box4 box_of(const Cell& a, const Cell& b) { return {a.u, a.v, b.u, b.v}; }

std::optional<Point4> newton(const RationalBezierPatch& a, const RationalBezierPatch& b,
                             const Point4& start, int fixed, const Box4& box) {
  const auto kept = kept_columns(fixed);
  Point4 x = start;
  double last_step = 0;
  for (int step = 0; step < kNewtonSteps; ++step) {
    const PatchJet ja = jet_at(a, x[0], x[1], 1), jb = jet_at(b, x[2], x[3], 1);
    const Columns j = jacobian(ja, jb);
    const auto column = [&](int i) {
      return j[static_cast<std::size_t>(kept[static_cast<std::size_t>(i)])];
    };
    const auto delta = solve(column(0), column(1), column(2), ja.point - jb.point);
    if (!delta) return std::nullopt;
    double largest = 0;
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(kept[static_cast<std::size_t>(i)]);
      const double width = length(box[k]);
      x[k] -= (*delta)[i];
      if (!(x[k] > box[k].from - 0.5 * width && x[k] < box[k].to + 0.5 * width))
        return std::nullopt;
      largest = std::max(largest, std::abs((*delta)[i]));
    }
    // Steps shrink quadratically: the next one would be this times the square of the ratio.
    const double ratio = step == 0 ? 1 : largest / last_step;
    if (largest * ratio * ratio < kSettled || (largest < kStalled && ratio > 0.25)) return x;
    last_step = largest;
  }
  return std::nullopt;
}

Point4 tangent_at(const RationalBezierPatch& a, const RationalBezierPatch& b, const Point4& x,
                  int along) {
  const Columns j = jacobian(jet_at(a, x[0], x[1], 1), jet_at(b, x[2], x[3], 1));
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

std::optional<PairArcs> arcs_in(const CellTree& tree_a, const Cell& a, const CellTree& tree_b,
                                const Cell& b, const JacobianBounds& bounds,
                                const SurfaceBorders& borders, int along) {
  PairBorder border(tree_a, a, tree_b, b, bounds);
  std::vector<Root> roots;
  if (!border.find(roots, along)) return std::nullopt;
  const auto k = static_cast<std::size_t>(along);
  std::sort(roots.begin(), roots.end(),
            [k](const Root& p, const Root& q) { return p.x[k] < q.x[k]; });
  PairArcs found;
  bool open = false;
  for (const Root& root : roots) {
    const bool starts = border.enters(root, 1), stops = border.enters(root, -1);
    if (starts && stops) return std::nullopt;
    if (!starts && !stops) {
      found.grazes.push_back(root.x);
      continue;
    }
    if (starts == open) return std::nullopt;
    Point4 direction{};
    direction[k] = 1;
    if (starts)
      found.arcs.push_back({root.x, root.x, direction, border.slides(), false});
    else
      found.arcs.back().to = root.x;
    open = starts;
  }
  if (open) return std::nullopt;
  if (border.belongs_elsewhere(borders)) found.arcs.clear();
  // What meets the other surface in nothing but its pole still meets it.
  std::erase_if(found.arcs, [&](const CellArc& arc) {
    const bool point = border.stays_at_pole(arc);
    if (point) found.grazes.push_back(arc.from);
    return point;
  });
  found.along_border = border.slides() && !found.arcs.empty();
  return found;
}

}  // namespace blossom
