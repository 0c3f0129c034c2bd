// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/curves/curve_valley.h"

#include <algorithm>
#include <cmath>

#include "core/bounds/value_arithmetic.h"
#include "core/curves/limits.h"
#include "core/math/functions/convex_gap.h"

namespace blossom {
namespace {

constexpr double kNarrowCone = 0.97;  // least cosine of half cones that are worth trying
constexpr double kNearlyOne = 0.97;   // least cosine between the axes
constexpr double kMaxOf = 0.5;        // of the tolerance, at the ends of a contact
constexpr int kSolveSteps = 12;       // of Newton's method for the place with a given x
constexpr double kNearX = 1e-8;       // of a cell; of what is left third powers do not matter
// Graphs are steeper than e by an angle of which this is the secant at most, and distances shorter
// than gaps by that: cones of kNarrowCone round axes that are kNearlyOne from each other.
constexpr double kSteep = 1.2;

// One graph's value, slope and curvature over x.
struct GraphPoint {
  double t = 0;
  double x = 0, y = 0;
  double slope = 0, bend = 0;
  double rate = 1;  ///< of x by t
  double turn = 0;  ///< of the rate by t
};

class Valley {
 public:
  Valley(const CurvePair& pair, double tolerance, double longest)
      : pair_(pair), tolerance_(tolerance), longest_(longest), error_(pair.margin()) {}

  std::optional<ValleyPoints> points() {
    if (!make_frame() || !make_range()) return std::nullopt;
    if (!(low_ < high_)) return ValleyPoints{};
    if (!bound_bend()) return std::nullopt;
    if (!is_convex()) {
      middle_ = side_at(0.5 * (low_ + high_));
      return is_monotone() && decide_crossing() ? result_ : side_of_tolerance();
    }
    half_length_ = std::sqrt(2 * (tolerance_ + error_) / least_bend_);
    // In space the third direction may still bring together what the gap keeps apart.
    const double beyond = pair_.dimension() == 2 ? 0 : tolerance_;
    const bool decided = convex_points(
        side_at(low_), side_at(high_), {tolerance_, error_, least_bend_, most_bend_, 1, beyond},
        [&](double x, const Side& near) { return side_at(x, near); },
        [&](const Side& side, bool touch) { return add(side, touch); });
    return decided ? std::optional(result_) : std::nullopt;
  }

 private:
  struct Side {
    double x, gap, slope, bend;
    GraphPoint a, b;
  };

  bool make_frame() {
    const CurveCell &a = pair_.a, &b = pair_.b;
    if (!(a.cosine > kNarrowCone && b.cosine > kNarrowCone)) return false;
    const double along = dot(a.axis, b.axis);
    if (!(std::abs(along) > kNearlyOne)) return false;
    reversed_ = along < 0;
    e_ = unit(a.axis + (reversed_ ? -b.axis : b.axis));
    if (pair_.dimension() == 2) {
      m_ = {-e_[1], e_[0], 0};
      return true;
    }
    const CurveJet ja = pair_.tree_a.jet({a.span, at(a.local, 0.5)});
    const CurveJet jb = pair_.tree_b.jet({b.span, at(b.local, 0.5)});
    const Vec3 difference = curvature(ja) - curvature(jb);
    m_ = unit(difference - e_ * dot(e_, difference));
    return !(m_ == Vec3{});
  }

  // The second derivative of the graph over e, as a vector.
  Vec3 curvature(const CurveJet& jet) const {
    const double rate = dot(e_, jet.first);
    return (jet.second - jet.first * (dot(e_, jet.second) / rate)) * (1 / (rate * rate));
  }

  // The part of x that both cells cover.
  bool make_range() {
    const auto end = [&](const CurveTree& tree, const CurveCell& cell, bool last) {
      return dot(e_, tree.jet({cell.span, last ? cell.local.to : cell.local.from}).point);
    };
    a_low_ = end(pair_.tree_a, pair_.a, false);
    a_high_ = end(pair_.tree_a, pair_.a, true);
    b_low_ = end(pair_.tree_b, pair_.b, reversed_);
    b_high_ = end(pair_.tree_b, pair_.b, !reversed_);
    low_ = std::max(a_low_, b_low_);
    high_ = std::min(a_high_, b_high_);
    return a_low_ < a_high_ && b_low_ < b_high_;
  }

