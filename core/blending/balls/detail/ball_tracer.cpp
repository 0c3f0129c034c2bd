// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/balls/detail/ball_tracer.h"
#include "core/base/not_zero.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace blossom {
namespace {

// Lengths here are relative: coordinates of x over the extents of the parts.
constexpr double kStepError = 1e-11;  // of a Runge-Kutta step
constexpr double kFirstStep = 0.02;
constexpr double kLongestWalk = 0.125;
constexpr double kShortestStep = 1e-9;
constexpr double kDrift = 1e-5;      // Newton's way from the predicted point, in steps
constexpr double kNoise = 1e-10;     // and what rounding may add to it
constexpr double kMinCosine = 0.8;   // between the directions at both ends of a step
constexpr double kOnLine = 1e-10;    // nearer to a knot line or border is on it
constexpr double kAlongLine = 1e-8;  // of a direction's size: less does not leave a line
constexpr double kSamePoint = 1e-7;  // where a loop closes
constexpr int kMaxNodes = 100'000;
constexpr int kEventSteps = 30;
constexpr double kSameStep = 1e-14;  // of the longest step: rounding of an event
constexpr double kSameLine = 1e-15;  // and of its place, part of the size
constexpr double kCaution = 0.9;     // of the step that would just be good enough

struct Place {
  Vec4 x;
  double parameter = 0;
};

struct Walk {
  std::vector<Place> places;     // the start first
  std::vector<BallCells> cells;  // between two places
  std::vector<char> is_break;    // of each place
  TrackEnd end = TrackEnd::Lost;
  int end_support = -1;
};

double relative(const Vec4& a, const Vec4& b, const Vec4& extents) {
  double sum = 0;
  for (int k = 0; k < 4; ++k) sum += a[k] * b[k] / (extents[k] * extents[k]);
  return sum;
}

// One walk in the direction of growing (+1) or falling (-1) parameters.
class Walker {
 public:
  Walker(const BallSystem& system, const TrackStops& stops, int direction)
      : system_(system), stops_(stops), direction_(direction), extents_(system.extents()) {}

  Walk walk(const Place& start);

 private:
  double size(const Vec4& x) const { return std::sqrt(relative(x, x, extents_)); }
  std::optional<Vec4> rate(const Vec4& x, double parameter) const {
    auto rate = system_.rate(x, cells_, parameter);
    if (rate) *rate *= direction_;
    return rate;
  }
  const BezierSurface& surface(int support) const {
    return *system_.supports()[static_cast<std::size_t>(support)].surface;
  }
  std::optional<Interval> border(int coordinate) const;
  bool enter(const Vec4& rate, Walk& walk);
  std::optional<Place> predicted(double h, double& error) const;
  std::optional<Place> stepped(double h, double& error) const;
  bool advance(Walk& walk);
  double longest_step() const;
  bool stop_at_lines(Place& next, double& h) const;
  bool closes(const Walk& walk, Place& next, double h) const;
  template <class Event>
  std::optional<Place> at_event(double h, const Event& event) const;

