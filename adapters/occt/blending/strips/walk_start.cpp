// SPDX-License-Identifier: LGPL-2.1-or-later
// Where a walk starts: beside an edge of the run, or behind smooth borders of its faces.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <BRep_Tool.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/fillet_refusal.h"
#include "adapters/occt/blending/limits.h"
#include "adapters/occt/blending/strips/ball_walker.h"
#include "adapters/occt/convert/curves.h"

namespace blossom::occt {
// Whether the ball touches both faces where they are, beside the middle of the strip's edge.
bool BallWalker::goes_beside(const WalkedStrip& of) const {
  return std::ranges::all_of(of.strip.contacts, [&](const RolledContact& contact) {
    return lies_on(body_, contact, of.inside);
  });
}

// Whether borders of a face that begin in the ends of an edge slant the same way, so that what lies
// between them at the distance of the contact is aside of the edge: over no other border does the
// contact come into the face, seen from the middle.
bool BallWalker::is_aside(const WalkedStrip& of, std::size_t side,
                          const std::vector<ContactCrossing>& all) const {
  const EdgeUseInFace& own = body_.use(of.strip.edge, side == 0);
  const std::vector<EdgeUseInFace>& uses = body_.uses(own.face);
  return std::ranges::all_of(all, [&](const ContactCrossing& each) {
    if (is_seam_at(body_, each) || each.leaves == (each.t > of.inside)) return true;
    const auto is = [&](int use) {
      return uses[static_cast<std::size_t>(use)].edge == each.use->edge;
    };
    return is(own.next) || is(own.previous);
  });
}

// Where the ball touches both faces of a strip that it does not touch beside the middle of its
// edge: beside another part of the edge, or between borders that begin in its ends. What is nearest
// to the middle counts. Nothing for others.
std::optional<double> BallWalker::place_between(const WalkedStrip& of) const {
  const RolledStrip& strip = of.strip;
  if (!of.of_edge || strip.closed) return std::nullopt;
  std::vector<double> places{strip.range.from, strip.range.to, strip.edge_range.from,
                             strip.edge_range.to};
  bool aside = true;
  for (const std::size_t side : {0U, 1U}) {
    const auto all = contact_crossings(body_, strip, side, {strip.edge});
    for (const ContactCrossing& each : all) places.push_back(each.t);
    if (!lies_inside(body_, strip.contacts[side], of.inside))
      aside = aside && is_aside(of, side, all);
  }
  std::ranges::sort(places);
  std::optional<double> nearest;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const double t = at(Interval{places[i], places[i + 1]}, 0.5);
    if (nearest && std::abs(t - of.inside) >= std::abs(*nearest - of.inside)) continue;
    const bool beside = t > strip.edge_range.from && t < strip.edge_range.to;
    if ((beside || aside) && std::ranges::all_of(strip.contacts, [&](const RolledContact& each) {
          return lies_on(body_, each, t);
        }))
      nearest = t;
  }
  return nearest;
}

// Whether the ball beside an edge leans on the far edge of a face all along.
bool BallWalker::leans_beside(const WalkedStrip& of) {
  return of.strip.held != std::array<int, 2>{};
}

// The first edge beside which there is a ball, if one does not lean on the far edge of a face;
// where contacts run along borders, any edge. Where there is none, the longest edge tells why:
// short ones may have none where a ball rolls past.
std::size_t BallWalker::start() {
  std::optional<std::size_t> any, leaning;
  std::optional<FilletRefused> refused;
  double longest = 0;
  for (std::size_t i = 0; i < run_.edges.size(); ++i) try {
      const WalkedStrip& of = strip_at(i);
      if (goes_beside(of)) {
        if (!leans_beside(of)) return i;
        if (!leaning) leaning = i;
      }
      if (!any) any = i;
    } catch (const FilletRefused& why) {
      const double length = edge_length(body_.edge(run_.edges[i].edge));
      if (refused && length <= longest) continue;
      refused = why;
      longest = length;
    }
  if (!any) throw FilletRefused(*refused);
  for (std::size_t i = 0; i < made_.size(); ++i)
    if (const auto t =
            made_[i] && !leans_beside(*made_[i]) ? place_between(*made_[i]) : std::nullopt) {
      made_[i]->inside = *t;
      return i;
    }
  return leaning.value_or(*any);
}

