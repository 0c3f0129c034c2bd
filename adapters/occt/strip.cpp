// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/strip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/blending/edge_borders.h"
#include "adapters/occt/blending/strip_border.h"
#include "adapters/occt/convert/edge_charts.h"
#include "adapters/occt/convert/surfaces.h"
#include "core/base/tolerances.h"

namespace blossom::occt {
namespace {

constexpr std::array kSides{SurfaceSide::UMin, SurfaceSide::UMax, SurfaceSide::VMin,
                            SurfaceSide::VMax};

/// Points of a pcurve looked at to see whether it runs along a border.
constexpr int kSamples = 9;

/// How far a pcurve may leave a border, as a part of the face's range of parameters.
constexpr double kOnBorder = 1e-6;

bool runs_along_v(SurfaceSide side) {
  return side == SurfaceSide::UMin || side == SurfaceSide::UMax;
}

double constant_of(const ParameterBox& box, SurfaceSide side) {
  switch (side) {
    case SurfaceSide::UMin: return box.u.from;
    case SurfaceSide::UMax: return box.u.to;
    case SurfaceSide::VMin: return box.v.from;
    case SurfaceSide::VMax: break;
  }
  return box.v.to;
}

/// The part of a border, as a fraction of its length, that an edge covers; 0 when it leaves it.
double covered(const TopoDS_Edge& edge, const TopoDS_Face& face, const ParameterBox& box,
               SurfaceSide side) {
  double first = 0, last = 0;
  const Handle(Geom2d_Curve) pcurve = BRep_Tool::CurveOnSurface(edge, face, first, last);
  if (pcurve.IsNull()) return 0;
  const bool along_v = runs_along_v(side);
  const Interval& along = along_v ? box.v : box.u;
  const Interval& inwards = along_v ? box.u : box.v;
  double low = 0, high = 0;
  for (int i = 0; i < kSamples; ++i) {
    const gp_Pnt2d uv = pcurve->Value(at({first, last}, i / (kSamples - 1.0)));
    const double off = (along_v ? uv.X() : uv.Y()) - constant_of(box, side);
    if (std::abs(off) > kOnBorder * length(inwards)) return 0;
    const double place = along_v ? uv.Y() : uv.X();
    low = i == 0 ? place : std::min(low, place);
    high = i == 0 ? place : std::max(high, place);
  }
  return (high - low) / length(along);
}

bool is_open(const TopoDS_Face& face, const ParameterBox& box, SurfaceSide side) {
  double sum = 0;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    if (BRep_Tool::Degenerated(edge) || BRep_Tool::IsClosed(edge, face)) continue;
    sum += covered(edge, face, box, side);
  }
  return sum > 1 - kOnBorder;
}

TopoDS_Face forward(const TopoDS_Face& face) { return TopoDS::Face(face.Oriented(TopAbs_FORWARD)); }

/// A border that a strip may start from.
struct Candidate {
  FaceStripEnd end;
  Border rows;
};

Candidate side_candidate(const BezierSurface& surface, SurfaceSide side) {
  return {{.start = {.side = side}}, border_of(surface, side, kMaxStripOrder)};
}

Candidate edge_candidate(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  StripBorder border = strip_border(edge, face);
  return {{.start = {.edge = edge}, .exact = border.exact, .fit_error = border.error},
          std::move(border.rows)};
}

/// Edges as the face has them, but for seams and edges without length.
std::vector<TopoDS_Edge> usable_edges(const TopoDS_Face& face) {
  std::vector<TopoDS_Edge> edges;
  for (TopExp_Explorer it(forward(face), TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    if (!BRep_Tool::Degenerated(edge) && !is_seam(edge, face)) edges.push_back(edge);
  }
  return edges;
}

Candidate named_side(const TopoDS_Face& face, const BezierSurface& surface, SurfaceSide side,
                     const std::string& name) {
  const std::vector<SurfaceSide> open = open_sides(face);
  if (std::find(open.begin(), open.end(), side) != open.end()) return side_candidate(surface, side);
  std::string known;
  for (const SurfaceSide other : open)
    known += std::string(known.empty() ? "" : ", ") + to_string(other);
  throw BadModel(
      "face " + name + " has no edge along " + to_string(side) +
      (known.empty() ? ", nor along another border of its parameters" : ", it has " + known));
}

Candidate named_edge(const TopoDS_Face& face, const TopoDS_Edge& edge, const std::string& name) {
  for (const TopoDS_Edge& own : usable_edges(face))
    if (own.IsSame(edge)) return edge_candidate(own, forward(face));
  if (BRep_Tool::Degenerated(edge))
    throw BadModel("the edge has no length: a strip on face " + name +
                   " cannot start from a point");
  if (is_seam(edge, face))
    throw BadModel("the edge is the seam of face " + name +
                   ", where its surface closes on itself: a strip starts from an edge with nothing "
                   "of the face beyond it");
  throw BadModel("the edge does not bound face " + name +
                 ": a strip starts from one of the edges of its face");
}

/// Edges along a side that can be taken whole.
bool lies_along(const TopoDS_Edge& edge, const TopoDS_Face& face, const ParameterBox& box,
                const std::vector<SurfaceSide>& sides) {
  return std::any_of(sides.begin(), sides.end(),
                     [&](SurfaceSide side) { return covered(edge, face, box, side) > 0; });
}

/// Whole sides, and edges that are no part of one. Edges that cannot be followed are passed over.
std::vector<Candidate> all_candidates(const TopoDS_Face& face, const BezierSurface& surface,
                                      const std::string& name) {
  const std::vector<SurfaceSide> sides = open_sides(face);
  const ParameterBox box = parameter_box(face);
  std::vector<Candidate> candidates;
  for (const SurfaceSide side : sides) candidates.push_back(side_candidate(surface, side));
  std::string reason = "it has none";
  for (const TopoDS_Edge& edge : usable_edges(face)) try {
      if (!lies_along(edge, face, box, sides))
        candidates.push_back(edge_candidate(edge, forward(face)));
    } catch (const BadModel& error) {
      reason = error.what();
    }
  if (candidates.empty())
    throw BadModel("face " + name + " has no edge that a strip can start from: " + reason);
  return candidates;
}

std::vector<Candidate> candidates(const TopoDS_Face& face, const BezierSurface& surface,
                                  const StripStart& start, const std::string& name) {
  if (start.side) return {named_side(face, surface, *start.side, name)};
  if (!start.edge.IsNull()) return {named_edge(face, start.edge, name)};
  return all_candidates(face, surface, name);
}

std::pair<Candidate, Candidate> nearest(const std::vector<Candidate>& of_a,
                                        const std::vector<Candidate>& of_b) {
  std::pair<std::size_t, std::size_t> best{0, 0};
  double least = border_distance(of_a[0].rows, of_b[0].rows);
  for (std::size_t i = 0; i < of_a.size(); ++i)
    for (std::size_t j = 0; j < of_b.size(); ++j) {
      const double apart = border_distance(of_a[i].rows, of_b[j].rows);
      if (!(apart < least)) continue;
      least = apart;
      best = {i, j};
    }
  return {of_a[best.first], of_b[best.second]};
}

/// Lowers multiplicities as far as the surface stays where it is within `tolerance`; every knot
/// stays, so that spans are still those of the strip.
void smooth_knots(Geom_BSplineSurface& surface, double tolerance) {
  for (int knot = surface.NbUKnots() - 1; knot > 1; --knot)
    for (int left = surface.UMultiplicity(knot) - 1; left >= 1; --left)
      if (!surface.RemoveUKnot(knot, left, tolerance)) break;
}

/// Figures of the surface that is written, beside the borders that it was made from.
void measure_again(FaceStrip& made, const Border& a, const Border& b) {
  Strip& strip = made.strip;
  const double error = strip.surface.error;
  strip.surface = bezier_surface(Handle(Geom_Surface)(made.surface), {{0, 1}, {0, 1}});
  strip.surface.error = error;
  const auto contacts = strip_contacts(strip.surface, a, b, strip.backward, strip.start_b);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const double scale = strip.contacts[i].scale;
    strip.contacts[i] = contacts[i];
    strip.contacts[i].scale = scale;
  }
}

/// The face beside an edge by the u of the strip that starts on it, or ends.
EdgeBorder along_strip(EdgeBorder border, bool backward, double start) {
  const auto to_edge = [=](double u) {
    const double x = start + (backward ? 1 - u : u);
    return x > 1 ? x - 1 : x;
  };
  EdgeBorder result;
  result.sides = [=, sides = border.sides](double u) {
    EdgeSide side = sides(to_edge(u));
    if (!backward) return side;
    side.along = side.along * -1.0;
    side.left = !side.left;
    return side;
  };
  for (const double x : border.breaks) {
    const double u = backward ? start - x : x - start;
    result.breaks.push_back(u < 0 ? u + 1 : u);
  }
  return result;
}

/// Figures beside the face itself, where rows were fitted.
void measure_beside_face(FaceStrip& made, std::size_t end, const TopoDS_Face& face) {
  if (made.ends[end].exact) return;
  const bool first = end == 0;
  const EdgeBorder border =
      along_strip(edge_border(made.ends[end].start.edge, face), !first && made.strip.backward,
                  first ? 0 : made.strip.start_b);
  std::vector<double> breaks = border.breaks;
  breaks.insert(breaks.end(), made.strip.surface.u_knots.begin(), made.strip.surface.u_knots.end());
  std::sort(breaks.begin(), breaks.end());
  std::vector<double> apart{0};
  for (const double x : breaks)
    if (x - apart.back() > kSliver) apart.push_back(x);
  const SurfaceSide side = first ? SurfaceSide::VMin : SurfaceSide::VMax;
  StripContact& contact = made.strip.contacts[end];
  const double scale = contact.scale;
  contact = strip_contact(made.strip.surface, side, border.sides, apart);
  contact.scale = scale;
}

TopoDS_Face face_on(const Handle(Geom_BSplineSurface) & surface) {
  BRepBuilderAPI_MakeFace maker(surface, Tolerances{}.point);
  if (!maker.IsDone()) throw Failure("the strip gives no face");
  if (!BRepCheck_Analyzer(maker.Face()).IsValid())
    throw Failure("the strip gives an invalid face: does it cross itself?");
  return maker.Face();
}

}  // namespace

