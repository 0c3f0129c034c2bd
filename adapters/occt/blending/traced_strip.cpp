// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <BRep_Tool.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <gp.hxx>
#include <gp_Vec2d.hxx>

#include "adapters/occt/blending/ball_supports.h"
#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/fillet_refusal.h"
#include "adapters/occt/blending/rolled_strip.h"
#include "adapters/occt/convert/curves.h"
#include "core/blending/balls/ball_spine.h"
#include "core/blending/balls/ball_strip.h"
#include "core/blending/balls/ball_track.h"

namespace blossom::occt {
namespace {

// Strips go on past the edge by so many times their width, as far as the ball rolls.
constexpr double kBeyond = 2;
constexpr int kSpineSamples = 4;  // between two knots of the strip

Handle(Geom_BSplineSurface) surface_of(const BallStrip& strip) {
  const int rows = strip.poles.rows(), columns = strip.poles.columns();
  TColgp_Array2OfPnt poles(1, rows, 1, columns);
  TColStd_Array2OfReal weights(1, rows, 1, columns);
  for (int i = 1; i <= rows; ++i)
    for (int k = 1; k <= columns; ++k) {
      const Vec4& p = strip.poles(i - 1, k - 1);
      weights(i, k) = p[3];
      poles(i, k) = {p[0] / p[3], p[1] / p[3], p[2] / p[3]};
    }
  const int count = static_cast<int>(strip.knots.size());
  TColStd_Array1OfReal u_knots(1, count);
  TColStd_Array1OfInteger u_multiplicities(1, count);
  for (int i = 1; i <= count; ++i) {
    u_knots(i) = strip.knots[static_cast<std::size_t>(i) - 1];
    u_multiplicities(i) = strip.multiplicities[static_cast<std::size_t>(i) - 1];
  }
  const int spans = (columns - 1) / strip.v_degree;
  TColStd_Array1OfReal v_knots(1, spans + 1);
  TColStd_Array1OfInteger v_multiplicities(1, spans + 1);
  for (int i = 1; i <= spans + 1; ++i) {
    v_knots(i) = static_cast<double>(i - 1) / spans;
    v_multiplicities(i) = i == 1 || i == spans + 1 ? strip.v_degree + 1 : strip.v_degree;
  }
  constexpr int kDegree = 5;  // along the spine, as BallStrip has it
  return new Geom_BSplineSurface(poles, weights, u_knots, v_knots, u_multiplicities,
                                 v_multiplicities, kDegree, strip.v_degree);
}

// The centres as a curve with the strip's parameter.
Handle(Geom_Curve) spine_of(const BallTrack& track, const std::vector<double>& knots) {
  std::vector<double> at;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i)
    for (int k = 0; k < kSpineSamples; ++k)
      at.push_back(blossom::at({knots[i], knots[i + 1]}, static_cast<double>(k) / kSpineSamples));
  at.push_back(knots.back());
  const int count = static_cast<int>(at.size());
  const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, count);
  const Handle(TColStd_HArray1OfReal) parameters = new TColStd_HArray1OfReal(1, count);
  for (int i = 1; i <= count; ++i) {
    const double t = at[static_cast<std::size_t>(i) - 1];
    const Vec3 c = track.at(t).centre;
    points->SetValue(i, {c[0], c[1], c[2]});
    parameters->SetValue(i, t);
  }
  GeomAPI_Interpolate maker(points, parameters, Standard_False, gp::Resolution());
  maker.Perform();
  return Handle(Geom_Curve)(maker.Curve());
}

// Chart curves may lie whole periods beside the face.
void shift_to_face(const BodyEdges& body, const EdgeUseInFace& use, double t,
                   RolledContact& contact) {
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(body.face(use.face));
  const Vec2 scale = body.trims(use.face).scale;
  const Vec2 near = point_at(use.coedge->curve, at(use.coedge->curve.domain(), 0.5));
  const gp_Pnt2d middle = contact.chart->Value(t);
  gp_Vec2d move(0, 0);
  if (surface->IsUPeriodic())
    move.SetX(surface->UPeriod() *
              std::round((near[0] / scale[0] - middle.X()) / surface->UPeriod()));
  if (surface->IsVPeriodic())
    move.SetY(surface->VPeriod() *
              std::round((near[1] / scale[1] - middle.Y()) / surface->VPeriod()));
  if (move.Magnitude() > 0) contact.chart->Translate(move);
}

