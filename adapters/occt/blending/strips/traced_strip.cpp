// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <gp.hxx>
#include <gp_Vec2d.hxx>

#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/fillet_refusal.h"
#include "adapters/occt/blending/limits.h"
#include "adapters/occt/blending/strips/ball_supports.h"
#include "adapters/occt/blending/strips/rolled_strip.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/faces/surface_projector.h"
#include "adapters/occt/splitting/edge_images.h"
#include "core/blending/balls/ball_spine.h"
#include "core/blending/balls/ball_strip.h"
#include "core/blending/balls/ball_track.h"

namespace blossom::occt {
namespace {

// Strips go on past the edge by so many times their width, as far as the ball rolls.
constexpr double kRollWidths = 2;
// Of the least radius: what a law may take off it past the edge's ends.
constexpr double kMinShare = 0.5;
// Of the way of a loop that is not beside the edge: what stays free of an open strip.
constexpr double kLoopShare = 0.2;
constexpr int kSpineSamples = 4;  // between two knots of the strip
// Likewise of a contact along an edge at most: its chart is as smooth as that of the edge.
constexpr int kMaxEdgeParts = 256;

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
  TColStd_Array1OfReal v_knots(1, 2);
  v_knots(1) = 0;
  v_knots(2) = 1;
  TColStd_Array1OfInteger v_multiplicities(1, 2);
  v_multiplicities.Init(columns);
  constexpr int kDegree = 5;  // along the spine, as BallStrip has it
  return new Geom_BSplineSurface(poles, weights, u_knots, v_knots, u_multiplicities,
                                 v_multiplicities, kDegree, columns - 1);
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
void shift_near(const Handle(Geom_Surface) & surface, const Vec2& near, double t,
                RolledContact& contact) {
  const gp_Pnt2d there = contact.chart->Value(t);
  const std::array<double, 2> turns = turns_of(surface);
  gp_Vec2d move(0, 0);
  if (turns[0] > 0) move.SetX(turns[0] * std::round((near[0] - there.X()) / turns[0]));
  if (turns[1] > 0) move.SetY(turns[1] * std::round((near[1] - there.Y()) / turns[1]));
  if (move.Magnitude() > 0) contact.chart->Translate(move);
}

// The parameter about - t for all curves and the surface of a strip.
void turn_round(RolledStrip& strip, double about) {
  const auto moved = [about](double first, double last) { return about - first - last; };
  const auto turn = [&moved](const auto& curve) {
    curve->Reverse();
    const double by = moved(curve->FirstParameter(), curve->LastParameter());
    TColStd_Array1OfReal knots(1, curve->NbKnots());
    for (int i = 1; i <= curve->NbKnots(); ++i) knots(i) = curve->Knot(i) + by;
    curve->SetKnots(knots);
  };
  const auto surface = Handle(Geom_BSplineSurface)::DownCast(strip.surface);
  surface->UReverse();
  TColStd_Array1OfReal knots(1, surface->NbUKnots());
  const double by = moved(surface->UKnot(1), surface->UKnot(surface->NbUKnots()));
  for (int i = 1; i <= surface->NbUKnots(); ++i) knots(i) = surface->UKnot(i) + by;
  surface->SetUKnots(knots);
  turn(Handle(Geom_BSplineCurve)::DownCast(strip.spine));
  for (RolledContact& contact : strip.contacts) {
    turn(Handle(Geom_BSplineCurve)::DownCast(contact.curve));
    turn(Handle(Geom2d_BSplineCurve)::DownCast(contact.chart));
  }
  for (Interval* each : {&strip.range, &strip.edge_range, &strip.most})
    *each = {about - each->to, about - each->from};
  std::swap(strip.pinched[0], strip.pinched[1]);
}

Interval common(const Interval& a, const Interval& b) {
  return {std::max(a.from, b.from), std::min(a.to, b.to)};
}

// A ball on its way along two faces, of which any part becomes a strip.
struct Tracing : std::enable_shared_from_this<Tracing> {
  Tracing(const BodyEdges& of, int edge_number, bool is_concave, const StripProfile& across)
      : body(of), edge(edge_number), concave(is_concave), profile(across), radius(across.radius) {}

