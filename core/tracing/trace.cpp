// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tracing/trace.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/not_zero.h"
#include "core/base/parallel.h"
#include "core/forms/evaluation.h"
#include "core/surfaces/gap/contact_points.h"

namespace blossom {
namespace {

constexpr std::size_t kPointGrain = 16;  // whose points one thread finds in a row
constexpr double kBeside = 1e-3;         // fraction of a link
constexpr double kFarthestBeside = 0.1;  // likewise
constexpr double kBesidePole = 0.02;     // likewise; the rounding of derivatives grows by its cube
constexpr double kStraight = 0.9;        // cosine: a tangent farther from its chord is none
constexpr double kRoundedSine = 1e-6;    // below it derivatives are rounding
constexpr double kTurned = 1e-6;         // radians: so little branches turn at a node's reach
constexpr double kMinReach = 1e-3;       // of a link
constexpr double kBesideValley = 1e-3;   // likewise: half the step of a difference
constexpr double kNoValley = 1e-3;       // of what tells its direction beside a point: none
constexpr double kReach = 0.5;           // fraction of a patch
constexpr double kAtAnAngle = 1e-4;      // sine: from there on Newton's method takes a step or two
constexpr int kStepsBeside = 3;
constexpr double kPole = 1e-8;  // a derivative this much shorter than the other one is none

// The line that a tangential arc is part of.
TouchLine touch_line(const FoundArc& arc) {
  return {{-arc.arc.direction[1], arc.arc.direction[0]}, arc.arc.crosses};
}

// How far Newton's method may lead from a chord of the arc: twice the size of the cells it is in.
double reach_of(const FoundArc& arc) {
  double reach = 0;
  for (std::size_t i = 0; i < 4; ++i)
    reach = std::max({reach, length(arc.box[i]), 2 * std::abs(arc.arc.to[i] - arc.arc.from[i])});
  return reach;
}

// Rates of (u, v) along `direction`, by least squares in the tangent plane.
Vec2 rates(const Vec3& su, const Vec3& sv, const Vec3& direction) {
  const Vec3 n = cross(su, sv);
  const double square = dot(n, n);
  return {dot(cross(direction, sv), n) / square, dot(cross(su, direction), n) / square};
}

bool is_pole(const PatchJet& jet) {
  const double du = norm(jet.u), dv = norm(jet.v);
  return std::min(du, dv) <= kPole * std::max(du, dv);
}

Vec3 second_form(const PatchJet& jet, const Vec2& rate) {
  return jet.uu * (rate[0] * rate[0]) + jet.uv * (2 * rate[0] * rate[1]) +
         jet.vv * (rate[1] * rate[1]);
}

// The curvature vector k of the curve: k . n = (second form) . n on either surface, k . t = 0.
Vec3 curvature(const Vec3& tangent, const Vec3& n1, const Vec3& n2, const Vec3& q1,
               const Vec3& q2) {
  const Vec3 c1 = cross(n2, tangent), c2 = cross(tangent, n1);
  const double d = dot(n1, c1);
  return (c1 * dot(q1, n1) + c2 * dot(q2, n2)) * (1 / d);
}

// Local parameters and their derivatives in the surface's own parameters.
void to_own(const BezierSurface& surface, const Interval& span_u, const Interval& span_v, double u,
            double v, const Vec2& rate, const Vec2& second, Vec2& p, Vec2& p1, Vec2& p2) {
  const Vec2 du{parameter_derivative(surface.u_law, span_u, u),
                parameter_derivative(surface.v_law, span_v, v)};
  const Vec2 ddu{parameter_second_derivative(surface.u_law, span_u, u),
                 parameter_second_derivative(surface.v_law, span_v, v)};
  p = {parameter_at(surface.u_law, span_u, u), parameter_at(surface.v_law, span_v, v)};
  for (int i = 0; i < 2; ++i) {
    p1[i] = du[i] * rate[i];
    p2[i] = ddu[i] * rate[i] * rate[i] + du[i] * second[i];
  }
}

// Between the parameters of a patch and those of its surface.
class SurfaceParameters {
 public:
  SurfaceParameters(const SurfaceCells& cells, int patch)
      : surface_(cells.surface()), u_(cells.knots_u(patch)), v_(cells.knots_v(patch)) {}