// The edge over which the straight way in a face's chart leaves it first.
std::optional<ContactCrossing> BallWalker::border_between(int face, const Vec2& from,
                                                          const Vec2& to, int entered) const {
  std::optional<ContactCrossing> first;
  const PlanarCurve way = planar_line(from, to, {0, 1});
  for (const EdgeUseInFace& use : body_.uses(face)) {
    if (use.coedge->degenerated || use.edge == entered) continue;
    if (options_.filleted.count(use.edge) > 0) continue;
    if (body_.use(use.edge, !use.forward).face == face) continue;
    for (const PlanarCrossing& each :
         crossings(way, use.coedge->curve, std::max(options_.tolerance, use.coedge->tolerance))
             .points)
      if (!first || each.a < first->t) first = ContactCrossing{each.a, &use, each.b, true};
  }
  return first;
}

// What the ball at the beginning of a strip has to go over to touch what is there; `ends` stays
// true while there is nothing. False if that cannot be gone over.
bool BallWalker::start_over(const WalkedStrip& of, std::size_t side, const Vec2& from, int entered,
                            WalkExit& over) const {
  const RolledContact& contact = of.strip.contacts[contact_at(of, side)];
  if (const int edge = held_by(of)[side]; edge > 0) {
    const EdgeUseInFace& own = body_.use_in(edge, contact.face);
    if (turned_past(of, side, body_.behind(own), of.inside) > 0) return false;
    if (turned_past(of, side, own, of.inside) <= 0) return true;
    over.held[side] = 0;
    over.ends = false;
    return true;
  }
  if (lies_inside(body_, contact, of.inside)) return true;
  const gp_Pnt2d uv = contact.chart->Value(of.inside);
  const Vec2 scale = body_.trims(contact.face).scale;
  const auto border =
      border_between(contact.face, from, {uv.X() * scale[0], uv.Y() * scale[1]}, entered);
  if (!border) return false;
  const bool leans = holds(of, of.inside, *border);
  if (!leans && !is_smooth_at(body_, *border)) return false;
  over.over[side] = border;
  if (leans) over.held[side] = border->use->edge;
  over.ends = false;
  return true;
}

// The ball beside the middle of an edge, whose contacts lie beyond borders of its faces: on the
// faces behind them, one after the other, or leaning on a bend. Nothing if a border is sharp, or
// none is met, or no ball of one radius rolls.
std::optional<WalkedStrip> BallWalker::start_behind(std::size_t place) {
  if (!profiles_.everywhere()) return std::nullopt;
  WalkedStrip of = strip_at(place);
  const TopoDS_Edge edge = body_.edge(run_.edges[place].edge);
  Interval range;
  BRep_Tool::Range(edge, range.from, range.to);
  std::array<Vec2, 2> from;
  std::array<int, 2> entered{};
  for (const std::size_t side : {0U, 1U}) {
    const EdgeUseInFace& use =
        body_.use(run_.edges[place].edge, (side == 0) == run_.edges[place].forward);
    from[side] = point_at(use.coedge->curve, at(range, 0.5));
  }
  for (int count = 0; count < kMaxFacesInARow; ++count) {
    WalkExit over{of.inside, {}, true, 0, held_by(of)};
    for (const std::size_t side : {0U, 1U}) {
      if (!start_over(of, side, from[side], entered[side], over)) return std::nullopt;
      if (const auto& border = over.over[side]) {
        const EdgeUseInFace& behind = body_.use(border->use->edge, !border->use->forward);
        from[side] = point_at(behind.coedge->curve, border->edge_parameter);
        entered[side] = border->use->edge;
      }
    }
    if (over.ends) return of;
    const Vec3 centre = vec(of.strip.spine->Value(of.inside).XYZ());
    of = pair_strip(of, over, faces_behind(of, over), place, run_.closed);
    of.inside = nearest_on(of.strip.spine, of.strip.range, centre);
  }
  return std::nullopt;
}

// Whether faces to the left and right of the way are those on which the walk started.
bool BallWalker::is_start(const std::array<int, 2>& faces, const std::array<int, 2>& held) const {
  return behind_ && held == held_by(*behind_) &&
         behind_->strip.contacts[contact_at(*behind_, 0)].face == faces[0] &&
         behind_->strip.contacts[contact_at(*behind_, 1)].face == faces[1];
}

}  // namespace blossom::occt
