// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/balls/largest_radius.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/base/errors.h"
#include "core/base/unbounded.h"
#include "core/blending/balls/ball_spine.h"
#include "core/blending/balls/detail/ball_equations.h"
#include "core/math/functions/golden_section.h"
#include "core/math/linear_solve.h"

namespace blossom {
namespace {

constexpr double kBracket =
    1e-3;  // of the radius: an end of the bracket is told if no limit is found
// Of the radius: balls as near to a limit roll, or do not, by more than what their tracks are off.
constexpr double kBesideLimit = 2e-4;
constexpr int kNewtonSteps = 20;
constexpr double kStep = 1e-5;           // of differences, relative to the extents and the radius
constexpr double kSettled = 1e-13;       // of a step, likewise
constexpr double kAlmostSettled = 1e-9;  // then a step that is no smaller is rounding
constexpr double kOnBorder = 1e-8;       // of the extents: the end of a track is there
constexpr double kPinched = 1e-12;       // factors 1 - s r k below
constexpr double kNearLeast = 1e-5;      // of the piece of a track round it: where it is least
constexpr int kScan = 65;                // balls of a track looked at for the walls' least angle

using Vec5 = Vec<double, 5>;

// Four charts relative to nothing, and the radius.
Vec4 charts_of(const Vec5& y) { return {y[0], y[1], y[2], y[3]}; }

Vec4 charts_of(const BallPoint& ball) {
  const Vec2 &a = ball.contacts[0].chart, &b = ball.contacts[1].chart;
  return {a[0], a[1], b[0], b[1]};
}

// Where a track ends: the coordinate of the charts that is on a border there.
struct EndBorder {
  int coordinate = -1;
  double value = 0;
};

// A condition that stops a ball, and where it is nearest to doing so.
struct Candidate {
  RadiusLimit limit = RadiusLimit::None;
  int support = -1, border = -1;
  double parameter = 0;
  double margin = 0;               // positive while the ball may roll
  std::optional<EndBorder> end{};  // set if it is an end of the track
};

struct Trial {
  BallSpine spine;
  std::vector<Candidate> candidates;
  bool feasible = false;
};

class RadiusSearch {
 public:
  RadiusSearch(const std::array<BallSupport, 2>& supports, const std::array<Vec2, 2>& start,
               const std::vector<ContactBorder>& borders)
      : supports_(supports), start_(start), borders_(borders) {}

  std::optional<LargestRadius> search(double least, double most);

 private:
  std::optional<Trial> trial(double radius) const;
  bool has_same_ends(const BallTrack& track) const;
  std::optional<EndBorder> end_border(const BallTrack& track, double parameter) const;
  Candidate border_candidate(const BallTrack& track, int border) const;
  Candidate facing_candidate(const BallTrack& track) const;
  BallSystem system(double radius) const {
    return BallSystem(supports_, RadiusLaw::constant(radius), {});
  }
  std::optional<double> margin(const Candidate& c, const Vec4& x, double radius) const;
  std::optional<Vec5> residual(const Candidate& c, const Vec5& y) const;
  std::optional<Vec5> solved(const Candidate& c, Vec5 y) const;
  LargestRadius answer(const Candidate& c, const Vec5& y) const;
  std::optional<LargestRadius> least_limit(const Trial& near, const Interval& radii,
                                           double radius) const;