  Vec2 local(const Vec2& own) const {
    return {local_parameter(surface_.u_law, u_, own[0]),
            local_parameter(surface_.v_law, v_, own[1])};
  }
  Vec2 own(const Vec2& local) const {
    return {parameter_at(surface_.u_law, u_, local[0]), parameter_at(surface_.v_law, v_, local[1])};
  }

 private:
  const BezierSurface& surface_;
  const Interval u_, v_;
};

}  // namespace

ChainTracer::ChainTracer(const PairSearchResult& found, SurfaceCells& a, SurfaceCells& b,
                         const Vec3& origin, const Chain& chain, double rounding)
    : found_(found), a_(a), b_(b), origin_(origin), chain_(chain) {
  struct LinkPoints {
    Vec3 from, middle, to;
  };
  std::vector<LinkPoints> points(chain.links.size());
  parallel_for(points.size(), kPointGrain, [&](std::size_t i) {
    const FoundArc& arc = found.arcs[static_cast<std::size_t>(chain.links[i].arc)];
    const auto& patch = a.tree(arc.patch_a).patch();
    const auto at_point = [&](const Point4& x) { return point_at(patch, x[0], x[1]); };
    points[i] = {at_point(arc.arc.from), at_point(parameters_on(arc, 0.5)), at_point(arc.arc.to)};
  });
  stations_.push_back(0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [from, middle, to] = points[i];
    const double sum = distance(from, middle) + distance(middle, to);
    if (i > 0) known_points_.push_back(origin + (chain.links[i].forward ? from : to));
    known_points_.push_back(origin + middle);
    stations_.push_back(stations_.back() + std::max(sum, kNotZero));
  }
  if (chain.closed || !(rounding > 0)) return;
  for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) find_node(side, rounding);
}

void ChainTracer::find_node(std::size_t side, double rounding) {
  const std::size_t index = side == 0 ? 0 : chain_.links.size() - 1;
  const ChainLink& link = chain_.links[index];
  const FoundArc& arc = found_.arcs[static_cast<std::size_t>(link.arc)];
  if (arc.arc.iso >= 0 || arc.arc.straight || arc.arc.tangential || arc.to_pole) return;
  const Vec3 apart = apart_in(arc, (side == 0) == link.forward ? arc.arc.from : arc.arc.to);
  const double gap = norm(apart);
  if (!(gap <= rounding && on_link(index, side == 0 ? 0 : 1).sine <= kRoundedSine)) return;
  const double station = side == 0 ? 0 : stations_.back(), most = 0.5 * stations_.back();
  double reach = kMinReach * (stations_[index + 1] - stations_[index]);
  while (reach < most && at(std::abs(station - reach), side == 0).sine * reach * kTurned < gap)
    reach *= 2;
  nodes_[side] = {station, apart, std::min(reach, most)};
}

Vec3 ChainTracer::apart_in(const FoundArc& arc, const Point4& x) const {
  return point_at(a_.tree(arc.patch_a).patch(), x[0], x[1]) -
         point_at(b_.tree(arc.patch_b).patch(), x[2], x[3]);
}

// By (1 - f^4)^2 of that in the node: the sine grows with f, and what tangents turn by is the slope
// of this over it.
ChainTracer::Apart ChainTracer::apart_at(double station) const {
  Apart sum{};
  for (const Node& node : nodes_) {
    const double f = (station - node.station) / node.reach;
    if (!(std::abs(f) < 1)) continue;
    const double square = f * f, part = 1 - square * square;
    sum.value += node.apart * (part * part);
    sum.first += node.apart * (-8 * f * square * part / node.reach);
    sum.second += node.apart * ((56 * square * square - 24) * square / (node.reach * node.reach));
  }
  return sum;
}

