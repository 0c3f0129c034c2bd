// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/branches/shared_borders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace blossom {
namespace {

constexpr double kOnOtherBorder = 2 * kSamePoint;  // of a patch: so near is on it
// Likewise, off the chord between two points of the border on the other surface: beyond it lies
// another sheet.
constexpr double kSameSheet = 0.05;

bool is_step(const ContactPoint& p, const ContactPoint& q) {
  return p.patch_a == q.patch_a && p.patch_b == q.patch_b && p.x != q.x;
}

bool lies_on(const SharedBorder& border, int patch_a, int patch_b, const Point4& x) {
  const auto across = static_cast<std::size_t>(border.across), along = across ^ 1;
  for (std::size_t i = 0; i + 1 < border.path.size(); ++i) {
    const ContactPoint &p = border.path[i], &q = border.path[i + 1];
    if (!is_step(p, q) || p.patch_a != patch_a || p.patch_b != patch_b) continue;
    const double t = (x[along] - p.x[along]) / (q.x[along] - p.x[along]);
    const double margin = kOnOtherBorder / std::abs(q.x[along] - p.x[along]);
    if (!(t >= -margin && t <= 1 + margin)) continue;
    bool near = true;
    for (std::size_t k = 0; k < 4; ++k)
      near = near && std::abs(p.x[k] + t * (q.x[k] - p.x[k]) - x[k]) <=
                         (k == across ? kOnOtherBorder : kSameSheet);
    if (near) return true;
  }
  return false;
}

bool runs_along(const SharedBorder& border, const FoundArc& arc) {
  Point4 middle;
  for (std::size_t k = 0; k < 4; ++k) middle[k] = 0.5 * (arc.arc.from[k] + arc.arc.to[k]);
  return std::ranges::all_of(std::array{arc.arc.from, middle, arc.arc.to}, [&](const Point4& x) {
    return lies_on(border, arc.patch_a, arc.patch_b, x);
  });
}

bool runs_along(const SharedBorder& border, const FoundContact& piece) {
  return std::ranges::all_of(piece.contact.path, [&](const Point4& x) {
    return lies_on(border, piece.patch_a, piece.patch_b, x);
  });
}

void drop_contacts(const std::vector<bool>& dropped, PairSearchResult& found) {
  std::vector<int> place(dropped.size(), -1);
  std::vector<FoundContact> kept;
  for (std::size_t i = 0; i < dropped.size(); ++i) {
    if (dropped[i]) continue;
    place[i] = static_cast<int>(kept.size());
    kept.push_back(std::move(found.contacts[i]));
  }
  found.contacts = std::move(kept);
  for (FoundArc& arc : found.arcs)
    for (int& contact : arc.contact)
      if (contact >= 0) contact = place[static_cast<std::size_t>(contact)];
}

FoundArc arc_between(const SharedBorder& border, const ContactPoint& p, const ContactPoint& q) {
  FoundArc arc{p.patch_a, p.patch_b, {}, {p.x, q.x}, {-1, -1}};
  for (std::size_t k = 0; k < 4; ++k) arc.arc.direction[k] = q.x[k] - p.x[k];
  arc.arc.tangential = true;
  arc.arc.iso = border.across;
  return arc;
}

}  // namespace

bool add_shared_border(const SharedBorder& border, PairSearchResult& found) {
  std::vector<bool> dropped;
  for (const FoundContact& piece : found.contacts) dropped.push_back(runs_along(border, piece));
  const auto is_dropped = [&](int contact) {
    return contact >= 0 && dropped[static_cast<std::size_t>(contact)];
  };
  const auto begins = [&](const FoundArc& arc) {
    return !arc.dropped && std::ranges::any_of(arc.contact, is_dropped) && !runs_along(border, arc);
  };
  if (std::ranges::any_of(found.arcs, begins)) return false;
  for (FoundArc& arc : found.arcs) arc.dropped = arc.dropped || runs_along(border, arc);
  drop_contacts(dropped, found);
  for (std::size_t i = 0; i + 1 < border.path.size(); ++i)
    if (is_step(border.path[i], border.path[i + 1]))
      found.arcs.push_back(arc_between(border, border.path[i], border.path[i + 1]));
  return true;
}

}  // namespace blossom