std::vector<SurfaceSide> open_sides(const TopoDS_Face& face) {
  return guarded("looking at the edges of a face", [&] {
    const ParameterBox box = parameter_box(face);
    std::vector<SurfaceSide> open;
    for (const SurfaceSide side : kSides)
      if (is_open(face, box, side)) open.push_back(side);
    return open;
  });
}

FaceStrip strip_between(const TopoDS_Face& a, const TopoDS_Face& b,
                        const FaceStripOptions& options) {
  const BezierSurface surface_a = bezier_surface(a), surface_b = bezier_surface(b);
  const auto [from, to] = nearest(candidates(a, surface_a, options.start_a, "a"),
                                  candidates(b, surface_b, options.start_b, "b"));
  FaceStrip result{.strip = blossom::strip_between(from.rows, to.rows, options.strip),
                   .ends = {from.end, to.end},
                   .surface = {},
                   .face = {}};
  guarded("making the strip's face", [&] {
    result.surface = to_occt(result.strip.surface);
    smooth_knots(*result.surface, strip_gap_bound(result.strip.surface));
    result.face = face_on(result.surface);
  });
  measure_again(result, from.rows, to.rows);
  measure_beside_face(result, 0, forward(a));
  measure_beside_face(result, 1, forward(b));
  return result;
}

}  // namespace blossom::occt
