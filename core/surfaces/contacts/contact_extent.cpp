// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/contacts/contact_extent.h"

#include <algorithm>

#include "core/base/disjoint_sets.h"
#include "core/forms/evaluation.h"

namespace blossom {
namespace {

// A contact is a curve if it is longer than kShort and most of it is far closer than the tolerance
// (or than it is where branches fork off its ends: it may end there before its gap has grown to
// the tolerance), or if it is longer than kLong and either hardly anything is or the gap of most
// of it is the same within kEven: a strip of constant gap. A zero of order k shrinks by 64^(-1/k)
// when the tolerance does by 64, so points up to order 8 are told from curves.
constexpr double kShort = 1e-3;  // of the size
constexpr double kLong = 0.05;
constexpr double kCloser = 1.0 / 64;  // of the tolerance
constexpr double kLargePart = 0.6;
constexpr double kHardlyAny = 0.1;
constexpr double kEven = 1.5;  // of the square of the distance to a zero it is a fifth

double length_between(const ContactSteps& steps, double low, double high) {
  double sum = 0;
  for (const auto& [gap, step] : steps)
    if (gap >= low && gap <= high) sum += step;
  return sum;
}

// The gap up to which a contact goes. Where it is far smaller yet, that may be rounding.
double level_of(const ContactChain& chain, double tolerance) {
  double level = 0;
  if (!chain.arms[0].empty()) level = chain.path.front().gap;
  if (!chain.arms[1].empty()) level = std::max(level, chain.path.back().gap);
  return level > kCloser * kCloser * tolerance ? std::min(level, tolerance) : tolerance;
}

// True if most of a contact has the same gap: that of its middle by size.
bool has_even_gap(ContactSteps steps, double length) {
  std::sort(steps.begin(), steps.end());
  double sum = 0;
  for (const auto& [gap, step] : steps)
    if ((sum += step) >= 0.5 * length)
      return length_between(steps, gap / kEven, gap * kEven) > kLargePart * length;
  return false;
}

}  // namespace

Vec3 ContactExtent::point(const ContactPoint& p) const {
  return point_at(a_.tree(p.patch_a).patch(), p.x[0], p.x[1]);
}

ContactSteps ContactExtent::steps_of(const ContactChain& chain) const {
  ContactSteps steps;
  for (std::size_t i = 1; i < chain.path.size(); ++i) {
    const ContactPoint &p = chain.path[i - 1], &q = chain.path[i];
    steps.push_back({std::max(p.gap, q.gap), distance(point(p), point(q))});
  }
  return steps;
}

bool ContactExtent::is_strip(const ContactSteps& steps, double length) const {
  const double close = length_between(steps, 0, kCloser * tolerance_);
  return length > kLong * size_ && (close < kHardlyAny * length || has_even_gap(steps, length));
}

void ContactExtent::measure(ContactChain& chain) const {
  for (const ContactPoint& p : chain.path) {
    const Vec3 x = point(p);
    chain.box = joined(chain.box, {x, x});
  }
  const ContactSteps steps = steps_of(chain);
  for (const auto& [gap, step] : steps) chain.length += step;
  const double close = length_between(steps, 0, kCloser * level_of(chain, tolerance_));
  chain.curve =
      chain.length > kShort * size_ &&
      (chain.closed || close > kLargePart * chain.length || is_strip(steps, chain.length));
}

bool ContactExtent::ends_in(const ContactChain& chain, const ContactChain& cluster) const {
  const double most = kContactJoinRadius * size_;
  return squared_distance(cluster.box, point(chain.path.front())) <= most * most ||
         squared_distance(cluster.box, point(chain.path.back())) <= most * most;
}

void ContactExtent::measure_across(std::vector<ContactChain>& chains,
                                   std::size_t clusters_from) const {
  DisjointSets groups(clusters_from);
  for (std::size_t c = clusters_from; c < chains.size(); ++c) {
    std::size_t first = clusters_from;
    for (std::size_t i = 0; i < clusters_from; ++i) {
      if (!ends_in(chains[i], chains[c])) continue;
      if (first == clusters_from) first = i;
      groups.join(i, first);
    }
  }
  for (std::size_t g = 0; g < clusters_from; ++g) {
    ContactSteps steps;
    double length = 0;
    for (std::size_t i = 0; i < clusters_from; ++i) {
      if (groups.find(i) != g) continue;
      const ContactSteps more = steps_of(chains[i]);
      steps.insert(steps.end(), more.begin(), more.end());
      length += chains[i].length;
    }
    if (!is_strip(steps, length)) continue;
    for (std::size_t i = 0; i < clusters_from; ++i)
      if (groups.find(i) == g) chains[i].curve = true;
  }
}

}  // namespace blossom
