// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves in which strips meet faces, as edges; faces that grow over the lines of their seams there.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/blending/blend_edges.h"
#include "adapters/occt/blending/limits.h"
#include "adapters/occt/blending/sheet/blend_sheet.h"
#include "adapters/occt/blending/strips/ball_walker.h"
#include "adapters/occt/convert/edge_charts.h"
#include "adapters/occt/faces/surface_projector.h"
#include "core/math/functions/sign_change.h"

namespace blossom::occt {
namespace {

constexpr double kSeamAt = 1e-14;  // of a curve: where it goes over a seam, to rounding

double in(const gp_Pnt2d& point, int d) { return point.Coord(d + 1); }

// The line of a face's seam in its chart.
struct SeamLine {
  int edge = 0;
  int across = 0;   // 0: it has one u, 1: one v
  double turn = 0;  // of that parameter
  double place = 0;
  double low = 0, high = 0;  // the other parameter at the seam's start and end

  // In turns, by which a point is beside it.
  double off(const gp_Pnt2d& point) const { return (in(point, across) - place) / turn; }
  bool is_beyond(double height) const { return (height - low) * (height - high) > 0; }
  bool starts_near(double height) const { return std::abs(height - low) < std::abs(height - high); }
  gp_Pnt2d at(double turns, double height) const {
    const double there = place + turns * turn;
    return across == 0 ? gp_Pnt2d(there, height) : gp_Pnt2d(height, there);
  }
};

std::vector<SeamLine> seam_lines(const BodyEdges& body, int face) {
  const std::array<double, 2> turns = turns_of(BRep_Tool::Surface(body.face(face)));
  std::vector<SeamLine> lines;
  for (const EdgeUseInFace& use : body.uses(face)) {
    if (use.coedge->degenerated || !use.forward || body.behind(use).face != face) continue;
    Interval range;
    const Handle(Geom2d_Curve) line = chart_curve_of(body.edge(use.edge), body.face(face), range);
    const gp_Pnt2d first = line->Value(range.from), last = line->Value(range.to);
    SeamLine made{use.edge};
    made.across =
        std::abs(in(first, 0) - in(last, 0)) < std::abs(in(first, 1) - in(last, 1)) ? 0 : 1;
    made.turn = turns[static_cast<std::size_t>(made.across)];
    made.place = in(first, made.across);
    made.low = in(first, 1 - made.across);
    made.high = in(last, 1 - made.across);
    if (made.turn != 0) lines.push_back(made);
  }
  return lines;
}

// Whether a point of a curve lies on such a line, whole turns off.
bool lies_on(const Handle(Geom_Surface) & surface, const SeamLine& line, const EndCurve& curve,
             double t, double turns, double reach) {
  const gp_Pnt2d beside = line.at(turns, in(curve.on_face->Value(t), 1 - line.across));
  return surface->Value(beside.X(), beside.Y()).Distance(curve.curve->Value(t)) <= reach;
}

// Whether a curve that begins on a border of a face lies outside of it: the face grows beyond that
// border.
//
// beside   a point of the border
// way      of the curve
bool grows_over(const BodyEdges& body, int face, const Vec3& beside, const Vec3& way,
                double reach) {
  return std::ranges::any_of(body.uses(face), [&](const EdgeUseInFace& use) {
    if (use.coedge->degenerated || body.behind(use).face == face) return false;
    const double x = nearest_on_edge(body, use.edge, beside);
    const BodyEdges::Corner corner = body.corner(use, x);
    return distance(corner.point, beside) <= reach && dot(corner.inwards, way) < 0;
  });
}

}  // namespace

// Where a curve in a face goes over the line of the face's seam, beyond the end of the seam and has
// neither end on it.
std::optional<BlendSheet::SeamMeeting> BlendSheet::seam_meeting(const EndCurve& curve, int face,
                                                                double reach) {
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(body_.face(face));
  for (const SeamLine& line : seam_lines(body_, face)) {
    const auto off = [&](double t) { return line.off(curve.on_face->Value(t)); };
    const double a = off(curve.range.from), b = off(curve.range.to);
    const double whole = std::ceil(std::min(a, b));
    if (whole <= std::min(a, b) || whole >= std::max(a, b)) continue;
    SignChange change{curve.range.from, curve.range.to};
    if (a > b) std::swap(change.below, change.above);
    const double t =
        narrowed([&](double x) { return off(x) - whole; }, change, std::min(a, b) - whole,
                 std::max(a, b) - whole, kSeamAt * length(curve.range))
            .below;
    if (lies_on(surface, line, curve, curve.range.from, whole, reach) ||
        lies_on(surface, line, curve, curve.range.to, whole, reach))
      continue;
    const double height = in(curve.on_face->Value(t), 1 - line.across);
    if (!line.is_beyond(height)) continue;  // it goes over the seam itself
    return SeamMeeting{line.edge, line.across, t, line.starts_near(height)};
  }
  return std::nullopt;
}

// The same where a curve begins or ends on that line, and the border of the face that runs along it
// from there to the seam gets the face on both of its sides.
std::optional<BlendSheet::SeamMeeting> BlendSheet::seam_at_end(const EndCurve& curve, bool at_start,
                                                               int face, double reach) {
  const double t = at_start ? curve.range.from : curve.range.to;
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(body_.face(face));
  const gp_Pnt2d uv = curve.on_face->Value(t);
  for (const SeamLine& line : seam_lines(body_, face)) {
    const double turns = std::round(line.off(uv)), height = in(uv, 1 - line.across);
    const auto point = [&](double at_height) {
      const gp_Pnt2d place = line.at(turns, at_height);
      return vec(surface->Value(place.X(), place.Y()));
    };
    const double end = line.starts_near(height) ? line.low : line.high;
    if (!lies_on(surface, line, curve, t, turns, reach)) continue;
    if (!line.is_beyond(height) || distance(point(height), point(end)) <= reach) continue;
    // Its middle, as it may begin along the border.
    const Vec3 way = vec(curve.curve->Value(at(curve.range, 0.5))) - point(height);
    if (grows_over(body_, face, point(0.5 * (height + end)), way, reach))
      return SeamMeeting{line.edge, line.across, t, line.starts_near(height)};
  }
  return std::nullopt;
}

// A face that grows beyond the end of its seam has a longer one: from there to the face's border.
void BlendSheet::grow_seam(const SeamMeeting& seam, const TopoDS_Vertex& met, int face) {
  const TopoDS_Edge edge = body_.edge(seam.edge);
  const TopoDS_Vertex end = body_.vertex({seam.edge, seam.at_start});
  const TopoDS_Face of = TopoDS::Face(body_.face(face).Oriented(TopAbs_FORWARD));
  Interval range;
  const Handle(Geom2d_Curve) there = chart_curve_of(edge, of, range);
  const Handle(Geom2d_Curve) back = chart_curve_of(TopoDS::Edge(edge.Reversed()), of, range);
  const int along = 1 - seam.across;
  const auto constant = [&](const Handle(Geom2d_Curve) & chart) {
    return chart->Value(range.from).Coord(seam.across + 1);
  };
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(of);
  const Handle(Geom_Curve) curve =
      seam.across == 0 ? surface->UIso(constant(there)) : surface->VIso(constant(there));
  const auto height = [&](const TopoDS_Vertex& vertex, double near) {
    return nearest_on(curve, {near - length(range), near + length(range)}, point_of(vertex));
  };
  const double from = there->Value(range.from).Coord(along + 1),
               to = there->Value(range.to).Coord(along + 1);
  const double old_end = seam.at_start ? from : to;
  const double new_end = height(met, old_end);
  const bool up = new_end > old_end;
  const TopoDS_Edge grown = edge_on(curve, {std::min(old_end, new_end), std::max(old_end, new_end)},
                                    up ? end : met, up ? met : end);
  const auto line = [&](const Handle(Geom2d_Curve) & chart) {
    const double at = constant(chart);
    return seam.across == 0 ? new Geom2d_Line(gp_Pnt2d(at, 0), gp_Dir2d(0, 1))
                            : new Geom2d_Line(gp_Pnt2d(0, at), gp_Dir2d(1, 0));
  };
  const bool alike = to > from;  // it runs as the seam does
  add_seam_charts(grown, line(alike ? there : back), line(alike ? back : there), of);
  for (const TopAbs_Orientation each : {TopAbs_FORWARD, TopAbs_REVERSED})
    added_[face].push_back(TopoDS::Edge(grown.Oriented(each)));
  border_.vertices.push_back(end);
}

// A curve in which a strip and a face meet, from one vertex to the other, as an edge; two where the
// face grows over the line of its seam.
std::vector<PathEdge> BlendSheet::edges_along(const RolledStrip& strip, const EndCurve& curve,
                                              int face, const TopoDS_Vertex& from,
                                              const TopoDS_Vertex& to) {
  const TopoDS_Vertex &start = curve.forward ? from : to, &end = curve.forward ? to : from;
  std::vector<std::pair<Interval, std::array<TopoDS_Vertex, 2>>> pieces{
      {curve.range, {start, end}}};
  const double reach =
      kSamePlace * std::max({tolerance_, BRep_Tool::Tolerance(from), BRep_Tool::Tolerance(to)});
  for (const bool at_start : {true, false})
    if (const auto seam = seam_at_end(curve, at_start, face, reach))
      grow_seam(*seam, at_start ? start : end, face);
  if (const auto seam = seam_meeting(curve, face, reach)) {
    const TopoDS_Vertex met = new_vertex(vec(curve.curve->Value(seam->t).XYZ()));
    grow_seam(*seam, met, face);
    pieces = {{{curve.range.from, seam->t}, {start, met}}, {{seam->t, curve.range.to}, {met, end}}};
  }
  if (!curve.forward) std::ranges::reverse(pieces);
  std::vector<PathEdge> made;
  for (const auto& [range, ends] : pieces) {
    const TopoDS_Edge edge = edge_on(curve.curve, range, ends[0], ends[1]);
    add_chart(edge, curve.on_strip, strip.bare_face());
    add_chart(edge, chart_near_face(curve.on_face, at(range, 0.5), body_, face), body_.face(face));
    made.push_back({edge, curve.forward});
  }
  return made;
}

}  // namespace blossom::occt
