// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/sheet/largest_fillet.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "adapters/occt/blending/sheet/fillet_attempt.h"
#include "adapters/occt/blending/sheet/fillet_limit.h"
#include "adapters/occt/blending/sheet/nearby_chains.h"
#include "core/base/errors.h"

namespace blossom::occt {
namespace {

// Relative, below a limit: at it edges of planes and cylinders can still be rounded, but elsewhere
// a contact would run along a border, or a section have no length; the last where what is left
// between is below the tolerances of the model.
constexpr double kJustBelow[] = {0, 2e-8, 1e-6, 1e-3};
constexpr double kJustAbove = 1e-3;  // relative: what works there was not stopped by the limit
constexpr int kMaxLimits = 4;        // of the edges of one run, one after the other
constexpr int kMaxMeetings = 4;      // steps to where blends meet in an edge
// Rungs of the ladder for an octave, and where they lie in it: at no round number, as sizes of
// parts and so radii at which things just touch mostly are.
constexpr int kRungs = 2;
constexpr double kRungOffset = 0.125;
constexpr int kMaxRises = 4 * kRungs;   // larger that do not work either: to 16 times
constexpr int kMaxFalls = 10 * kRungs;  // smaller: a thousandth
// Ratios of brackets' ends: of a few edges, and of more, which take longer.
constexpr double kClosed = 1 + 1e-6;
constexpr double kRounded = 1 + 1e-3;
constexpr std::size_t kFewEdges = 4;
// Edges that are rounded until the bracket is left as it is, some seconds of work, and beside them
// all edges so many times, however many they are.
constexpr std::size_t kMaxEdges = 1000;
constexpr std::size_t kMaxWhole = 2;
constexpr std::size_t kRollsInWork = 4;  // that cost about as much as one edge that is rounded

using Chains = std::vector<FilletEdges>;

double rung(int number) { return std::exp2((number + kRungOffset) / kRungs); }

int rung_above(double radius) {
  return static_cast<int>(std::ceil(kRungs * std::log2(radius) - kRungOffset));
}

std::size_t edge_count(const Chains& chains) {
  std::size_t count = 0;
  for (const FilletEdges& chain : chains) count += chain.size();
  return count;
}

FilletEdges edges_of(const Chains& chains) {
  FilletEdges all;
  for (const FilletEdges& chain : chains) all.insert(chain.begin(), chain.end());
  return all;
}

// Of the ends of a bracket that rounding closes, or rolling.
double rounding_ratio(const Chains& chains) {
  return edge_count(chains) > kFewEdges ? kRounded : kClosed;
}

/// What is near an edge, rounded alone.
struct NearTrial {
  bool is_known = false;  // else it is most of what there is, or fails where it is not whole
  std::optional<FilletRefusal> why{};
  Chains chains{};
};

/// A radius that works, and why larger ones do not.
struct Bound {
  double radius = 0;
  double fails = std::numeric_limits<double>::infinity();
  FilletRefusal why{};  // at `fails`
  std::string stopped{};
};

LargestFillet answer(const Bound& bound) {
  return {bound.radius, bound.stopped,
          bound.stopped.empty() && bound.fails > kRounded * bound.radius};
}

class RadiusSearch {
 public:
  RadiusSearch(Filleting& work, const Chains& chains, double asked)
      : work_(work),
        chains_(chains),
        first_(rung_above(asked)),
        most_work_(kMaxEdges + kMaxWhole * edge_count(chains)) {
    for (const EdgeRun& run : edge_runs(work.body(), edges_of(chains))) {
      FilletEdges& edges = runs_.emplace_back();
      for (const RunEdge& each : run.edges) edges.emplace(each.edge, run.concave);
    }
  }

  std::optional<LargestFillet> found() try { return searched(); } catch (const LimitFailure&) {
    if (works_ > 0) return LargestFillet{works_, {}, true};
    throw;
  }

 private:
  using Trial = std::optional<FilletRefusal> (RadiusSearch::*)(const Chains&, double);
  /// What trials told, by radius and edges: searches that follow each other ask for some again.
  /// Asking counts as work, so that no search goes round for ever.
  using Told = std::map<std::pair<double, FilletEdges>, std::optional<FilletRefusal>>;
  std::optional<FilletRefusal> roll(const Chains& chains, double radius);
  std::optional<FilletRefusal> round(const Chains& chains, double radius);
  bool may_go_on() const { return rounded_ + rolled_ / kRollsInWork < most_work_; }
  const FilletEdges* run_of(int edge) const;