  // Bounds of d2y/dx2 = (y'' - y' x'' / x') / x'^2 over a cell; nothing if x' may vanish.
  static std::optional<ValueRange> bend_range(const std::array<ValueRange, 2>& x,
                                              const std::array<ValueRange, 2>& y) {
    const double sign = x[0].low > 0 ? 1 : -1;
    const double least = std::min(sign * x[0].low, sign * x[0].high);
    const double most = std::max(sign * x[0].low, sign * x[0].high);
    if (!(least > 0)) return std::nullopt;
    const double slope = std::max(std::abs(y[0].low), std::abs(y[0].high)) / least;
    const double stretch = std::max(std::abs(x[1].low), std::abs(x[1].high));
    const double low = y[1].low - slope * stretch, high = y[1].high + slope * stretch;
    const double over_least = 1 / (least * least), over_most = 1 / (most * most);
    return ValueRange{low * (low < 0 ? over_least : over_most),
                      high * (high < 0 ? over_most : over_least)};
  }

  // Of h, seen so that it bends up where it bends one way only.
  bool bound_bend() {
    const auto bounds = [&](const CurveTree& tree, const CurveCell& cell) {
      return bend_range(tree.derivative_ranges(cell, e_), tree.derivative_ranges(cell, m_));
    };
    const auto a = bounds(pair_.tree_a, pair_.a);
    const auto b = a ? bounds(pair_.tree_b, pair_.b) : std::nullopt;
    if (!b) return false;
    ValueRange bend{a->low - b->high, a->high - b->low};
    sign_ = bend.low > 0 ? 1 : -1;
    if (sign_ < 0) bend = {-bend.high, -bend.low};
    least_bend_ = bend.low;
    most_bend_ = bend.high;
    return true;
  }

  bool is_convex() const {
    return least_bend_ > 0 && least_bend_ * longest_ * longest_ >= 8 * tolerance_;
  }

  double largest_bend() const { return std::max(std::abs(least_bend_), std::abs(most_bend_)); }

  // |h'(x)| >= |h'(c)| - most |h''| w within w of the middle c of the range: one zero at most,
  // where the cones of directions would need far smaller cells.
  bool is_monotone() {
    const double w = 0.5 * (high_ - low_);
    const double least = std::abs(middle_.slope) - largest_bend() * w;
    half_length_ = (tolerance_ + error_) / least;
    return least * w > 4 * error_ && 2 * half_length_ <= longest_;
  }

  // A zero with all of its contact inside, about; else the cells may be a part of a run.
  bool decide_crossing() {
    const Side low = side_at(low_), high = side_at(high_);
    const Side &above = low.gap > high.gap ? low : high, &below = low.gap > high.gap ? high : low;
    const double least = std::max(error_, kMaxOf * tolerance_);
    if (!(above.gap > least && below.gap < -least)) return false;
    const auto from_last = [&, last = above](double x) mutable { return last = side_at(x, last); };
    return add(zero_between(above, below, from_last, detail::kConvexNoise * error_), false);
  }

  // |h(x) - h(c)| <= |h'(c)| w + most |h''| w^2 / 2 within w of the middle c of the range.
  std::optional<ValleyPoints> side_of_tolerance() const {
    const double w = 0.5 * (high_ - low_), gap = std::abs(middle_.gap);
    const double change = std::abs(middle_.slope) * w + 0.5 * largest_bend() * w * w;
    if (gap - change > kSteep * tolerance_ + error_) return ValleyPoints{};
    if (pair_.dimension() != 2 || gap + change > tolerance_ - error_) return std::nullopt;
    const Side low = side_at(low_), high = side_at(high_);
    ValleyPoints result;
    result.contact = true;
    result.a = stretch(low.a.t, high.a.t, pair_.a);
    result.b = stretch(low.b.t, high.b.t, pair_.b);
    return result;
  }

  // Between two parameters and a little beyond, so that stretches of neighbours meet: seen along
  // axes of their own they end where points within tolerance of each other are apart.
  Interval stretch(double from, double to, const CurveCell& cell) const {
    const double slack =
        length(cell.local) * std::max(detail::kConvexBorder, 4 * tolerance_ / cell.extent);
    return {std::max(cell.local.from, std::min(from, to) - slack),
            std::min(cell.local.to, std::max(from, to) + slack)};
  }

