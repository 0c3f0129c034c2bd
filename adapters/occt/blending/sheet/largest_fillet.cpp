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
constexpr double kJustBelow[] = {0, 1e-6, 1e-3};
constexpr double kJustAbove = 1e-3;   // relative: what works there was not stopped by the limit
constexpr int kMostLimits = 4;        // edges whose limits are followed, one after the other
constexpr double kFall = 8;           // from radius to radius until one works
constexpr double kLeastShare = 1e-3;  // of the radius asked for: a smaller one is no help
constexpr double kBracketed = 1.01;   // ratio of the bracket's ends
// Edges that all trials together round, about ten seconds of work: then the bracket stays as it is.
constexpr std::size_t kMostEdges = 1000;

class RadiusTrials {
 public:
  RadiusTrials(Filleting& work, const std::vector<FilletEdges>& chains, double radius,
               const FilletRefusal& why)
      : work_(work), chains_(chains), asked_(radius), high_(radius), why_(why) {
    for (const FilletEdges& chain : chains) edges_ += chain.size();
  }

  std::optional<LargestFillet> found();

 private:
  bool works(double radius);
  bool may_go_on() const { return tried_ < kMostEdges; }
  std::optional<FilletLimit> limit() const;
  bool follow_limits();
  bool fall();
  void close_bracket();

  Filleting& work_;
  const std::vector<FilletEdges>& chains_;
  std::size_t edges_ = 0, tried_ = 0;
  double asked_;
  double low_ = 0, high_;  // works, does not
  FilletRefusal why_;      // at the least radius that did not
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
  for (int i = 0; i < kMostLimits && may_go_on(); ++i) {
    const auto next = limit();
    if (!next || next->radius < kLeastShare * asked_) return false;
    for (const double below : kJustBelow)
      if (works((1 - below) * next->radius)) {
        stopped_ = next->cause;
        return true;
      }
  }
  return false;
}

bool RadiusTrials::fall() {
  while (high_ > kFall * kLeastShare * asked_ && may_go_on())
    if (works(high_ / kFall)) return true;
  return false;
}

void RadiusTrials::close_bracket() {
  while (high_ > kBracketed * low_ && may_go_on()) works(std::sqrt(low_ * high_));
}

std::optional<LargestFillet> RadiusTrials::found() {
  const bool at_limit = follow_limits();
  if (at_limit) {
    const double above = low_ * (1 + kJustAbove);
    if (above >= high_ || !works(above)) return LargestFillet{low_, stopped_};
    stopped_.clear();
  } else if (!fall()) {
    return std::nullopt;
  }
  close_bracket();
  return LargestFillet{low_, stopped_};
}

}  // namespace

std::optional<LargestFillet> largest_fillet(Filleting& work, const std::vector<FilletEdges>& chains,
                                            double radius, const FilletRefusal& why) {
  if (why.fault == FilletFault::Edge) return std::nullopt;
  return RadiusTrials(work, chains, radius, why).found();
}

}  // namespace blossom::occt
