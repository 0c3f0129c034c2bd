// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tracing/fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "core/base/not_zero.h"
#include "core/base/parallel.h"
#include "core/base/unbounded.h"
#include "core/tracing/conic_fit.h"
#include "core/tracing/deviation.h"
#include "core/tracing/sites.h"
#include "core/tracing/spline_fit.h"

namespace blossom {
namespace {

// No fit is asked to be more accurate than any of these three.
constexpr double kGaps = 16;         // times the surfaces' gap: that is half of a sampling's share
constexpr double kRounding = 1e-12;  // times the size
constexpr double kRoundings = 0x1p-46;  // times the largest coordinate, for far from the origin

constexpr double kToleranceShare = 0.3;   // of the wanted tolerance, left to one fit
constexpr double kLengthShare = 5e-7;     // of a curve's length: small loops keep theirs to 1e-6
constexpr double kSamplingShare = 0.125;  // of the fit's error, left to the pieces it is made from
constexpr int kMaxRounds = 8;             // of choosing knots
constexpr double kAim = 0.7;              // part of the wanted accuracy that knots are chosen for
constexpr int kMovingRounds = 2;          // then knots stay, and are only added
constexpr double kWorthARound = 0.9;      // of the knots at most, or no further round is made
constexpr double kMinError = 1e-12;       // of the wanted accuracy: a smaller error is rounding
constexpr double kWidening = 0.6;         // of spans, over a unit of length
constexpr std::size_t kMinSamples = 49;
constexpr double kCountRounding = 1e-9;  // of samples
constexpr double kWholeSpan = 1e-9;      // of a span: a rest that needs none of its own
constexpr double kSagOfSize = 1e-4;      // a chord may leave a curve by this part of the surfaces,
constexpr double kSagOfRun = 1e-3;       // and of the run, whose loops may be small
constexpr std::size_t kRunGrain = 8;     // runs that one thread fits in a row
constexpr std::size_t kSampleGrain = 8;  // pieces that it takes samples on
constexpr double kLastStep = 1e-8;  // of the size: Newton's step from there to a sample is exact

// Traced points leave a conic by rounding alone: so much of the curve's length and of the size.
constexpr double kConicOfLength = 1e-11;
constexpr double kConicOfSize = 1e-13;
// A conic is worth having if it is about as near to the surfaces as a spline would be.
constexpr double kConicDeviation = 4;  // of the wanted accuracy, and of the gap between the images

// Errors of quintics over spans of one width: of splines with simple knots over that of a Hermite
// piece. For one derivative of order 6 it is 61 (Favard's constant 1.2726 over pi^6, times 6! 2^6);
// of the coordinates' errors most cancel in the gaps, and so few are left.
constexpr double kSplineOverHermite = 6;

// How many spans a unit of length wants, between neighbouring parameters.
struct Density {
  std::vector<double> parameters, values;
};

// The width of spans changes by a bounded part of the way: an error may vanish by chance.
void level(Density& density) {
  std::vector<double>& values = density.values;
  const auto middle = [&](std::size_t i) {
    return 0.5 * (density.parameters[i] + density.parameters[i + 1]);
  };
  const auto raise = [&](std::size_t to, std::size_t from) {
    const double way = std::abs(middle(to) - middle(from));
    values[to] = std::max(values[to], 1 / (1 / values[from] + kWidening * way));
  };
  for (std::size_t i = 1; i < values.size(); ++i) raise(i, i - 1);
  for (std::size_t i = values.size(); i-- > 1;) raise(i - 1, i);
}

Density first_density(const SmoothRun& run) {
  Density density;
  density.parameters.push_back(run.sites.front().parameter);
  for (std::size_t i = 0; i < run.pieces.size(); ++i) {
    const double width = length(run.pieces[i].place);
    const double error = std::max(run.errors[i], kMinError);
    density.parameters.push_back(run.pieces[i].place.to);
    density.values.push_back(std::pow(error * kSplineOverHermite / kAim, 1.0 / 6) / width);
  }
  level(density);
  return density;
}

Density next_density(const RunSpline& spline, const std::vector<double>& errors) {
  Density density{spline.knots, {}};
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double change = std::clamp(std::pow(errors[i] / kAim, 1.0 / 6), 0.4, 2.0);
    density.values.push_back(change / (spline.knots[i + 1] - spline.knots[i]));
  }
  level(density);
  return density;
}

// The knots that share the integral of the density evenly.
std::vector<double> knots_of(const Density& density) {
  double total = 0;
  for (std::size_t i = 0; i < density.values.size(); ++i)
    total += density.values[i] * (density.parameters[i + 1] - density.parameters[i]);
  const double spans = std::max(1.0, std::ceil(total - kWholeSpan));
  std::vector<double> knots{density.parameters.front()};
  double reached = 0;
  std::size_t i = 0;
  for (double k = 1; k < spans; ++k) {
    const double goal = k * total / spans;
    const auto share = [&] {
      return density.values[i] * (density.parameters[i + 1] - density.parameters[i]);
    };
    while (i + 1 < density.values.size() && reached + share() < goal) {
      reached += share();
      ++i;
    }
    const double knot = density.parameters[i] + (goal - reached) / density.values[i];
    if (knot > knots.back() && knot < density.parameters.back()) knots.push_back(knot);
  }
  knots.push_back(density.parameters.back());
  return knots;
}

// Splines of runs one after the other, with one knot of its own multiplicity where two meet.
struct JoinedSpline {
  std::vector<double> knots;
  std::vector<int> multiplicities;
  std::vector<Vec7> poles;
};

// Where both have d derivatives in common, d + 1 poles of each are replaced by d + 1 of both. The
// only one that is in neither, at a curvature continuous knot b, is the blossom at (l, b, b, b, r)
// with the knots next to b: affine in r, and known at b and at the knot before l.
void append(JoinedSpline& joined, const RunSpline& next, int multiplicity_at_end) {
  std::size_t skipped = 0;
  if (!joined.poles.empty()) {
    const int multiplicity = joined.multiplicities.back();
    skipped = multiplicity == kFitDegree - 2 ? 2 : 1;
    const Vec7 at_b = joined.poles[joined.poles.size() - 2];
    const Vec7 at_l2 = joined.poles[joined.poles.size() - 3];
    if (multiplicity < kFitDegree) joined.poles.pop_back();
    if (multiplicity < kFitDegree - 1) {
      const std::size_t last = joined.knots.size() - 1;
      const double b = joined.knots[last];
      const double l2 = joined.knots[joined.multiplicities[last - 1] > 1 ? last - 1 : last - 2];
      joined.poles.back() = at_b + (at_b - at_l2) * ((next.knots[1] - b) / (b - l2));
    }
  } else {
    joined.knots.push_back(next.knots.front());
    joined.multiplicities.push_back(kFitDegree + 1);
  }
  joined.knots.insert(joined.knots.end(), next.knots.begin() + 1, next.knots.end());
  joined.multiplicities.resize(joined.knots.size(), 1);
  joined.multiplicities.back() = multiplicity_at_end;
  joined.poles.insert(joined.poles.end(), next.poles.begin() + static_cast<std::ptrdiff_t>(skipped),
                      next.poles.end());
}

std::vector<double> halved_where_missed(const RunSpline& spline,
                                        const std::vector<double>& errors) {
  std::vector<double> knots{spline.knots.front()};
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (errors[i] > 1) knots.push_back(0.5 * (spline.knots[i] + spline.knots[i + 1]));
    knots.push_back(spline.knots[i + 1]);
  }
  return knots;
}

