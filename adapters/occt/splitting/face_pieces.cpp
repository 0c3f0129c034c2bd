// SPDX-License-Identifier: LGPL-2.1-or-later
// The last step of FaceSplitter: the arrangement, and its pieces as faces.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/convert/edge_charts.h"
#include "adapters/occt/convert/pcurves.h"
#include "adapters/occt/splitting/face_splitter.h"
#include "core/base/sampled_margin.h"

namespace blossom::occt {
namespace {

// Chart areas of pieces add up to rounding if the arrangement is right. Relative.
constexpr double kAreaError = 1e-6;
constexpr int kDeviationSamples = 33;

// The largest sampled distance between the curve and the image of its chart curve.
double deviation(const FaceCut& cut, const Handle(Geom_Surface) & surface, const Interval& range) {
  double largest = 0;
  for (int i = 0; i < kDeviationSamples; ++i) {
    const double s = at(range, static_cast<double>(i) / (kDeviationSamples - 1));
    const Vec2 uv = point_at(cut.chart, s);
    largest = std::max(largest, pnt(space_point(cut, s)).Distance(surface->Value(uv[0], uv[1])));
  }
  return largest;
}

bool lies_near(const PlanarPath& path, const Vec2& point, double tolerance) {
  return std::any_of(path.begin(), path.end(), [&](const PlanarBezier& curve) {
    return nearest({{{curve, {0, 1}, ParameterLaw::Linear}}}, point).distance <= tolerance;
  });
}

TopoDS_Face without_wires(const TopoDS_Face& face) {
  TopoDS_Face empty = TopoDS::Face(face.EmptyCopied());
  empty.Orientation(TopAbs_FORWARD);
  return empty;
}

void cover(const TopoDS_Vertex& vertex, const gp_Pnt& point, double edge_tolerance) {
  const double gap = BRep_Tool::Pnt(vertex).Distance(point);
  BRep_Builder().UpdateVertex(
      vertex, std::max({Precision::Confusion(), kSampledMargin * gap, edge_tolerance}));
}

}  // namespace

Handle(Geom_Curve) space_curve(const FaceCut& cut) {
  if (cut.conic) return to_occt(*cut.conic);
  return to_occt(cut.curve);
}

Vec3 space_point(const FaceCut& cut, double t) {
  return cut.conic ? point_at(*cut.conic, t) : point_at(cut.curve, t);
}

const TopoDS_Vertex& FaceSplitter::shape_of(int vertex, const LiftedCut& lifted_cut,
                                            double parameter) {
  Vertex& of = vertices_[static_cast<std::size_t>(vertex)];
  if (!of.shape.IsNull()) return of.shape;
  if (of.split >= 0)
    of.shape = splits_.vertex(edge_of(coedge(of.loop, of.coedge)), of.split);
  else
    BRep_Builder().MakeVertex(
        of.shape, pnt(space_point(cuts_[static_cast<std::size_t>(lifted_cut.cut)], parameter)),
        Precision::Confusion());
  // Cuts that cross beside their vertex would be wires that intersect each other.
  if (of.touch > 0) BRep_Builder().UpdateVertex(of.shape, of.touch);
  return of.shape;
}

// The curve of an edge that has none in the parameters yet: on a plane that of its conic, if it is
// one, which is of the same kind; else what was found with the cut.
Handle(Geom2d_Curve) FaceSplitter::chart_of(const TopoDS_Edge& edge,
                                            const LiftedCut& lifted_cut) const {
  const FaceCut& cut = cuts_[static_cast<std::size_t>(lifted_cut.cut)];
  if (cut.conic)
    if (Handle(Geom2d_Curve) flat = plane_curve_of(edge, face_); !flat.IsNull()) return flat;
  Spline2 chart = cut.chart;
  const Vec2 shift{lifted_cut.shift[0] / trims_.scale[0], lifted_cut.shift[1] / trims_.scale[1]};
  for (Vec2& point : chart.points) point += shift;
  return simplest_to_occt(chart, trims_.scale);
}

// In a plane a conic is itself, in fewer spans than its spline.
PlanarCurve FaceSplitter::chart_of(const FaceCut& cut) const {
  if (cut.conic)
    if (const auto flat = plane_curve_of(to_occt(*cut.conic), face_); !flat.IsNull())
      return transformed(planar_curve(flat, cut.chart.domain()), trims_.scale, {});
  return chart_curve(trims_, cut.chart);
}

// One edge for both neighbours. Its curves are the whole cut's; only its range is its own.
TopoDS_Edge FaceSplitter::cut_edge(const LiftedCut& lifted_cut, const Interval& range, int from,
                                   int to) {
  const FaceCut& cut = cuts_[static_cast<std::size_t>(lifted_cut.cut)];
  TopLoc_Location location;
  const Handle(Geom_Surface) raw = BRep_Tool::Surface(face_, location);
  const double tolerance =
      std::max({Precision::Confusion(), cut.tolerance,
                kSampledMargin * deviation(cut, BRep_Tool::Surface(face_), range)});
  const BRep_Builder builder;
  TopoDS_Edge edge;
  builder.MakeEdge(edge, space_curve(cut), tolerance);
  builder.UpdateEdge(edge, chart_of(edge, lifted_cut), raw, location, tolerance);
  builder.Range(edge, range.from, range.to);
  const TopoDS_Vertex first = shape_of(from, lifted_cut, range.from);
  const TopoDS_Vertex last = shape_of(to, lifted_cut, range.to);
  cover(first, pnt(space_point(cut, range.from)), tolerance);
  cover(last, pnt(space_point(cut, range.to)), tolerance);
  builder.Add(edge, first.Oriented(TopAbs_FORWARD));
  builder.Add(edge, last.Oriented(TopAbs_REVERSED));
  return edge;
}

// The uses of cuts that run along a piece of an edge, walked as the wire walks it. A run along
// one side of a seam is one along the other side too.
std::vector<CutUse> FaceSplitter::runs_along(int loop, int index, const EdgePiece& piece) const {
  std::vector<CutUse> uses;
  const Coedge& of = coedge(loop, index);
  for (const LiftedCut& lifted_cut : lifted_cuts_)
    for (const TrimRun& run : lifted_cut.runs) {
      const double low = std::min(run.edge_parameters.from, run.edge_parameters.to);
      const double high = std::max(run.edge_parameters.from, run.edge_parameters.to);
      const double middle = at(piece.range, 0.5);
      const Coedge& beside = coedge(run.loop, run.coedge);
      if (beside.edge != of.edge || middle < low || middle > high) continue;
      const auto parameter = [&](double t) {
        return nearest(lifted_cut.curve, point_at(beside.curve, at(piece.range, t))).parameter;
      };
      Interval along{parameter(0.25), parameter(0.75)};
      if (of.reversed) std::swap(along.from, along.to);
      uses.push_back({lifted_cut.cut, along, {}, true});
    }
  return uses;
}

void FaceSplitter::add_border_arc(int loop, int index, const EdgePiece& piece) {
  const Coedge& of = coedge(loop, index);
  Interval range = piece.range;
  int from = vertex_at_split(loop, index, piece.from);
  int to = vertex_at_split(loop, index, piece.to);
  if (of.reversed) {
    std::swap(range.from, range.to);
    std::swap(from, to);
  }
  PlanarPath path = bezier_pieces(of.curve, range);
  if (path.empty()) return;
  arcs_.push_back({from, to, std::move(path), true});
  const TopoDS_Edge edge =
      TopoDS::Edge(piece.edge.Oriented(of.reversed ? TopAbs_REVERSED : TopAbs_FORWARD));
  origins_.push_back({edge, runs_along(loop, index, piece), -1, loop});
}

void FaceSplitter::add_border_arcs() {
  for (std::size_t loop = 0; loop < trims_.loops.size(); ++loop)
    for (std::size_t i = 0; i < trims_.loops[loop].size(); ++i) {
      std::vector<EdgePiece> along = splits_.pieces(edge_of(trims_.loops[loop][i]));
      if (trims_.loops[loop][i].reversed) std::reverse(along.begin(), along.end());
      for (const EdgePiece& piece : along)
        add_border_arc(static_cast<int>(loop), static_cast<int>(i), piece);
    }
}

// The border or the cut between the same vertices that a piece of a cut keeps to; -1 for none.
int FaceSplitter::arc_beside(const LiftedCut& lifted_cut, const std::pair<double, int>& from,
                             const std::pair<double, int>& to, bool border) const {
  const Interval range{from.first, to.first};
  const auto is_beside = [&](const ChartArc& arc) {
    if (arc.border != border || !((arc.from == from.second && arc.to == to.second) ||
                                  (arc.from == to.second && arc.to == from.second)))
      return false;
    return std::ranges::all_of(std::array{0.5, 0.25, 0.75}, [&](double part) {
      return lies_near(arc.path, point_at(lifted_cut.curve, at(range, part)),
                       4 * reach(lifted_cut));
    });
  };
  const auto found = std::ranges::find_if(arcs_, is_beside);
  return found == arcs_.end() ? -1 : static_cast<int>(found - arcs_.begin());
}

// False if the piece lies outside or along a wire. What keeps to an edge from outside runs along
// it, though by a curve without errors it would stay inside: a contact of high order.
bool FaceSplitter::add_cut_arc(const LiftedCut& lifted_cut, const std::pair<double, int>& from,
                               const std::pair<double, int>& to) {
  const Interval range{from.first, to.first};
  const double middle = at(range, 0.5);
  const bool along =
      std::any_of(lifted_cut.runs.begin(), lifted_cut.runs.end(),
                  [&](const TrimRun& run) { return run.at.from <= middle && middle <= run.at.to; });
  if (along) return false;
  const bool outside = !is_inside(trims_, point_at(lifted_cut.curve, middle));
  const int beside = arc_beside(lifted_cut, from, to, outside);
  if (outside) {
    if (beside >= 0) add_repeat(beside, lifted_cut, from, to);
    return false;
  }
  PlanarPath path = bezier_pieces(lifted_cut.curve, range);
  if (path.empty()) return false;
  if (beside >= 0) {
    if (!cuts_[static_cast<std::size_t>(lifted_cut.cut)].may_repeat)
      note(lifted_cut.cut, "repeats another cut");
    add_repeat(beside, lifted_cut, from, to);
    return true;
  }
  arcs_.push_back({from.second, to.second, std::move(path), false});
  origins_.push_back({{},
                      {{lifted_cut.cut, range, {}, false}},
                      static_cast<int>(&lifted_cut - lifted_cuts_.data()),
                      -1});
  return true;
}

// Where the two come round to where they began, which way they go is not told by their ends.
void FaceSplitter::add_repeat(int arc, const LiftedCut& lifted_cut,
                              const std::pair<double, int>& from,
                              const std::pair<double, int>& to) {
  Origin& origin = origins_[static_cast<std::size_t>(arc)];
  const bool border = arcs_[static_cast<std::size_t>(arc)].border;
  const bool has_edge = border || origin.lifted_cut >= 0 || !origin.piece.IsNull();
  if (!has_edge || from.second == to.second) return;
  const Interval range{from.first, to.first};
  Interval along{at(range, 0.25), at(range, 0.75)};
  if (arcs_[static_cast<std::size_t>(arc)].from != from.second) std::swap(along.from, along.to);
  (border ? origin.uses : origin.repeats).push_back({lifted_cut.cut, along, {}, true});
}

bool FaceSplitter::add_cut_arcs() {
  bool any = false;
  std::vector<bool> useful(cuts_.size(), false);
  for (const LiftedCut& lifted_cut : lifted_cuts_) {
    bool used = false;
    for (std::size_t i = 0; i + 1 < lifted_cut.stops.size(); ++i)
      used = add_cut_arc(lifted_cut, lifted_cut.stops[i], lifted_cut.stops[i + 1]) || used;
    if (!used && !lifted_cut.runs.empty() &&
        !cuts_[static_cast<std::size_t>(lifted_cut.cut)].may_repeat)
      note(lifted_cut.cut, "runs along an edge");
    if (used || !lifted_cut.runs.empty()) useful[static_cast<std::size_t>(lifted_cut.cut)] = true;
    any = any || used;
  }
  for (std::size_t i = 0; i < useful.size(); ++i)
    if (!useful[i] && !cuts_[i].may_repeat) note(static_cast<int>(i), "lies outside of the trims");
  return any;
}

void FaceSplitter::add_wire(const Cycle& cycle, FacePiece& piece) const {
  const BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for (const HalfEdge& half : cycle) {
    const Origin& origin = origins_[static_cast<std::size_t>(half.arc)];
    const TopoDS_Edge edge =
        TopoDS::Edge(half.reversed ? origin.edge.Reversed() : TopoDS_Shape(origin.edge));
    builder.Add(wire, edge);
    for (const CutUse& use : origin.uses)
      piece.cuts.push_back(
          {use.cut, half.reversed ? Interval{use.at.to, use.at.from} : use.at, edge, use.along});
  }
  wire.Closed(Standard_True);
  builder.Add(piece.face, wire);
}

bool FaceSplitter::adds_up(const ChartPieces& found) const {
  double whole = 0, sum = 0;
  for (const ChartPiece& piece : found.pieces) {
    sum += signed_area(arcs_, piece.outer);
    for (const Cycle& hole : piece.holes) sum += signed_area(arcs_, hole);
  }
  for (const ChartArc& arc : arcs_) {
    if (!arc.border) continue;
    const Vec2 from = vertices_[static_cast<std::size_t>(arc.from)].point;
    const Vec2 to = vertices_[static_cast<std::size_t>(arc.to)].point;
    const Vec2 origin = trims_.box.low;
    const Vec2 start = start_of(arc.path), end = end_of(arc.path);
    whole += area_along(arc.path, origin) + 0.5 * cross(from - origin, start - origin) +
             0.5 * cross(end - origin, to - origin);
  }
  return found.consistent && std::abs(sum - whole) <= kAreaError * std::abs(whole);
}

void FaceSplitter::make_edge(int arc) {
  const auto index = static_cast<std::size_t>(arc);
  Origin& origin = origins_[index];
  const LiftedCut& lifted_cut = lifted_cuts_[static_cast<std::size_t>(origin.lifted_cut)];
  origin.edge = cut_edge(lifted_cut, origin.uses.front().at, arcs_[index].from, arcs_[index].to);
}

// Internal edges, those that hang together in one wire.
void FaceSplitter::imprint(std::vector<int> arcs, FacePiece& piece) {
  const BRep_Builder builder;
  while (!arcs.empty()) {
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    std::vector<int> reached;  // vertices
    const auto touches = [&](int arc) {
      const ChartArc& of = arcs_[static_cast<std::size_t>(arc)];
      return std::any_of(reached.begin(), reached.end(),
                         [&](int vertex) { return vertex == of.from || vertex == of.to; });
    };
    for (auto next = arcs.begin(); next != arcs.end();
         next = std::find_if(arcs.begin(), arcs.end(), touches)) {
      const auto index = static_cast<std::size_t>(*next);
      if (origins_[index].lifted_cut >= 0) make_edge(*next);
      piece.imprints.push_back(TopoDS::Edge(origins_[index].edge.Oriented(TopAbs_INTERNAL)));
      builder.Add(wire, piece.imprints.back());
      reached.insert(reached.end(), {arcs_[index].from, arcs_[index].to});
      arcs.erase(next);
    }
    builder.Add(piece.face, wire);
  }
}

// Of arcs that cuts repeat, those that bound nothing are what both lie along all the same.
void FaceSplitter::add_repeats(const std::vector<int>& dangling, FaceSplit& result) {
  for (std::size_t i = 0; i < origins_.size(); ++i) {
    Origin& origin = origins_[i];
    if (origin.repeats.empty()) continue;
    const int arc = static_cast<int>(i);
    const bool dangles = std::find(dangling.begin(), dangling.end(), arc) != dangling.end();
    if (dangles && !origin.piece.IsNull())
      result.coincident.push_back({origin.piece, origin.edge});
    else if (dangles) {
      if (origin.edge.IsNull()) make_edge(arc);  // it may be imprinted
      result.repeats.push_back(origin.uses.front());
      result.repeats.back().edge = origin.edge;
    }
    for (CutUse use : origin.repeats) {
      use.edge = origin.edge;
      result.repeats.push_back(use);
    }
  }
}

FaceSplit FaceSplitter::divided(const ChartPieces& found, OpenCuts open) {
  for (std::size_t i = 0; i < arcs_.size(); ++i) {
    const int arc = static_cast<int>(i);
    if (origins_[i].lifted_cut >= 0 &&
        std::find(found.dangling.begin(), found.dangling.end(), arc) == found.dangling.end())
      make_edge(arc);
  }
  FaceSplit result;
  for (const ChartPiece& piece : found.pieces) {
    FacePiece made{without_wires(given_), {}, {}};
    add_wire(piece.outer, made);
    for (const Cycle& hole : piece.holes) add_wire(hole, made);
    imprint(imprints_among(piece.inner, open), made);
    made.face.Orientation(given_.Orientation());
    result.pieces.push_back(std::move(made));
  }
  for (std::size_t i = 0; i < arcs_.size(); ++i)
    if (!origins_[i].piece.IsNull() && std::find(found.dangling.begin(), found.dangling.end(),
                                                 static_cast<int>(i)) == found.dangling.end())
      result.coincident.push_back({origins_[i].piece, origins_[i].edge});
  result.notes = notes_;
  return result;
}

// The wires as they were, with split edges in pieces.
FaceSplit FaceSplitter::undivided(const std::vector<int>& imprinted) {
  const auto any_split = [&](const std::vector<Coedge>& loop) {
    return std::any_of(loop.begin(), loop.end(),
                       [&](const Coedge& of) { return splits_.is_split(edge_of(of)); });
  };
  const bool only_own = std::all_of(imprinted.begin(), imprinted.end(), [&](int arc) {
    return origins_[static_cast<std::size_t>(arc)].lifted_cut < 0;
  });
  const bool same = only_own && !any_split(trims_.inner) &&
                    std::none_of(trims_.loops.begin(), trims_.loops.end(), any_split);
  FacePiece piece{without_wires(given_), {}, {}};
  std::vector<Cycle> wires(trims_.loops.size());
  for (std::size_t i = 0; i < arcs_.size(); ++i)
    if (arcs_[i].border)
      wires[static_cast<std::size_t>(origins_[i].loop)].push_back({static_cast<int>(i), false});
  for (const Cycle& wire : wires) add_wire(wire, piece);
  imprint(imprinted, piece);
  piece.face.Orientation(given_.Orientation());
  if (same) piece.face = given_;
  return {{std::move(piece)}, notes_};
}

FaceSplit FaceSplitter::split(OpenCuts open) {
  add_border_arcs();
  const bool any_inner = add_inner_arcs(), any_coincident = add_coincident_arcs();
  if (!add_cut_arcs() && !any_inner && !any_coincident) return undivided();
  const ChartPieces found = pieces(arcs_, tolerance_);
  for (const int arc : found.dangling)
    if (origins_[static_cast<std::size_t>(arc)].lifted_cut >= 0)
      note(origins_[static_cast<std::size_t>(arc)].uses.front().cut,
           open == OpenCuts::Imprint
               ? "ends inside of the face, a part of it divides nothing and is imprinted"
               : "ends inside of the face, a part of it divides nothing and is left out");
  const auto cuts =
      std::count_if(arcs_.begin(), arcs_.end(), [](const ChartArc& arc) { return !arc.border; });
  const bool whole = cuts == static_cast<std::ptrdiff_t>(found.dangling.size());
  if (whole || adds_up(found)) {
    FaceSplit result =
        whole ? undivided(imprints_among(found.dangling, open)) : divided(found, open);
    add_repeats(found.dangling, result);
    return result;
  }
  notes_.push_back("cuts and wires do not fit together, the face stays whole");
  std::vector<int> all(arcs_.size());
  std::iota(all.begin(), all.end(), 0);
  return undivided(imprints_among(all, OpenCuts::LeaveOut));
}

FaceSplit split_face(const TopoDS_Face& face, const std::vector<FaceCut>& cuts, double tolerance,
                     OpenCuts open) {
  EdgeSplits splits(tolerance);
  FaceSplitter splitter(face, cuts, splits, tolerance);
  splitter.settle();
  return splitter.split(open);
}

}  // namespace blossom::occt
