// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tracing/sites.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/unbounded.h"
#include "core/math/four.h"

namespace blossom {
namespace {

constexpr int kDeepest = 24;               // halvings of a link
constexpr std::size_t kMaxPieces = 5000;   // where sampling ends whatever the accuracy: this, and
constexpr std::size_t kPiecesOfLink = 32;  // so many more for each link
constexpr std::size_t kUsualPieces = 4;    // of a link: more take another allocation
constexpr std::size_t kLinksAtOnce = 256;  // refined ahead of being joined
constexpr std::size_t kLinkGrain = 4;      // links that one thread refines in a row,
constexpr std::size_t kJointGrain = 8;     // and stations that it looks at
constexpr double kShortest = 0.1;          // of the wanted accuracy: no piece needs to be shorter
constexpr double kNoLength = 1e-4;         // likewise: a piece shorter than this is a point
constexpr double kLongestTurn = 1.0;       // radians of the tangent in one piece
constexpr double kMinSine = 1e-3;          // below it, agreement is not tightened further
constexpr double kLeastSine = 0x1p-26;     // root of a rounding: a smaller one comes of the bend
constexpr double kStraightOn = 0.9;        // cosine: tangents at a contact that agree so far
constexpr double kKink = 1e-7;             // tangents farther apart than this: a kink
constexpr double kCurvatureJump = 1e-6;    // relative; curvatures farther apart: tangent continuous
constexpr double kSamePoint = 1e-3;  // of the wanted accuracy: the ends of a loop meet so closely
constexpr double kSameParameter = 1e-10;  // relative, likewise
constexpr double kOnKnot = 1e-9;          // of a span: a parameter so near a knot lies on it
// Where a Hermite piece is tried. Its error is about t^3 (1 - t)^3 times a constant: what it has to
// be multiplied with to give that of the middle.
struct Probe {
  double t, factor;
};
constexpr std::array<Probe, 2> kProbes{{{0.42, 1.08}, {0.64, 1.28}}};
constexpr std::array<Probe, 1> kMiddleProbe{{{0.5, 1}}};

// Gauss's nodes and weights, the middle one of five last.
constexpr std::array<std::array<double, 2>, 5> kGauss{{{0.046910077030668, 0.118463442528095},
                                                       {0.230765344947158, 0.239314335249683},
                                                       {0.769234655052842, 0.239314335249683},
                                                       {0.953089922969332, 0.118463442528095},
                                                       {0.5, 0.284444444444444}}};

// By Bernstein polynomial of degree 4: 5 times its values at the nodes.
constexpr std::array<std::array<double, 5>, 5> kHodograph = [] {
  std::array<std::array<double, 5>, 5> values{};
  for (std::size_t k = 0; k < 5; ++k) {
    const double t = kGauss[k][0], s = 1 - t;
    const double b[5] = {5 * s * s * s * s, 20 * s * s * s * t, 30 * s * s * t * t,
                         20 * s * t * t * t, 5 * t * t * t * t};
    for (std::size_t i = 0; i < 5; ++i) values[i][k] = b[i];
  }
  return values;
}();

// Length in space by five-point Gauss quadrature of the hodograph, four nodes at a time.
BLOSSOM_HOT double arc_length(const std::array<Vec3, 6>& points) {
  Four squares{};
  double last = 0;
  for (int axis = 0; axis < 3; ++axis) {
    Four d{};
    double middle = 0;
    for (std::size_t i = 0; i < 5; ++i) {
      const double step = points[i + 1][axis] - points[i][axis];
      Four weights;
      std::memcpy(&weights, kHodograph[i].data(), sizeof weights);
      d += step * weights;
      middle += step * kHodograph[i][4];
    }
    squares += d * d;
    last += middle * middle;
  }
  double sum = kGauss[4][1] * std::sqrt(last);
  for (int k = 0; k < 4; ++k) sum += kGauss[static_cast<std::size_t>(k)][1] * std::sqrt(squares[k]);
  return sum;
}

// Value and derivatives by a parameter with ds/dt = speed and d^2 s/dt^2 = change, s the arc
// length.
std::array<Vec7, 3> jet(const TracePoint& x, double speed, double change) {
  const Vec7 first = seven(x.first, x.a_first, x.b_first);
  const Vec7 second = seven(x.second, x.a_second, x.b_second);
  return {seven(x.point, x.a, x.b), first * speed, second * (speed * speed) + first * change};
}

// A piece that begins at parameter 0, and its length in space.
struct Step {
  QuinticPiece piece;
  double length;
};

// The parameter is arc length, which the curve itself has to tell: from that of a circle's arc, two
// rounds settle it.
Step step_by_length(const TracePoint& p, const TracePoint& q) {
  const std::array start{p.point, p.first, p.second}, stop{q.point, q.first, q.second};
  const Vec3 turn = q.first - p.first;
  double width = distance(p.point, q.point) * (1 + dot(turn, turn) / 24);
  for (int round = 0; round < 2; ++round) width = arc_length(hermite_points(start, stop, width));
  return {{{0, width}, hermite_points(jet(p, 1, 0), jet(q, 1, 0), width)}, width};
}

// The parameter is that of the conic; where it does not grow, or by half a turn or more, the piece
// has no width.
Step step_by_conic(const TracePoint& p, const TracePoint& q, const Conic& conic) {
  const double from = parameter_at(conic, p.point), to = parameter_at(conic, q.point);
  double width = to - from;
  if (conic.is_closed()) width = std::remainder(width, 2 * std::numbers::pi);
  const auto jet_at = [&](const TracePoint& x, double t) {
    const Vec3 rate = derivative_at(conic, t);
    const double speed = norm(rate);
    return jet(x, speed, dot(rate, second_derivative_at(conic, t)) / speed);
  };
  Step step{{{0, std::max(width, 0.0)}, {}}, distance(p.point, q.point)};
  step.piece.points = hermite_points(jet_at(p, from), jet_at(q, to), step.piece.place.to);
  std::array<Vec3, 6> in_space;
  for (std::size_t i = 0; i < 6; ++i) in_space[i] = space(step.piece.points[i]);
  if (width > 0) step.length = arc_length(in_space);
  return step;
}

// Part of the scale: vectors that are shorter are compared by it.
constexpr double kMinOfScale = 1e-3;

// A difference beyond rounding, measured against the values and a part of `scale`.
template <int Dim>
bool jumps(const Vec<double, Dim>& x, const Vec<double, Dim>& y, double scale, double relative) {
  return distance(x, y) > relative * std::max(norm(x) + norm(y), kMinOfScale * scale);
}

// Of a knot where one link meets the next: in space and in both charts.
int multiplicity(const TracePoint& before, const TracePoint& after) {
  if (distance(before.first, after.first) > kKink ||
      jumps(before.a_first, after.a_first, 0, kKink) ||
      jumps(before.b_first, after.b_first, 0, kKink))
    return kFitDegree;
  if (jumps(before.second, after.second, 1, kCurvatureJump) ||
      jumps(before.a_second, after.a_second, norm(after.a_first), kCurvatureJump) ||
      jumps(before.b_second, after.b_second, norm(after.b_first), kCurvatureJump))
    return kFitDegree - 1;
  return kFitDegree - 2;
}

bool on_knot(const std::vector<double>& knots, double parameter) {
  for (std::size_t i = 1; i + 1 < knots.size(); ++i)
    if (std::abs(parameter - knots[i]) <= kOnKnot * (knots[i + 1] - knots[i - 1])) return true;
  return false;
}

// The distance of a piece's middle to a point near it, by the distance to the tangent line of the
// nearest parameter.
double distance_from(const QuinticPiece& piece, const Vec3& point) {
  constexpr double kSecant = 1e-4;  // part of the piece: a difference in place of a derivative
  double best = kUnbounded, t = 0.5;
  for (int step = 0; step < 6; ++step) {
    const Vec3 x = space(value_at(piece.points, t));
    const double gap = distance(x, point);
    if (gap >= best) break;
    best = gap;
    const Vec3 rate =
        (space(value_at(piece.points, std::min(t + kSecant, 1.0))) - x) * (1 / kSecant);
    const double square = dot(rate, rate);
    if (square == 0) break;
    t = std::clamp(t + dot(point - x, rate) / square, 0.0, 1 - kSecant);
  }
  return best;
}

class Sampler {
 public:
  Sampler(const ChainTracer& tracer, const BezierSurface& a, const BezierSurface& b,
          const Agreement& wanted, double limit, const Conic* conic, const WorkLimit* work)
      : tracer_(tracer), a_(a), b_(b), wanted_(wanted), limit_(limit), conic_(conic), work_(work) {}

