// SPDX-License-Identifier: LGPL-2.1-or-later
// Where strips go on in one another: vertices and the arc that both have.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <BRep_Tool.hxx>
#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <TopoDS.hxx>
#include <gp.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/limits.h"
#include "adapters/occt/blending/sheet/blend_sheet.h"

namespace blossom::occt {
namespace {

constexpr double kSameAngle = 1e-9;  // of sections that are counted alike, radians or shares
constexpr int kFollowed = 32;        // points of half an arc that are followed along a section
constexpr int kSectionSamples = 8;   // of an arc, to compare it with a section

// Two splines of one degree, one after the other.
Handle(Geom2d_BSplineCurve) joined(const Geom2d_BSplineCurve& a, const Geom2d_BSplineCurve& b) {
  const int knot_count = a.NbKnots() + b.NbKnots() - 1, pole_count = a.NbPoles() + b.NbPoles() - 1;
  TColgp_Array1OfPnt2d poles(1, pole_count);
  TColStd_Array1OfReal knots(1, knot_count);
  TColStd_Array1OfInteger multiplicities(1, knot_count);
  for (int i = 1; i <= pole_count; ++i)
    poles(i) = i <= a.NbPoles() ? a.Pole(i) : b.Pole(i - a.NbPoles() + 1);
  for (int i = 1; i <= knot_count; ++i) {
    const bool of_a = i <= a.NbKnots();
    knots(i) = of_a ? a.Knot(i) : b.Knot(i - a.NbKnots() + 1);
    multiplicities(i) = of_a ? a.Multiplicity(i) : b.Multiplicity(i - a.NbKnots() + 1);
  }
  multiplicities(a.NbKnots()) = a.Degree();
  return new Geom2d_BSplineCurve(poles, knots, multiplicities, a.Degree());
}

// The chart of a curve along a strip's section at t: both halves apart, as wide sections have a
// knot in the middle.
Handle(Geom2d_Curve) followed_section(const Handle(Geom_Curve) & curve, const Interval& range,
                                      const RolledStrip& strip, double t) {
  const Handle(Geom_Curve) section =
      strip.along_u ? strip.surface->UIso(t) : strip.surface->VIso(t);
  const Interval across{std::min(strip.contacts[0].w, strip.contacts[1].w),
                        std::max(strip.contacts[0].w, strip.contacts[1].w)};
  std::vector<Handle(Geom2d_BSplineCurve)> halves;
  for (const Interval& half :
       {Interval{range.from, at(range, 0.5)}, Interval{at(range, 0.5), range.to}}) {
    const Handle(TColgp_HArray1OfPnt2d) points = new TColgp_HArray1OfPnt2d(1, kFollowed + 1);
    const Handle(TColStd_HArray1OfReal) places = new TColStd_HArray1OfReal(1, kFollowed + 1);
    for (int i = 0; i <= kFollowed; ++i) {
      const double x = at(half, static_cast<double>(i) / kFollowed);
      const Vec2 uv = strip.chart(t, nearest_on(section, across, vec(curve->Value(x).XYZ())));
      points->SetValue(i + 1, {uv[0], uv[1]});
      places->SetValue(i + 1, x);
    }
    Geom2dAPI_Interpolate maker(points, places, Standard_False, gp::Resolution());
    maker.Perform();
    halves.push_back(maker.Curve());
  }
  return joined(*halves[0], *halves[1]);
}

// The chart of an arc that is a strip's section at t, by its own parameter: the section itself
// where both count the angle alike, else a fit.
Handle(Geom2d_Curve)
    section_chart(const TopoDS_Edge& arc, const RolledStrip& strip, double t, double reach) {
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(arc, range.from, range.to);
  for (const bool turned : {false, true}) {
    const double first = strip.contacts[turned ? 1 : 0].w, last = strip.contacts[turned ? 0 : 1].w;
    const double sign = first < last ? 1 : -1;
    if (std::abs(sign * (last - first) - length(range)) > kSameAngle) continue;
    const Vec2 start = strip.chart(t, first - sign * range.from), way = strip.chart(0, sign);
    const Handle(Geom2d_Curve) line =
        new Geom2d_Line(gp_Pnt2d(start[0], start[1]), gp_Dir2d(way[0], way[1]));
    bool is_section = true;
    for (int i = 0; i <= kSectionSamples; ++i) {
      const double x = at(range, static_cast<double>(i) / kSectionSamples);
      const gp_Pnt2d uv = line->Value(x);
      is_section =
          is_section && curve->Value(x).Distance(strip.surface->Value(uv.X(), uv.Y())) <= reach;
    }
    if (is_section) return line;
  }
  return followed_section(curve, range, strip, t);
}

// Whether a contact is a point in which the ball turns.
bool stays(const RolledContact& contact) {
  return contact.curve->DN(contact.curve->FirstParameter(), 1).Magnitude() == 0;
}

}  // namespace

// Where a strip ends that another one goes on from: on the edge that the contact goes over there;
// a new one inside of a face.
TopoDS_Vertex BlendSheet::joint_vertex(const PlacedStrip& of, std::size_t side, double t,
                                       const std::optional<ContactCrossing>& over) {
  const Vec3 point = vec(of.strip.contacts[side].curve->Value(t));
  const TopoDS_Face& face = body_.face(of.strip.contacts[side].face);
  std::optional<ContactCrossing> crossing = over;
  if (!crossing)  // a closed strip may begin on a seam
    for (const ContactCrossing& each : contact_crossings(body_, of.strip, side, filleted_)) {
      const double off = distance(vec(of.strip.contacts[side].curve->Value(each.t)), point);
      const double reach = kSamePlace * std::max(tolerance_, each.use->coedge->tolerance);
      if (off <= reach && is_seam_at(body_, each)) crossing = each;
    }
  if (!crossing) return new_vertex(point);
  const TopoDS_Vertex vertex = cut_edge(*crossing, face);
  cover(vertex, point, Precision::Confusion());
  return vertex;
}

// Two strips go on in one another, or a closed one in itself.
void BlendSheet::join(const Joint& joint) {
  const PlacedStrip &of = strips_[joint.before.strip], &next = strips_[joint.after.strip];
  StripEnd& end = strips_[joint.before.strip].ends[joint.before.end];
  StripEnd& begin = strips_[joint.after.strip].ends[joint.after.end];
  const double t = joint.walked.before, t_after = joint.walked.after;
  end.t = {t, t};
  begin.t = {t_after, t_after};
  for (const std::size_t walking : {0U, 1U}) {
    const std::size_t side = joint.before.end == 1 ? walking : 1 - walking;
    const std::size_t side_after = joint.after.end == 0 ? walking : 1 - walking;
    // Where the ball turns on the spot both ends of its strip have to be in one vertex.
    const bool of_next = !joint.walked.over[walking] && stays(next.strip.contacts[side_after]);
    const TopoDS_Vertex vertex = of_next ? joint_vertex(next, side_after, t_after, {})
                                         : joint_vertex(of, side, t, joint.walked.over[walking]);
    cover(vertex, vec(of.strip.contacts[side].curve->Value(t)), Precision::Confusion());
    cover(vertex, vec(next.strip.contacts[side_after].curve->Value(t_after)),
          Precision::Confusion());
    end.vertices[side] = begin.vertices[side_after] = vertex;
    if (const auto& over = joint.walked.over[walking])
      end.over[side] = begin.over[side_after] = over->use->edge;
  }
  join_section(joint.before, joint.after);
  for (const std::size_t walking : {0U, 1U})
    if (const auto& over = joint.walked.over[walking]) {
      join_to_face(joint.before, joint.before.end == 1 ? walking : 1 - walking, *over);
      join_to_face(joint.after, joint.after.end == 0 ? walking : 1 - walking, *over);
    }
}

namespace {

// The chart, in that of a strip, of an edge that runs beside its contact.
//
// part   of the contact, from what is beside the edge's start to what is beside its end
Handle(Geom2d_Curve) chart_beside(const TopoDS_Edge& edge, const RolledStrip& strip,
                                  const RolledContact& contact, const Interval& part) {
  Interval range;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.from, range.to);
  const Interval beside{std::min(part.from, part.to), std::max(part.from, part.to)};
  const Handle(TColgp_HArray1OfPnt2d) points = new TColgp_HArray1OfPnt2d(1, kFollowed + 1);
  const Handle(TColStd_HArray1OfReal) places = new TColStd_HArray1OfReal(1, kFollowed + 1);
  for (int i = 0; i <= kFollowed; ++i) {
    const double x = at(range, static_cast<double>(i) / kFollowed);
    double t = nearest_on(contact.curve, beside, vec(curve->Value(x).XYZ()));
    if (i == 0) t = part.from;
    if (i == kFollowed) t = part.to;
    const Vec2 uv = strip.chart(t, contact.w);
    points->SetValue(i + 1, {uv[0], uv[1]});
    places->SetValue(i + 1, x);
  }
  Geom2dAPI_Interpolate maker(points, places, Standard_False, gp::Resolution());
  maker.Perform();
  return Handle(Geom2d_Curve)(maker.Curve());
}

}  // namespace

