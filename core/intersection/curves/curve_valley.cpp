// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/intersection/curves/curve_valley.h"

#include <algorithm>
#include <cmath>

#include "core/intersection/gap/convex_gap.h"

namespace blossom {
namespace {

constexpr double kNarrow = 0.97;     // least cosine of half cones that are worth trying
constexpr double kNearlyOne = 0.97;  // least cosine between the axes
constexpr double kMostOf = 0.5;      // of the tolerance, at the ends of a contact
constexpr int kSolveSteps = 12;      // of Newton's method for the place with a given x
constexpr double kNearX = 1e-8;      // of a cell; of what is left third powers do not matter
constexpr double kNoise = 1e-3;      // a gap this part of the bound on its error is 0
constexpr double kBorder = 1e-9;     // fraction of the range; what is this far outside counts, too
// Graphs are steeper than e by an angle of which this is the secant at most, and distances shorter
// than gaps by that: cones of kNarrow round axes that are kNearlyOne from each other.
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
    if (!decide()) return std::nullopt;
    return result_;
  }

 private:
  struct Side {
    double x, gap, slope, bend;
    GraphPoint a, b;
  };

  bool make_frame() {
    const CurveCell &a = pair_.a, &b = pair_.b;
    if (!(a.cosine > kNarrow && b.cosine > kNarrow)) return false;
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
    const double least = std::max(error_, kMostOf * tolerance_);
    return above.gap > least && below.gap < -least && add(zero(above, below), false);
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
    const double slack = length(cell.local) * std::max(kBorder, 4 * tolerance_ / cell.extent);
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

  Side zero(const Side& above, const Side& below) const {
    const auto from_last = [&, last = above](double x) mutable { return last = side_at(x, last); };
    return zero_between(above, below, from_last, kNoise * error_);
  }

  // A zero between the border `side` of the range and the least value, if there is one.
  bool add_zero(const Side& side, const Side& least) {
    if (side.gap < -error_) return true;
    if (side.gap <= error_) return add(side, false);
    return add(zero(side, least), false);
  }

  bool decide() {
    const Side low = side_at(low_), high = side_at(high_);
    const double slack = most_bend_ * kBorder * (high_ - low_);
    if (low.slope < slack && high.slope > -slack) {
      const auto from_last = [&, last = low](double x) mutable { return last = side_at(x, last); };
      const Side bottom = least_between(low, high, from_last);
      if (bottom.gap > tolerance_ + error_) return true;
      const double depth = std::max(0.0, -bottom.gap - error_);
      const bool one_point = 2 * std::sqrt(2 * depth / least_bend_) <= tolerance_;
      if (bottom.gap >= -error_ || one_point) return add(bottom, true);
      return add_zero(low, bottom) && add_zero(high, bottom);
    }
    return decide_monotone(low.slope >= slack ? low : high, low.slope >= slack ? high : low);
  }

  // The gap grows from `lower` to `upper`.
  bool decide_monotone(const Side& lower, const Side& upper) {
    if (lower.gap > error_)  // in space the third direction may still bring them together
      return pair_.dimension() == 2 || lower.gap > tolerance_ + error_;
    if (upper.gap < -error_) return pair_.dimension() == 2 || upper.gap < -tolerance_ - error_;
    if (lower.gap >= -error_) return add(lower, false);
    if (upper.gap <= error_) return add(upper, false);
    return add(zero(upper, lower), false);
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

}  // namespace

std::optional<ValleyPoints> valley_points(const CurvePair& pair, double tolerance, double longest) {
  return Valley(pair, tolerance, longest).points();
}

}  // namespace blossom