  std::vector<SmoothRun> run() {
    const std::size_t links = tracer_.stations().size() - 1;
    const double station = tracer_.stations().front();
    const TracePoint first = tracer_.at(station, true);
    begin_run({station, first_parameter(first), 0, first});
    last_.stop = runs_.front().sites.front();
    for (std::size_t from = 0; from < links; from += kLinksAtOnce)
      if (!add_links(from, std::min(from + kLinksAtOnce, links))) return {};
    drop_empty_runs();
    return std::move(runs_);
  }

 private:
  // Where a derivative jumps: the point that a new run begins with.
  struct Break {
    TracePoint point;
    int multiplicity;
  };

  // Where a link ends.
  struct Joint {
    Site stop;
    bool may_break = false;
    std::optional<Break> next;  // after `stop`

    Site start() const { return {stop.station, 0, 0, next ? next->point : stop.point}; }
  };

  // A piece that ends at a site.
  struct Refined {
    Step step;
    double error;
    Site stop;
  };

  struct RefinedLink {
    std::size_t most;  // pieces; from there on all are good enough
    std::vector<Refined> pieces;
  };

  // Links are refined by all threads, each from where the one before should end, and joined in
  // order. Those that begin elsewhere or take many pieces are refined again then, so that the
  // result is that of one thread. False if the sampling has to end.
  bool add_links(std::size_t from, std::size_t to) {
    std::vector<Joint> joints(to - from + 1);
    joints[0] = last_;
    parallel_for(to - from, kJointGrain,
                 [&](std::size_t k) { joints[k + 1] = joint_at(from + k + 1); });
    if (to + 1 == tracer_.stations().size())
      close(joints.back().stop.point, runs_.front().sites.front().point);
    std::vector<RefinedLink> ahead(to - from);
    parallel_for(to - from, kLinkGrain, [&](std::size_t k) {
      ahead[k] = refined(joints[k].start(), joints[k + 1].stop, kPiecesOfLink);
    });
    for (std::size_t k = 0; k + from < to; ++k) {
      add_link(std::move(ahead[k]), joints[k + 1]);
      if (late() || stands_still_) return false;
    }
    last_ = joints.back();
    return true;
  }

