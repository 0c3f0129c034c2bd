// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/branches/spurious_branches.h"

#include <algorithm>

#include "core/bounds/box_tree.h"
#include "core/surfaces/branches/found_places.h"

namespace blossom {
namespace {

// A chain this many times as long as the cluster at both its ends belongs to the contact there.
constexpr double kClusterReach = 4;

// The contact that a closed chain passes, if that is the only one it is an arm of; or -1.
int contact_on(const Chain& chain, const std::vector<ContactChain>& contacts) {
  const auto holds = [&](ArcEnd end) {
    return std::any_of(chain.links.begin(), chain.links.end(), [&](const ChainLink& link) {
      return static_cast<std::size_t>(link.arc) == end / 2;
    });
  };
  int found = -1;
  for (std::size_t i = 0; i < contacts.size(); ++i)
    for (const auto& arms : contacts[i].arms) {
      if (std::none_of(arms.begin(), arms.end(), holds)) continue;
      if (found >= 0 && found != static_cast<int>(i)) return -1;
      found = static_cast<int>(i);
    }
  return found;
}

// The contact that is a pole and that a box meets, or -1.
int pole_at(const Box& box, const std::vector<ContactChain>& contacts, double reach) {
  for (std::size_t i = 0; i < contacts.size(); ++i)
    if (contacts[i].pole && !contacts[i].curve && meet(widened(contacts[i].box, reach), box))
      return static_cast<int>(i);
  return -1;
}

// The contact that the chain, with arms in the box, is short enough to be a part of, or -1.
int contact_with(const Chain& chain, const Box& box, const std::vector<ContactChain>& contacts,
                 double tolerance) {
  const int from = chain.ends[0].contact, to = chain.ends[1].contact;
  const bool returns = chain.closed || (from == to && from >= 0);
  if (!returns && from >= 0 && to >= 0) return -1;
  const int contact = chain.closed              ? contact_on(chain, contacts)
                      : std::max(from, to) >= 0 ? std::max(from, to)
                                                : pole_at(box, contacts, tolerance);
  if (contact < 0) return -1;
  const ContactChain& at = contacts[static_cast<std::size_t>(contact)];
  if (at.curve || (!returns && !at.pole)) return -1;
  // A cluster ends somewhere near its point, a valley's contact exactly.
  const double part = !returns ? 0 : at.path.size() == 1 ? kClusterReach : 1;
  const bool is_short = diagonal(box) <= part * at.length + kShortestBranch * tolerance;
  return is_short ? contact : -1;
}

}  // namespace

void drop_spurious_branches(PairSearchResult& found, SurfaceCells& a, SurfaceCells& b,
                            std::vector<ContactChain>& contacts,
                            const std::vector<CriticalCluster>& clusters, double tolerance) {
  if (contacts.empty()) return;
  for (const Chain& chain : chains_of(found, a, b, contacts, clusters)) {
    const int contact = contact_with(chain, end_box(a, found, chain), contacts, tolerance);
    if (contact < 0) continue;
    // A spurious one is known by its contact, which has to stay for that.
    contacts[static_cast<std::size_t>(contact)].regular = false;
    for (const ChainLink& link : chain.links)
      found.arcs[static_cast<std::size_t>(link.arc)].dropped = true;
  }
  for (ContactChain& contact : contacts)
    for (auto& arms : contact.arms)
      std::erase_if(arms, [&](ArcEnd end) { return found.arcs[end / 2].dropped; });
}

}  // namespace blossom