  const BallSystem& system_;
  const TrackStops& stops_;
  const int direction_;
  const Vec4& extents_;
  BallCells cells_;
  Place at_;
  Vec4 rate_;
  double h_ = 0;
};

// The part's range in a coordinate; nothing if there the ball may go round and round.
std::optional<Interval> Walker::border(int coordinate) const {
  const BallSupport& support = system_.supports()[static_cast<std::size_t>(coordinate / 2)];
  const bool in_u = coordinate % 2 == 0;
  const Interval& range = in_u ? support.part.u : support.part.v;
  const std::vector<double>& knots = in_u ? support.surface->u_knots : support.surface->v_knots;
  const double period = knots.back() - knots.front();
  const bool closed = in_u ? support.surface->closed_u : support.surface->closed_v;
  if (closed && length(range) >= period * (1 - kOnLine)) return std::nullopt;
  return range;
}

// Passes into the cells ahead. Returns false at a border that the ball would leave.
bool Walker::enter(const Vec4& rate, Walk& walk) {
  const double speed = size(rate);
  for (int k = 0; k < 4; ++k) {
    if (std::abs(rate[k]) / extents_[k] <= kAlongLine * speed) continue;
    const bool up = rate[k] > 0;
    const auto beyond = [&](const Interval& range) {
      return up ? at_.x[k] - range.to : range.from - at_.x[k];
    };
    const auto part = border(k);
    if (part && beyond(*part) >= -kOnLine * extents_[k]) {
      walk.end = TrackEnd::Border;
      walk.end_support = k / 2;
      return false;
    }
    ChartCell& cell = cells_[static_cast<std::size_t>(k / 2)];
    const Interval span = range_of(surface(k / 2), cell, k % 2);
    if (beyond(span) < -kOnLine * length(span)) continue;
    const auto next = cell_beside(surface(k / 2), cell, k % 2, up ? 1 : -1);
    if (!next) continue;
    if (!are_one_piece(surface(k / 2), cell, *next, chart_of(at_.x, k / 2), k % 2))
      walk.is_break.back() = 1;
    cell = *next;
  }
  return true;
}

// Source: Dormand, Prince 1980, table 2.
std::optional<Place> Walker::predicted(double h, double& error) const {
  static constexpr double kA[6][6] = {
      {1.0 / 5},
      {3.0 / 40, 9.0 / 40},
      {44.0 / 45, -56.0 / 15, 32.0 / 9},
      {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
      {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
      {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
  static constexpr double kC[6] = {1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1, 1};
  static constexpr double kError[7] = {71.0 / 57600,      0,          -71.0 / 16695, 71.0 / 1920,
                                       -17253.0 / 339200, 22.0 / 525, -1.0 / 40};
  std::array<Vec4, 7> slopes;
  slopes[0] = rate_;
  Place y;
  for (std::size_t stage = 0; stage < 6; ++stage) {
    y.x = at_.x;
    for (std::size_t j = 0; j <= stage; ++j) y.x += slopes[j] * (h * kA[stage][j]);
    y.parameter = at_.parameter + direction_ * h * kC[stage];
    const auto slope = rate(y.x, y.parameter);
    if (!slope) return std::nullopt;
    slopes[stage + 1] = *slope;
  }
  Vec4 off;
  for (std::size_t j = 0; j < 7; ++j) off += slopes[j] * (h * kError[j]);
  error = size(off);
  if (!(relative(slopes[6], rate_, extents_) >= kMinCosine * size(slopes[6]) * size(rate_)))
    return std::nullopt;
  return y;
}

std::optional<Place> Walker::stepped(double h, double& error) const {
  auto y = predicted(h, error);
  if (!y) return std::nullopt;
  const auto slope = rate(y->x, y->parameter);
  if (!slope) return std::nullopt;
  ChartPlane plane;
  for (int k = 0; k < 4; ++k) plane.row[k] = (*slope)[k] / (extents_[k] * extents_[k]);
  plane.value = dot(plane.row, y->x);
  const auto x = system_.solved(y->x, cells_, y->parameter, plane);
  if (!x || size(*x - y->x) > kDrift * size(y->x - at_.x) + kNoise) return std::nullopt;
  y->x = *x;
  return y;
}

// The step after which event(x) is 0, from one after which it is not far; by Newton's method. The
// event gives its value and its derivative's row.
template <class Event>
std::optional<Place> Walker::at_event(double h, const Event& event) const {
  std::optional<Place> y;
  for (int step = 0; step < kEventSteps; ++step) {
    double error = 0;
    y = stepped(h, error);
    if (!y) return std::nullopt;
    const auto slope = rate(y->x, y->parameter);
    if (!slope) return std::nullopt;
    const ChartPlane plane = event();
    const double by_h = dot(plane.row, *slope);
    const double change = (plane.value - dot(plane.row, y->x)) / by_h;
    if (!std::isfinite(change)) return std::nullopt;
    h += change;
    if (h < 0 || std::abs(change) * size(*slope) > 1) return std::nullopt;
    if (std::abs(change) <= kSameStep * h_ || std::abs(change) * size(*slope) <= kSameLine) break;
  }
  if (system_.is_driven()) return y;
  const auto x = system_.solved(y->x, cells_, y->parameter, event());
  if (!x) return std::nullopt;
  return Place{*x, at_.parameter + direction_ * h};
}

// Shortens a step to the first knot line or border that it passes. Returns false if that cannot be
// found.
bool Walker::stop_at_lines(Place& next, double& h) const {
  bool found = true;
  const Place whole = next;
  const double whole_h = h;
  for (int k = 0; k < 4; ++k) {
    const auto part = border(k);
    const Interval span = range_of(surface(k / 2), cells_[static_cast<std::size_t>(k / 2)], k % 2);
    const double slack = kOnLine * std::min(extents_[k], length(span));
    double low = span.from, high = span.to;
    if (part) low = std::max(low, part->from), high = std::min(high, part->to);
    const bool above = whole.x[k] > high + slack, below = whole.x[k] < low - slack;
    if (!above && !below) continue;
    ChartPlane line;
    line.row[k] = 1;
    line.value = above ? high : low;
    const double passed = std::abs((line.value - at_.x[k]) / (whole.x[k] - at_.x[k]));
    const auto place = at_event(whole_h * std::clamp(passed, 0.0, 1.0), [&] { return line; });
    if (!place) {
      found = false;
      continue;
    }
    const double place_h = std::abs(place->parameter - at_.parameter);
    if (place_h >= h) continue;
    next = *place;
    next.x[k] = line.value;
    h = place_h;
  }
  return found;
}

// True if the step passes the start of the walk; then it ends there.
bool Walker::closes(const Walk& walk, Place& next, double h) const {
  if (system_.is_driven() || walk.places.size() < 3) return false;
  Vec4 start = walk.places.front().x;
  for (int k = 0; k < 4; ++k) {
    const BezierSurface& s = surface(k / 2);
    if (!(k % 2 == 0 ? s.closed_u : s.closed_v)) continue;
    const std::vector<double>& knots = k % 2 == 0 ? s.u_knots : s.v_knots;
    const double period = knots.back() - knots.front();
    start[k] += period * std::round((next.x[k] - start[k]) / period);
  }
  const double reach = 2 * size(next.x - at_.x);
  if (size(start - at_.x) > reach || relative(start - at_.x, rate_, extents_) <= 0) return false;
  const auto ahead = rate(next.x, next.parameter);
  if (!ahead || relative(start - next.x, *ahead, extents_) > kOnLine * size(*ahead)) return false;
  ChartPlane plane;
  for (int k = 0; k < 4; ++k) plane.row[k] = rate_[k] / (extents_[k] * extents_[k]);
  plane.value = dot(plane.row, start);
  const double part = size(start - at_.x) / std::max(size(next.x - at_.x), kNotZero);
  const auto place = at_event(h * std::clamp(part, 0.0, 1.0), [&] { return plane; });
  if (!place || size(place->x - start) > kSamePoint) return false;
  next = {start, place->parameter};
  return true;
}

double Walker::longest_step() const {
  double h = kLongestWalk / size(rate_);
  if (!system_.is_driven()) return h;
  const double p = at_.parameter;
  const auto limit = [&](double stop) {
    const double way = direction_ * (stop - p);
    if (way > kOnLine * length(stops_.range)) h = std::min(h, way);
  };
  limit(direction_ > 0 ? stops_.range.to : stops_.range.from);
  for (const double knot : stops_.knots) limit(knot);
  return h;
}

// One step. Returns false when the walk is over.
bool Walker::advance(Walk& walk) {
  const auto here = rate(at_.x, at_.parameter);
  if (!here || !enter(*here, walk)) return false;
  const auto into = rate(at_.x, at_.parameter);  // in the cells ahead
  if (!into) return false;
  rate_ = *into;
  if (system_.is_driven()) {
    const double rest =
        direction_ > 0 ? stops_.range.to - at_.parameter : at_.parameter - stops_.range.from;
    if (rest <= kOnLine * length(stops_.range)) {
      walk.end = TrackEnd::Guide;
      return false;
    }
  }
  const double speed = size(rate_);
  if (h_ == 0) h_ = kFirstStep / speed;
  for (double h = std::min(h_, longest_step()); h * speed > kShortestStep;) {
    double error = 0;
    auto next = stepped(h, error);
    const double growth = kCaution * std::pow(kStepError / std::max(error, kNotZero), 0.2);
    if (!next || error > kStepError) {
      h *= next ? std::clamp(growth, 0.1, 0.8) : 0.5;
      continue;
    }
    double taken = h;
    if (!stop_at_lines(*next, taken)) {
      h *= 0.5;
      continue;
    }
    h_ = h * std::clamp(growth, 0.2, 2.0);
    const bool closed = closes(walk, *next, taken);
    walk.places.push_back(*next);
    walk.cells.push_back(cells_);
    walk.is_break.push_back(0);
    if (closed) walk.end = TrackEnd::Closed;
    at_ = *next;
    for (const double knot : stops_.knots)
      if (std::abs(knot - at_.parameter) <= kOnLine * length(stops_.range))
        walk.is_break.back() = 1;
    return !closed;
  }
  return false;
}

Walk Walker::walk(const Place& start) {
  Walk walk;
  at_ = start;
  for (int k = 0; k < 2; ++k)
    cells_[static_cast<std::size_t>(k)] = cell_at(surface(k), chart_of(start.x, k));
  walk.places.push_back(start);
  walk.is_break.push_back(0);
  for (int i = 0; i < kMaxNodes && advance(walk); ++i) {
  }
  return walk;
}

Walk reversed(Walk walk) {
  std::reverse(walk.places.begin(), walk.places.end());
  std::reverse(walk.cells.begin(), walk.cells.end());
  std::reverse(walk.is_break.begin(), walk.is_break.end());
  return walk;
}

// A loop that begins where it passes a seam, or else where it has a break.
void begin_at_seam(const BallSystem& system, Walk& loop) {
  const std::size_t count = loop.cells.size();
  const auto passes_seam = [&](std::size_t i) {
    const BallCells &before = loop.cells[(i + count - 1) % count], &after = loop.cells[i];
    for (std::size_t k = 0; k < 2; ++k)
      for (int d = 0; d < 2; ++d) {
        const BezierSurface& s = *system.supports()[k].surface;
        const int last = (d == 0 ? s.patches.rows() : s.patches.columns()) - 1;
        const auto at = static_cast<std::size_t>(d);
        const int p = before[k].span[at], q = after[k].span[at];
        const bool moved = before[k].shift[d] != after[k].shift[d];
        if ((moved || i == 0) && last > 0 && std::abs(p - q) == last) return true;
        if (moved && last == 0) return true;
      }
    return false;
  };
  std::size_t first = 0;
  for (std::size_t i = count; i-- > 0;)
    if (loop.is_break[i]) first = i;
  for (std::size_t i = count; i-- > 0;)
    if (passes_seam(i)) first = i;
  if (first == 0) return;
  const Vec4 way = loop.places.back().x - loop.places.front().x;  // whole periods
  const double whole = loop.places.back().parameter - loop.places.front().parameter;
  for (std::size_t i = 0; i < first; ++i) {
    loop.places.push_back({loop.places[i + 1].x + way, loop.places[i + 1].parameter + whole});
    loop.is_break.push_back(loop.is_break[i + 1]);
    loop.cells.push_back(loop.cells[i]);
    for (int k = 0; k < 4; ++k)
      loop.cells.back()[static_cast<std::size_t>(k / 2)].shift[k % 2] += way[k];
  }
  loop.is_break[count] = loop.is_break[0];
  const auto from = static_cast<std::ptrdiff_t>(first);
  loop.places.erase(loop.places.begin(), loop.places.begin() + from);
  loop.cells.erase(loop.cells.begin(), loop.cells.begin() + from);
  loop.is_break.erase(loop.is_break.begin(), loop.is_break.begin() + from);
}

}  // namespace

std::optional<BallTrack> traced(const std::shared_ptr<const BallSystem>& system, const Vec4& x,
                                double parameter, const TrackStops& stops) {
  const Place start{x, system->is_driven() ? parameter : 0};
  Walk on = Walker(*system, stops, 1).walk(start);
  std::array<TrackEnd, 2> ends{on.end, on.end};
  std::array<int, 2> end_supports{-1, on.end_support};
  if (on.end == TrackEnd::Closed) {
    begin_at_seam(*system, on);
  } else {
    Walk back = reversed(Walker(*system, stops, -1).walk(start));
    ends[0] = back.end;
    end_supports[0] = back.end_support;
    if (on.is_break.front()) back.is_break.back() = 1;
    back.places.insert(back.places.end(), on.places.begin() + 1, on.places.end());
    back.cells.insert(back.cells.end(), on.cells.begin(), on.cells.end());
    back.is_break.insert(back.is_break.end(), on.is_break.begin() + 1, on.is_break.end());
    on = std::move(back);
  }
  if (on.places.size() < 2) return std::nullopt;
  const double first = system->is_driven() ? 0 : on.places.front().parameter;
  std::vector<BallTrack::Node> nodes(on.places.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    nodes[i].parameter = on.places[i].parameter - first;
    nodes[i].chart = on.places[i].x;
    nodes[i].is_break = on.is_break[i] != 0;
  }
  return BallTrack(system, std::move(nodes), std::move(on.cells), ends, end_supports);
}

}  // namespace blossom