// Where two faces miss their common edge, a contact that goes over it at a small angle leaves the
// one long before it comes to the other. In between the border of its strip is the edge, of which
// so much is left to one of the faces.
//
// over   where it leaves the one face
void BlendSheet::join_to_face(const EndPlace& place, std::size_t side,
                              const ContactCrossing& over) {
  PlacedStrip& of = strips_[place.strip];
  StripEnd& end = of.ends[place.end];
  const RolledContact& contact = of.strip.contacts[side];
  const TopoDS_Vertex joined = end.vertices[side];
  const double joint_t = end.t[side];
  const double inwards = place.end == 0 ? 1 : -1;
  const TopoDS_Edge edge = body_.edge(over.use->edge);
  std::optional<ContactCrossing> late;
  for (const ContactCrossing& each :
       chart_crossings(body_, of.strip, side, body_.use_in(over.use->edge, contact.face)))
    if (inwards * (each.t - joint_t) > 0 && each.leaves != (inwards > 0) &&
        (!late || inwards * (late->t - each.t) > 0))
      late = each;
  if (!late) return;
  const Vec3 comes = vec(contact.curve->Value(late->t));
  if (distance(comes, point_of(joined)) <= BRep_Tool::Tolerance(joined)) return;
  // What stays of the edge begins at the one or the other place.
  const bool stays_behind = over.keep_after == (late->edge_parameter > over.edge_parameter);
  if (stays_behind)
    std::erase_if(border_.cuts, [&](const EdgeCut& cut) {
      return cut.edge == over.use->edge && splits_.vertex(edge, cut.split).IsSame(joined);
    });
  const int split = splits_.add(edge, late->edge_parameter, body_.face(contact.face));
  if (stays_behind) border_.cuts.push_back({over.use->edge, split, over.keep_after});
  end.t[side] = late->t;
  const TopoDS_Vertex met = end.vertices[side] = splits_.vertex(edge, split);
  if (met.IsSame(joined)) return;
  const bool rises = late->edge_parameter > over.edge_parameter;
  const TopoDS_Edge piece =
      rises ? piece_of(edge, {over.edge_parameter, late->edge_parameter}, joined, met)
            : piece_of(edge, {late->edge_parameter, over.edge_parameter}, met, joined);
  const Interval part = rises ? Interval{joint_t, late->t} : Interval{late->t, joint_t};
  add_chart(piece, chart_beside(piece, of.strip, contact, part), of.strip.bare_face());
  const int left_to = stays_behind ? body_.behind(*late->use).face : contact.face;
  const bool forward = body_.use_in(over.use->edge, left_to).forward;
  added_[left_to].push_back(
      TopoDS::Edge(piece.Oriented(forward ? TopAbs_FORWARD : TopAbs_REVERSED)));
  // From the contact on the first side to that on the second.
  if (side == 0)
    end.path.insert(end.path.begin(), {piece, !rises});
  else
    end.path.push_back({piece, rises});
}

