// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/sheet/largest_fillet.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "adapters/occt/blending/sheet/fillet_attempt.h"
#include "adapters/occt/blending/sheet/fillet_limit.h"

namespace blossom::occt {
namespace {

// Relative, below a limit: at it edges of planes and cylinders can still be rounded, but elsewhere
// a contact would run along a border, or a section have no length; the last where what is left
// between is below the tolerances of the model.
constexpr double kJustBelow[] = {0, 2e-8, 1e-6, 1e-3};
constexpr double kJustAbove = 1e-3;       // relative: what works there was not stopped by the limit
constexpr int kMaxLimits = 4;             // edges whose limits are followed, one after the other
constexpr int kMaxMeetings = 4;           // steps to where blends meet in an edge
constexpr double kFall = 2;               // from radius to radius until one works
constexpr double kMinRadiusShare = 1e-3;  // of the radius asked for: a smaller one is no help
constexpr int kMaxRises = 4;              // times kFall: larger ones that do not work either
// Ratios of the bracket's ends: as many digits as are told, or near enough where trials take long.
constexpr double kTold = 1 + 1e-6;
constexpr double kBracketed = 1.01;
// Edges that trials round all together until the bracket is near enough, about one second of work,
// and until it stays as it is, about ten.
constexpr std::size_t kManyEdges = 100;
constexpr std::size_t kMaxEdges = 1000;
constexpr std::size_t kRollsInWork = 4;  // that cost about as much as one edge that is rounded

class RadiusTrials {
 public:
  RadiusTrials(Filleting& work, const std::vector<FilletEdges>& chains, double radius,
               const FilletRefusal& why)
      : work_(work), chains_(chains), asked_(radius), why_asked_(why), high_(radius), why_(why) {
    for (const FilletEdges& chain : chains) edges_ += chain.size();
  }

  std::optional<LargestFillet> found();

 private:
  bool works(double radius);
  bool rolls(double radius);
  std::size_t done() const { return tried_ + rolled_ / kRollsInWork; }
  bool may_go_on() const { return done() < kMaxEdges; }
  bool is_open(double low) const {
    return high_ > (done() < kManyEdges ? kTold : kBracketed) * low && may_go_on();
  }
  std::optional<FilletLimit> limit() const;
  bool follow_limits();
  bool follow_meetings();
  bool fall();
  bool rise();
  void start_anew();
  void close_rolling();
  void close_bracket();

  Filleting& work_;
  const std::vector<FilletEdges>& chains_;
  std::size_t edges_ = 0, tried_ = 0, rolled_ = 0;
  double asked_;
  FilletRefusal why_asked_;  // that one does not work
  double low_ = 0, high_;    // works, does not
  FilletRefusal why_;        // at the last radius that did not
  std::string stopped_;
};

bool RadiusTrials::works(double radius) {
  tried_ += edges_;
  FilletAttempt made = fillet_attempt(work_, chains_, radius);
  if (!made.why) {
    low_ = std::max(low_, radius);
    return true;
  }
  high_ = radius;
  why_ = *std::move(made.why);
  return false;
}

// Whether balls roll along the edges: much less work, and all that is wrong with most radii.
bool RadiusTrials::rolls(double radius) {
  rolled_ += edges_;
  auto why = roll_attempt(work_, chains_, radius);
  if (!why) return true;
  high_ = radius;
  why_ = *std::move(why);
  return false;
}

// Of the edge that was at fault last; of balls alone.
std::optional<FilletLimit> RadiusTrials::limit() const {
  if (work_.is_chamfer()) return std::nullopt;
  for (const FilletEdges& chain : chains_) {
    const auto edge = chain.find(why_.edge);
    if (edge == chain.end()) continue;
    const auto limit = fillet_limit(work_.body(), edge->first, edge->second, high_);
    if (limit && limit->radius < high_) return limit;
  }
  return std::nullopt;
}

// Whether just below one of the limits all edges can be rounded.
bool RadiusTrials::follow_limits() {
  for (int i = 0; i < kMaxLimits && may_go_on(); ++i) {
    const int followed = why_.edge;
    const auto next = limit();
    if (!next || next->radius < kMinRadiusShare * asked_) return false;
    for (const double below : kJustBelow) {
      if (below == 0 && !next->reached) continue;
      if (why_.edge != followed) break;  // the limit of that edge is looked at next
      const double radius = (1 - below) * next->radius;
      if (rolls(radius) && works(radius)) {
        stopped_ = next->cause;
        return true;
      }
    }
  }
  return false;
}

// Whether blends that take too much of an edge together can be made where they just meet, or just
// below that: what they take grows with the radius, in planes just so.
bool RadiusTrials::follow_meetings() {
  for (int i = 0; i < kMaxMeetings && why_.fits < 1 && may_go_on(); ++i) {
    const double meeting = why_.fits * high_;
    const int edge = why_.edge;
    for (const double below : kJustBelow) {
      if (works((1 - below) * meeting)) {
        stopped_ = "another blend, which they meet in edge " + std::to_string(edge);
        return true;
      }
      if (why_.fits < 1) break;  // what meets there is looked at next
    }
  }
  return false;
}

// However many edges there are: else nothing could be said of smaller radii.
bool RadiusTrials::fall() {
  while (high_ > kFall * kMinRadiusShare * asked_) {
    const double radius = high_ / kFall;
    if (rolls(radius) && works(radius)) return true;
  }
  return false;
}

// Where faces turn over at an end of the edge the contact of a small ball is lost in them, and that
// of a larger one passes.
bool RadiusTrials::rise() {
  start_anew();
  for (int failed = 0; failed < kMaxRises && may_go_on();) {
    const double radius = kFall * std::max(low_, high_);
    if (rolls(radius) && works(radius)) continue;
    if (low_ > 0 || is_own_fault(why_.fault)) break;
    ++failed;
  }
  return low_ > 0;
}

// As if none had been tried: those that do not work tell nothing of larger ones that may.
void RadiusTrials::start_anew() {
  high_ = asked_;
  why_ = why_asked_;
}

// The largest ball that rolls where larger ones do not; then all else has to work with it.
void RadiusTrials::close_rolling() {
  if (!is_own_fault(why_.fault)) return;
  double rolling = low_;
  while (is_open(rolling)) {
    const double radius = std::sqrt(rolling * high_);
    if (rolls(radius)) rolling = radius;
  }
  if (rolling > low_) works(rolling);
}

void RadiusTrials::close_bracket() {
  while (is_open(low_)) {
    const double radius = std::sqrt(low_ * high_);
    if (rolls(radius)) works(radius);
  }
}

std::optional<LargestFillet> RadiusTrials::found() {
  if (follow_limits() || follow_meetings()) {
    const double above = low_ * (1 + kJustAbove);
    if (above >= asked_ || !rolls(above) || !works(above)) return LargestFillet{low_, stopped_};
    stopped_.clear();
    if (high_ <= low_) start_anew();  // at the limit alone none works
  } else {
    start_anew();
    if (!fall() && !rise()) return std::nullopt;
  }
  close_rolling();
  close_bracket();
  return LargestFillet{low_, stopped_};
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
  return RadiusTrials(work, chains, radius, why).found();
}

}  // namespace blossom::occt