struct Tracing {
  const BodyEdges& body;
  int edge;
  bool concave;
  double radius;
  Interval edge_domain;
  Vec3 middle;

  [[noreturn]] void refuse(FilletFault fault, const std::string& cause,
                           const std::optional<Vec3>& point) const {
    throw FilletRefused(
        {fault, edge, cause, std::nullopt, point ? point : std::optional(middle), {}});
  }
  Interval valid_part(const BallTrack& track, const Interval& wanted) const;
};

// As much of what is wanted as the ball keeps to its sides.
Interval Tracing::valid_part(const BallTrack& track, const Interval& wanted) const {
  const BallSpine spine = with_stretches(track);
  for (const BallStretch& stretch : spine.stretches) {
    const double centre = at(wanted, 0.5);
    if (centre < stretch.range.from || centre > stretch.range.to) continue;
    if (!stretch.valid) break;
    return {std::max(wanted.from, stretch.range.from), std::min(wanted.to, stretch.range.to)};
  }
  const BallPoint ball = track.at(spine.tightest.parameter);
  refuse(FilletFault::Pinch,
         "the ball is too large for the curvature of the face on its " +
             std::string(spine.tightest.support == 0 ? "left" : "right"),
         ball.contacts[static_cast<std::size_t>(spine.tightest.support)].point);
}

// Turns the strip round so that t grows as the edge runs.
void reverse(RolledStrip& strip) {
  const double sum = strip.range.from + strip.range.to;
  strip.surface->UReverse();
  strip.spine->Reverse();
  for (RolledContact& contact : strip.contacts) {
    contact.curve->Reverse();
    contact.chart->Reverse();
  }
  strip.edge_range = {sum - strip.edge_range.to, sum - strip.edge_range.from};
}

}  // namespace

RolledStrip traced_strip(const BodyEdges& body, int edge, bool concave, double radius) {
  Tracing of{body, edge, concave, radius, {}, {}};
  BRep_Tool::Range(body.edge(edge), of.edge_domain.from, of.edge_domain.to);
  const std::array<const EdgeUseInFace*, 2> uses{&body.use(edge, true), &body.use(edge, false)};
  const RolledSupports supports = rolled_supports(body, edge, concave, radius);
  const double width = supports.width;
  of.middle = supports.middle;
  const auto track = track_through(supports.of[0].whole(), supports.of[1].whole(), radius,
                                   {supports.of[0].start, supports.of[1].start});
  if (!track)
    of.refuse(FilletFault::NoBall, "no ball of that radius touches both faces beside the edge", {});
  if (track->closed())
    of.refuse(FilletFault::End, "closed edges of free-form faces cannot be rounded yet", {});
  const double start = track->nearest(point_of(body.vertex({edge, true})));
  const double end = track->nearest(point_of(body.vertex({edge, false})));
  const bool backwards = end < start;
  Interval edge_range{std::min(start, end), std::max(start, end)};
  const double beyond = kBeyond * std::max(width, radius);
  Interval range = of.valid_part(*track, {std::max(track->domain().from, edge_range.from - beyond),
                                          std::min(track->domain().to, edge_range.to + beyond)});
  edge_range = {std::max(edge_range.from, range.from), std::min(edge_range.to, range.to)};
  if (length(edge_range) <= 0)
    of.refuse(FilletFault::NoBall, "the ball does not roll along the edge", {});
  const BallStrip made = ball_strip(*track, range);
  RolledStrip strip;
  strip.edge = edge;
  strip.concave = concave;
  strip.radius = radius;
  strip.surface = surface_of(made);
  strip.outward = false;  // du runs along the edge, dv from left to right as seen from outside
  strip.spine = spine_of(*track, made.knots);
  strip.range = range;
  strip.edge_range = edge_range;
  for (const std::size_t k : {0U, 1U}) {
    strip.contacts[k] = {uses[k]->face, to_occt(made.contacts[k].row),
                         to_occt(made.contacts[k].chart), static_cast<double>(k)};
    shift_to_face(body, *uses[k], at(range, 0.5), strip.contacts[k]);
  }
  if (backwards) reverse(strip);
  return strip;
}

}  // namespace blossom::occt
