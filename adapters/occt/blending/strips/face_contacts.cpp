// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/strips/face_contacts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>

#include <BRep_Tool.hxx>
#include <Precision.hxx>

#include "adapters/occt/blending/limits.h"
#include "adapters/occt/convert/pcurves.h"
#include "core/plane/planar_crossings.h"

namespace blossom::occt {
namespace {

// Of lines round a corner that is cut off: which side edges lie on that do not meet them is told by
// their chords.
constexpr int kLineSamples = 64;
constexpr double kRunEnd = 1e-9;  // of a run: meetings so near to its ends are those

// A line in the scaled parameters of a face, and whole periods beside, wherever it may meet edges
// of the face.
std::vector<PlanarCurve> copies_in(const BodyEdges& body, int face,
                                   const Handle(Geom2d_Curve) & chart, const Interval& range) {
  const FaceTrims& trims = body.trims(face);
  const PlanarCurve line = transformed(planar_curve(chart, range), trims.scale, {});
  std::vector<PlanarCurve> all;
  for (const Vec2& shift : period_shifts(trims, line)) {
    if (norm(shift) > 0 && trims.period[0] == 0 && trims.period[1] == 0) continue;
    all.push_back(transformed(line, {1, 1}, shift));
  }
  return all;
}

std::vector<PlanarCurve> contact_copies(const BodyEdges& body, const RolledStrip& strip,
                                        std::size_t side, int face) {
  return copies_in(body, face, strip.contacts[side].chart, strip.range);
}

// Common points but those where the curves run along each other: there neither goes over the other.
std::vector<PlanarCrossing> apart_from_runs(const PlanarCrossings& found) {
  std::vector<PlanarCrossing> points;
  std::ranges::copy_if(found.points, std::back_inserter(points), [&](const PlanarCrossing& each) {
    return std::ranges::none_of(found.overlaps, [&](const PlanarOverlap& run) {
      const double room = kRunEnd * length(run.a);
      return each.a >= run.a.from - room && each.a <= run.a.to + room;
    });
  });
  return points;
}

double meeting_tolerance(const EdgeUseInFace& use) {
  return std::max(Precision::Confusion(), use.coedge->tolerance);
}

// runs   where a contact runs along the edge, added
std::vector<PlanarCrossing> meetings(const std::vector<PlanarCurve>& contacts,
                                     const EdgeUseInFace& use, double tolerance,
                                     std::vector<Interval>* runs = nullptr) {
  std::vector<PlanarCrossing> all;
  for (const PlanarCurve& contact : contacts) {
    const PlanarCrossings found = crossings(contact, use.coedge->curve, tolerance);
    if (runs != nullptr)
      for (const PlanarOverlap& run : found.overlaps) runs->push_back(run.a);
    std::ranges::copy(apart_from_runs(found), std::back_inserter(all));
  }
  return all;
}

// How a contact and an edge cross in the chart of their face: the cross product of both rates.
double crossing_rate(const BodyEdges& body, const RolledStrip& strip, std::size_t side,
                     const EdgeUseInFace& use, const PlanarCrossing& at) {
  gp_Pnt2d point;
  gp_Vec2d rate;
  strip.contacts[side].chart->D1(at.a, point, rate);
  const Vec2 scale = body.trims(use.face).scale;
  const Vec2 edge = jet_at(use.coedge->curve, at.b).first;
  return cross(Vec2{rate.X() * scale[0], rate.Y() * scale[1]}, edge);
}

// Whether any of the places of a point in a chart, whole periods apart, is as wanted.
bool any_place(const FaceTrims& trims, const Vec2& uv,
               const std::function<bool(const Vec2&)>& is_wanted) {
  const Vec2 point{uv[0] * trims.scale[0], uv[1] * trims.scale[1]};
  return std::ranges::any_of(period_shifts(trims, planar_line(point, point, {0, 1})),
                             [&](const Vec2& shift) { return is_wanted(point + shift); });
}

Vec2 chart_at(const RolledContact& contact, double t) {
  const gp_Pnt2d uv = contact.chart->Value(t);
  return {uv.X(), uv.Y()};
}

}  // namespace

std::optional<ContactMeeting> meeting_with(const BodyEdges& body, const RolledStrip& strip,
                                           std::size_t side, const EdgeUseInFace& use,
                                           double near) {
  std::optional<ContactMeeting> best;
  for (const PlanarCrossing& each :
       meetings(contact_copies(body, strip, side, use.face), use, meeting_tolerance(use)))
    if (!best || std::abs(each.a - near) < std::abs(best->t - near))
      best = ContactMeeting{each.a, each.b};
  return best;
}

bool lies_inside(const BodyEdges& body, int face, const Vec2& uv) {
  const FaceTrims& trims = body.trims(face);
  return any_place(trims, uv, [&](const Vec2& at) { return is_inside(trims, at); });
}

bool lies_inside(const BodyEdges& body, const RolledContact& contact, double t) {
  return lies_inside(body, contact.face, chart_at(contact, t));
}

bool lies_on(const BodyEdges& body, const RolledContact& contact, double t) {
  const auto is_on_border = [&](const Vec2& at) {
    return std::ranges::any_of(body.uses(contact.face), [&](const EdgeUseInFace& use) {
      return nearest(use.coedge->curve, at).distance <=
             std::max(Precision::Confusion(), use.coedge->tolerance);
    });
  };
  return lies_inside(body, contact, t) ||
         any_place(body.trims(contact.face), chart_at(contact, t), is_on_border);
}

namespace {

// Runs along edges that follow each other are one.
std::vector<Interval> joined(std::vector<Interval> runs, double room) {
  std::ranges::sort(runs, {}, &Interval::from);
  std::vector<Interval> made;
  for (const Interval& run : runs)
    if (!made.empty() && run.from <= made.back().to + room)
      made.back().to = std::max(made.back().to, run.to);
    else
      made.push_back(run);
  return made;
}

// Where a contact runs along the border of its face it goes over none, and at the ends of such a
// run it does so only where it leaves the face on the other side of it, or comes into it. A seam
// that ends in the border it goes over all the same.
void keep_ways_out(const BodyEdges& body, const RolledStrip& strip, const RolledContact& contact,
                   const Interval& run, std::vector<ContactCrossing>& all) {
  const auto room = [&](const ContactCrossing& each) {
    const double speed = contact.curve->DN(each.t, 1).Magnitude();
    return kSamePlace * std::max(Precision::Confusion(), each.use->coedge->tolerance) / speed;
  };
  Interval before{strip.range.from, run.from}, after{run.to, strip.range.to};
  for (const ContactCrossing& each : all) {
    if (each.t < run.from - room(each)) before.from = each.t;
    if (each.t > run.to + room(each)) after.to = std::min(after.to, each.t);
  }
  const auto is_outside = [&](const Interval& beside) {
    return length(beside) > 0 && !lies_inside(body, contact, at(beside, 0.5));
  };
  const bool comes = is_outside(before), leaves = is_outside(after);
  std::erase_if(all, [&](const ContactCrossing& each) {
    const double near = room(each);
    if (body.behind(*each.use).face == each.use->face) return false;
    if (each.t < run.from - near || each.t > run.to + near) return false;
    return !(comes && each.t <= run.from + near) && !(leaves && each.t >= run.to - near);
  });
}

}  // namespace

namespace {

ContactCrossing crossing_of(const BodyEdges& body, const RolledStrip& strip, std::size_t side,
                            const EdgeUseInFace& use, const PlanarCrossing& at) {
  // The face lies to the left of the first contact of a strip and to the right of the second,
  // seen from outside.
  const bool reversed = body.face(use.face).Orientation() == TopAbs_REVERSED;
  const bool to_left = crossing_rate(body, strip, side, use, at) > 0;
  return {at.a, &use, at.b, ((side == 0) != reversed) == to_left, to_left != use.coedge->reversed};
}

void sort_by_t(std::vector<ContactCrossing>& all) {
  std::ranges::sort(all, {}, &ContactCrossing::t);
}

}  // namespace

std::vector<ContactCrossing> contact_crossings(const BodyEdges& body, const RolledStrip& strip,
                                               std::size_t side, const std::set<int>& left_out) {
  std::vector<ContactCrossing> all;
  std::vector<Interval> runs;
  const std::vector<PlanarCurve> contacts =
      contact_copies(body, strip, side, strip.contacts[side].face);
  for (const EdgeUseInFace& use : body.uses(strip.contacts[side].face)) {
    if (use.coedge->degenerated || left_out.count(use.edge) > 0) continue;
    if (use.edge == strip.bend[side]) continue;  // the contact runs along it
    for (const PlanarCrossing& each : meetings(contacts, use, meeting_tolerance(use), &runs))
      all.push_back(crossing_of(body, strip, side, use, each));
  }
  sort_by_t(all);
  for (const Interval& run : joined(std::move(runs), kRunEnd * length(strip.range)))
    keep_ways_out(body, strip, strip.contacts[side], run, all);
  return all;
}

std::vector<ContactCrossing> chart_crossings(const BodyEdges& body, const RolledStrip& strip,
                                             std::size_t side, const EdgeUseInFace& use) {
  std::vector<ContactCrossing> all;
  for (const PlanarCrossing& each :
       meetings(contact_copies(body, strip, side, use.face), use, Precision::Confusion()))
    all.push_back(crossing_of(body, strip, side, use, each));
  sort_by_t(all);
  return all;
}

namespace {

bool meet_between_ends(const PlanarCurve& line, const EdgeUseInFace& use) {
  const double tolerance = std::max(Precision::Confusion(), use.coedge->tolerance);
  const PlanarCrossings found = crossings(line, use.coedge->curve, tolerance);
  return !found.overlaps.empty() ||
         std::ranges::any_of(found.points, [&](const PlanarCrossing& each) {
           const Vec2 place = point_at(line, each.a);
           return distance(place, point_at(line, 0)) > tolerance &&
                  distance(place, point_at(line, 1)) > tolerance;
         });
}

// Whether a polygon goes round a point.
bool goes_round(const std::vector<Vec2>& polygon, const Vec2& point) {
  double turned = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i] - point, b = polygon[(i + 1) % polygon.size()] - point;
    turned += std::atan2(cross(a, b), dot(a, b));
  }
  return std::abs(turned) > std::numbers::pi;
}

