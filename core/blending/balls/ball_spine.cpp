// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/balls/ball_spine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/base/unbounded.h"
#include "core/forms/algebra/interpolation.h"
#include "core/math/functions/golden_section.h"
#include "core/math/functions/sign_change.h"

namespace blossom {
namespace {

constexpr int kDegree = 4;        // of the interpolation, between two nodes of a track
constexpr double kSafety = 2;     // on differences measured at twice as many points
constexpr double kRough = 1e-2;   // difference relative to the function: the piece is halved
constexpr int kMaxHalvings = 24;  // of a piece between two nodes
// Pieces of a track that are looked at, on average between two nodes: where determinants are noise,
// as beside points without a normal, no piece is ever smooth enough, and halving would not end.
constexpr std::size_t kMaxPieces = 16;
// Of a determinant's size: what charts that are off by 1e-10 of their extents may make of it, with
// room for curvatures that change a hundred times as fast.
constexpr double kNear = 1e-8;
constexpr double kZero = 1e-12;         // determinants are dimensionless, 1 for a plane
constexpr double kRootWidth = 0x1p-50;  // of the domain
constexpr double kCoarse = 1e-3;    // of the piece: where an extremum is, before parabolas find it
constexpr double kExtremum = 1e-9;  // of the piece: where an extremum is

using Coefficients = std::array<double, kDegree + 1>;

// 1 - s r k for the larger of s k: continuous, and negative just where the ball is not on its side.
template <class Bend>
double least_factor(const Bend& contact) {
  const double half = 0.5 * contact.trace;
  return half - std::sqrt(std::max(0.0, half * half - contact.determinant));
}

double determinant_at(const BallTrack& track, int support, double parameter) {
  return track.at(parameter).contacts[static_cast<std::size_t>(support)].determinant;
}

// Zeros of the determinants along a track.
class CuspSearch {
 public:
  explicit CuspSearch(const BallTrack& track)
      : track_(track), width_(kRootWidth * length(track.domain())) {}

  std::vector<BallCusp> cusps();

 private:
  void look(const Interval& range, int depth);
  void isolate(const Coefficients& c, const Interval& range, double error, int depth);
  void add_zero(const Interval& range);

  const BallTrack& track_;
  double width_;
  std::size_t pieces_left_ = 0;  // that may still be halved
  int support_ = 0;
  std::vector<BallCusp> cusps_;
};

void CuspSearch::add_zero(const Interval& range) {
  const auto f = [&](double p) { return determinant_at(track_, support_, p); };
  const double from = f(range.from), to = f(range.to);
  if ((from < 0) == (to < 0)) return;
  const SignChange ends =
      from < 0 ? SignChange{range.from, range.to} : SignChange{range.to, range.from};
  const SignChange zero = narrowed(f, ends, std::min(from, to), std::max(from, to), width_);
  cusps_.push_back({0.5 * (zero.below + zero.above), support_});
}

void CuspSearch::isolate(const Coefficients& c, const Interval& range, double error, int depth) {
  const auto [low, high] = std::minmax_element(c.begin(), c.end());
  if (*low > error || *high < -error) return;
  if (std::max(-*low, *high) <= kZero) return;  // 0 all along
  bool rises = true, falls = true, bends_up = true, bends_down = true;
  for (std::size_t i = 0; i + 1 < c.size(); ++i) {
    rises &= c[i + 1] > c[i];
    falls &= c[i + 1] < c[i];
    if (i + 2 >= c.size()) continue;
    const double bend = c[i + 2] - 2 * c[i + 1] + c[i];
    bends_up &= bend > 0;
    bends_down &= bend < 0;
  }
  if (rises || falls) return add_zero(range);
  if (bends_up || bends_down) {
    const auto f = [&](double p) { return determinant_at(track_, support_, p); };
    const double turn = extremum(f, range, bends_up ? 1 : -1, kExtremum).place;
    add_zero({range.from, turn});
    return add_zero({turn, range.to});
  }
  if (depth == kMaxHalvings) return add_zero(range);
  Coefficients left, right = c;  // right: the triangle's other side
  for (std::size_t k = 0; k < c.size(); ++k) {
    left[k] = right[0];
    for (std::size_t i = 0; i + k + 1 < c.size(); ++i) right[i] = 0.5 * (right[i] + right[i + 1]);
  }
  const double middle = at(range, 0.5);
  isolate(left, {range.from, middle}, error, depth + 1);
  isolate(right, {middle, range.to}, error, depth + 1);
}

void CuspSearch::look(const Interval& range, int depth) {
  static const std::vector<double> fine = extreme_points(2 * kDegree);
  std::vector<Vec2> all, nodes;  // determinants of both supports
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const double p = at(range, fine[i]);
    const bool after = i + 1 < fine.size();
    all.push_back(
        {track_.bend_near(0, p, after).determinant, track_.bend_near(1, p, after).determinant});
    if (i % 2 == 0) nodes.push_back(all.back());
  }
  const BezierCurve2 fit = bezier_through(nodes);
  std::array<double, 2> error{}, size{};
  for (std::size_t i = 0; i < fine.size(); ++i) {
    std::vector<Vec2> d = fit.points;
    for (std::size_t count = kDegree; count > 0; --count)
      for (std::size_t k = 0; k < count; ++k) d[k] = (1 - fine[i]) * d[k] + fine[i] * d[k + 1];
    for (int k = 0; k < 2; ++k) {
      const auto at = static_cast<std::size_t>(k);
      error[at] = std::max(error[at], kSafety * std::abs(d[0][k] - all[i][k]));
      size[at] = std::max(size[at], std::abs(all[i][k]));
    }
  }
  const auto is_rough = [&](std::size_t k) { return error[k] > kRough * size[k] + kZero; };
  if ((is_rough(0) || is_rough(1)) && depth < kMaxHalvings && pieces_left_ > 0) {
    --pieces_left_;
    look({range.from, at(range, 0.5)}, depth + 1);
    return look({at(range, 0.5), range.to}, depth + 1);
  }
  for (support_ = 0; support_ < 2; ++support_) {
    Coefficients c;
    for (std::size_t i = 0; i < c.size(); ++i) c[i] = fit.points[i][support_];
    const auto k = static_cast<std::size_t>(support_);
    isolate(c, range, error[k] + kNear * size[k], depth);
  }
}

std::vector<BallCusp> CuspSearch::cusps() {
  const auto& nodes = track_.nodes();
  pieces_left_ = kMaxPieces * nodes.size();
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    look({nodes[i].parameter, nodes[i + 1].parameter}, 0);
  std::sort(cusps_.begin(), cusps_.end(),
            [](const BallCusp& a, const BallCusp& b) { return a.parameter < b.parameter; });
  return std::move(cusps_);
}

}  // namespace