// Spans next to a pole may be too short to be halved.
bool increase(const std::vector<double>& knots) {
  return std::adjacent_find(knots.begin(), knots.end(),
                            [](double p, double q) { return !(p < q); }) == knots.end();
}

class Fitter {
 public:
  Fitter(const ChainTracer& tracer, const BezierSurface& a, const BezierSurface& b,
         const FitOptions& options)
      : tracer_(tracer), a_(a), b_(b), options_(options), wanted_(wanted()) {}

  IntersectionCurve run() {
    const double whole = tracer_.stations().back();
    conic_ = conic_along(tracer_, kConicOfLength * whole + kConicOfSize * options_.size);
    if (conic_) {
      IntersectionCurve curve = fitted_curve();
      const Deviation& d = curve.deviation;
      if (std::max(d.a, d.b) <= kConicDeviation * std::max(wanted_.gap, d.between)) return curve;
      conic_.reset();
    }
    return fitted_curve();
  }

 private:
  bool late() const { return options_.work != nullptr && options_.work->late_after_search(); }

  Agreement wanted() const {
    double largest = 0;
    for (const Vec3& x : tracer_.known_points()) largest = std::max(largest, max_norm(x));
    const double rounding = kRoundings * largest;
    const double length = tracer_.stations().back();
    return {std::max({std::min(kToleranceShare * options_.tolerance, kLengthShare * length),
                      kRounding * options_.size, kGaps * options_.gap, rounding}),
            rounding};
  }