  void add_link(RefinedLink&& link, const Joint& joint) {
    const std::size_t most = most_pieces_ - std::min(count_, most_pieces_);
    if (!is_at_stop_ || link.pieces.size() >= std::min(link.most, most))
      link = refined(Site(last_site()), joint.stop, most);
    for (const Refined& piece : link.pieces) append(piece);
    if (!joint.may_break) return;
    if (const auto next = is_at_stop_ ? joint.next : break_at(last_site())) {
      runs_.back().multiplicity = next->multiplicity;
      Site site = last_site();
      site.point = next->point;
      begin_run(site);
    }
  }

  Joint joint_at(std::size_t index) const {
    const std::vector<double>& stations = tracer_.stations();
    Joint joint{{stations[index], 0, 0, tracer_.at(stations[index], false)}, false, {}};
    const bool last = index + 1 == stations.size();
    joint.may_break = !last && (may_break(joint.stop.point) || turns_back(joint.stop));
    if (joint.may_break) joint.next = break_at(joint.stop);
    return joint;
  }

  const Site& last_site() const { return runs_.back().sites.back(); }

  // Of a circle it is 0 but for rounding.
  double first_parameter(const TracePoint& first) const {
    constexpr double kAngleRounding = 1e-14;
    const double t = conic_ != nullptr ? parameter_at(*conic_, first.point) : 0;
    return std::abs(t) <= kAngleRounding ? 0 : t;
  }

  void begin_run(const Site& site) { runs_.push_back({{site}, {}, {}, 0}); }

  // Both runs have one point, and the derivatives in common that agree.
  std::optional<Break> break_at(const Site& site) const {
    const TracePoint& before = site.point;
    TracePoint after = tracer_.at(site.station, true);
    const int found = multiplicity(before, after);
    if (found == kFitDegree - 2 && !on_line_knot(before)) return {};
    after.point = before.point;
    after.a = before.a;
    after.b = before.b;
    if (found < kFitDegree) {
      after.first = before.first;
      after.a_first = before.a_first;
      after.b_first = before.b_first;
    }
    if (found < kFitDegree - 1) {
      after.second = before.second;
      after.a_second = before.a_second;
      after.b_second = before.b_second;
    }
    return Break{after, found};
  }

