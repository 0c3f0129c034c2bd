// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/sheet/fillet_limit.h"

#include <cmath>
#include <limits>
#include <vector>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/blending/fillet_refusal.h"
#include "adapters/occt/blending/sheet/filleting.h"
#include "adapters/occt/blending/strips/ball_supports.h"
#include "adapters/occt/blending/strips/rolled_strip.h"
#include "core/base/errors.h"
#include "core/blending/balls/largest_radius.h"
#include "core/plane/planar_curves.h"

namespace blossom::occt {
namespace {

constexpr double kMinShare = 1e-3;      // of the most: where no ball is known to roll, this may
constexpr double kRadiusError = 1e-12;  // relative
constexpr int kMaxSteps = 100;
constexpr int kSamples = 16;  // along a contact

// The distance of a chart point from a border, positive on the face's side. Beyond the ends of the
// border there is none: other borders say on which side a point is.
ContactBorder border_of(const FaceTrims& trims, const Coedge& coedge, int support) {
  const Vec2 scale = trims.scale;
  const bool reversed = coedge.reversed;
  return {support, [&coedge, scale, reversed](const Vec2& uv) {
            const Vec2 point{uv[0] * scale[0], uv[1] * scale[1]};
            const double foot = nearest(coedge.curve, point).parameter;
            const PlanarJet jet = jet_at(coedge.curve, foot);
            const Interval domain = coedge.curve.domain();
            if (foot <= domain.from || foot >= domain.to) return distance(point, jet.point);
            const double height = cross(unit(jet.first), point - jet.point);
            return reversed ? -height : height;
          }};
}

// All borders of the outer kind but the edge itself, those at which the strip ends, and smooth
// ones, over which the ball rolls on.
void add_borders(const BodyEdges& body, int edge, bool forward, std::vector<ContactBorder>& borders,
                 std::vector<int>& numbers) {
  const EdgeUseInFace& own = body.use(edge, forward);
  const std::vector<EdgeUseInFace>& uses = body.uses(own.face);
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const int place = static_cast<int>(i);
    if (&uses[i] == &own || place == own.next || place == own.previous ||
        uses[i].coedge->degenerated)
      continue;
    double angle = 0;
    if (edge_kind(body, uses[i].edge, angle) == EdgeKind::Smooth) continue;
    borders.push_back(border_of(body.trims(own.face), *uses[i].coedge, forward ? 0 : 1));
    numbers.push_back(uses[i].edge);
  }
}

struct Borders {
  std::vector<ContactBorder> of;
  std::vector<int> edges;  // their numbers
};

// How far the contacts of a swept strip keep from the borders, and from which it is least.
struct Room {
  double least = std::numeric_limits<double>::infinity();
  int edge = 0;
};

// What is looked for, or nothing where it cannot be made: a hint that fails is no reason to end the
// whole fillet. That the time is up is.
template <class Look>
auto unless_it_fails(const Look& look) -> decltype(look()) {
  try {
    return guarded(kFilleting, look);
  } catch (const FilletRefused&) {
    return std::nullopt;
  } catch (const LimitFailure&) {
    throw;
  } catch (const Failure&) {
    return std::nullopt;
  } catch (const BadModel&) {
    return std::nullopt;
  } catch (const InvalidInput&) {  // of the core: numbers that make no geometry
    return std::nullopt;
  }
}

std::optional<Room> room_of_strip(const BodyEdges& body, int edge, bool concave, double radius,
                                  const Borders& borders) {
  const auto strip = swept_strip(body, edge, concave, radius);
  if (!strip) return std::nullopt;
  Room room;
  for (std::size_t i = 0; i < borders.of.size(); ++i) {
    const RolledContact& contact = strip->contacts[static_cast<std::size_t>(borders.of[i].support)];
    for (int k = 0; k <= kSamples; ++k) {
      const gp_Pnt2d uv =
          contact.chart->Value(at(strip->edge_range, static_cast<double>(k) / kSamples));
      const double height = borders.of[i].inside({uv.X(), uv.Y()});
      if (height < room.least) room = {height, borders.edges[i]};
    }
  }
  return room;
}

// Nothing where there is no strip.
std::optional<Room> room_of(const BodyEdges& body, int edge, bool concave, double radius,
                            const Borders& borders) {
  return unless_it_fails([&] { return room_of_strip(body, edge, concave, radius, borders); });
}

// The largest radius of which there is a strip, which a smaller one has and a larger one has not.
double largest_swept(const BodyEdges& body, int edge, bool concave, double low, double high) {
  for (int i = 0; i < kMaxSteps && high - low > kRadiusError * high; ++i) {
    const double middle = 0.5 * (low + high);
    (room_of(body, edge, concave, middle, {}) ? low : high) = middle;
  }
  return low;
}

// Where the curvature of a face ends the strip, or the room is used up, by the secant of a bracket
// (the Illinois method). Contacts of swept strips are lines and circles, as their borders mostly
// are, so it is the same all along.
std::optional<FilletLimit> swept_limit(const BodyEdges& body, int edge, bool concave,
                                       const Interval& radii, const Borders& borders) {
  double low = radii.from, high = radii.to;
  const auto at_low = room_of(body, edge, concave, low, borders);
  if (!at_low || at_low->least <= 0) return std::nullopt;
  auto at_high = room_of(body, edge, concave, high, borders);
  const bool ends = !at_high;
  if (ends) {
    high = largest_swept(body, edge, concave, low, high);
    at_high = room_of(body, edge, concave, high, borders);
  }
  if (!at_high) return std::nullopt;
  if (at_high->least >= 0)
    return ends ? std::optional(FilletLimit{high, "the curvature of a face", true}) : std::nullopt;
  double f_low = at_low->least, f_high = at_high->least;
  int cause = at_high->edge, side = 0;
  for (int i = 0; i < kMaxSteps && high - low > kRadiusError * high; ++i) {
    const double radius = high - f_high * (high - low) / (f_high - f_low);
    const auto room = room_of(body, edge, concave, radius, borders);
    if (!room) return std::nullopt;
    cause = room->edge;
    if (room->least <= 0) {
      high = radius;
      f_high = room->least;
      if (side == -1) f_low *= 0.5;
      side = -1;
    } else {
      low = radius;
      f_low = room->least;
      if (side == 1) f_high *= 0.5;
      side = 1;
    }
    if (room->least == 0) low = high;
  }
  return FilletLimit{low, "edge " + std::to_string(cause) + ", which the contact reaches", true};
}

std::optional<FilletLimit> limit_of(const BodyEdges& body, int edge, bool concave,
                                    const Interval& radii) {
  Borders borders;
  add_borders(body, edge, true, borders.of, borders.edges);
  add_borders(body, edge, false, borders.of, borders.edges);
  if (swept_strip(body, edge, concave, radii.from))
    return swept_limit(body, edge, concave, radii, borders);
  const RolledSupports supports = rolled_supports(body, edge, concave, radii.to);
  const auto found = largest_radius(supports.of[0].whole(), supports.of[1].whole(),
                                    {supports.of[0].at_edge, supports.of[1].at_edge}, radii.from,
                                    radii.to, borders.of);
  if (!found || found->limit == RadiusLimit::None) return std::nullopt;
  std::string cause = "two walls that face each other";
  if (found->limit == RadiusLimit::Other) cause = "what is at an end of the edge";
  if (found->limit == RadiusLimit::Curvature) cause = "the curvature of a face";
  if (found->limit == RadiusLimit::Border && found->border >= 0)
    cause = "edge " + std::to_string(borders.edges[static_cast<std::size_t>(found->border)]) +
            ", which the contact reaches";
  return FilletLimit{found->radius, cause, found->limit == RadiusLimit::Border};
}

}  // namespace

std::optional<FilletLimit> fillet_limit(const BodyEdges& body, int edge, bool concave, double rolls,
                                        double most) {
  const Interval radii{rolls > 0 ? rolls : kMinShare * most, most};
  return unless_it_fails([&] { return limit_of(body, edge, concave, radii); });
}

}  // namespace blossom::occt