  GraphPoint graph(const CurveTree& tree, int span, double t) const {
    const CurveJet jet = tree.jet({span, t});
    const double rate = dot(e_, jet.first);
    GraphPoint point{t,    dot(e_, jet.point), dot(m_, jet.point), dot(m_, jet.first) / rate, 0,
                     rate, dot(e_, jet.second)};
    point.bend = (dot(m_, jet.second) - point.slope * point.turn) / (rate * rate);
    return point;
  }

  // The point of a graph at x, from a guess by Newton's method kept inside the cell; what is left
  // of the equation for x moves value and slope along the graph.
  GraphPoint graph_at(const CurveTree& tree, const CurveCell& cell, double width, double x,
                      double t) const {
    const double near = kNearX * width;
    for (int k = 0;; ++k) {
      GraphPoint point = graph(tree, cell.span, t);
      const double rest = x - point.x;
      const double next = std::clamp(t + rest / point.rate, cell.local.from, cell.local.to);
      if (std::abs(rest) > near && next != t && k < kSolveSteps) {
        t = next;
        continue;
      }
      point.t = next;
      point.x = x;
      point.y += rest * (point.slope + 0.5 * rest * point.bend);
      point.slope += rest * point.bend;
      return point;
    }
  }

  // The parameter at x by the chord of the graph, and by Taylor's polynomial at another place.
  static double guess(const CurveCell& cell, double x_from, double x_to, double x) {
    return at(cell.local, std::clamp((x - x_from) / (x_to - x_from), 0.0, 1.0));
  }
  static double guess(const CurveCell& cell, const GraphPoint& near, double x) {
    const double step = (x - near.x) / near.rate;
    const double t = near.t + step * (1 - 0.5 * step * near.turn / near.rate);
    return std::clamp(t, cell.local.from, cell.local.to);
  }

  // The gap over x, as a convex function.
  Side side_at(double x) const {
    const double t =
        reversed_ ? guess(pair_.b, b_high_, b_low_, x) : guess(pair_.b, b_low_, b_high_, x);
    return side_at(x, guess(pair_.a, a_low_, a_high_, x), t);
  }
  Side side_at(double x, const Side& near) const {
    return side_at(x, guess(pair_.a, near.a, x), guess(pair_.b, near.b, x));
  }
  Side side_at(double x, double guess_a, double guess_b) const {
    Side side;
    side.x = x;
    side.a = graph_at(pair_.tree_a, pair_.a, a_high_ - a_low_, x, guess_a);
    side.b = graph_at(pair_.tree_b, pair_.b, b_high_ - b_low_, x, guess_b);
    side.gap = sign_ * (side.a.y - side.b.y);
    side.slope = sign_ * (side.a.slope - side.b.slope);
    side.bend = std::clamp(sign_ * (side.a.bend - side.b.bend), least_bend_, most_bend_);
    return side;
  }

  // The distance in all directions at a place; false if the curves part there in the third one.
  bool add(const Side& side, bool touch) {
    ValleyPoint point;
    point.foot = foot_at(pair_, {pair_.a.span, side.a.t}, {pair_.b.span, side.b.t});
    point.touch = touch;
    const double off = pair_.dimension() == 3 ? std::abs(dot(cross(e_, m_), point.foot.gap())) : 0;
    if (off > 4 * error_) return false;
    point.gap = {0, error_ + off};
    if (touch && side.gap > error_) measure(side, point);
    point.half_length = half_length_;
    result_.points[static_cast<std::size_t>(result_.count++)] = point;
    return true;
  }

  // At the least gap over x the directions agree, but the shortest way leads along the normal, not
  // along m. Moving b's point there by gap * slope changes the distance by the square of that.
  void measure(const Side& side, ValleyPoint& point) const {
    const CurveJet& jet = point.foot.jet_b;
    const double step = dot(jet.first, point.foot.gap()) / dot(jet.first, jet.first);
    point.foot =
        foot_at(pair_, point.foot.a, {pair_.b.span, std::clamp(side.b.t + step, 0.0, 1.0)});
    const double moved = side.gap * side.b.slope;
    const double error = error_ + (most_bend_ + std::abs(side.b.bend)) * moved * moved;
    const double gap = norm(point.foot.gap());
    point.gap = {std::max(0.0, gap - error), gap + error};
  }