  // Links without any length leave nothing behind but the knot's multiplicity.
  void drop_empty_runs() {
    std::vector<SmoothRun> kept;
    for (SmoothRun& run : runs_)
      if (!run.pieces.empty())
        kept.push_back(std::move(run));
      else if (!kept.empty())
        kept.back().multiplicity = std::max(kept.back().multiplicity, run.multiplicity);
    runs_ = std::move(kept);
  }

  // A loop ends in its first point, exactly; at a seam only in space.
  void close(TracePoint& last, const TracePoint& first) const {
    if (distance(last.point, first.point) > kSamePoint * wanted_.gap) return;
    last.point = first.point;
    if (distance(last.a, first.a) <= kSameParameter * norm(first.a)) last.a = first.a;
    if (distance(last.b, first.b) <= kSameParameter * norm(first.b)) last.b = first.b;
  }

  // Surfaces are smooth but at their knots.
  bool may_break(const TracePoint& p) const {
    return on_knot(a_.u_knots, p.a[0]) || on_knot(a_.v_knots, p.a[1]) ||
           on_knot(b_.u_knots, p.b[0]) || on_knot(b_.v_knots, p.b[1]);
  }

  // Where surfaces touch a branch may turn back.
  bool turns_back(const Site& site) const {
    return site.point.sine < kMinSine &&
           dot(site.point.first, tracer_.at(site.station, true).first) < kStraightOn;
  }

  // The knots of an angle are those of its circle's arcs: the surface goes on unchanged there.
  bool on_line_knot(const TracePoint& p) const {
    return (a_.u_law == ParameterLaw::Linear && on_knot(a_.u_knots, p.a[0])) ||
           (a_.v_law == ParameterLaw::Linear && on_knot(a_.v_knots, p.a[1])) ||
           (b_.u_law == ParameterLaw::Linear && on_knot(b_.u_knots, p.b[0])) ||
           (b_.v_law == ParameterLaw::Linear && on_knot(b_.v_knots, p.b[1]));
  }

  bool late() const { return work_ != nullptr && work_->late_after_search(); }

  // Round a surface that one patch closes a whole loop may be one link: its ends are one point, its
  // middle is another. Where surfaces cross at a small angle, rounding moves points by its
  // cosecant, and where they touch by no more than spheres of their size let it.
  bool is_point(const Step& step, const Site& start, const Site& stop) const {
    const double sine = std::max(start.point.sine, stop.point.sine);
    const double noise = wanted_.rounding / std::max(sine, kLeastSine);
    const double shortest = std::max(kShortest * wanted_.gap, noise);
    if (step.length > shortest) return false;
    if (std::isnan(step.length)) return true;
    const double half_way = 0.5 * (start.station + stop.station);
    return distance(tracer_.at(half_way, true).point, start.point.point) <= shortest;
  }

  RefinedLink refined(const Site& start, const Site& stop, std::size_t most) const {
    RefinedLink link{most, {}};
    link.pieces.reserve(kUsualPieces);
    refine(start, stop, 0, link);
    return link;
  }

  // A piece that is nearly good enough is so in halves.
  void refine(const Site& start, const Site& stop, int depth, RefinedLink& link) const {
    const Step step = step_between(start, stop);
    const double error = error_of(step.piece, start, stop, kProbes);
    const double turn = std::acos(std::clamp(dot(start.point.first, stop.point.first), -1.0, 1.0));
    if ((error <= limit_ && turn <= kLongestTurn) || depth >= kDeepest ||
        link.pieces.size() >= link.most || late() || is_point(step, start, stop))
      return link.pieces.push_back({step, error, stop});
    const double station = 0.5 * (start.station + stop.station);
    const Site middle{station, 0, 0, tracer_.at(station, true)};
    // All three images may agree on another branch: the true middle point has to be near.
    const double off =
        distance_from(step.piece, middle.point.point) * middle.point.sine / wanted_.gap;
    const double worst = std::max(error, off);
    const bool halves = turn <= kLongestTurn && worst <= 32 * limit_;
    for (const auto& [from, to] : {std::pair{&start, &middle}, std::pair{&middle, &stop}})
      if (!halves || !refine_half(*from, *to, worst / 64, link))
        refine(*from, *to, depth + 1, link);
  }