  std::optional<int> rung_that_rolls(const FilletEdges& run, int below);
  std::optional<int> first_rung();
  void close(Trial trial, const Chains& chains, double ratio, Bound& bound);
  bool follow_limits(Trial trial, const Chains& chains, Bound& bound);
  bool follow_meetings(const Chains& chains, Bound& bound);
  std::optional<Bound> meeting(const Bound& of);
  NearTrial near_trial(int edge, double radius);
  bool close_near(int number, Bound& bound);
  std::optional<Bound> alone(const Bound& of);
  bool rounds_at(const Bound& of, Bound& whole);
  bool go_down(int rung, Bound& bound);
  bool go_up(Bound& bound);
  std::optional<LargestFillet> searched();

  Filleting& work_;
  const Chains& chains_;
  Chains runs_;  // of all of them: what balls roll along without stopping
  int first_;    // rung above the radius asked for
  std::size_t most_work_, rolled_ = 0, rounded_ = 0;
  Told rolls_told_, rounds_told_;
  Bound rolls_;       // of the run that stops balls first, on the ladder
  double works_ = 0;  // the largest with which all were rounded
};

// Whether balls roll along the edges: much less work, and all that is wrong with most radii.
std::optional<FilletRefusal> RadiusSearch::roll(const Chains& chains, double radius) {
  rolled_ += edge_count(chains);
  const std::pair trial{radius, edges_of(chains)};
  if (const auto told = rolls_told_.find(trial); told != rolls_told_.end()) return told->second;
  return rolls_told_.emplace(trial, roll_attempt(work_, chains, radius)).first->second;
}

std::optional<FilletRefusal> RadiusSearch::round(const Chains& chains, double radius) {
  if (auto why = roll(chains, radius)) return why;
  rounded_ += edge_count(chains);
  const std::pair trial{radius, edges_of(chains)};
  if (const auto told = rounds_told_.find(trial); told != rounds_told_.end()) return told->second;
  auto why = fillet_attempt(work_, chains, radius).why;
  if (!why && chains.size() == chains_.size()) works_ = std::max(works_, radius);
  return rounds_told_.emplace(trial, std::move(why)).first->second;
}

const FilletEdges* RadiusSearch::run_of(int edge) const {
  const auto found =
      std::ranges::find_if(runs_, [&](const auto& run) { return run.count(edge) > 0; });
  return found == runs_.end() ? nullptr : &*found;
}

// The highest rung below one at which balls roll along a run, in steps that grow and then are
// halved. Where faces turn over at an end of an edge the contact of a small ball is lost in them,
// and that of a larger one passes: so if there is none the ones above are looked at.
std::optional<int> RadiusSearch::rung_that_rolls(const FilletEdges& run, int below) {
  int fails = below;
  std::optional<int> rolls;
  for (int step = 1, i = below - 1; !rolls && i >= first_ - kMaxFalls; i -= step) {
    if (roll({run}, rung(i)))
      fails = i;
    else
      rolls = i;
    if (below - i > 2 * step) step *= 2;
  }
  while (rolls && fails - *rolls > 1) {
    const int middle = *rolls + (fails - *rolls) / 2;
    (roll({run}, rung(middle)) ? fails : *rolls) = middle;
  }
  for (int i = first_; !rolls && i <= first_ + kMaxRises; ++i)
    if (i != below && !roll({run}, rung(i))) rolls = i;
  return rolls;
}

// The highest rung, not far above the radius asked for, at which balls roll along all chains.
std::optional<int> RadiusSearch::first_rung() {
  int top = first_ + 1, step = 1;
  std::set<const FilletEdges*> risen;  // what was too small at first goes down from there
  while (auto why = roll(chains_, rung(top))) {
    rolls_.fails = rung(top);
    rolls_.why = *std::move(why);
    const FilletEdges* const run = run_of(rolls_.why.edge);
    if (!run || !roll({*run}, rung(top))) {  // it is not stopped by itself
      top -= step;
      step *= 2;
      if (top < first_ - kMaxFalls || !may_go_on()) return std::nullopt;
      continue;
    }
    const auto next = rung_that_rolls(*run, top);
    if (!next || (*next > top && !risen.insert(run).second)) return std::nullopt;
    top = *next;
    rolls_.fails = rung(top + 1);
  }
  return top;
}

void RadiusSearch::close(Trial trial, const Chains& chains, double ratio, Bound& bound) {
  while (bound.fails > ratio * bound.radius && may_go_on()) {
    const double radius = std::sqrt(bound.radius * bound.fails);
    auto why = (this->*trial)(chains, radius);
    (why ? bound.fails : bound.radius) = radius;
    if (why) bound.why = *std::move(why);
  }
}

// The condition that stops the ball, if ones just below work and ones above do not.
bool RadiusSearch::follow_limits(Trial trial, const Chains& chains, Bound& bound) {
  for (int i = 0; i < kMaxLimits && !work_.is_chamfer(); ++i) {
    const int edge = bound.why.edge;
    const FilletEdges* const run = run_of(edge);
    if (!run) return false;
    const auto limit = fillet_limit(work_.body(), edge, run->at(edge), bound.radius,
                                    rung(rung_above(bound.fails)));
    if (!limit || limit->radius >= bound.fails || limit->radius <= bound.radius) return false;
    bool of_other = false;
    for (const double below : kJustBelow) {
      if (below == 0 && !limit->reached) continue;
      const double radius = (1 - below) * limit->radius;
      auto why = (this->*trial)(chains, radius);
      if (!why) {
        bound.radius = radius;
        bound.stopped = limit->cause;
        return !!(this->*trial)(chains, limit->radius * (1 + kJustAbove));
      }
      of_other = why->edge != edge;
      bound.fails = radius;
      bound.why = *std::move(why);
      if (of_other) break;  // its limit is looked at next
    }
    if (!of_other) return false;
  }
  return false;
}

// Whether blends that take too much of an edge together can be made where they just meet, or just
// below that: what they take grows with the radius, in planes just so.
bool RadiusSearch::follow_meetings(const Chains& chains, Bound& bound) {
  for (int i = 0; i < kMaxMeetings && bound.why.fits < 1 && may_go_on(); ++i) {
    const double meeting = bound.why.fits * bound.fails;
    const int edge = bound.why.edge;
    for (const double below : kJustBelow) {
      auto why = round(chains, (1 - below) * meeting);
      if (!why) {
        bound.radius = (1 - below) * meeting;
        bound.stopped = "another blend, which they meet in edge " + std::to_string(edge);
        return !!round(chains, meeting * (1 + kJustAbove));
      }
      bound.fails = (1 - below) * meeting;
      bound.why = *std::move(why);
      if (bound.why.fits < 1) break;  // what meets there is looked at next
    }
  }
  return false;
}

// Where blends near the fault just meet.
std::optional<Bound> RadiusSearch::meeting(const Bound& of) {
  if (!(of.why.fits < 1)) return std::nullopt;
  Bound bound = of;
  const NearbyChains near =
      nearby_chains(work_.body(), chains_, of.why.edge, of.why.fits * of.fails);
  return follow_meetings(near.chains, bound) ? std::optional(std::move(bound)) : std::nullopt;
}

NearTrial RadiusSearch::near_trial(int edge, double radius) {
  if (edge <= 0) return {};
  NearbyChains near = nearby_chains(work_.body(), chains_, edge, radius);
  if (2 * edge_count(near.chains) > edge_count(chains_)) return {};
  auto why = round(near.chains, radius);
  const bool is_known = !why || near.whole.count(why->edge) > 0;
  return {is_known, std::move(why), std::move(near.chains)};
}

// The largest radius with which what is near the fault works alone, if alone it works and fails as
// all do together.
std::optional<Bound> RadiusSearch::alone(const Bound& of) {
  const FilletEdges* const run = run_of(of.why.edge);
  if (!run) return std::nullopt;
  Bound bound = of;
  if (auto why = roll({*run}, of.fails)) {
    bound.why = *std::move(why);
    if (follow_limits(&RadiusSearch::roll, {*run}, bound)) return bound;
    bound = of;
    close(&RadiusSearch::roll, {*run}, rounding_ratio({*run}), bound);
    return bound;
  }
  NearTrial near = near_trial(of.why.edge, of.fails);
  const bool shows = near.is_known && near.why;
  if (shows) bound.why = *std::move(near.why);
  if (follow_limits(&RadiusSearch::round, shows ? near.chains : chains_, bound)) return bound;
  if (!shows) return std::nullopt;
  bound.radius = of.radius;
  bound.fails = of.fails;
  bound.stopped.clear();
  close(&RadiusSearch::round, near.chains, rounding_ratio(near.chains), bound);
  if (bound.radius == of.radius && round(near.chains, of.radius)) return std::nullopt;
  return bound;
}

// Whether all are rounded where some are stopped, or just below that; what fails there is the next
// to be looked at. Where no condition tells exactly where that is, by how much is of no account.
bool RadiusSearch::rounds_at(const Bound& of, Bound& whole) {
  const FilletEdges* const run = run_of(of.why.edge);
  for (const double below : kJustBelow) {
    if (of.stopped.empty() && below > 0 && 1 + below < kRounded) continue;
    const double radius = (1 - below) * of.radius;
    if (radius <= whole.radius) return true;
    auto why = round(chains_, radius);
    if (!why) {
      if (below == 0 || !of.stopped.empty()) whole = of;
      whole.radius = radius;
      return true;
    }
    whole.fails = radius;
    whole.why = *std::move(why);
    if (whole.why.edge > 0 && run_of(whole.why.edge) != run) return false;
  }
  return false;
}

// Whether all are rounded with the largest radius with which those are that are near the fault.
// They are on a rung, and are not on one of those above it.
bool RadiusSearch::close_near(int number, Bound& bound) {
  Bound near = bound;
  NearTrial trial;
  for (near.radius = rung(number); near.radius < bound.fails; near.radius = near.fails) {
    near.fails = std::min(rung(++number), bound.fails);
    trial = near_trial(bound.why.edge, near.fails);
    if (!trial.is_known) return false;
    if (trial.why) break;
  }
  if (!trial.why) return false;
  near.why = *std::move(trial.why);
  close(&RadiusSearch::round, trial.chains, rounding_ratio(trial.chains), near);
  return rounds_at(near, bound);
}

// From a rung to the first one at which all are rounded.
bool RadiusSearch::go_down(int number, Bound& bound) {
  for (; number >= first_ - kMaxFalls; --number) {
    NearTrial near = near_trial(bound.why.edge, rung(number));
    if (near.is_known && !near.why && close_near(number, bound)) return true;
    auto why = near.is_known && near.why ? std::move(near.why) : round(chains_, rung(number));
    if (!why) {
      bound.radius = rung(number);
      return true;
    }
    bound.fails = rung(number);
    bound.why = *std::move(why);
    const auto met = meeting(bound);
    if (met && rounds_at(*met, bound)) return true;
    number = std::min(number, rung_above(std::min(1.0, bound.why.fits) * bound.fails));
  }
  return false;
}

// From above the first rungs to where all are rounded, and on to where they are no more.
bool RadiusSearch::go_up(Bound& bound) {
  for (int i = first_ + 2, failed = 0; failed < kMaxRises && may_go_on(); ++i) {
    auto why = round(chains_, rung(i));
    if (!why) {
      bound.radius = rung(i);
    } else if (bound.radius > 0) {
      bound.fails = rung(i);
      bound.why = *std::move(why);
      break;
    } else {
      ++failed;
    }
  }
  return bound.radius > 0;
}

std::optional<LargestFillet> RadiusSearch::searched() {
  const auto first = first_rung();
  if (!first) return std::nullopt;
  Bound bound = rolls_;
  if (!go_down(*first, bound) || std::isinf(bound.fails))
    if (!go_up(bound)) return std::nullopt;
  while (bound.stopped.empty() && std::isfinite(bound.fails) &&
         bound.fails > rounding_ratio(chains_) * bound.radius && may_go_on()) {
    if (const auto next = alone(bound)) {
      rounds_at(*next, bound);
      continue;
    }
    const double middle = std::sqrt(bound.radius * bound.fails);
    auto why = round(chains_, middle);
    (why ? bound.fails : bound.radius) = middle;
    if (why) bound.why = *std::move(why);
  }
  return answer(bound);
}

}  // namespace

std::optional<LargestFillet> largest_fillet(Filleting& work, const std::vector<FilletEdges>& chains,
                                            double radius, const FilletRefusal& why) {
  if (why.fault == FilletFault::Edge) return std::nullopt;
  // Of trials only whether they work is used.
  struct Restored {
    Filleting& work;
    bool volumes;
    ~Restored() { work.set_volumes(volumes); }
  } const restored{work, work.set_volumes(false)};
  return RadiusSearch(work, chains, radius).found();
}

}  // namespace blossom::occt
