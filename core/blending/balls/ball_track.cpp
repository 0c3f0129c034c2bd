// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/balls/ball_track.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/base/errors.h"
#include "core/base/unbounded.h"
#include "core/blending/balls/detail/ball_equations.h"
#include "core/blending/balls/detail/ball_tracer.h"
#include "core/tracing/spline_fit.h"

namespace blossom {
namespace {

// Relative to the extents: the step of a central difference of rates, whose own curvature adds its
// square and rounding 2^-53 over it.
constexpr double kDifference = 1e-5;
// A ball is followed to an edge's one from this part of its radius.
constexpr double kSmallBall = 1.0 / 256;
constexpr int kNearestSteps = 30;
// A start may be outside of a part by so much of it.
constexpr double kOutside = 1e-9;

// The second derivative along a track at a node, by its rates before and after.
Vec4 second_derivative(const BallSystem& system, const Vec4& x, const Vec4& rate,
                       const std::array<ChartCell, 2>& cells, double parameter) {
  double speed = 0;
  for (int k = 0; k < 4; ++k) speed = std::max(speed, std::abs(rate[k]) / system.extents()[k]);
  if (!(speed > 0)) return {};
  const double h = kDifference / speed;
  const auto after = system.rate(x + h * rate, cells, parameter + h),
             before = system.rate(x - h * rate, cells, parameter - h);
  if (!after || !before) return {};
  return (*after - *before) * (0.5 / h);
}

struct Hermite {
  Vec4 value, first;
};

// Of the quintic between two nodes, at the fraction t of the way.
Hermite hermite(const BallTrack::Node& from, const BallTrack::Node& to, double t) {
  const double h = to.parameter - from.parameter;
  std::array<Vec4, 6> c = hermite_points<Vec4>({from.chart, from.first[1], from.second[1]},
                                               {to.chart, to.first[0], to.second[0]}, h);
  for (std::size_t count = 5; count > 1; --count)
    for (std::size_t i = 0; i < count; ++i) c[i] = (1 - t) * c[i] + t * c[i + 1];
  return {(1 - t) * c[0] + t * c[1], (c[1] - c[0]) * (5 / h)};
}

bool is_inside(const BallSupport& support, const Vec2& uv) {
  const auto inside = [](const Interval& range, bool closed, const std::vector<double>& knots,
                         double x) {
    const double slack = kOutside * length(range);
    if (closed && length(range) + slack >= knots.back() - knots.front()) return true;
    return x >= range.from - slack && x <= range.to + slack;
  };
  const BezierSurface& s = *support.surface;
  return inside(support.part.u, s.closed_u, s.u_knots, uv[0]) &&
         inside(support.part.v, s.closed_v, s.v_knots, uv[1]);
}

Vec4 joined(const std::array<Vec2, 2>& charts) {
  return {charts[0][0], charts[0][1], charts[1][0], charts[1][1]};
}

BallCells cells_of(const BallSystem& system, const Vec4& x) {
  return {cell_at(*system.supports()[0].surface, chart_of(x, 0)),
          cell_at(*system.supports()[1].surface, chart_of(x, 1))};
}

std::optional<BallTrack> driven_track(const std::shared_ptr<const BallSystem>& system,
                                      double parameter, const std::array<Vec2, 2>& start,
                                      const TrackStops& stops) {
  Vec4 guess = joined(start);
  const auto x = system->solved(guess, cells_of(*system, guess), parameter, {});
  if (!x || !is_inside(system->supports()[0], chart_of(*x, 0)) ||
      !is_inside(system->supports()[1], chart_of(*x, 1)))
    return std::nullopt;
  return traced(system, *x, parameter, stops);
}

}  // namespace

BallSupport whole_support(const BezierSurface& surface, int side) {
  return {&surface,
          {{surface.u_knots.front(), surface.u_knots.back()},
           {surface.v_knots.front(), surface.v_knots.back()}},
          side};
}

BallSupport edge_support(const BezierSurface& ruled) {
  BallSupport support = whole_support(ruled, 1);
  support.is_edge = true;
  return support;
}

const char* to_string(TrackEnd end) {
  switch (end) {
    case TrackEnd::Closed: return "closed";
    case TrackEnd::Cut: return "cut";
    case TrackEnd::Border: return "border";
    case TrackEnd::Guide: return "guide";
    case TrackEnd::Lost: return "lost";
  }
  return "";
}

BallTrack::BallTrack(std::shared_ptr<const BallSystem> system, std::vector<Node> nodes,
                     std::vector<std::array<ChartCell, 2>> cells,
                     const std::array<TrackEnd, 2>& ends, const std::array<int, 2>& end_supports)
    : system_(std::move(system)),
      nodes_(std::move(nodes)),
      cells_(std::move(cells)),
      ends_(ends),
      end_supports_(end_supports) {
  for (std::size_t i = 0; i < cells_.size(); ++i)
    for (const std::size_t side : {1, 0}) {
      Node& node = nodes_[side == 1 ? i : i + 1];
      const auto rate = system_->rate(node.chart, cells_[i], node.parameter);
      node.first[side] = rate ? *rate
                              : (nodes_[i + 1].chart - nodes_[i].chart) *
                                    (1 / (nodes_[i + 1].parameter - nodes_[i].parameter));
      node.second[side] =
          second_derivative(*system_, node.chart, node.first[side], cells_[i], node.parameter);
    }
  nodes_.front().first[0] = nodes_.front().first[1];
  nodes_.front().second[0] = nodes_.front().second[1];
  nodes_.back().first[1] = nodes_.back().first[0];
  nodes_.back().second[1] = nodes_.back().second[0];
}

const std::array<BallSupport, 2>& BallTrack::supports() const { return system_->supports(); }
const RadiusLaw& BallTrack::law() const { return system_->law(); }

std::vector<double> BallTrack::breaks() const {
  std::vector<double> result{domain().from};
  for (std::size_t i = 1; i + 1 < nodes_.size(); ++i)
    if (nodes_[i].is_break) result.push_back(nodes_[i].parameter);
  result.push_back(domain().to);
  return result;
}

std::size_t BallTrack::interval_at(double parameter, bool after) const {
  const auto before = [](const Node& node, double p) { return node.parameter < p; };
  const auto not_before = [](double p, const Node& node) { return p < node.parameter; };
  const auto first = nodes_.begin() + 1, last = nodes_.end() - 1;
  const auto above = after ? std::upper_bound(first, last, parameter, not_before)
                           : std::lower_bound(first, last, parameter, before);
  return static_cast<std::size_t>(above - nodes_.begin()) - 1;
}

// Nodes are solutions, and so is what lies between them.
Vec4 BallTrack::solution_near(std::size_t interval, double parameter, const Vec4& chart,
                              const ChartPlane& plane) const {
  for (const Node* node : {&nodes_[interval], &nodes_[interval + 1]})
    if (parameter == node->parameter) return node->chart;
  return system_->solved(chart, cells_[interval], parameter, plane).value_or(chart);
}

BallBend BallTrack::bend_near(std::size_t support, double parameter, bool after) const {
  const double p = std::clamp(parameter, domain().from, domain().to);
  const std::size_t i = interval_at(p, after);
  const Node &from = nodes_[i], &to = nodes_[i + 1];
  const Vec4 x = hermite(from, to, (p - from.parameter) / (to.parameter - from.parameter)).value;
  const BallSupport& on = supports()[support];
  const auto jet =
      offset_jet(on, cells_[i][support], chart_of(x, static_cast<int>(support)), law().at(p).value);
  return jet ? BallBend{jet->determinant, jet->trace} : BallBend{};
}

BallPoint BallTrack::at(double parameter, bool after) const {
  const double p = std::clamp(parameter, domain().from, domain().to);
  const std::size_t i = interval_at(p, after);
  const Node &from = nodes_[i], &to = nodes_[i + 1];
  const Hermite near = hermite(from, to, (p - from.parameter) / (to.parameter - from.parameter));
  const Vec4& extents = system_->extents();
  ChartPlane plane;
  for (int k = 0; k < 4; ++k) plane.row[k] = near.first[k] / (extents[k] * extents[k]);
  plane.value = dot(plane.row, near.value);
  const Vec4 x = solution_near(i, p, near.value, plane);
  const auto jets = system_->jets(x, cells_[i], law().at(p).value);
  if (!jets) return {};
  Vec4 rate = system_->rate(*jets, p).value_or(near.first);
  if (!system_->is_driven()) rate *= dot(plane.row, near.first) / dot(plane.row, rate);
  return system_->ball(x, rate, *jets, p);
}

// What lies before the cut comes last, whole turns and the length of the loop further on.
BallTrack BallTrack::cut_open(double parameter) const {
  const auto nearest = std::ranges::min_element(
      nodes_, {}, [&](const Node& node) { return std::abs(node.parameter - parameter); });
  const std::size_t count = cells_.size();
  const auto first = static_cast<std::size_t>(nearest - nodes_.begin()) % count;
  const Vec4 way = nodes_.back().chart - nodes_.front().chart;
  const double start = nodes_[first].parameter, whole = length(domain());
  std::vector<Node> nodes;
  std::vector<std::array<ChartCell, 2>> cells;
  for (std::size_t i = first; i <= first + count; ++i) {
    const bool turned = i >= count;
    nodes.push_back(nodes_[turned ? i - count : i]);
    nodes.back().is_break = nodes.back().is_break || i == count;  // on a seam, perhaps
    nodes.back().parameter += (turned ? whole : 0) - start;
    if (turned) nodes.back().chart += way;
    if (i == first + count) break;
    cells.push_back(cells_[turned ? i - count : i]);
    for (int k = 0; turned && k < 4; ++k)
      cells.back()[static_cast<std::size_t>(k / 2)].shift[k % 2] += way[k];
  }
  return BallTrack(system_, std::move(nodes), std::move(cells), {TrackEnd::Cut, TrackEnd::Cut},
                   {-1, -1});
}

double BallTrack::nearest(const Vec3& centre, const Interval& part) const {
  double low = part.from, high = part.to, p = blossom::at(part, 0.5), least = kUnbounded;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const double node = nodes_[i].parameter;
    if (node < part.from || node > part.to) continue;
    const double d = distance(at(node).centre, centre);
    if (d >= least) continue;
    least = d;
    p = node;
    low = std::max(part.from, nodes_[i == 0 ? 0 : i - 1].parameter);
    high = std::min(part.to, nodes_[std::min(i + 1, nodes_.size() - 1)].parameter);
  }
  constexpr double kLastOfTrack = 1e-15;  // part of the stretch: a few roundings
  for (int step = 0; step < kNearestSteps; ++step) {
    const BallPoint ball = at(p);
    const double speed = dot(ball.centre_rate, ball.centre_rate);
    if (!(speed > 0)) break;
    const double next =
        std::clamp(p - dot(ball.centre - centre, ball.centre_rate) / speed, low, high);
    if (std::abs(next - p) <= kLastOfTrack * (high - low)) break;
    p = next;
  }
  return p;
}

