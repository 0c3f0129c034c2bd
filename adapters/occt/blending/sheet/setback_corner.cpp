// SPDX-License-Identifier: LGPL-2.1-or-later
// Corners of several strips that no one ball touches, or of different radii or kinds, or of
// chamfers whose borders do not cross all round: the strips end in sections before they meet,
// curves in the faces lead from the one to the next, and a fill of many sides closes the hole
// between them.
//
// Where an edge without a fillet comes to the corner, the fill ends in a point of it, and meets the
// faces beside it in creases that begin there and end where the strips do.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Precision.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <TopoDS.hxx>
#include <gp.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/hole_side.h"
#include "adapters/occt/blending/limits.h"
#include "adapters/occt/blending/sheet/blend_sheet.h"
#include "adapters/occt/blending/sheet/corner_path.h"
#include "adapters/occt/blending/sheet/fill_faces.h"
#include "adapters/occt/blending/strips/section_side.h"
#include "adapters/occt/convert/curves.h"
#include "core/blending/fills/fill.h"
#include "core/forms/evaluation.h"

namespace blossom::occt {
namespace {

// Of a strip's width: how far it stops before its contact meets what is beside it, so that the
// curves in the faces have the room to turn.
constexpr double kSetback = 0.5;
// Of the way to the middle of a strip: what a corner may take of it, so that those at both ends
// leave something.
constexpr double kShare = 0.5;
// Of a strip's width: what a setback that was asked for has to leave for the curves in the faces.
constexpr double kMinRoom = 0.05;
constexpr double kSidePart = 0.1;      // of the tolerance: of sides that are fitted
constexpr double kCreaseAngle = 1e-6;  // radians: between faces that a fill can be tangent to both
constexpr int kFollowedAcross = 32;    // points of half a section that are followed along a patch
constexpr int kFoldSamples = 6;  // in each direction of a patch, between which none turns back
constexpr int kPathSamples = 8;  // of a path, that have to lie in its face

Vec3 contact_at(const RolledStrip& strip, std::size_t side, double t) {
  return vec(strip.contacts[side].curve->Value(t).XYZ());
}

// The chart of an arc that runs along a patch's border with another parameter.
Handle(Geom2d_BSplineCurve)
    beside_border(const Handle(Geom_Curve) & arc, const Interval& range, const FillBorder& border) {
  const Handle(TColgp_HArray1OfPnt2d) points = new TColgp_HArray1OfPnt2d(1, kFollowedAcross + 1);
  const Handle(TColStd_HArray1OfReal) places = new TColStd_HArray1OfReal(1, kFollowedAcross + 1);
  for (int i = 0; i <= kFollowedAcross; ++i) {
    const double x = at(range, static_cast<double>(i) / kFollowedAcross);
    const double along = nearest_on(border.curve, {0, 1}, vec(arc->Value(x).XYZ()));
    points->SetValue(i + 1, border.chart->Value(along));
    places->SetValue(i + 1, x);
  }
  Geom2dAPI_Interpolate maker(points, places, Standard_False, gp::Resolution());
  maker.Perform();
  return maker.Curve();
}

// The last digit that std::to_string tells.
constexpr double kLastDigit = 1e-6;
// Relative: of the arithmetic that a bound comes from.
constexpr double kBoundError = 1e-12;

// Told so that what is told is not below the value: it can be given back as a bound.
std::string told_from_above(double value) {
  std::string text = std::to_string(value);
  return std::stod(text) >= value ? text : std::to_string(value + kLastDigit);
}

// Likewise not above it. What is given has to be less than that, so its own error does no harm.
std::string told_from_below(double value) {
  std::string text = std::to_string(value);
  return std::stod(text) <= value * (1 + kBoundError) ? text : std::to_string(value - kLastDigit);
}

// Whether a patch turns back on itself: normals at neighbouring samples differ by more than a right
// angle.
bool folds(const RationalBezierPatch& patch) {
  Grid<Vec3> normals(kFoldSamples + 1, kFoldSamples + 1);
  for (int i = 0; i <= kFoldSamples; ++i)
    for (int k = 0; k <= kFoldSamples; ++k) {
      const PatchJet jet = jet_at(patch, i / double{kFoldSamples}, k / double{kFoldSamples}, 1);
      normals(i, k) = cross(jet.u, jet.v);
      if (i > 0 && dot(normals(i, k), normals(i - 1, k)) < 0) return true;
      if (k > 0 && dot(normals(i, k), normals(i, k - 1)) < 0) return true;
    }
  return false;
}

}  // namespace

// Where a contact meets that of the strip beside it, or the edge.
std::optional<double> BlendSheet::stop_beside(const Ring& ring, std::size_t sector, bool on_left) {
  const std::size_t count = ring.size(), before = (sector + count - 1) % count;
  const DirectedEdge half = ring[sector].half;
  const DirectedEdge beside = ring[on_left ? (sector + 1) % count : before].half;
  const RolledStrip& strip = strip_of(half).strip;
  const std::size_t side = on_left ? left_side(half) : right_side(half);
  if (is_filleted(beside.edge)) {
    const std::size_t other = on_left ? right_side(beside) : left_side(beside);
    const auto crossing = contacts_cross(body_, strip, side, end_t(half), strip_of(beside).strip,
                                         other, end_t(beside));
    return crossing ? std::optional((*crossing)[0]) : std::nullopt;
  }
  const EdgeUseInFace& use =
      on_left ? arriving(ring, sector)
              : body_.uses(ring[before].face)[static_cast<std::size_t>(ring[before].use)];
  const auto meeting = meeting_with(body_, strip, side, use, end_t(half));
  return meeting ? std::optional(meeting->t) : std::nullopt;
}

// The section at the distance from the vertex that was asked for.
//
// stop    t at which the contacts meet what is beside them
double BlendSheet::wanted_setback_t(const DirectedEdge& half, double stop, double width) {
  const PlacedStrip& of = strip_of(half);
  const double inwards = is_low_end(half) ? 1 : -1;
  const double whole = edge_length(body_.edge(half.edge));
  const double speed = whole / length(of.strip.edge_range);
  const double t = end_t(half) + inwards * *setback_ / speed;
  const double least = inwards * (stop - end_t(half)) * speed + kMinRoom * width;
  const double room = inwards * (of.inside - end_t(half)) * speed;
  if (least >= room)
    refuse(half, FilletFault::Corner,
           "no setback fits there, the strips that meet take half of the edge: " + too_large());
  if (*setback_ < least)
    refuse(half, FilletFault::Setback,
           "the setback is too small for the strips that meet there, it has to be " +
               told_from_above(least) + " at least");
  if (*setback_ >= room)
    refuse(half, FilletFault::Setback,
           "the setback is more than half of the edge, it has to be less than " +
               told_from_below(room));
  return t;
}

// The section in which a strip ends before the corner.
double BlendSheet::setback_t(const Ring& ring, std::size_t sector) {
  const DirectedEdge half = ring[sector].half;
  const PlacedStrip& of = strip_of(half);
  const RolledStrip& strip = of.strip;
  const double inwards = is_low_end(half) ? 1 : -1;
  std::optional<double> stop;
  for (const bool on_left : {true, false})
    if (const auto met = stop_beside(ring, sector, on_left))
      if (!stop || inwards * (*met - *stop) > 0) stop = met;
  const double t = stop.value_or(end_t(half));
  if (setback_)
    return wanted_setback_t(half, t, distance(contact_at(strip, 0, t), contact_at(strip, 1, t)));
  const double room = kShare * inwards * (of.inside - t);
  if (room <= 0)
    refuse(half, FilletFault::EdgeConsumed,
           "what is beside its strip meets it beyond its middle: " + too_large());
  const double speed = strip.contacts[0].curve->DN(t, 1).Magnitude();
  const double width = distance(contact_at(strip, 0, t), contact_at(strip, 1, t));
  return t + inwards * std::min(room, kSetback * width / speed);
}

// The parameter of an edge without fillet in which the fill ends.
double BlendSheet::setback_cut(const Ring& ring, std::size_t sector) {
  const std::size_t count = ring.size(), before = (sector + count - 1) % count;
  const DirectedEdge half = ring[sector].half;
  const Vec3 vertex = point_of(body_.vertex(half));
  double reach = 0, width = 0;
  for (const bool from_left : {true, false}) {
    const std::size_t beside = from_left ? (sector + 1) % count : before;
    const DirectedEdge& other = ring[beside].half;
    if (!is_filleted(other.edge)) continue;
    const RolledStrip& strip = strip_of(other).strip;
    const std::size_t side = from_left ? right_side(other) : left_side(other);
    const double t = end_of(other).t[side];
    width = std::max(width, distance(contact_at(strip, 0, t), contact_at(strip, 1, t)));
    if (const auto met = stop_beside(ring, beside, !from_left))
      reach = std::max(reach, distance(contact_at(strip, side, *met), vertex));
  }
  if (width == 0)  // between edges without fillets
    for (const VertexSector& each : ring)
      if (is_filleted(each.half.edge)) width = std::max(width, strip_of(each.half).strip.radius);
  const BRepAdaptor_Curve curve(body_.edge(half.edge));
  const double sign = half.at_start ? 1 : -1;
  const double start = half.at_start ? curve.FirstParameter() : curve.LastParameter();
  const double whole = edge_length(body_.edge(half.edge));
  if (reach >= kShare * whole)
    refuse(half, FilletFault::EdgeConsumed,
           "the strips beside it take more of it than half: " + too_large());
  const double cut = std::min(reach + kSetback * width, kShare * (reach + whole));
  return GCPnts_AbscissaPoint(curve, sign * cut, start).Parameter();
}

// From right to left, as seen by who walks away from the vertex.
BlendSheet::SetbackSide BlendSheet::section_side_of(const DirectedEdge& half) {
  const RolledStrip& strip = strip_of(half).strip;
  const StripEnd& end = end_of(half);
  try {
    return {
        section_side(strip, end.t[0], is_low_end(half), right_side(half), kSidePart * tolerance_),
        end.vertices[right_side(half)], half};
  } catch (const LimitFailure&) {
    throw;
  } catch (const Failure& failure) {
    refuse(half, FilletFault::Corner, std::string(failure.what()) + " where its corner begins");
  }
}

// In the face of a sector, from the left of its first edge to the right of the next one.
BlendSheet::SetbackSide BlendSheet::path_side(const Ring& ring, std::size_t sector,
                                              const std::map<std::size_t, double>& cuts) {
  const std::size_t next = (sector + 1) % ring.size();
  const int face = ring[sector].face;
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(body_.face(face));
  SetbackSide made;
  made.face = face;
  made.side.continuity = is_chamfer_ ? FillContinuity::G0 : FillContinuity::G1;
  const auto end_in = [&](std::size_t at, bool on_left) {
    const DirectedEdge half = ring[at].half;
    PathEnd end;
    if (const auto cut = cuts.find(at); cut != cuts.end()) {
      const EdgeUseInFace& use = on_left ? body_.uses(face)[static_cast<std::size_t>(ring[at].use)]
                                         : arriving(ring, sector);
      const Vec2 chart = point_at(use.coedge->curve, cut->second), scale = body_.trims(face).scale;
      end.chart = {chart[0] / scale[0], chart[1] / scale[1]};
      double angle = 0;
      edge_kind(body_, half.edge, angle);
      if (angle > kCreaseAngle) made.side.continuity = FillContinuity::G0;
      return end;
    }
    const RolledStrip& strip = strip_of(half).strip;
    const std::size_t side = on_left ? left_side(half) : right_side(half);
    const double t = end_of(half).t[side], outwards = is_low_end(half) ? -1 : 1;
    if (strip.contacts[side].face != face)
      refuse(half, FilletFault::Corner,
             "its strip goes over a smooth edge before it comes to its corner: how strips meet "
             "behind one cannot be built yet");
    gp_Pnt2d place;
    gp_Vec2d rate;
    strip.contacts[side].chart->D1(t, place, rate);
    const double speed = strip.contacts[side].curve->DN(t, 1).Magnitude();
    end.chart = {place.X(), place.Y()};
    if (is_chamfer_) return end;
    end.ahead = (outwards / speed) * Vec2{rate.X(), rate.Y()};
    if (const auto met = stop_beside(ring, at, on_left); met && outwards * (*met - t) > 0)
      end.leg = distance(contact_at(strip, side, *met), contact_at(strip, side, t));
    return end;
  };
  const PathEnd from = end_in(sector, true), to = end_in(next, false);
  made.chart = corner_path(surface, from, to);
  TopoDS_Edge edge;
  const BRep_Builder builder;
  builder.MakeEdge(edge);
  builder.UpdateEdge(edge, made.chart, body_.face(face), Precision::Confusion());
  builder.Range(edge, 0, 1);
  edge.Orientation(TopAbs_REVERSED);
  // A fit has the parameter of the chart; an exact arc would have one of its own.
  made.side = fitted_hole_side({ring[sector].half.edge, edge, body_.face(face), false},
                               made.side.continuity, {.point = tolerance_, .angle = kCreaseAngle})
                  .side;
  return made;
}

// A path has to lie in its face, and meets and cuts off no border but the edges of its sector.
// Where the face turns by more than half a circle between two strips it grows over what the concave
// one fills, and the path may go over those two.
void BlendSheet::check_room(const Ring& ring, std::size_t sector, const SetbackSide& path) const {
  const DirectedEdge half = ring[sector].half, next = ring[(sector + 1) % ring.size()].half;
  const bool grows =
      is_filleted(half.edge) && is_filleted(next.edge) && !is_narrow(body_, ring[sector], next);
  const RolledContact in_face{path.face, {}, Handle(Geom2d_Curve)(path.chart), 0};
  bool has_room = !meets_border(body_, path.chart, ring[sector], next);
  for (int i = 1; i < kPathSamples && !grows; ++i)
    has_room = has_room && lies_inside(body_, in_face, static_cast<double>(i) / kPathSamples);
  if (!has_room)
    refuse(half, FilletFault::Corner,
           "face " + std::to_string(path.face) + " has no room for its corner: " + too_large());
}

// Half a strip's section as an edge of the sheet, with its charts on the strip and the fill.
PathEdge BlendSheet::section_edge(const DirectedEdge& half, const FillBorder& border) {
  const RolledStrip& strip = strip_of(half).strip;
  const double t = end_of(half).t[0];
  const Handle(Geom_Curve) arc = strip.along_u ? strip.surface->UIso(t) : strip.surface->VIso(t);
  const double start = strip.contacts[right_side(half)].w, end = strip.contacts[left_side(half)].w;
  const TopoDS_Vertex& middle = border.half == 0 ? border.to : border.from;
  const double cut =
      nearest_on(arc, {std::min(start, end), std::max(start, end)}, point_of(middle));
  const bool forward = start < end;
  const Interval way = border.half == 0 ? Interval{start, cut} : Interval{cut, end};
  const Interval range = forward ? way : Interval{way.to, way.from};
  const TopoDS_Edge edge =
      edge_on(arc, range, forward ? border.from : border.to, forward ? border.to : border.from);
  add_chart(edge, strip.section_line(t), strip.bare_face());
  add_chart(edge, beside_border(arc, range, border), border.patch);
  return {edge, forward};
}

// Half a side as an edge of the sheet, which the strip or the face beside it uses the other way.
PathEdge BlendSheet::setback_edge(const SetbackSide& side, const FillBorder& border) {
  // A strip's end is walked from left to right, the fill from right to left.
  const auto ends_strip = [&](const PathEdge& made) {
    std::vector<PathEdge>& path = end_of(*side.half).path;
    path.insert(path.begin(), {made.edge, !made.forward});
    return made;
  };
  if (side.chart.IsNull()) return ends_strip(section_edge(*side.half, border));
  const TopoDS_Edge edge = edge_on(border.curve, {0, 1}, border.along ? border.from : border.to,
                                   border.along ? border.to : border.from);
  add_chart(edge, border.chart, border.patch);
  const Handle(Geom2d_BezierCurve) chart = Handle(Geom2d_BezierCurve)::DownCast(side.chart->Copy());
  chart->Segment(0.5 * border.half, 0.5 * (border.half + 1));
  if (!border.along) chart->Reverse();
  if (side.half) {
    add_chart(edge, chart, strip_of(*side.half).strip.bare_face());
    return ends_strip({edge, border.along});
  }
  const TopoDS_Face& face = body_.face(side.face);
  add_chart(edge, chart_near_face(chart, 0.5, body_, side.face), face);
  added_[side.face].push_back(
      TopoDS::Edge(edge.Oriented(border.along ? TopAbs_REVERSED : TopAbs_FORWARD)));
  return {edge, border.along};
}

// Closes the hole between sides that follow each other, seen from outside against the clock.
void BlendSheet::fill_corner(const Ring& ring, const std::vector<SetbackSide>& sides) {
  if (sides.size() > kMaxFillSides)
    refuse(ring.front().half, FilletFault::Corner,
           "its corner has " + std::to_string(sides.size()) + " sides, and " +
               std::to_string(kMaxFillSides) + " can be filled");
  std::vector<FillSide> given;
  std::vector<TopoDS_Vertex> corners;
  for (const SetbackSide& each : sides) {
    given.push_back(each.side);
    if (is_chamfer_) given.back().continuity = FillContinuity::G0;
    corners.push_back(each.from);
  }
  const Fill made = fill(given, {.tolerances = {.point = kSamePlace * tolerance_}});
  if (made.problem != FillProblem::None)
    refuse(ring.front().half, FilletFault::Corner, "its corner cannot be filled: " + made.message);
  if (std::ranges::any_of(made.patches, folds))
    refuse(ring.front().half, FilletFault::Corner,
           "what would fill its corner turns back on itself: corners of such edges cannot be "
           "filled yet");
  const auto border = [&](const FillBorder& of) {
    return setback_edge(sides[static_cast<std::size_t>(of.side)], of);
  };
  // Where corners at both ends of a strip meet, sections of both have one middle.
  const auto middle = [&](int side, const Vec3& point) {
    return sides[static_cast<std::size_t>(side)].half ? new_vertex(point) : vertex_at(point);
  };
  for (FillFace& each : fill_faces(made, corners, middle, border))
    patches_.push_back({each.face, std::move(each.edges), 0});
  for (const VertexSector& each : ring)
    if (is_filleted(each.half.edge)) turn_path(each.half);
}

void BlendSheet::set_back(const Ring& ring) {
  const std::size_t count = ring.size();
  std::map<std::size_t, double> cuts;  // by sector
  std::map<std::size_t, TopoDS_Vertex> feet;
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_filleted(ring[i].half.edge)) continue;
    const RolledStrip& strip = strip_of(ring[i].half).strip;
    StripEnd& end = end_of(ring[i].half);
    const double t = setback_t(ring, i);
    end.t = {t, t};
    for (const std::size_t side : {0U, 1U})
      end.vertices[side] = new_vertex(contact_at(strip, side, t));
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (is_filleted(ring[i].half.edge)) continue;
    cuts[i] = setback_cut(ring, i);
    feet[i] = cut_edge(ring[i].half, cuts[i], body_.face(ring[i].face));
  }
  std::vector<SetbackSide> sides;
  for (std::size_t i = 0; i < count; ++i) {
    const DirectedEdge half = ring[i].half;
    const bool is_strip = is_filleted(half.edge);
    if (is_strip) sides.push_back(section_side_of(half));
    sides.push_back(path_side(ring, i, cuts));
    check_room(ring, i, sides.back());
    sides.back().from = is_strip ? end_of(half).vertices[left_side(half)] : feet[i];
  }
  fill_corner(ring, sides);
}

}  // namespace blossom::occt