std::size_t ChainTracer::link_at(double station, bool after) const {
  const auto first = stations_.begin();
  const auto found = after ? std::upper_bound(first, stations_.end(), station)
                           : std::lower_bound(first, stations_.end(), station);
  const auto last_link = static_cast<std::ptrdiff_t>(chain_.links.size()) - 1;
  return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(found - first - 1, 0, last_link));
}

TracePoint ChainTracer::at(double station, bool after) const {
  const std::size_t link = link_at(station, after);
  const double width = stations_[link + 1] - stations_[link];
  const double fraction = std::clamp((station - stations_[link]) / width, 0.0, 1.0);
  TracePoint p = on_link(link, fraction);
  const FoundArc& arc = found_.arcs[static_cast<std::size_t>(chain_.links[link].arc)];
  const bool to_pole = arc.to_pole || (arc.arc.tangential && p.sine == 0);  // or to such a node
  const bool is_end = fraction <= 0 || fraction >= 1;
  const bool finite = std::isfinite(norm(p.second) + norm(p.a_second) + norm(p.b_second));
  if (arc.arc.straight || (finite && (!is_end || (p.sine > kRoundedSine && !to_pole)))) return p;
  // At a pole a surface has no normal, at a node the two are parallel or a valley has no direction:
  // the derivatives are taken from points beside it, by quadratic extrapolation. Where contact is
  // of higher order, more of the link is too near to the node for that.
  double step = (fraction < 0.5 ? 1 : -1) * (to_pole ? kBesidePole : kBeside);
  TracePoint q1 = on_link(link, fraction + step);
  while (!to_pole && !(q1.sine > kRoundedSine) && std::abs(step) < kFarthestBeside) {
    step *= 2;
    q1 = on_link(link, fraction + step);
  }
  const TracePoint q2 = on_link(link, fraction + 2 * step), q3 = on_link(link, fraction + 3 * step);
  const auto extrapolated = [&](auto TracePoint::*member) {
    return 3 * (q1.*member - q2.*member) + q3.*member;
  };
  p.sine = std::max(extrapolated(&TracePoint::sine), 0.0);
  // An iso-line tells everything but the image on the other surface.
  const bool on_a = arc.arc.iso == 0 || arc.arc.iso == 1, on_b = arc.arc.iso > 1;
  if (!on_a && !on_b) {
    p.first = unit(extrapolated(&TracePoint::first));
    p.second = extrapolated(&TracePoint::second);
  }
  if (!on_a) {
    p.a_first = extrapolated(&TracePoint::a_first);
    p.a_second = extrapolated(&TracePoint::a_second);
  }
  if (!on_b) {
    p.b_first = extrapolated(&TracePoint::b_first);
    p.b_second = extrapolated(&TracePoint::b_second);
  }
  const double width_here = distance(q3.point, p.point);
  const Vec3 chord = unit(q3.point - p.point) * (step > 0 ? 1.0 : -1.0);
  const bool smooth = dot(p.first, chord) > kStraight && norm(p.second) * width < 1 / kStraight;
  if (smooth || !(width_here > 0)) return p;
  // Too singular for that: the curve begins along its chord.
  const double rate = (step > 0 ? 1 : -1) / width_here;
  p.first = chord;
  p.a_first = (q3.a - p.a) * rate;
  p.b_first = (q3.b - p.b) * rate;
  p.second = {};
  p.a_second = p.b_second = {};
  return p;
}

