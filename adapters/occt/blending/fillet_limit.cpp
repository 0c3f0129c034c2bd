// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/fillet_limit.h"

#include <exception>
#include <vector>

#include "adapters/occt/blending/ball_supports.h"
#include "core/blending/largest_radius.h"
#include "core/plane/planar_curves.h"

namespace blossom::occt {
namespace {

constexpr double kLeastPart = 1e-3;  // of the radius asked for: smaller ones are not looked at

// The distance of a chart point from a border, positive on the face's side.
ContactBorder border_of(const FaceTrims& trims, const Coedge& coedge, int support) {
  const Vec2 scale = trims.scale;
  const bool reversed = coedge.reversed();
  return {support, [&coedge, scale, reversed](const Vec2& uv) {
            const Vec2 point{uv[0] * scale[0], uv[1] * scale[1]};
            const double foot = nearest(coedge.curve, point).parameter;
            const PlanarJet jet = jet_at(coedge.curve, foot);
            const double height = cross(unit(jet.first), point - jet.point);
            return reversed ? -height : height;
          }};
}

// All borders of the outer kind but the edge itself and those at which the strip ends.
void add_borders(const BodyEdges& body, int edge, bool forward, std::vector<ContactBorder>& borders,
                 std::vector<int>& numbers) {
  const EdgeUseInFace& own = body.use(edge, forward);
  const std::vector<EdgeUseInFace>& uses = body.uses(own.face);
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const int place = static_cast<int>(i);
    if (&uses[i] == &own || place == own.next || place == own.previous ||
        uses[i].coedge->degenerated)
      continue;
    borders.push_back(border_of(body.trims(own.face), *uses[i].coedge, forward ? 0 : 1));
    numbers.push_back(uses[i].edge);
  }
}

}  // namespace

std::optional<FilletLimit> fillet_limit(const BodyEdges& body, int edge, bool concave,
                                        double most) try {
  const RolledSupports supports = rolled_supports(body, edge, concave, most);
  std::vector<ContactBorder> borders;
  std::vector<int> numbers;
  add_borders(body, edge, true, borders, numbers);
  add_borders(body, edge, false, borders, numbers);
  const auto found = largest_radius(supports.of[0].whole(), supports.of[1].whole(),
                                    {supports.of[0].at_edge, supports.of[1].at_edge},
                                    kLeastPart * most, most, borders);
  if (!found || found->limit == RadiusLimit::None || found->limit == RadiusLimit::Other)
    return std::nullopt;
  std::string cause = "two walls that face each other";
  if (found->limit == RadiusLimit::Curvature) cause = "the curvature of a face";
  if (found->limit == RadiusLimit::Border && found->border >= 0)
    cause = "edge " + std::to_string(numbers[static_cast<std::size_t>(found->border)]) +
            ", which the contact reaches";
  return FilletLimit{found->radius, cause};
} catch (const std::exception&) {
  return std::nullopt;  // the refusal stands without it
}

}  // namespace blossom::occt
