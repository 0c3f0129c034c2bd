// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/gap/chart_ownership.h"

namespace blossom {

bool within(const Box2& inner, const Box2& outer) {
  return within(inner[0], outer[0]) && within(inner[1], outer[1]);
}

int ChartOwnership::add_chart(const Box2& piece) {
  pieces_.push_back(piece);
  return static_cast<int>(pieces_.size()) - 1;
}

ChartOwnership::Claim ChartOwnership::claim_of(const Box2& foot, int chart) const {
  for (const int cell : path_)
    if (const auto found = claims_.find(cell); found != claims_.end())
      for (const int other : found->second)
        if (other != chart) {
          if (within(foot, pieces_[static_cast<std::size_t>(other)])) return Claim::Taken;
          if (meets(foot, other)) return Claim::Partly;
        }
  if (const auto found = claims_below_.find(path_.back()); found != claims_below_.end())
    for (const int other : found->second)
      if (other != chart && meets(foot, other)) return Claim::Partly;
  return Claim::Free;
}

bool ChartOwnership::meets(const Box2& foot, int chart) const {
  const Box2& piece = pieces_[static_cast<std::size_t>(chart)];
  return overlap(foot[0], piece[0]) && overlap(foot[1], piece[1]);
}

void ChartOwnership::claim(int chart) {
  claims_[path_.back()].push_back(chart);
  for (const int cell : path_)
    if (cell != path_.back()) claims_below_[cell].insert(chart);
}

}  // namespace blossom