// Each step leads to where the tangent planes of both surfaces and the plane across them meet. It
// leaves an error of the square of its length over the sine.
std::optional<CrossingPoint> ChainTracer::beside(double station, const SurfacePoint& start,
                                                 double settled) const {
  const int index = chain_.links[link_at(station, true)].arc;
  const FoundArc& arc = found_.arcs[static_cast<std::size_t>(index)];
  if (arc.arc.iso >= 0 || arc.arc.straight || arc.arc.tangential) return std::nullopt;
  const SurfaceParameters on_a(a_, arc.patch_a), on_b(b_, arc.patch_b);
  const Vec3 apart = apart_at(station).value;
  Vec3 x = start.point - origin_;
  Vec2 at_a = on_a.local(start.uv_a), at_b = on_b.local(start.uv_b);
  for (int step = 0; step < kStepsBeside; ++step) {
    const PatchJet p = jet_at(a_.tree(arc.patch_a).patch(), at_a[0], at_a[1], 1);
    const PatchJet q = jet_at(b_.tree(arc.patch_b).patch(), at_b[0], at_b[1], 1);
    const Vec3 n1 = unit(cross(p.u, p.v)), n2 = unit(cross(q.u, q.v));
    const double cosine = dot(n1, n2), sine = norm(cross(n1, n2)), square = sine * sine;
    if (!(sine > kAtAnAngle)) return std::nullopt;
    const double h1 = dot(n1, p.point - x), h2 = dot(n2, q.point + apart - x);
    x += n1 * ((h1 - cosine * h2) / square) + n2 * ((h2 - cosine * h1) / square);
    const Vec3 move_a = x - p.point, move_b = x - apart - q.point;
    at_a += rates(p.u, p.v, move_a);
    at_b += rates(q.u, q.v, move_b);
    if (std::max(dot(move_a, move_a), dot(move_b, move_b)) <= settled * settled * sine)
      return CrossingPoint{{x + origin_, on_a.own(at_a), on_b.own(at_b)}, sine};
  }
  return std::nullopt;
}

TracePoint ChainTracer::on_link(std::size_t index, double fraction) const {
  const ChainLink& link = chain_.links[index];
  const FoundArc& arc = found_.arcs[static_cast<std::size_t>(link.arc)];
  const double station = stations_[index] + fraction * (stations_[index + 1] - stations_[index]);
  const Apart apart = apart_at(station);
  return differentiate(arc, parameters_on(arc, link.forward ? fraction : 1 - fraction, apart.value),
                       link.forward, apart);
}

Point4 ChainTracer::parameters_on(const FoundArc& arc, double fraction, const Vec3& apart) const {
  if (fraction <= 0 || fraction >= 1) {
    const Point4& end = fraction <= 0 ? arc.arc.from : arc.arc.to;
    if (apart == Vec3{} || apart == apart_in(arc, end)) return end;
  }
  Point4 x;
  for (std::size_t i = 0; i < 4; ++i)
    x[i] = (1 - fraction) * arc.arc.from[i] + fraction * arc.arc.to[i];
  const auto& patch_a = a_.tree(arc.patch_a).patch();
  const auto& patch_b = b_.tree(arc.patch_b).patch();
  if (arc.arc.iso >= 0 || arc.arc.straight)
    return point_on_iso_line(patch_a, patch_b, x, std::max(arc.arc.iso, 0), kReach).value_or(x);
  if (arc.arc.tangential) {
    const auto solution =
        touch_point(patch_a, patch_b, x, touch_line(arc), arc.arc.direction, kReach);
    return solution ? *solution : x;
  }
  const auto solve = [&](const Point4& start) {
    return curve_point(patch_a, patch_b, start, arc.arc.direction, reach_of(arc), apart);
  };
  if (const auto solution = solve(x)) return *solution;
  // The chord leads too far off: follow the arc from its beginning in small steps.
  constexpr int kSteps = 32;
  Point4 y = arc.arc.from;
  for (int step = 1; step <= kSteps; ++step) {
    // The next plane, nearest to where the arc is now.
    const double part = fraction * step / static_cast<double>(kSteps);
    double square = 0, missing = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const double goal = arc.arc.from[i] + part * (arc.arc.to[i] - arc.arc.from[i]);
      square += arc.arc.direction[i] * arc.arc.direction[i];
      missing += arc.arc.direction[i] * (goal - y[i]);
    }
    Point4 start = y;
    for (std::size_t i = 0; i < 4; ++i) start[i] += arc.arc.direction[i] * missing / square;
    if (const auto next = solve(start)) y = *next;
  }
  return y;
}