std::optional<BallTrack> track_through(const BallSupport& a, const BallSupport& b, double radius,
                                       const std::array<Vec2, 2>& start) {
  validate(a, "a");
  validate(b, "b");
  validate_radius(radius);
  const auto system = std::make_shared<const BallSystem>(
      std::array{a, b}, RadiusLaw::constant(radius), std::function<MovingPlane(double)>{});
  const auto x = system->nearest(joined(start));
  if (!x || !is_inside(a, chart_of(*x, 0)) || !is_inside(b, chart_of(*x, 1))) return std::nullopt;
  return traced(system, *x, 0);
}

std::optional<BallTrack> track_through(const BallSupport& a, const BallSupport& b,
                                       const RadiusLaw& law, const BallGuide& guide,
                                       double parameter, const std::array<Vec2, 2>& start) {
  validate(a, "a");
  validate(b, "b");
  if (!guide.curve || !(length(guide.range) > 0))
    throw InvalidInput("track_through: the guide has no curve or no range");
  if (!(parameter >= guide.range.from && parameter <= guide.range.to))
    throw InvalidInput("track_through: the parameter is not on the guide");
  validate_radius(law.at(parameter).value);
  const auto planes = [curve = guide.curve](double p) {
    const CurveJet g = curve(p);
    return MovingPlane{g.point, g.first, g.first, g.second};
  };
  TrackStops stops{guide.range, guide.knots};
  for (const double knot : law.knots()) stops.knots.push_back(knot);
  std::sort(stops.knots.begin(), stops.knots.end());
  return driven_track(std::make_shared<const BallSystem>(std::array{a, b}, law, planes), parameter,
                      start, stops);
}

std::optional<std::array<Vec2, 2>> ball_beside_edge(const BallSupport& a, const BallSupport& b,
                                                    double radius,
                                                    const std::array<Vec2, 2>& edge) {
  validate(a, "a");
  validate(b, "b");
  validate_radius(radius);
  const Vec4 x = joined(edge);
  const BallSystem still({a, b}, RadiusLaw::constant(radius), {});
  const auto jets = still.jets(x, cells_of(still, x), radius);
  if (!jets) return std::nullopt;
  const Vec3 along = cross((*jets)[0].normal, (*jets)[1].normal);
  if (!(norm(along) > 0)) return std::nullopt;
  const MovingPlane plane{(*jets)[0].point, {}, unit(along), {}};
  const Interval radii{kSmallBall * radius, radius};
  const auto system = std::make_shared<const BallSystem>(
      std::array{a, b}, RadiusLaw::linear(radii, radii.from, radii.to),
      [plane](double) { return plane; });
  const auto track = driven_track(system, radii.from, edge, {radii, {}});
  if (!track || track->ends()[1] != TrackEnd::Guide) return std::nullopt;
  const Vec4& last = track->nodes().back().chart;
  return std::array{chart_of(last, 0), chart_of(last, 1)};
}

}  // namespace blossom