BallSpine with_stretches(BallTrack track) {
  BallSpine spine{std::move(track), {}, {}};
  const BallTrack& t = spine.track;
  const Interval domain = t.domain();
  spine.cusps = CuspSearch(t).cusps();
  std::vector<double> cuts{domain.from};
  for (const BallCusp& cusp : spine.cusps)
    if (cusp.parameter > cuts.back() && cusp.parameter < domain.to) cuts.push_back(cusp.parameter);
  cuts.push_back(domain.to);
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const BallPoint middle = t.at(at({cuts[i], cuts[i + 1]}, 0.5));
    const bool valid =
        least_factor(middle.contacts[0]) > kZero && least_factor(middle.contacts[1]) > kZero;
    if (!spine.stretches.empty() && spine.stretches.back().valid == valid)
      spine.stretches.back().range.to = cuts[i + 1];
    else
      spine.stretches.push_back({{cuts[i], cuts[i + 1]}, valid});
  }
  return spine;
}

namespace {

// Where a function is least in a range beside a place about kCoarse of the range from there: the
// vertices of two parabolas, the second one through points as much nearer to each other.
template <class Function>
double parabolic_least(const Function& f, const Interval& range, double place) {
  for (const double part : {kCoarse, kCoarse * kCoarse}) {
    const double h = part * length(range);
    const double p = std::clamp(place, range.from + h, range.to - h);
    const double before = f(p - h), middle = f(p), after = f(p + h);
    const double bend = before - 2 * middle + after;
    if (!(bend > 0)) return place;
    place = std::clamp(p + 0.5 * h * (before - after) / bend, range.from, range.to);
  }
  return place;
}

}  // namespace

// Looks for the least factor near the nodes that have the least ones.
BallPinch tightest_of(const BallTrack& track) {
  BallPinch pinch{track.domain().from, 0, kUnbounded};
  const auto& nodes = track.nodes();
  for (const std::size_t k : {0U, 1U}) {
    const auto about = [&](double p) { return least_factor(track.bend_near(k, p)); };
    const auto factor = [&](double p) { return least_factor(track.at(p).contacts[k]); };
    const auto note = [&](double p, double f) {
      if (f < pinch.factor) pinch = {p, static_cast<int>(k), f};
    };
    std::vector<double> factors;
    for (const BallTrack::Node& node : nodes) factors.push_back(about(node.parameter));
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      note(nodes[i].parameter, factors[i]);
      const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, nodes.size() - 1);
      if (factors[i] > factors[before] || factors[i] > factors[after]) continue;
      if (factors[i] == factors[before] && factors[i] == factors[after]) continue;
      const Interval range{nodes[before].parameter, nodes[after].parameter};
      const double least = parabolic_least(factor, range, extremum(about, range, 1, kCoarse).place);
      note(least, factor(least));
    }
  }
  return pinch;
}

}  // namespace blossom