// Along an iso-line, or another straight line in the parameters of one surface, everything follows
// from it; the parameters of the other surface are those of its foot.
TracePoint ChainTracer::differentiate_straight(const FoundArc& arc, const Point4& x,
                                               bool forward) const {
  const PatchJet p = jet_at(a_.tree(arc.patch_a).patch(), x[0], x[1], 2);
  const PatchJet q = jet_at(b_.tree(arc.patch_b).patch(), x[2], x[3], 2);
  const bool on_a = arc.arc.iso < 2;
  const PatchJet &own = on_a ? p : q, &other = on_a ? q : p;
  Vec2 run;
  for (int k = 0; k < 2; ++k) {
    const auto i = static_cast<std::size_t>(on_a ? k : k + 2);
    if (arc.arc.iso != static_cast<int>(i)) run[k] = arc.arc.to[i] - arc.arc.from[i];
  }
  // By arc length: r' = +-1 / |d|, r'' = -(d . dd) / |d|^4.
  const Vec3 d = own.u * run[0] + own.v * run[1], dd = second_form(own, run);
  const double square = dot(d, d);
  const Vec2 rate = run * ((forward ? 1 : -1) / std::sqrt(square));
  const Vec2 second = run * (-dot(d, dd) / (square * square));
  TracePoint result;
  result.point = own.point + origin_;
  result.first = d * ((forward ? 1 : -1) / std::sqrt(square));
  result.second = dd * (1 / square) + d * (-dot(d, dd) / (square * square));
  if (arc.arc.tangential || arc.arc.straight)
    result.sine = is_pole(other) ? 0 : 1;
  else
    result.sine = norm(cross(unit(cross(p.u, p.v)), unit(cross(q.u, q.v))));
  const Vec2 rate_other = rates(other.u, other.v, result.first);
  const Vec2 second_other = rates(other.u, other.v, result.second - second_form(other, rate_other));
  to_own(a_.surface(), a_.knots_u(arc.patch_a), a_.knots_v(arc.patch_a), x[0], x[1],
         on_a ? rate : rate_other, on_a ? second : second_other, result.a, result.a_first,
         result.a_second);
  to_own(b_.surface(), b_.knots_u(arc.patch_b), b_.knots_v(arc.patch_b), x[2], x[3],
         on_a ? rate_other : rate, on_a ? second_other : second, result.b, result.b_first,
         result.b_second);
  return result;
}