  const Conic* conic() const { return conic_ ? &*conic_ : nullptr; }

  IntersectionCurve fitted_curve() {
    IntersectionCurve none;
    none.length = std::numeric_limits<double>::quiet_NaN();
    none.deviation.a = kInfinity;
    runs_ = smooth_runs(tracer_, a_, b_, wanted_, kSamplingShare, conic(), options_.work);
    if (runs_.empty() ||
        std::any_of(runs_.begin(), runs_.end(), [&](const SmoothRun& run) { return strays(run); }))
      return none;
    if (conic_ && conic_->is_closed()) complete_turn();
    IntersectionCurve curve;
    write_splines(curve);
    if (late()) return none;
    sample(curve);
    curve.conic = conic_;
    curve.deviation = proven_deviation(curve, a_, b_);
    const Deviation& d = curve.deviation;
    return std::max({d.a, d.b, d.between}) <= options_.most ? curve : none;
  }

  // A loop's parameter grows by a turn, without rounding.
  void complete_turn() {
    Site& last = runs_.back().sites.back();
    const Site& first = runs_.front().sites.front();
    if (last.point.point != first.point.point) return;
    last.parameter = first.parameter + 2 * std::numbers::pi;
    runs_.back().pieces.back().place.to = last.parameter;
  }

  // Pieces that are as good as wanted need not be looked at again.
  bool strays(const SmoothRun& run) const {
    for (std::size_t i = 0; i < run.pieces.size(); ++i) {
      if (run.errors[i] <= 1) continue;
      for (const double t : {0.25, 0.5, 0.75}) {
        const Gaps gaps =
            gaps_at(a_, b_, value_at(run.pieces[i].points, t), conic(), at(run.pieces[i].place, t));
        if (!(std::max({gaps.a, gaps.b, gaps.between}) <= options_.most)) return true;
      }
    }
    return false;
  }

  // The spline of a run with the fewest knots found; nothing if none was good enough.
  std::optional<RunSpline> fit(const SmoothRun& run) const {
    std::optional<RunSpline> best;
    std::vector<double> knots = knots_of(first_density(run));
    for (int round = 0; round < kMaxRounds && increase(knots) && !late(); ++round) {
      RunSpline spline = least_squares_spline(run.pieces, knots);
      // Hermite pieces with triple knots would be as short.
      if (spline.poles.size() > 3 * run.pieces.size() + 3) break;
      const std::vector<double> errors = span_errors(run, spline);
      const bool good = *std::max_element(errors.begin(), errors.end()) <= 1;
      knots = !good && round >= kMovingRounds ? halved_where_missed(spline, errors)
                                              : knots_of(next_density(spline, errors));
      if (good && (!best || spline.poles.size() < best->poles.size())) best = std::move(spline);
      if (best && static_cast<double>(knots.size()) >
                      kWorthARound * static_cast<double>(best->knots.size()))
        break;
    }
    return best;
  }