// A radius that changes evenly along a line and an arc changes at two rates along the way of the
// ball, and its envelope has two sections where they meet.
void BlendSheet::note_gap(int edge, double gap, double apart) {
  if (gap <= apart) return;
  is_tolerant_ = true;
  char figure[32];
  std::snprintf(figure, sizeof figure, "%.2g", gap);
  notes_.push_back("edge " + std::to_string(edge) +
                   ": its strip and the next one along the edges do not quite meet: within " +
                   figure + ", the tolerance of the edge between them");
}

// The arc in which two strips go on in one another.
void BlendSheet::join_section(const EndPlace& before, const EndPlace& after) {
  const RolledStrip &strip = strips_[before.strip].strip, &next = strips_[after.strip].strip;
  StripEnd& end = strips_[before.strip].ends[before.end];
  StripEnd& begin = strips_[after.strip].ends[after.end];
  const TopoDS_Edge arc = section(strips_[before.strip], end);
  const bool forward = strip.contacts[0].w < strip.contacts[1].w;
  end.path = {{arc, forward}};
  // Both have the same contact to the left of the way if t grows along both or neither.
  const bool alike = (before.end == 1) == (after.end == 0);
  begin.path = {{arc, alike == forward}};
  if (before.strip == after.strip) {
    // The strip lies to the left of the forward arc at one of its ends.
    const Handle(Geom2d_Curve) first = strip.section_line(strip.edge_range.from);
    const Handle(Geom2d_Curve) last = strip.section_line(strip.edge_range.to);
    const bool forward_at_start = forward == strip.outward;
    add_seam_charts(arc, forward_at_start ? first : last, forward_at_start ? last : first,
                    strip.bare_face());
    return;
  }
  add_chart(arc, strip.section_line(end.t[0]), strip.bare_face());
  const double apart = kSamePlace * std::max({tolerance_, BRep_Tool::Tolerance(end.vertices[0]),
                                              BRep_Tool::Tolerance(end.vertices[1])});
  add_chart(arc, section_chart(arc, next, begin.t[0], apart), next.bare_face());
  note_gap(strip.edge, BRep_Tool::Tolerance(arc), apart);
}

}  // namespace blossom::occt