  const BodyEdges& body;
  int edge;
  bool concave;
  StripProfile profile;
  double radius;  // the largest
  std::array<int, 2> faces{};
  std::array<int, 2> held{};  // edges on which it leans in place of them
  std::array<Vec2, 2> near;   // where the contacts' charts are to be
  double near_at = 0;         // the track's parameter there
  RolledSupports supports;
  std::optional<BallTrack> track;
  mutable std::shared_ptr<StripMaker> strips;  // along it
  bool turned = false;                         // t = - the track's parameter
  Interval valid, edge_range;
  std::array<bool, 2> pinched{};        // at the ends of what is valid
  std::optional<Interval> kept;         // of a loop that was cut open: what of it may be used
  std::shared_ptr<const Tracing> loop;  // that one, which has the track's surfaces

  [[noreturn]] void refuse(FilletFault fault, const std::string& cause,
                           const std::optional<Vec3>& point) const {
    throw FilletRefused(
        {fault, edge, cause, std::nullopt, point ? point : std::optional(supports.middle), {}});
  }
  void start(const std::array<BallSupport, 2>& on);
  void start_by_law(const Interval& domain);
  void find_valid(double parameter);
  void check_reach(double end, const Vec3& vertex, double room) const;
  void put_on_face(std::size_t k, RolledStrip& strip) const;
  RolledStrip strip(const Interval& range) const;
  RolledStrip beside_edge(double beyond);
  Interval way_apart() const;
};

void Tracing::start(const std::array<BallSupport, 2>& on) {
  strips.reset();
  track = track_through(on[0], on[1], radius, {supports.of[0].start, supports.of[1].start});
  if (!track)
    refuse(FilletFault::NoBall, "no ball of that radius touches both faces beside the edge", {});
}

// How far a law goes on past both ends of its range, at most by so much, before it takes more than
// a part of the least radius off.
double law_beyond(const RadiusLaw& law, const Interval& range, double most) {
  const double least = (1 - kMinShare) * law.extremes(range).from;
  double beyond = most;
  while (law.extremes({range.from - beyond, range.to + beyond}).from < least) beyond /= 2;
  return beyond;
}

// Radii by a law over the edge's parameter; the edge is the guide, and goes on past its ends.
void Tracing::start_by_law(const Interval& domain) {
  Interval own;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(body.edge(edge), own.from, own.to);
  const double speed = curve->DN(at(domain, 0.5), 1).Magnitude();
  const RadiusLaw law = profile.law->over({0, 1}, domain);
  const double beyond =
      law_beyond(law, domain, kRollWidths * std::max(supports.width, radius) / speed);
  BallGuide guide;
  guide.range = {domain.from - beyond, domain.to + beyond};
  guide.curve = [curve](double x) {
    gp_Pnt p;
    gp_Vec first, second;
    curve->D2(x, p, first, second);
    return CurveJet{{p.X(), p.Y(), p.Z()},
                    {first.X(), first.Y(), first.Z()},
                    {second.X(), second.Y(), second.Z()}};
  };
  track = track_through(supports.of[0].whole(), supports.of[1].whole(), law, guide, near_at,
                        {supports.of[0].start, supports.of[1].start});
  if (!track)
    refuse(FilletFault::NoBall, "no ball of that radius touches both faces beside the edge", {});
}

// As much of the track as the ball keeps to its sides.
void Tracing::find_valid(double parameter) {
  const BallSpine spine = with_stretches(*track);
  for (const BallStretch& stretch : spine.stretches) {
    if (parameter < stretch.range.from || parameter > stretch.range.to) continue;
    if (!stretch.valid) break;
    valid = kept ? common(stretch.range, *kept) : stretch.range;
    const Interval all = track->domain();
    pinched = {valid.from == stretch.range.from && valid.from > all.from,
               valid.to == stretch.range.to && valid.to < all.to};
    return;
  }
  const BallPinch tightest = tightest_of(*track);
  const BallPoint ball = track->at(tightest.parameter);
  refuse(FilletFault::Pinch,
         "the ball is too large for the curvature of the face on its " +
             std::string(tightest.support == 0 ? "left" : "right"),
         ball.contacts[static_cast<std::size_t>(tightest.support)].point);
}

// Whether the track comes to the end of the edge, or as near as the border of a surface there lets
// it.
void Tracing::check_reach(double end, const Vec3& vertex, double room) const {
  const BallPoint ball = track->at(end);
  if (std::abs(dot(vertex - ball.centre, unit(ball.centre_rate))) <= room) return;
  refuse(FilletFault::LeavesFace,
         std::string("the ball rolls only along a part of the edge: there ") +
             (track->ends()[0] == TrackEnd::Lost || track->ends()[1] == TrackEnd::Lost
                  ? "its way cannot be followed further"
                  : "a contact leaves the surface of a face"),
         ball.contacts[0].point);
}

// The chart of a contact along an edge in a face of that: what the edge has there, at the edge's
// parameter that the contact has at each t. Null where the contact goes past an end of the edge, or
// no fit is near enough.
//
// on_edge     the edge's parameter and the angle about it, by t
// tolerance   model units
Handle(Geom2d_Curve) chart_along(const BodyEdges& body, const EdgeUseInFace& use,
                                 const Handle(Geom2d_BSplineCurve) & on_edge, double tolerance) {
  const Interval ends = use.coedge->curve.domain();
  const Vec2 scale = body.trims(use.face).scale;
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(body.face(use.face));
  bool keeps = true;
  const auto place = [&](double t) {
    const double x = on_edge->Value(t).X();
    keeps = keeps && x >= ends.from && x <= ends.to;
    const Vec2 chart = point_at(use.coedge->curve, std::clamp(x, ends.from, ends.to));
    return gp_Pnt2d(chart[0] / scale[0], chart[1] / scale[1]);
  };
  const auto point = [&](const gp_Pnt2d& uv) { return surface->Value(uv.X(), uv.Y()); };
  for (int parts = kSpineSamples; parts <= kMaxEdgeParts && keeps; parts *= 2) {
    const int count = parts * (on_edge->NbKnots() - 1) + 1;
    const Handle(TColgp_HArray1OfPnt2d) points = new TColgp_HArray1OfPnt2d(1, count);
    const Handle(TColStd_HArray1OfReal) places = new TColStd_HArray1OfReal(1, count);
    for (int i = 0; i < count; ++i) {
      const int knot = std::min(i / parts + 1, on_edge->NbKnots() - 1);
      const Interval span{on_edge->Knot(knot), on_edge->Knot(knot + 1)};
      places->SetValue(i + 1, at(span, static_cast<double>(i - (knot - 1) * parts) / parts));
      points->SetValue(i + 1, place(places->Value(i + 1)));
    }
    Geom2dAPI_Interpolate maker(points, places, Standard_False, gp::Resolution());
    maker.Perform();
    double off = 0;
    for (int i = 1; i < count; ++i) {
      const double t = 0.5 * (places->Value(i) + places->Value(i + 1));
      off = std::max(off, point(maker.Curve()->Value(t)).Distance(point(place(t))));
    }
    if (off <= tolerance && keeps) return Handle(Geom2d_Curve)(maker.Curve());
  }
  return {};
}

void Tracing::put_on_face(std::size_t k, RolledStrip& strip) const {
  RolledContact& contact = strip.contacts[k];
  const TopoDS_Edge along = body.edge(held[k]);
  const EdgeUseInFace& use = body.use_in(held[k], contact.face);
  if (const Handle(Geom2d_Curve) chart = chart_along(
          body, use, Handle(Geom2d_BSplineCurve)::DownCast(contact.chart), Precision::Confusion());
      !chart.IsNull()) {
    contact.chart = chart;
    return;
  }
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(along, range.from, range.to);
  const gp_Pnt middle = contact.curve->Value(at(strip.range, 0.5));
  const Vec2 chart =
      point_at(use.coedge->curve, nearest_on(curve, range, {middle.X(), middle.Y(), middle.Z()}));
  const Vec2 scale = body.trims(contact.face).scale;
  const SurfaceProjector feet(body.face(contact.face), Precision::Confusion());
  contact.chart =
      image_of(contact.curve, strip.range, feet, Vec2{chart[0] / scale[0], chart[1] / scale[1]},
               kSamePlace * std::max(Precision::Confusion(), BRep_Tool::Tolerance(along)))
          .chart;
}

RolledStrip Tracing::strip(const Interval& wanted) const {
  const Interval range = turned ? Interval{-wanted.to, -wanted.from} : wanted;
  BallStripOptions options;
  options.section = profile.section.kind;
  options.rho = profile.section.rho;
  if (!strips) strips = std::make_shared<StripMaker>(*track, options);
  const BallStrip made = strips->strip(range);
  RolledStrip strip;
  strip.edge = edge;
  strip.concave = concave;
  strip.radius = radius;
  strip.is_ball = profile.is_ball();
  strip.surface = surface_of(made);
  strip.outward = false;  // du runs along the edge, dv from left to right as seen from outside
  strip.closed = made.closed;
  strip.spine = spine_of(*track, made.knots);
  strip.range = range;
  strip.edge_range = edge_range;
  strip.most = valid;
  strip.pinched = pinched;
  strip.bend = held;
  for (const std::size_t k : {0U, 1U}) {
    strip.contacts[k] = {faces[k], to_occt(made.contacts[k].row), to_occt(made.contacts[k].chart),
                         static_cast<double>(k)};
    if (held[k] > 0) continue;
    shift_near(BRep_Tool::Surface(body.face(faces[k])), near[k],
               std::clamp(near_at, range.from, range.to), strip.contacts[k]);
  }
  // Open strips turn about 0, so that all parts of one track have one parameter. Closed ones keep
  // their range: where it ends at 0, Open CASCADE's readers can take the seam's one side for the
  // other and lose an edge.
  if (turned) turn_round(strip, made.closed ? range.from + range.to : 0);
  for (const std::size_t k : {0U, 1U})
    if (held[k] > 0) put_on_face(k, strip);
  if (!strip.closed)
    strip.over = [self = shared_from_this()](const Interval& part) { return self->strip(part); };
  return strip;
}

// The strip beside the edge, with some room past its ends.
RolledStrip Tracing::beside_edge(double beyond) {
  // Each end of the edge on its own side of the middle: a ball on its way round may come through
  // one place twice, as it does where faces touch in a vertex and its way crosses itself.
  const double middle = track->nearest(supports.middle);
  const Interval before{track->domain().from, middle}, after{middle, track->domain().to};
  const double start = track->nearest(point_of(body.vertex({edge, true})), turned ? after : before);
  const double end = track->nearest(point_of(body.vertex({edge, false})), turned ? before : after);
  const Interval between{std::min(start, end), std::max(start, end)};
  near_at = at(between, 0.5);
  find_valid(near_at);
  edge_range = common(between, valid);
  if (length(edge_range) <= 0)
    refuse(FilletFault::NoBall, "the ball does not roll along the edge", {});
  const DirectedEdge low{edge, !turned}, high{edge, turned};
  const double room = std::max(beyond, kEndRadii * radius);
  check_reach(edge_range.from, point_of(body.vertex(low)), room);
  check_reach(edge_range.to, point_of(body.vertex(high)), room);
  const Interval range = common({edge_range.from - beyond, edge_range.to + beyond}, valid);
  return strip(turned ? Interval{-range.to, -range.from} : range);
}

// What of the way of a loop is not beside the edge; it may go past the end of the track.
Interval Tracing::way_apart() const {
  const double turn = length(track->domain());
  const double a = track->nearest(point_of(body.vertex({edge, true})));
  const double b = track->nearest(point_of(body.vertex({edge, false})));
  const double low = std::min(a, b), high = std::max(a, b);
  const double middle = track->nearest(supports.middle);
  if (middle < low || middle > high) return {low, high};
  return {high, low + turn};
}

// A ball that rolls round and comes back, along an edge that does not: the way of the ball is cut
// where it is not beside the edge, and the strip ends before.
RolledStrip opened(const Tracing& round, double beyond) {
  const auto of = std::make_shared<Tracing>(round);
  of->loop = round.shared_from_this();
  const Interval apart = of->way_apart(), domain = round.track->domain();
  const double far = at(apart, 0.5);
  of->strips.reset();
  of->track = round.track->cut_open(far > domain.to ? far - length(domain) : far);
  const double room = 0.5 * kLoopShare * length(apart);
  of->kept = {of->track->domain().from + room, of->track->domain().to - room};
  return of->beside_edge(beyond);
}

}  // namespace

RolledStrip traced_strip(const BodyEdges& body, int edge, bool concave,
                         const StripProfile& profile) {
  const auto of = std::make_shared<Tracing>(body, edge, concave, profile);
  Interval domain;
  BRep_Tool::Range(body.edge(edge), domain.from, domain.to);
  of->supports = rolled_supports(body, edge, concave,
                                 profile.law ? profile.law->at(0.5).value : profile.radius);
  for (const std::size_t k : {0U, 1U}) {
    const EdgeUseInFace& use = body.use(edge, k == 0);
    const Vec2 scale = body.trims(use.face).scale;
    const Vec2 at_middle = point_at(use.coedge->curve, at(use.coedge->curve.domain(), 0.5));
    of->faces[k] = use.face;
    of->near[k] = {at_middle[0] / scale[0], at_middle[1] / scale[1]};
  }
  const double beyond = kRollWidths * std::max(of->supports.width, of->radius);
  if (profile.law) {
    of->near_at = at(domain, 0.5);
    of->start_by_law(domain);
    of->find_valid(of->near_at);
    of->edge_range = common(domain, of->valid);
    if (of->edge_range.from > domain.from || of->edge_range.to < domain.to)
      of->refuse(FilletFault::LeavesFace, "the ball rolls only along a part of the edge", {});
    if (!body.vertex({edge, true}).IsSame(body.vertex({edge, false}))) return of->strip(of->valid);
    RolledStrip strip = of->strip(domain);
    strip.closed = true;
    strip.over = nullptr;
    return strip;
  }
  const std::array<BallSupport, 2> on{of->supports.of[0].whole(), of->supports.of[1].whole()};
  // Where faces bend on the way to its contacts, the ball that is nearest to those of the edge's
  // tangent planes may be another one.
  if (const auto charts = ball_beside_edge(
          on[0], on[1], profile.radius, {of->supports.of[0].at_edge, of->supports.of[1].at_edge}))
    for (const std::size_t k : {0U, 1U}) of->supports.of[k].start = (*charts)[k];
  of->start(on);
  const BallTrack& track = *of->track;
  const gp_Vec along = BRepAdaptor_Curve(body.edge(edge)).DN(at(domain, 0.5), 1);
  const double middle = track.nearest(of->supports.middle);
  const Vec3 rate = track.at(middle).centre_rate;
  of->turned = rate[0] * along.X() + rate[1] * along.Y() + rate[2] * along.Z() < 0;
  if (!track.closed()) return of->beside_edge(beyond);
  const bool is_loop = body.vertex({edge, true}).IsSame(body.vertex({edge, false}));
  of->find_valid(middle);
  of->edge_range = track.domain();
  of->near_at = middle;
  const bool pinches = of->valid.from > track.domain().from || of->valid.to < track.domain().to;
  if (pinches) {
    if (!is_loop) return opened(*of, beyond);
    of->refuse(FilletFault::Pinch, "the ball is too large for the curvature of a face", {});
  }
  RolledStrip strip = of->strip(of->turned ? Interval{-of->valid.to, -of->valid.from} : of->valid);
  if (!is_loop) strip.opened = [of, beyond] { return opened(*of, beyond); };
  return strip;
}

RolledStrip traced_strip(const BodyEdges& body, const BallPlace& place, int edge, bool concave,
                         const StripProfile& profile) {
  const auto of = std::make_shared<Tracing>(body, edge, concave, profile);
  const double radius = of->radius;
  of->supports = supports_at(body, place, concave, radius);
  of->faces = place.faces;
  of->held = place.held;
  of->near = place.charts;
  of->start({of->supports.of[0].whole(), of->supports.of[1].whole()});
  const BallTrack& track = *of->track;
  of->near_at = track.nearest(place.centre);
  of->turned = dot(track.at(of->near_at).centre_rate, place.along) < 0;
  of->find_valid(of->near_at);
  if (place.as_loop && track.closed() && length(of->valid) == length(track.domain())) {
    of->edge_range = of->valid;
    return of->strip(of->turned ? Interval{-of->valid.to, -of->valid.from} : of->valid);
  }
  const double beyond = kRollWidths * radius;
  const Interval range = common({of->near_at - beyond, of->near_at + beyond}, of->valid);
  of->edge_range = range;
  return of->strip(of->turned ? Interval{-range.to, -range.from} : range);
}

RolledStrip traced_strip(const BodyEdges& body, const GuidedPlace& place, bool concave,
                         const StripProfile& profile) {
  const auto of = std::make_shared<Tracing>(body, place.edge, concave, profile);
  Interval domain;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(body.edge(place.edge), domain.from, domain.to);
  BallPlace ball;
  ball.faces = of->faces = place.faces;
  ball.charts = of->near = place.charts;
  ball.centre = vec(curve->Value(place.at));
  of->supports = supports_at(body, ball, concave, of->radius);
  of->near_at = place.at;
  of->start_by_law(domain);
  of->find_valid(place.at);
  of->edge_range = common(domain, of->valid);
  const double beyond = kRollWidths * of->radius / curve->DN(place.at, 1).Magnitude();
  return of->strip(common({place.at - beyond, place.at + beyond}, of->valid));
}

}  // namespace blossom::occt