void add_part(const PlanarCurve& curve, const Interval& part, std::vector<Vec2>& polygon) {
  for (int i = 0; i <= kLineSamples; ++i)
    polygon.push_back(point_at(curve, at(part, static_cast<double>(i) / kLineSamples)));
}

// What a line cuts off from a sector: round along its first edge, the line, and back along the
// next.
//
// copies   of the line, of which that is meant which is nearest to the sector
std::vector<Vec2> corner_cut_off(const BodyEdges& body, const std::vector<PlanarCurve>& copies,
                                 const VertexSector& sector, const DirectedEdge& next) {
  const auto vertex_on = [&](const DirectedEdge& half) {
    double first = 0, last = 0;
    BRep_Tool::Range(body.edge(half.edge), first, last);
    return half.at_start ? first : last;
  };
  const auto use = static_cast<std::size_t>(sector.use);
  const PlanarCurve& leaving = body.uses(sector.face)[use].coedge->curve;
  const PlanarCurve& arriving = body.use(next.edge, !next.at_start).coedge->curve;
  const double from = vertex_on(sector.half), to = vertex_on(next);
  const Vec2 vertex = point_at(leaving, from);
  const auto away = [&](const PlanarCurve& copy) { return distance(point_at(copy, 0), vertex); };
  const auto line = std::ranges::min_element(copies, {}, away);
  if (line == copies.end()) return {};
  std::vector<Vec2> polygon;
  add_part(leaving, {from, nearest(leaving, point_at(*line, 0)).parameter}, polygon);
  add_part(*line, {0, 1}, polygon);
  add_part(arriving, {nearest(arriving, point_at(*line, 1)).parameter, to}, polygon);
  return polygon;
}

}  // namespace