  const CurvePair& pair_;
  double tolerance_;
  double longest_;
  double error_;
  bool reversed_ = false;
  Vec3 e_, m_;
  double a_low_ = 0, a_high_ = 0, b_low_ = 0, b_high_ = 0;
  double low_ = 0, high_ = 0;
  double sign_ = 1;
  double least_bend_ = 0, most_bend_ = 0;
  double half_length_ = 0;  // of the runs within tolerance, about
  Side middle_{};           // where the gap is not convex
  ValleyPoints result_;
};

// A straight cell and a bent one; x is the bent one's parameter, the gap its distance from the
// line.
class LineValley {
 public:
  LineValley(const CurvePair& pair, bool line_is_a, double tolerance, double longest)
      : pair_(pair),
        line_is_a_(line_is_a),
        line_tree_(line_is_a ? pair.tree_a : pair.tree_b),
        curve_tree_(line_is_a ? pair.tree_b : pair.tree_a),
        line_(line_is_a ? pair.a : pair.b),
        curve_(line_is_a ? pair.b : pair.a),
        tolerance_(tolerance),
        longest_(longest),
        degree_(curve_.points - 1) {
    const Vec3& e = line_.axis;
    normal_ = {-e[1], e[0], 0};
    level_ = 0.5 * (line_.across.low + line_.across.high);
    start_ = e[0] * line_.hull[0] + e[1] * line_.hull[2];
    length_ = e[0] * line_.hull[1] + e[1] * line_.hull[3] - start_;
    error_ = pair.margin() + 2 * curve_.margin + 0.5 * (line_.across.high - line_.across.low);
  }

  std::optional<ValleyPoints> points() {
    const auto [slope, bend] = curve_tree_.derivative_ranges(curve_, normal_);
    const ValueRange along = curve_tree_.derivative_ranges(curve_, line_.axis)[0];
    speed_ = std::hypot(magnitude(slope), magnitude(along));
    if (!(speed_ > 0)) return std::nullopt;
    sign_ = bend.low > 0 || (!(bend.high < 0) && slope.low > 0) ? 1 : -1;
    const ValueRange bends = sign_ > 0 ? bend : ValueRange{-bend.high, -bend.low};
    least_bend_ = bends.low;
    most_bend_ = bends.high;
    for (int i = 0; i <= degree_; ++i)
      values_[i] = sign_ * (normal_[0] * curve_.hull[i] +
                            normal_[1] * curve_.hull[degree_ + 1 + i] - level_);
    const bool decided = is_convex() ? decide_convex() : decide_crossing(least_of(slope));
    return decided ? std::optional(result_) : std::nullopt;
  }

 private:
  struct Side {
    double x, gap, slope, bend;
  };

  static double least_of(const ValueRange& a) { return std::max({0.0, a.low, -a.high}); }

  // Contacts are no longer than what others do not look for.
  bool is_convex() const {
    return least_bend_ > 0 && least_bend_ * longest_ * longest_ >= 8 * tolerance_ * speed_ * speed_;
  }

  bool decide_convex() {
    half_length_ = speed_ * std::sqrt(2 * (tolerance_ + error_) / least_bend_);
    return convex_points(
        side_at(0), side_at(1), {tolerance_, error_, least_bend_, most_bend_, speed_},
        [&](double x, const Side&) { return side_at(x); },
        [&](const Side& side, bool touch) { return add(side, touch); });
  }

  // The distance only grows or only falls, and all of the contact is inside.
  bool decide_crossing(double least_slope) {
    half_length_ = speed_ * (tolerance_ + error_) / least_slope;
    if (!(least_slope > 8 * error_ && 2 * half_length_ <= longest_)) return false;
    const Side low = side_at(0), high = side_at(1);
    const double least = std::max(error_, kMaxOf * tolerance_);
    const Side &above = low.gap > high.gap ? low : high, &below = low.gap > high.gap ? high : low;
    if (!(above.gap > least && below.gap < -least)) return false;
    const auto place = [&](double x) { return side_at(x); };
    return add(zero_between(above, below, place, detail::kConvexNoise * error_), false);
  }

