// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/branches/chains_at_poles.h"

#include <algorithm>
#include <cstddef>

#include "core/forms/evaluation.h"
#include "core/surfaces/contacts/contact_reach.h"

namespace blossom {
namespace {

// Of the size. A piece so short is straight to rounding, and from a few hundredths of it the free
// parameter has derivatives good enough for it.
constexpr double kPoleReach = 1e-4;

// Likewise: so near to a pole arcs are so short that their ends count as one, and chains end.
constexpr double kLostAtPole = 4 * kSamePoint;

// The end at which a chain comes to a link, or leaves it.
ArcEnd arc_end(const ChainLink& link, bool comes) {
  return 2 * static_cast<std::size_t>(link.arc) + (link.forward == comes ? 0 : 1);
}

// Of the contact at a pole that holds a point; 0 if there is none.
double pole_contact_length(const std::vector<ContactChain>& contacts, SurfaceCells& a,
                           const ContactPoint& point, double tolerance) {
  const Vec3 x = point_at(a.tree(point.patch_a).patch(), point.x[0], point.x[1]);
  const Vec3 r{tolerance, tolerance, tolerance};
  double length = 0;
  for (const ContactChain& contact : contacts)
    if (contact.pole && meet(contact.box, {x - r, x + r}))
      length = std::max(length, contact.length);
  return length;
}

// How many links at one side of a chain, all in the same patches, end within reach of its end.
std::size_t links_near_end(const Chain& chain, const PairSearchResult& found, SurfaceCells& a,
                           std::size_t side, double reach) {
  const std::size_t count = chain.links.size();
  const auto link = [&](std::size_t i) { return chain.links[side == 0 ? i : count - 1 - i]; };
  const auto arc = [&](std::size_t i) -> const FoundArc& {
    return found.arcs[static_cast<std::size_t>(link(i).arc)];
  };
  const auto point = [&](std::size_t i, bool far) {
    const Point4& x = end_of(found, arc_end(link(i), (side == 0) != far));
    return point_at(a.tree(arc(i).patch_a).patch(), x[0], x[1]);
  };
  const FoundArc& first = arc(0);
  const Vec3 end = point(0, false);
  std::size_t near = 0;
  while (near < count && arc(near).patch_a == first.patch_a && arc(near).patch_b == first.patch_b &&
         !arc(near).arc.tangential && arc(near).arc.iso < 0 &&
         distance(end, point(near, true)) <= reach)
    ++near;
  return near;
}

}  // namespace

void straighten_at_poles(std::vector<Chain>& chains, PairSearchResult& found, SurfaceCells& a,
                         SurfaceCells& b, const std::vector<ContactChain>& contacts, double size,
                         double tolerance) {
  for (Chain& chain : chains)
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
      if (chain.closed) continue;
      const ChainLink inner = side == 0 ? chain.links.front() : chain.links.back();
      const ArcEnd end = arc_end(inner, side == 0);
      const FoundArc arc = found.arcs[end / 2];
      const ContactPoint last{arc.patch_a, arc.patch_b, end_of(found, end)};
      const double length =
          std::max(pole_contact_length(contacts, a, last, tolerance), kLostAtPole * size);
      const auto pole = pole_near(a, b, last, length, tolerance);
      if (pole && !(pole->point.gap <= kAttachGap * tolerance)) continue;
      const std::size_t near = pole ? links_near_end(chain, found, a, side, kPoleReach * size) : 0;
      if (near == 0) continue;
      const ContactPoint goal = in_patches_of(found, end, *pole, a, b);
      if (goal.patch_a != arc.patch_a || goal.patch_b != arc.patch_b) continue;
      const std::size_t first = side == 0 ? 0 : chain.links.size() - near;
      const ChainLink outer = chain.links[side == 0 ? near - 1 : first];
      FoundArc straight{arc.patch_a, arc.patch_b, kNoBox, {}, {-1, -1}};
      straight.to_pole = true;
      straight.arc.runs_along_border = arc.arc.runs_along_border;
      straight.arc.from = end_of(found, arc_end(outer, side != 0));
      straight.arc.to = goal.x;
      for (std::size_t k = 0; k < 4; ++k)
        straight.arc.direction[k] = straight.arc.to[k] - straight.arc.from[k];
      const auto at = chain.links.begin() + static_cast<std::ptrdiff_t>(first);
      const auto place = chain.links.erase(at, at + static_cast<std::ptrdiff_t>(near));
      chain.links.insert(place, {static_cast<int>(found.arcs.size()), side != 0});
      found.arcs.push_back(straight);
    }
}

}  // namespace blossom