  std::array<BallSupport, 2> supports_;
  std::array<Vec2, 2> start_;
  const std::vector<ContactBorder>& borders_;
  bool closed_ = false;
  std::array<Vec3, 2> ends_;  // of the first track
};

BallCells cells_at(const std::array<BallSupport, 2>& supports, const Vec4& x) {
  return {cell_at(*supports[0].surface, chart_of(x, 0)),
          cell_at(*supports[1].surface, chart_of(x, 1))};
}

// A ball that turns round before an end and comes back is not on its way along the edge any more.
bool RadiusSearch::has_same_ends(const BallTrack& track) const {
  if (track.closed() != closed_) return false;
  if (closed_) return true;
  const Vec3 first = track.at(track.domain().from).centre,
             last = track.at(track.domain().to).centre;
  return distance(first, ends_[0]) < distance(first, ends_[1]) &&
         distance(last, ends_[1]) < distance(last, ends_[0]);
}

std::optional<EndBorder> RadiusSearch::end_border(const BallTrack& track, double parameter) const {
  if (parameter != track.domain().from && parameter != track.domain().to) return std::nullopt;
  const Vec4 x = charts_of(track.at(parameter));
  for (int k = 0; k < 4; ++k) {
    const ChartRectangle& part = supports_[static_cast<std::size_t>(k / 2)].part;
    const Interval& range = k % 2 == 0 ? part.u : part.v;
    for (const double value : {range.from, range.to})
      if (std::abs(x[k] - value) <= kOnBorder * length(range)) return EndBorder{k, value};
  }
  return std::nullopt;
}

// The place of a track where a function of the ball is least, by golden section round the least
// node: from there Newton's method does the rest.
template <class Function>
double place_of_least(const BallTrack& track, const Function& f) {
  std::vector<double> parameters;
  for (int i = 0; i < kScan; ++i) parameters.push_back(at(track.domain(), i / (kScan - 1.0)));
  for (const BallTrack::Node& node : track.nodes()) parameters.push_back(node.parameter);
  std::sort(parameters.begin(), parameters.end());
  parameters.erase(std::unique(parameters.begin(), parameters.end()), parameters.end());
  std::size_t best = 0;
  double least = kInfinity;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const double value = f(track.at(parameters[i]));
    if (value < least) least = value, best = i;
  }
  if (best == 0 || best + 1 == parameters.size()) return parameters[best];
  Interval range{parameters[best - 1], parameters[best + 1]};
  return extremum([&](double p) { return f(track.at(p)); }, range, 1, kNearLeast).place;
}

Candidate RadiusSearch::border_candidate(const BallTrack& track, int border) const {
  const ContactBorder& line = borders_[static_cast<std::size_t>(border)];
  const auto inside = [&](const BallPoint& ball) {
    return line.inside(ball.contacts[static_cast<std::size_t>(line.support)].chart);
  };
  Candidate c{RadiusLimit::Border, line.support, border, place_of_least(track, inside), 0, {}};
  c.margin = inside(track.at(c.parameter));
  c.end = end_border(track, c.parameter);
  return c;
}

Candidate RadiusSearch::facing_candidate(const BallTrack& track) const {
  const auto open = [](const BallPoint& ball) {
    return 1 + dot(ball.contacts[0].normal, ball.contacts[1].normal);
  };
  Candidate c{RadiusLimit::Facing, -1, -1, place_of_least(track, open), 0, {}};
  c.margin = open(track.at(c.parameter));
  return c;
}

std::optional<Trial> RadiusSearch::trial(double radius) const {
  const auto charts = ball_beside_edge(supports_[0], supports_[1], radius, start_);
  if (!charts) return std::nullopt;
  auto track = track_through(supports_[0], supports_[1], radius, *charts);
  if (!track) return std::nullopt;
  Trial trial{with_stretches(std::move(*track)), {}, true};
  const BallTrack& t = trial.spine.track;
  const BallPinch pinch = tightest_of(t);
  trial.candidates.push_back({RadiusLimit::Curvature, pinch.support, -1, pinch.parameter,
                              pinch.factor, end_border(t, pinch.parameter)});
  for (std::size_t i = 0; i < borders_.size(); ++i)
    trial.candidates.push_back(border_candidate(t, static_cast<int>(i)));
  trial.feasible = trial.spine.is_valid() && pinch.factor > kPinched;
  for (const Candidate& c : trial.candidates) trial.feasible &= c.margin > 0;
  trial.candidates.push_back(facing_candidate(t));
  for (const TrackEnd end : t.ends()) trial.feasible &= end != TrackEnd::Lost;
  return trial;
}

std::optional<double> RadiusSearch::margin(const Candidate& c, const Vec4& x, double radius) const {
  if (c.limit == RadiusLimit::Border)
    return borders_[static_cast<std::size_t>(c.border)].inside(chart_of(x, c.support));
  const auto o = system(radius).jets(x, cells_at(supports_, x), radius);
  if (!o) return std::nullopt;
  return (*o)[static_cast<std::size_t>(c.support)].determinant;
}

// The five equations: the ball touches both; the margin is 0, and its derivative along the track
// is, or an end's border is kept; for walls that face each other the normals are opposite.
std::optional<Vec5> RadiusSearch::residual(const Candidate& c, const Vec5& y) const {
  const Vec4 x = charts_of(y);
  const double radius = y[4];
  if (!(radius > 0)) return std::nullopt;
  const BallSystem ball = system(radius);
  const BallCells cells = cells_at(supports_, x);
  const auto o = ball.jets(x, cells, radius);
  if (!o) return std::nullopt;
  const Vec3 f = (*o)[0].offset - (*o)[1].offset;
  Vec5 result{f[0], f[1], f[2], 0, 0};
  if (c.limit == RadiusLimit::Facing) {
    const Vec3 sum = (*o)[0].normal + (*o)[1].normal;
    const Vec3 a = unit((*o)[0].u), b = cross((*o)[0].normal, a);
    result[3] = dot(sum, a);
    result[4] = dot(sum, b);
    return result;
  }
  const auto g = margin(c, x, radius);
  if (!g) return std::nullopt;
  result[3] = *g;
  if (c.end) {
    result[4] = x[c.end->coordinate] - c.end->value;
    return result;
  }
  const auto rate = ball.rate(x, cells, 0);
  if (!rate) return std::nullopt;
  double speed = 0;
  for (int k = 0; k < 4; ++k) speed = std::max(speed, std::abs((*rate)[k]) / ball.extents()[k]);
  const Vec4 step = *rate * (kStep / speed);
  const auto after = margin(c, x + step, radius), before = margin(c, x - step, radius);
  if (!after || !before) return std::nullopt;
  result[4] = (*after - *before) / (2 * kStep);
  return result;
}

std::optional<Vec5> RadiusSearch::solved(const Candidate& c, Vec5 y) const {
  const BallSystem ball = system(y[4]);
  const Vec4& e = ball.extents();
  const Vec5 scale{e[0], e[1], e[2], e[3], y[4]};
  double last = kUnbounded;
  for (int step = 0; step < kNewtonSteps; ++step) {
    const auto f = residual(c, y);
    if (!f) return std::nullopt;
    SquareMatrix<5> m{};
    for (int j = 0; j < 5; ++j) {
      Vec5 up = y, down = y;
      up[j] += kStep * scale[j];
      down[j] -= kStep * scale[j];
      const auto after = residual(c, up), before = residual(c, down);
      if (!after || !before) return std::nullopt;
      for (int i = 0; i < 5; ++i)
        m[static_cast<std::size_t>(i)][j] = ((*after)[i] - (*before)[i]) / (2 * kStep);
    }
    Vec5 change = *f;
    if (!solve<5>(m, change)) return std::nullopt;
    const double size = max_norm(change);
    if (!(size < 1)) return std::nullopt;
    for (int j = 0; j < 5; ++j) y[j] -= change[j] * scale[j];
    if (size <= kSettled || (size < kAlmostSettled && size >= 0.5 * last)) return y;
    last = size;
  }
  return std::nullopt;
}

LargestRadius RadiusSearch::answer(const Candidate& c, const Vec5& y) const {
  LargestRadius result;
  result.limit = c.limit;
  result.radius = y[4];
  result.support = c.support;
  result.border = c.border;
  result.parameter = c.parameter;
  result.charts = {chart_of(charts_of(y), 0), chart_of(charts_of(y), 1)};
  const auto o = system(y[4]).jets(charts_of(y), cells_at(supports_, charts_of(y)), y[4]);
  if (o) result.centre = (*o)[0].offset;
  return result;
}

// The solution of a condition next to a ball, if it is a radius in a range.
std::optional<LargestRadius> RadiusSearch::least_limit(const Trial& near, const Interval& radii,
                                                       double radius) const {
  std::optional<LargestRadius> best;
  for (const Candidate& c : near.candidates) {
    const Vec4 x = charts_of(near.spine.track.at(c.parameter));
    for (const bool at_end : {false, true}) {
      Candidate form = c;
      if (!at_end) form.end.reset();
      if (at_end && !c.end) continue;
      const auto y = solved(form, {x[0], x[1], x[2], x[3], radius});
      if (!y || (*y)[4] < radii.from || (*y)[4] > radii.to) continue;
      if (!best || (*y)[4] < best->radius) best = answer(form, *y);
    }
  }
  return best;
}

// Newton's method from the largest ball known to roll comes to the limit, or near to it: it is the
// limit if balls a little smaller roll and a little larger ones do not. Either is news of the
// bracket; where there is none it is halved.
std::optional<LargestRadius> RadiusSearch::search(double least, double most) {
  auto below = trial(least);
  if (!below) return std::nullopt;
  const BallTrack& first = below->spine.track;
  closed_ = first.closed();
  ends_ = {first.at(first.domain().from).centre, first.at(first.domain().to).centre};
  if (!below->feasible) return std::nullopt;
  Interval bracket{least, most};
  const auto feasible = [&](double radius) {
    auto next = trial(radius);
    const bool rolls = next && next->feasible && has_same_ends(next->spine.track);
    if (rolls) below = std::move(next);
    (rolls ? bracket.from : bracket.to) = radius;
    return rolls;
  };
  if (feasible(most)) {
    LargestRadius result;
    result.radius = most;
    return result;
  }
  while (length(bracket) > kBracket * bracket.to) {
    const auto limit = least_limit(*below, bracket, bracket.from);
    const double before = limit ? limit->radius * (1 - kBesideLimit) : 0;
    const double behind = limit ? limit->radius * (1 + kBesideLimit) : 0;
    if (limit && before > bracket.from && !feasible(before)) continue;
    if (limit && (behind >= bracket.to || !feasible(behind))) return limit;
    if (!limit) feasible(at(bracket, 0.5));
  }
  // The limit is the condition whose solution lies in the bracket.
  const double room = length(bracket);
  if (auto limit = least_limit(*below, {bracket.from - room, bracket.to + room}, bracket.from))
    return limit;
  LargestRadius result;
  result.limit = RadiusLimit::Other;
  result.radius = bracket.from;
  result.centre = below->spine.track.at(below->candidates.front().parameter).centre;
  return result;
}

}  // namespace

const char* to_string(RadiusLimit limit) {
  switch (limit) {
    case RadiusLimit::None: return "none";
    case RadiusLimit::Curvature: return "curvature";
    case RadiusLimit::Border: return "border";
    case RadiusLimit::Facing: return "facing";
    case RadiusLimit::Other: return "other";
  }
  return "";
}

std::optional<LargestRadius> largest_radius(const BallSupport& a, const BallSupport& b,
                                            const std::array<Vec2, 2>& start, double least,
                                            double most,
                                            const std::vector<ContactBorder>& borders) {
  validate(a, "a");
  validate(b, "b");
  validate_radius(least);
  validate_radius(most);
  if (!(least < most)) throw InvalidInput("largest_radius: the least radius is not below the most");
  for (const ContactBorder& border : borders)
    if (!border.inside || (border.support != 0 && border.support != 1))
      throw InvalidInput("largest_radius: a border has no function or no support");
  return RadiusSearch({a, b}, start, borders).search(least, most);
}

}  // namespace blossom