  Side side_at(double x) const {
    std::array<double, kMaxDegree + 1> c;
    std::copy_n(values_.begin(), degree_ + 1, c.begin());
    const double rest = 1 - x, n = degree_;
    const auto step = [&](int count) {
      for (int i = 0; i < count; ++i) c[i] = rest * c[i] + x * c[i + 1];
    };
    for (int count = degree_; count > 2; --count) step(count);
    const double bend = n * (n - 1) * (c[2] - 2 * c[1] + c[0]);
    step(2);
    return {x, rest * c[0] + x * c[1], n * (c[1] - c[0]),
            std::clamp(bend, least_bend_, most_bend_)};
  }

  // How far from a computed zero or least value an exact zero may be, by x.
  double reach(const Side& side) const {
    const double slope = std::abs(side.slope);
    if (!(least_bend_ > 0)) return 2 * error_ / slope;
    const bool simple = slope * slope > 8 * error_ * most_bend_;
    return simple ? 2 * error_ / slope : 4 * std::sqrt(error_ / least_bend_);
  }

  // What lies beyond the ends of the line is nothing: ends of curves are examined apart, and other
  // cells go on beyond an end of this one.
  bool add(const Side& side, bool touch) {
    SpanPoint on_curve{curve_.span, at(curve_.local, side.x)};
    CurveJet jet = curve_tree_.jet(on_curve);
    const double rest = dot(normal_, jet.point) - level_;
    if (!touch && std::abs(rest) > 0.5 * pair_.margin()) {  // of the cell's net, not of the curve
      const double step = rest / dot(normal_, jet.first);
      if (!(std::abs(step) <= reach(side) * length(curve_.local))) return false;
      on_curve.t = std::clamp(on_curve.t - step, 0.0, 1.0);
      jet = curve_tree_.jet(on_curve);
    }
    const double part = (dot(line_.axis, jet.point) - start_) / length_;
    const double slack = (speed_ * reach(side) + error_) / length_ + kParameterSlack;
    if (part < -slack || part > 1 + slack) return true;
    const SpanPoint on_line{line_.span, std::clamp(at(line_.local, part), 0.0, 1.0)};
    const CurveJet line_jet = line_tree_.jet(on_line);
    const CurveFoot foot = line_is_a_ ? CurveFoot{on_line, on_curve, line_jet, jet}
                                      : CurveFoot{on_curve, on_line, jet, line_jet};
    // A line may end before the place: less than the slack, but farther than the tolerance.
    if (norm(foot.gap()) > tolerance_ + 2 * error_) return false;
    ValleyPoint& point = result_.points[static_cast<std::size_t>(result_.count++)];
    point.foot = foot;
    point.touch = touch;
    const bool apart = touch && side.gap > error_;
    point.gap = {apart ? side.gap - error_ : 0, apart ? side.gap + error_ : error_};
    point.half_length = half_length_;
    return true;
  }

  const CurvePair& pair_;
  bool line_is_a_;
  const CurveTree& line_tree_;
  const CurveTree& curve_tree_;
  const CurveCell& line_;
  const CurveCell& curve_;
  double tolerance_;
  double longest_;
  int degree_;
  Vec3 normal_;
  double level_ = 0;               // of the line along the normal
  double start_ = 0, length_ = 0;  // of the line along its axis
  double error_ = 0;               // of a gap
  double speed_ = 0;               // bound on the bent cell's
  double sign_ = 1;
  double least_bend_ = 0, most_bend_ = 0;
  double half_length_ = 0;
  std::array<double, kMaxDegree + 1> values_;  // the gap's coefficients
  ValleyPoints result_;
};

}  // namespace

std::optional<ValleyPoints> line_points(const CurvePair& pair, double tolerance, double longest) {
  if (pair.dimension() != 2) return std::nullopt;
  if (pair.tree_a.curve().rational || pair.tree_b.curve().rational) return std::nullopt;
  const bool line_a = pair.a.points == 2, line_b = pair.b.points == 2;
  if (line_a == line_b || (line_a ? pair.a : pair.b).axis == Vec3{}) return std::nullopt;
  return LineValley(pair, line_a, tolerance, longest).points();
}

std::optional<ValleyPoints> valley_points(const CurvePair& pair, double tolerance, double longest) {
  return Valley(pair, tolerance, longest).points();
}

}  // namespace blossom