bool meets_border(const BodyEdges& body, const Handle(Geom2d_Curve) & line, const VertexSector& at,
                  const DirectedEdge& next) {
  const std::vector<PlanarCurve> copies = copies_in(body, at.face, line, {0, 1});
  const std::vector<Vec2> corner = corner_cut_off(body, copies, at, next);
  return std::ranges::any_of(body.uses(at.face), [&](const EdgeUseInFace& use) {
    if (use.coedge->degenerated || use.edge == at.half.edge || use.edge == next.edge) return false;
    if (body.behind(use).face == at.face) return false;
    if (std::ranges::any_of(copies, [&](const auto& each) { return meet_between_ends(each, use); }))
      return true;
    return goes_round(corner,
                      point_at(use.coedge->curve, blossom::at(use.coedge->curve.domain(), 0.5)));
  });
}

std::optional<std::array<double, 2>> contacts_cross(const BodyEdges& body, const RolledStrip& a,
                                                    std::size_t side_a, double near_a,
                                                    const RolledStrip& b, std::size_t side_b,
                                                    double near_b) {
  const Vec2 scale = body.trims(a.contacts[side_a].face).scale;
  const auto chart = [&](const RolledStrip& of, std::size_t side) {
    return transformed(planar_curve(of.contacts[side].chart, of.range), scale, {});
  };
  std::optional<std::array<double, 2>> best;
  double least = 0;
  for (const PlanarCrossing& each :
       apart_from_runs(crossings(chart(a, side_a), chart(b, side_b), Precision::Confusion()))) {
    const double away = std::abs(each.a - near_a) + std::abs(each.b - near_b);
    if (best && away >= least) continue;
    best = {each.a, each.b};
    least = away;
  }
  return best;
}

}  // namespace blossom::occt