  // `expected` is the error by its order; the piece tells whether it is.
  bool refine_half(const Site& start, const Site& stop, double expected, RefinedLink& link) const {
    const Step step = step_between(start, stop);
    const double error = error_of(step.piece, start, stop, kMiddleProbe);
    if (error > limit_) return false;
    link.pieces.push_back({step, std::max(error, expected), stop});
    return true;
  }

  Step step_between(const Site& start, const Site& stop) const {
    return conic_ != nullptr ? step_by_conic(start.point, stop.point, *conic_)
                             : step_by_length(start.point, stop.point);
  }

  double error_of(const QuinticPiece& piece, const Site& start, const Site& stop,
                  std::span<const Probe> probes) const {
    if (!(length(piece.place) > 0)) return kInfinity;
    const double sine = std::min(start.point.sine, stop.point.sine);
    const double from = conic_ != nullptr ? parameter_at(*conic_, start.point.point) : 0;
    const double apart = tracer_.gap_at(0.5 * (start.station + stop.station));
    double error = 0;
    for (const auto& [t, factor] : probes) {
      Gaps gaps =
          gaps_at(a_, b_, value_at(piece.points, t), conic_, from + t * length(piece.place));
      gaps.between = std::max(gaps.between - apart, 0.0);
      error = std::max(error, factor * relative_gap(gaps, wanted_, sine));
    }
    return error;
  }

  void append(const Refined& refined) {
    SmoothRun& run = runs_.back();
    ++count_;
    is_at_stop_ = refined.step.length > kNoLength * wanted_.gap;
    if (!is_at_stop_) {  // both ends in one point, or no point
      run.sites.back().station = refined.stop.station;
      return;
    }
    QuinticPiece piece = refined.step.piece;
    const double from = run.sites.back().parameter;
    stands_still_ = stands_still_ || !(from + length(piece.place) > from);
    piece.place = {from, from + length(piece.place)};
    Site stop = refined.stop;
    stop.parameter = piece.place.to;
    stop.length = run.sites.back().length + refined.step.length;
    run.pieces.push_back(piece);
    run.errors.push_back(refined.error);
    run.sites.push_back(stop);
  }

  const ChainTracer& tracer_;
  const BezierSurface& a_;
  const BezierSurface& b_;
  const Agreement wanted_;
  const double limit_;
  const Conic* conic_;
  const WorkLimit* work_;
  std::size_t count_ = 0;
  const std::size_t most_pieces_ = kMaxPieces + kPiecesOfLink * tracer_.stations().size();
  bool stands_still_ = false;  // the parameter, somewhere along the chain
  bool is_at_stop_ = true;     // the last site is where its link ends
  Joint last_;                 // of the links so far
  std::vector<SmoothRun> runs_;
};

}  // namespace

Vec7 seven(const Vec3& x, const Vec2& a, const Vec2& b) {
  return {x[0], x[1], x[2], a[0], a[1], b[0], b[1]};
}

Vec3 space(const Vec7& x) { return {x[0], x[1], x[2]}; }
Vec2 chart_a(const Vec7& x) { return {x[3], x[4]}; }
Vec2 chart_b(const Vec7& x) { return {x[5], x[6]}; }

Gaps gaps_at(const BezierSurface& a, const BezierSurface& b, const Vec7& x, const Conic* conic,
             double parameter) {
  const Vec3 on_a = point_at(a, chart_a(x)), on_b = point_at(b, chart_b(x));
  const Vec3 point = conic != nullptr ? point_at(*conic, parameter) : space(x);
  const double off = distance(point, space(x));
  return {off + distance(point, on_a), off + distance(point, on_b), distance(on_a, on_b)};
}

double relative_gap(const Gaps& gaps, const Agreement& wanted, double sine) {
  const double between = std::max(wanted.gap * std::clamp(sine, kMinSine, 1.0), wanted.rounding);
  return std::max(std::max(gaps.a, gaps.b) / wanted.gap, gaps.between / between);
}

std::vector<SmoothRun> smooth_runs(const ChainTracer& tracer, const BezierSurface& a,
                                   const BezierSurface& b, const Agreement& wanted, double limit,
                                   const Conic* conic, const WorkLimit* work) {
  return Sampler(tracer, a, b, wanted, limit, conic, work).run();
}

}  // namespace blossom