// Where the surfaces touch the tangent is that of the valley; the second derivative is the
// difference of two of them.
TracePoint ChainTracer::differentiate_valley(const FoundArc& arc, const Point4& x,
                                             bool forward) const {
  const auto& patch_a = a_.tree(arc.patch_a).patch();
  const auto& patch_b = b_.tree(arc.patch_b).patch();
  struct Rates {
    Vec3 tangent;
    Vec2 a, b;
    double size;  // before scaling
  };
  const auto rates_at = [&](const Point4& at) {
    Point4 tangent = touch_tangent(patch_a, patch_b, at, touch_line(arc));
    double growth = 0;
    for (std::size_t i = 0; i < 4; ++i) growth += tangent[i] * arc.arc.direction[i];
    const PatchJet p = jet_at(patch_a, at[0], at[1], 1);
    const Vec3 rate = p.u * tangent[0] + p.v * tangent[1];
    const double scale = ((growth > 0) == forward ? 1 : -1) / norm(rate);
    return Rates{rate * scale,
                 {tangent[0] * scale, tangent[1] * scale},
                 {tangent[2] * scale, tangent[3] * scale},
                 norm(rate)};
  };
  const Rates here = rates_at(x);
  const auto beside = [&](double step) {
    Point4 start = x;
    for (std::size_t i = 0; i < 4; ++i) start[i] += step * arc.arc.direction[i];
    const auto found =
        touch_point(patch_a, patch_b, start, touch_line(arc), arc.arc.direction, kReach);
    return found ? *found : start;
  };
  const Point4 x0 = beside(-kBesideValley), x1 = beside(kBesideValley);
  const Rates r0 = rates_at(x0), r1 = rates_at(x1);
  const double width = (forward ? 1 : -1) *
                       (distance(point_at(patch_a, x0[0], x0[1]), point_at(patch_a, x1[0], x1[1])));
  TracePoint result;
  result.point = point_at(patch_a, x[0], x[1]) + origin_;
  result.first = here.tangent;
  result.second = (r1.tangent - r0.tangent) * (1 / width);
  result.second = result.second - here.tangent * dot(result.second, here.tangent);
  const bool at_pole =
      is_pole(jet_at(patch_a, x[0], x[1], 1)) || is_pole(jet_at(patch_b, x[2], x[3], 1));
  // In a node of a high order no direction is the valley's more than another.
  const bool at_node = here.size <= kNoValley * std::max(r0.size, r1.size);
  result.sine = at_pole || at_node ? 0 : 1;
  to_own(a_.surface(), a_.knots_u(arc.patch_a), a_.knots_v(arc.patch_a), x[0], x[1], here.a,
         (r1.a - r0.a) * (1 / width), result.a, result.a_first, result.a_second);
  to_own(b_.surface(), b_.knots_u(arc.patch_b), b_.knots_v(arc.patch_b), x[2], x[3], here.b,
         (r1.b - r0.b) * (1 / width), result.b, result.b_first, result.b_second);
  return result;
}

TracePoint ChainTracer::differentiate(const FoundArc& arc, const Point4& x, bool forward,
                                      const Apart& apart) const {
  if (arc.arc.iso >= 0 || arc.arc.straight) return differentiate_straight(arc, x, forward);
  if (arc.arc.tangential) return differentiate_valley(arc, x, forward);
  const PatchJet p = jet_at(a_.tree(arc.patch_a).patch(), x[0], x[1], 2);
  const PatchJet q = jet_at(b_.tree(arc.patch_b).patch(), x[2], x[3], 2);
  const Vec3 n1 = unit(cross(p.u, p.v)), n2 = unit(cross(q.u, q.v));
  TracePoint result;
  Vec3 tangent = cross(n1, n2);
  result.sine = norm(tangent);
  tangent = unit(tangent);
  // The sign that makes the arc's own parameter grow, turned when the chain runs it backwards.
  const Vec2 ra = rates(p.u, p.v, tangent), rb = rates(q.u, q.v, tangent);
  const Point4& d = arc.arc.direction;
  const double growth = d[0] * ra[0] + d[1] * ra[1] + d[2] * rb[0] + d[3] * rb[1];
  const double sign = (growth > 0) == forward ? 1 : -1;
  tangent = tangent * sign;
  // It leads along a, and b is left at the rate at which the surfaces are apart.
  if (result.sine > 0 && apart.first != Vec3{}) {
    const Vec3 across = unit(cross(n1, tangent));
    tangent = unit(tangent + across * (dot(apart.first, n2) / dot(across, n2)));
  }
  const Vec2 rate_a = rates(p.u, p.v, tangent), rate_b = rates(q.u, q.v, tangent - apart.first);

  const Vec3 qa = second_form(p, rate_a), qb = second_form(q, rate_b) + apart.second;
  const Vec3 k = curvature(tangent, n1, n2, qa, qb);
  result.point = p.point + origin_;
  result.first = tangent;
  result.second = k;
  to_own(a_.surface(), a_.knots_u(arc.patch_a), a_.knots_v(arc.patch_a), x[0], x[1], rate_a,
         rates(p.u, p.v, k - qa), result.a, result.a_first, result.a_second);
  to_own(b_.surface(), b_.knots_u(arc.patch_b), b_.knots_v(arc.patch_b), x[2], x[3], rate_b,
         rates(q.u, q.v, k - qb), result.b, result.b_first, result.b_second);
  return result;
}

}  // namespace blossom
