// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/strips/law_joints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include <BRep_Tool.hxx>
#include <Geom_Curve.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/blending/fillet_refusal.h"
#include "adapters/occt/blending/strips/ball_supports.h"
#include "adapters/occt/blending/strips/face_contacts.h"
#include "core/blending/balls/chart_cell.h"
#include "core/forms/evaluation.h"

namespace blossom::occt {
namespace {

// Rates of both sides that differ by less, of their size, leave sections that differ by less than
// any tolerance of an edge.
constexpr double kSameRate = 1e-10;

// The ball beside an edge in the plane across it at a parameter.
struct BallBeside {
  Vec3 centre;
  bool is_inside =
      false;  // whether it touches both faces themselves, and not where they would go on
};

std::optional<BallBeside> ball_at(const BodyEdges& body, int edge, bool concave, double radius,
                                  double parameter) {
  const RolledSupports on = rolled_supports(body, edge, concave, radius, parameter);
  const RolledSupport& first = on.of[0];
  const auto charts =
      ball_beside_edge(first.whole(), on.of[1].whole(), radius, {first.at_edge, on.of[1].at_edge});
  if (!charts) return std::nullopt;
  const Vec2& uv = (*charts)[0];
  const PatchJet s = chart_jet(first.surface, cell_at(first.surface, uv), uv, 1);
  BallBeside made{s.point + unit(cross(s.u, s.v)) * (first.side * radius), true};
  for (const std::size_t k : {0U, 1U})
    made.is_inside = made.is_inside && lies_inside(body, body.use(edge, k == 0).face, (*charts)[k]);
  return made;
}

// An end of an edge where a run goes over it.
struct LawEnd {
  std::size_t place = 0;
  std::size_t end = 0;   // 0: where the forward edge starts
  double way = 1;        // of the ball by the edge's length
  double to_length = 1;  // rates by the law's parameter to rates by the length along the run
  gp_Pnt point{};
  gp_Vec second{};  // derivative of the edge
  double speed = 1;
  std::optional<BallBeside> ball{};
};

LawEnd law_end(const BodyEdges& body, const EdgeRun& run, const std::vector<StripProfile>& profiles,
               std::size_t place, bool ahead) {
  const RunEdge& edge = run.edges[place];
  LawEnd made{place, edge.forward == ahead ? 1U : 0U};
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(body.edge(edge.edge), range.from, range.to);
  const double parameter = made.end == 0 ? range.from : range.to;
  gp_Vec first;
  curve->D2(parameter, made.point, first, made.second);
  made.speed = first.Magnitude();
  const double radius = profiles[place].law->at(made.end == 0 ? 0 : 1).value;
  made.ball = ball_at(body, edge.edge, run.concave, radius, parameter);
  made.to_length = (edge.forward ? 1 : -1) / (made.speed * length(range));
  return made;
}

// False if there is no such strip.
bool set_way(LawEnd& of, const Vec3& centre) {
  of.way = 1 - dot(centre - vec(of.point), vec(of.second)) / (of.speed * of.speed);
  return of.way > 0;
}

// Where faces lean, the ball in the plane between two edges may still touch a face of the one, or
// those of the other already: that one ball is the ball of both.
bool set_ways(LawEnd& before, LawEnd& after) {
  if (!before.ball || !after.ball || !(before.speed > 0) || !(after.speed > 0)) return false;
  if (before.ball->is_inside)
    after.ball = before.ball;
  else if (after.ball->is_inside)
    before.ball = after.ball;
  return set_way(before, before.ball->centre) && set_way(after, after.ball->centre);
}

}  // namespace

void match_rates(const BodyEdges& body, const EdgeRun& run, std::vector<StripProfile>& profiles) {
  const std::size_t count = profiles.size();
  std::vector<std::array<double, 2>> rates;
  for (const StripProfile& each : profiles)
    rates.push_back({each.law->at(0).first, each.law->at(1).first});
  std::vector<bool> changes(count, false);
  for (std::size_t i = 0; i < (run.closed ? count : count - 1); ++i) {
    LawEnd before = law_end(body, run, profiles, i, true);
    LawEnd after = law_end(body, run, profiles, (i + 1) % count, false);
    if (!set_ways(before, after)) continue;
    double& last = rates[before.place][before.end];
    double& next = rates[after.place][after.end];
    const double a = last * before.to_length, b = next * after.to_length;
    const double common = (a + b) / (before.way + after.way);
    const double off =
        std::max(std::abs(a - common * before.way), std::abs(b - common * after.way));
    if (off <= kSameRate * std::max(std::abs(a), std::abs(b))) continue;
    last = common * before.way / before.to_length;
    next = common * after.way / after.to_length;
    changes[before.place] = changes[after.place] = true;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!changes[i]) continue;
    StripProfile& profile = profiles[i];
    profile.law = profile.law->with_rates({0, 1}, rates[i][0], rates[i][1]);
    const Interval radii = profile.law->extremes({0, 1});
    profile.radius = radii.to;
    if (!(radii.from > 0))
      throw FilletRefused(
          {FilletFault::Edge,
           run.edges[i].edge,
           "the law falls so steeply at an end of it that the radius would become 0",
           std::nullopt,
           std::nullopt,
           {}});
  }
}

}  // namespace blossom::occt