  // The largest gap at the checks of every span as a part of the wanted accuracy.
  std::vector<double> span_errors(const SmoothRun& run, const RunSpline& spline) const {
    std::vector<double> errors(spline.knots.size() - 1, 0.0);
    std::size_t site = 0;
    for (std::size_t i = 0; i < spline.values.size(); ++i) {
      const std::size_t span = i / kJudgedChecks.size();
      while (site + 2 < run.sites.size() && run.sites[site + 1].parameter < spline.knots[span])
        ++site;
      const double sine = std::min(run.sites[site].point.sine, run.sites[site + 1].point.sine);
      const double t = at(Interval{spline.knots[span], spline.knots[span + 1]},
                          kFitChecks[kJudgedChecks[i % kJudgedChecks.size()]]);
      const Gaps gaps = gaps_at(a_, b_, spline.values[i], conic(), t);
      errors[span] = std::max(errors[span], relative_gap(gaps, wanted_, sine));
    }
    return errors;
  }

  void write_splines(IntersectionCurve& curve) const {
    std::vector<std::optional<RunSpline>> splines(runs_.size());
    parallel_for(runs_.size(), kRunGrain, [&](std::size_t i) { splines[i] = fit(runs_[i]); });
    JoinedSpline joined;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      const SmoothRun& run = runs_[i];
      if (splines[i]) {
        append(joined, *splines[i], run.multiplicity);
        continue;
      }
      for (const QuinticPiece& piece : run.pieces)
        append(joined,
               {{piece.place.from, piece.place.to}, {piece.points.begin(), piece.points.end()}, {}},
               &piece == &run.pieces.back() ? run.multiplicity : kFitDegree - 2);
    }
    joined.multiplicities.back() = kFitDegree + 1;
    curve.length = runs_.back().sites.back().length;
    curve.curve = {kFitDegree, joined.knots, joined.multiplicities, {}};
    curve.chart_a = {kFitDegree, joined.knots, joined.multiplicities, {}};
    curve.chart_b = {kFitDegree, joined.knots, joined.multiplicities, {}};
    for (auto* points : {&curve.chart_a.points, &curve.chart_b.points})
      points->reserve(joined.poles.size());
    curve.curve.points.reserve(joined.poles.size());
    for (const Vec7& pole : joined.poles) {
      curve.curve.points.push_back(space(pole));
      curve.chart_a.points.push_back(chart_a(pole));
      curve.chart_b.points.push_back(chart_b(pole));
    }
  }

  // The chord of a piece may leave the curve by so much.
  double largest_sag() const {
    Vec3 low = runs_.front().sites.front().point.point, high = low;
    for (const SmoothRun& run : runs_)
      for (const QuinticPiece& piece : run.pieces)
        for (const double t : {0.25, 0.5, 0.75, 1.0}) {
          const Vec3 x = space(value_at(piece.points, t));
          for (int k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], x[k]);
            high[k] = std::max(high[k], x[k]);
          }
        }
    return std::max(std::min(kSagOfSize * options_.size, kSagOfRun * distance(low, high)),
                    kNotZero);
  }

  // Exact points, dense enough to draw and to compare the curve by its chords.
  void sample(IntersectionCurve& curve) const {
    const double sag = largest_sag();
    curve.least_angle = 1;
    const auto add = [&](const SurfacePoint& p, double sine, double parameter) {
      curve.samples.push_back(p);
      curve.sample_parameters.push_back(parameter);
      curve.least_angle = std::min(curve.least_angle, sine);
    };
    const auto add_site = [&](const Site& site) {
      add({site.point.point, site.point.a, site.point.b}, site.point.sine, site.parameter);
    };
    std::vector<std::pair<const SmoothRun*, std::size_t>> pieces;
    for (const SmoothRun& run : runs_)
      for (std::size_t k = 0; k < run.pieces.size(); ++k) pieces.emplace_back(&run, k);
    std::vector<std::vector<CrossingPoint>> inner(pieces.size());
    parallel_for(pieces.size(), kSampleGrain, [&](std::size_t i) {
      const auto& [run, k] = pieces[i];
      inner[i] = samples_inside(
          *run, k, samples_between(run->sites[k], run->sites[k + 1], sag, curve.length));
    });
    add_site(runs_.front().sites.front());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const auto& [run, k] = pieces[i];
      const Site &start = run->sites[k], &stop = run->sites[k + 1];
      for (std::size_t j = 0; j < inner[i].size(); ++j) {
        const double fraction = fraction_of(j, inner[i].size());
        add(inner[i][j].point, inner[i][j].sine,
            at(Interval{start.parameter, stop.parameter}, fraction));
      }
      add_site(stop);
    }
    curve.least_angle = std::asin(std::min(curve.least_angle, 1.0));
  }

  // Place of a point among so many inside of a piece.
  static double fraction_of(std::size_t index, std::size_t inside) {
    return static_cast<double>(index + 1) / static_cast<double>(inside + 1);
  }

  std::vector<CrossingPoint> samples_inside(const SmoothRun& run, std::size_t piece,
                                            int parts) const {
    std::vector<CrossingPoint> samples(static_cast<std::size_t>(parts - 1));
    for (std::size_t j = 0; j < samples.size(); ++j)
      samples[j] = sample_on(run, piece, fraction_of(j, samples.size()));
    return samples;
  }

  // A piece that is as good as wanted is so near the curve that there is no need to trace it again.
  CrossingPoint sample_on(const SmoothRun& run, std::size_t piece, double fraction) const {
    const double station =
        at(Interval{run.sites[piece].station, run.sites[piece + 1].station}, fraction);
    if (run.errors[piece] <= 1) {
      const Vec7 x = value_at(run.pieces[piece].points, fraction);
      const SurfacePoint near{space(x), chart_a(x), chart_b(x)};
      if (const auto found = tracer_.beside(station, near, kLastStep * options_.size))
        return *found;
    }
    const TracePoint p = tracer_.at(station, true);
    return {{p.point, p.a, p.b}, p.sine};
  }

  static int samples_between(const Site& start, const Site& stop, double sag, double whole) {
    const double width = stop.length - start.length;
    const double turn = std::acos(std::clamp(dot(start.point.first, stop.point.first), -1.0, 1.0));
    const double bend = std::max({norm(start.point.second), norm(stop.point.second), turn / width});
    const double by_sag = width * std::sqrt(bend / (6 * sag));
    // Of as many as the whole curve gets: rounding up in every piece would make more of them.
    const auto reached = [&](const Site& site) {
      return std::floor(static_cast<double>(kMinSamples) * site.length / whole + kCountRounding);
    };
    const double by_count = reached(stop) - reached(start);
    const double wanted = std::max(std::ceil(by_sag), by_count);
    return wanted > 1 ? static_cast<int>(std::min(wanted, 1e4)) : 1;  // 1 of a piece without width
  }

  const ChainTracer& tracer_;
  const BezierSurface& a_;
  const BezierSurface& b_;
  const FitOptions& options_;
  const Agreement wanted_;
  std::optional<Conic> conic_;
  std::vector<SmoothRun> runs_;
};

}  // namespace

IntersectionCurve fitted(const ChainTracer& tracer, const BezierSurface& a, const BezierSurface& b,
                         const FitOptions& options) {
  return Fitter(tracer, a, b, options).run();
}

}  // namespace blossom
