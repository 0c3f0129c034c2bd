// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/contacts/contact_arms.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/forms/evaluation.h"
#include "core/surfaces/contacts/contact_reach.h"
#include "core/surfaces/contacts/limits.h"
#include "core/surfaces/gap/contact_points.h"

namespace blossom {
namespace {

// Of the size: ends of branches this near a contact may be its arms.
constexpr double kAttachRadius = 1e-3;
constexpr double kSamePoint3 = 4;        // tolerances: points this close in space are one
constexpr double kOtherMeridian = 1e-3;  // of a patch: arms of a pole this far apart stay two
constexpr double kStraightOn = 0.9;      // cosine: curves that meet within 25 degrees go on

Vec3 point_of(const PairSearchResult& found, SurfaceCells& a, ArcEnd end) {
  const Point4& x = end_of(found, end);
  return point_at(a.tree(found.arcs[end / 2].patch_a).patch(), x[0], x[1]);
}

// In a pole each arm keeps its own value of the free parameter, and at a seam its own side. Two
// arms go on into each other only if they have the same one.
void meet_apart(ContactChain& contact, const Pole& pole, SurfaceCells& a, SurfaceCells& b,
                PairSearchResult& found) {
  contact.centre = pole.point;
  const bool at_pole = std::ranges::any_of(pole.free, [](bool free) { return free; });
  std::vector<Point4> ends;
  for (auto& side : contact.arms)
    for (ArcEnd& end : side) {
      const ContactPoint goal = in_patches_of(found, end, pole, a, b);
      ends.push_back(in_patches(a, b, goal.patch_a, goal.patch_b, goal.x, pole.point));
      end = reach_contact(found, a, b, end, goal);
      found.arcs[end / 2].to_pole = found.arcs[end / 2].to_pole || at_pole;
    }
  for (std::size_t k = 0; k < 4 && ends.size() == 2; ++k)
    contact.parted = contact.parted || std::abs(ends[0][k] - ends[1][k]) > kOtherMeridian;
}

// Lengthens an arm to the centre of a node, in the arm's own patches where the centre is on their
// border, perhaps across a seam. A branch that only passes by the centre ends beside it.
ArcEnd at_node(const ContactChain& contact, ArcEnd end, SurfaceCells& a, SurfaceCells& b,
               PairSearchResult& found) {
  const ContactPoint goal = in_patches_of(found, end, {contact.centre, {}}, a, b);
  const auto &patch_a = a.tree(goal.patch_a).patch(), &patch_b = b.tree(goal.patch_b).patch();
  const bool leads = leads_to(patch_a, patch_b, arm_of(found, a, b, end, goal), goal.x);
  return leads ? reach_contact(found, a, b, end, goal) : end;
}

// True if an arm ends in the centre, perhaps in patches that have it on their border.
bool ends_in(const PairSearchResult& found, const SurfaceCells& a, const SurfaceCells& b,
             ArcEnd end, const ContactPoint& centre) {
  const Point4 x = arm_of(found, a, b, end, centre).end;
  for (std::size_t k = 0; k < 4; ++k)
    if (std::abs(x[k] - centre.x[k]) > kOnBorder) return false;
  return true;
}

// Over a, from a contact's end of an arm into the arm.
Vec2 direction_of(const ContactArm& arm) {
  return unit(Vec2{arm.end[0] - arm.start[0], arm.end[1] - arm.start[1]});
}

// True if the arms face each other: unlike those of a cusp or a fold, where a branch turns round.
bool face_each_other(const std::vector<ContactArm>& arms) {
  return dot(direction_of(arms[0]), direction_of(arms[1])) < -kStraightOn;
}

// False if some arms are tangential curves and some are branches.
bool are_alike(const ContactChain& contact, const PairSearchResult& found) {
  bool any[2]{};
  for (const auto& side : contact.arms)
    for (const ArcEnd end : side) any[found.arcs[end / 2].arc.tangential ? 1 : 0] = true;
  return !(any[0] && any[1]);
}

// True if arms that face each other are tangential curves. Along a strip of contact some cells
// are within tolerance all over, and the closest point in them need not lie between the arms.
bool passes(const ContactChain& contact, const std::vector<ContactArm>& arms,
            const PairSearchResult& found) {
  for (const auto& side : contact.arms)
    for (const ArcEnd end : side)
      if (!found.arcs[end / 2].arc.tangential) return false;
  const Vec2 out = direction_of(arms[0]), back = direction_of(arms[1]);
  const Vec2 step{arms[1].end[0] - arms[0].end[0], arms[1].end[1] - arms[0].end[1]};
  return dot(out, step) >= 0 && dot(back, step) <= 0;
}

// Cells round a contact were looked at together somewhat beyond it.
Box proven_box(const ContactChain& contact) { return widened(contact.box, 0.1 * contact.length); }

// True if all arms end where the proof of a regular contact holds.
bool ends_are_inside(const ContactChain& contact, SurfaceCells& a, const PairSearchResult& found) {
  const Box box = proven_box(contact);
  for (const auto& side : contact.arms)
    for (const ArcEnd end : side) {
      const Vec3 p = point_of(found, a, end);
      if (!meet(box, {p, p})) return false;
    }
  return true;
}

// Drops what is no arc but a point, in a contact that two arms pass.
void drop_inside(PairSearchResult& found, SurfaceCells& a, const ContactChain& contact,
                 const std::vector<ArcEnd>& arms) {
  const Box box = proven_box(contact);
  const auto is_inside = [&](const FoundArc& arc, const Point4& x) {
    const Vec3 p = point_at(a.tree(arc.patch_a).patch(), x[0], x[1]);
    return meet(box, {p, p});
  };
  const auto is_point = [](const CellArc& arc) {
    for (std::size_t k = 0; k < 4; ++k)
      if (std::abs(arc.to[k] - arc.from[k]) > 4 * kSamePoint) return false;
    return true;
  };
  for (std::size_t i = 0; i < found.arcs.size(); ++i) {
    FoundArc& arc = found.arcs[i];
    if (i != arms[0] / 2 && i != arms[1] / 2 && is_point(arc.arc) && is_inside(arc, arc.arc.from))
      arc.dropped = true;
  }
}

// False if no contact is near enough.
bool attach_to_nearest(ArcEnd end, const PairSearchResult& found, SurfaceCells& a, SurfaceCells& b,
                       std::vector<ContactChain>& contacts, double size, double tolerance) {
  const FoundArc& arc = found.arcs[end / 2];
  const Point4& x = end_of(found, end);
  const Vec3 p = point_of(found, a, end);
  double least = kAttachRadius * size;
  ContactChain* nearest = nullptr;
  std::size_t side = 0;
  for (ContactChain& chain : contacts) {
    if (chain.curve && arc.arc.tangential) continue;  // its own, perhaps
    const auto to = [&](const ContactPoint& q) {
      return distance(p, point_at(a.tree(q.patch_a).patch(), q.x[0], q.x[1]));
    };
    const double to_front = to(chain.path.front()), to_back = to(chain.path.back());
    const double d =
        chain.curve ? std::min(to_front, to_back) : std::sqrt(squared_distance(chain.box, p));
    if (d >= least) continue;
    least = d;
    nearest = &chain;
    side = to_front <= to_back ? 0 : 1;
  }
  if (nearest == nullptr) return false;
  const ContactPoint& goal = side == 0 ? nearest->path.front() : nearest->path.back();
  // At a pole one point has many parameters, so being there is enough.
  if (least > kSamePoint3 * tolerance &&
      !in_contact(a, b, {arc.patch_a, arc.patch_b, x, 0}, goal, tolerance))
    return false;
  nearest->arms[side].push_back(end);
  return true;
}

// Where patches join with kinks, branches of more than two pairs of them may end in one point:
// each changes the side, so their number is even.
void add_corners(std::vector<ArcEnd> ends, const PairSearchResult& found, SurfaceCells& a,
                 std::vector<ContactChain>& contacts, double tolerance) {
  while (!ends.empty()) {
    const ArcEnd first = ends.front();
    const Vec3 x = point_of(found, a, first);
    const auto others = std::stable_partition(ends.begin(), ends.end(), [&](ArcEnd end) {
      return distance(point_of(found, a, end), x) <= tolerance;
    });
    const FoundArc& arc = found.arcs[first / 2];
    ContactChain corner;
    corner.path = {{arc.patch_a, arc.patch_b, end_of(found, first), 0}};
    corner.centre = corner.path.front();
    corner.arms[0].assign(ends.begin(), others);
    std::set<std::pair<int, int>> pairs;
    for (const ArcEnd end : corner.arms[0]) {
      const Vec3 p = point_of(found, a, end);
      corner.box = joined(corner.box, {p, p});
      pairs.insert({found.arcs[end / 2].patch_a, found.arcs[end / 2].patch_b});
    }
    const std::size_t count = corner.arm_count();
    if (count > 2 && count % 2 == 0 && pairs.size() == count) contacts.push_back(corner);
    ends.erase(ends.begin(), others);
  }
}

}  // namespace

void attach(const std::vector<ArcEnd>& ends, const PairSearchResult& found, SurfaceCells& a,
            SurfaceCells& b, std::vector<ContactChain>& contacts, double size, double tolerance) {
  std::vector<ArcEnd> rest;
  for (const ArcEnd end : ends)
    if (!attach_to_nearest(end, found, a, b, contacts, size, tolerance)) rest.push_back(end);
  add_corners(std::move(rest), found, a, contacts, tolerance);
}

void meet_in_centres(std::vector<ContactChain>& contacts, SurfaceCells& a, SurfaceCells& b,
                     PairSearchResult& found, double tolerance) {
  for (ContactChain& contact : contacts) {
    if (contact.curve) continue;
    contact.regular = contact.regular && ends_are_inside(contact, a, found);
    if (const auto pole = pole_near(a, b, contact.centre, contact.length, tolerance)) {
      contact.pole = true;
      meet_apart(contact, *pole, a, b, found);
      continue;
    }
    const auto &patch_a = a.tree(contact.centre.patch_a).patch(),
               &patch_b = b.tree(contact.centre.patch_b).patch();
    std::vector<ContactArm> arms;
    for (const auto& side : contact.arms)
      for (const ArcEnd end : side) arms.push_back(arm_of(found, a, b, end, contact.centre));
    const bool joins = arms.size() == 2 && !contact.high_order;
    contact.parted = contact.high_order && !are_alike(contact, found);
    if (joins && jumps(arms[0].end, arms[1].end, a, b)) {
      meet_apart(contact, {contact.centre, {}}, a, b, found);
      continue;
    }
    contact.straight = joins && face_each_other(arms);
    contact.passed = contact.straight && passes(contact, arms, found);
    if (contact.passed)
      contact.centre.x = arms[0].end;
    else if (joins)
      contact.centre.x = meeting_point(patch_a, patch_b, {arms[0], arms[1]}, contact.centre.x);
    for (auto& side : contact.arms)
      for (ArcEnd& end : side) {
        end = joins                ? reach_contact(found, a, b, end, contact.centre)
              : contact.high_order ? reach_node(found, a, b, end, contact.centre, tolerance)
                                   : at_node(contact, end, a, b, found);
        contact.passed_by |= contact.high_order && !ends_in(found, a, b, end, contact.centre);
        const Vec3 p = point_of(found, a, end);  // what lies between is the contact's
        contact.box = joined(contact.box, {p, p});
      }
  }
}

void drop_regular(std::vector<ContactChain>& contacts, PairSearchResult& found, SurfaceCells& a) {
  std::erase_if(contacts, [&](const ContactChain& contact) {
    const std::size_t arms = contact.arm_count();
    if (!contact.regular || contact.pole || contact.parted || (arms != 0 && arms != 2))
      return false;
    std::vector<ArcEnd> ends(contact.arms[0]);
    ends.insert(ends.end(), contact.arms[1].begin(), contact.arms[1].end());
    if (arms == 2) {
      found.joins.push_back({ends[0], ends[1]});
      drop_inside(found, a, contact, ends);
    }
    return true;
  });
}

}  // namespace blossom
