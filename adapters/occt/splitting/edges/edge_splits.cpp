// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/splitting/edges/edge_splits.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Builder.hxx>
#include <BRep_CurveRepresentation.hxx>
#include <BRep_ListIteratorOfListOfCurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/curves.h"
#include "core/base/sampled_margin.h"
#include "core/base/unbounded.h"

namespace blossom::occt {
namespace {

// Two splits of a degenerated edge are told apart by parameter alone. Relative to its range.
constexpr double kSameOnPole = 1e-9;

// Two faces that meet in an edge may be apart by twice its tolerance, and a cut that runs through
// both meets the edge at an angle: so many tolerances apart are its two ends still one split.
constexpr double kFaceDisagreement = 4;
// Some eight for each of the 23 that BRepCheck takes, which see other places.
constexpr int kEdgeDeviationSamples = 187;

// The triangulation of the whole edge is none of its pieces.
void drop_polygons(const TopoDS_Edge& edge) {
  const auto data = Handle(BRep_TEdge)::DownCast(edge.TShape());
  for (BRep_ListIteratorOfListOfCurveRepresentation it(data->ChangeCurves()); it.More();) {
    const Handle(BRep_CurveRepresentation)& curve = it.Value();
    if (curve->IsPolygon3D() || curve->IsPolygonOnTriangulation())
      data->ChangeCurves().Remove(it);
    else
      it.Next();
  }
}

// An edge's stated tolerance may rest on few samples of the whole; a piece is sampled anew, and
// gets a wider one where what lies between these samples may need it.
void widen(const TopoDS_Edge& piece) {
  const double found = image_deviation(piece, kEdgeDeviationSamples);
  if (kSampledMargin * found > BRep_Tool::Tolerance(piece)) {
    const BRep_Builder builder;
    builder.UpdateEdge(piece, kSampledMargin * found);
    builder.UpdateVertex(TopExp::FirstVertex(piece), kSampledMargin * found);
    builder.UpdateVertex(TopExp::LastVertex(piece), kSampledMargin * found);
  }
}

}  // namespace

TopoDS_Edge piece_of(const TopoDS_Edge& edge, const Interval& range, const TopoDS_Vertex& from,
                     const TopoDS_Vertex& to) {
  const BRep_Builder builder;
  TopoDS_Edge piece = TopoDS::Edge(edge.EmptyCopied());
  piece.Orientation(TopAbs_FORWARD);
  drop_polygons(piece);
  builder.Range(piece, range.from, range.to);
  leave_periods(piece);
  builder.Add(piece, from.Oriented(TopAbs_FORWARD));
  builder.Add(piece, to.Oriented(TopAbs_REVERSED));
  widen(piece);
  return piece;
}

double image_deviation(const TopoDS_Edge& edge, int samples) {
  Interval range;
  TopLoc_Location location;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, location, range.from, range.to);
  if (curve.IsNull()) return 0;
  double largest = 0;
  const auto add = [&](const Handle(Geom_Surface) & surface, const TopLoc_Location& place,
                       const Handle(Geom2d_Curve) & pcurve) {
    const gp_Trsf move = (edge.Location() * place).Transformation();
    for (int i = 0; i < samples; ++i) {
      const double t = at(range, static_cast<double>(i) / (samples - 1));
      const gp_Pnt2d uv = pcurve->Value(t);
      const gp_Pnt image = surface->Value(uv.X(), uv.Y()).Transformed(move);
      const gp_Pnt point = curve->Value(t).Transformed(location.Transformation());
      largest = std::max(largest, point.Distance(image));
    }
  };
  const auto data = Handle(BRep_TEdge)::DownCast(edge.TShape());
  for (const Handle(BRep_CurveRepresentation) & on : data->Curves()) {
    if (!on->IsCurveOnSurface()) continue;
    add(on->Surface(), on->Location(), on->PCurve());
    if (on->IsCurveOnClosedSurface()) add(on->Surface(), on->Location(), on->PCurve2());
  }
  return largest;
}

EdgeSplits::Record& EdgeSplits::record(const TopoDS_Edge& edge) {
  const int known = index_.FindIndex(edge);
  if (known > 0) return records_[static_cast<std::size_t>(known) - 1];
  const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
  double first = 0, last = 0;
  BRep_Tool::Range(forward, first, last);
  const TopoDS_Vertex from = TopExp::FirstVertex(forward), to = TopExp::LastVertex(forward);
  if (from.IsNull() || to.IsNull()) throw BadModel("an edge has no vertices");
  index_.Add(edge);
  records_.push_back({forward, {{first, from, {}}, {last, to, {}}}, {}});
  return records_.back();
}

const EdgeSplits::Record* EdgeSplits::find(const TopoDS_Edge& edge) const {
  const int known = index_.FindIndex(edge);
  return known > 0 ? &records_[static_cast<std::size_t>(known) - 1] : nullptr;
}

// How near to an older split or vertex a new one has to be to become the same.
double EdgeSplits::reach(const Record& of, const Split& split, const TopoDS_Face& face,
                         double inverse_sine) const {
  const double own = std::max(tolerance_, BRep_Tool::Tolerance(of.edge));
  if (split.face.IsNull()) return std::max(own, BRep_Tool::Tolerance(split.vertex));
  return split.face.IsSame(face) ? own : kFaceDisagreement * inverse_sine * own;
}

void EdgeSplits::add_uncertain(const TopoDS_Edge& edge, const Interval& at) {
  record(edge).uncertain.push_back(at);
}

// The split that a parameter in a uncertain interval stands for; -1 if there is none.
int EdgeSplits::split_in_uncertain(const Record& of, double parameter) const {
  int best = -1;
  const auto is_better = [&](const Split& split) {
    if (best < 0) return true;
    const Split& other = of.splits[static_cast<std::size_t>(best)];
    if (split.face.IsNull() != other.face.IsNull()) return split.face.IsNull() == Standard_True;
    return std::abs(split.parameter - parameter) < std::abs(other.parameter - parameter);
  };
  for (const Interval& interval : of.uncertain) {
    if (parameter < interval.from || parameter > interval.to) continue;
    for (std::size_t i = 0; i < of.splits.size(); ++i) {
      const Split& split = of.splits[i];
      if (interval.from <= split.parameter && split.parameter <= interval.to && is_better(split))
        best = static_cast<int>(i);
    }
  }
  return best;
}

int EdgeSplits::add(const TopoDS_Edge& edge, double parameter, const TopoDS_Face& face,
                    double uncertainty, double inverse_sine) {
  Record& of = record(edge);
  assert(of.pieces.empty());
  const bool pole = BRep_Tool::Degenerated(of.edge);
  const double range = of.splits[kLast].parameter - of.splits[kFirst].parameter;
  const gp_Pnt point =
      pole ? BRep_Tool::Pnt(of.splits[kFirst].vertex) : BRepAdaptor_Curve(of.edge).Value(parameter);
  if (const int known = split_in_uncertain(of, parameter); known >= 0) {
    const TopoDS_Vertex& vertex = of.splits[static_cast<std::size_t>(known)].vertex;
    widened_.emplace_back(vertex, kSampledMargin * point.Distance(BRep_Tool::Pnt(vertex)));
    return known;
  }
  int nearest = -1;
  double least = kInfinity;
  for (std::size_t i = 0; i < of.splits.size(); ++i) {
    const Split& split = of.splits[i];
    const double along = std::abs(split.parameter - parameter);
    const bool same = pole ? along <= kSameOnPole * range
                           : point.Distance(BRep_Tool::Pnt(split.vertex)) <=
                                 std::max(reach(of, split, face, inverse_sine), uncertainty);
    if (same && along < least) {  // a closed edge has its vertex at both ends
      least = along;
      nearest = static_cast<int>(i);
    }
  }
  if (nearest >= 0) return nearest;
  TopoDS_Vertex vertex = of.splits[kFirst].vertex;
  if (!pole)
    BRep_Builder().MakeVertex(vertex = TopoDS_Vertex(), point, BRep_Tool::Tolerance(of.edge));
  of.splits.push_back({parameter, vertex, face});
  return static_cast<int>(of.splits.size()) - 1;
}

void EdgeSplits::widen(const TopoDS_Edge& edge, int split, double tolerance) {
  widened_.emplace_back(vertex(edge, split), tolerance);
}

double EdgeSplits::covered(const TopoDS_Edge& edge, int split) const {
  const TopoDS_Vertex of = vertex(edge, split);
  double most = BRep_Tool::Tolerance(of);
  for (const auto& [widened, tolerance] : widened_)
    if (widened.IsSame(of)) most = std::max(most, tolerance);
  return most;
}

bool EdgeSplits::is_split(const TopoDS_Edge& edge) const {
  const Record* of = find(edge);
  return of != nullptr && of->splits.size() > 2;
}

TopoDS_Vertex EdgeSplits::vertex(const TopoDS_Edge& edge, int split) const {
  if (const Record* of = find(edge)) return of->splits[static_cast<std::size_t>(split)].vertex;
  assert(split == kFirst || split == kLast);
  const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
  return split == kFirst ? TopExp::FirstVertex(forward) : TopExp::LastVertex(forward);
}

double EdgeSplits::parameter(const TopoDS_Edge& edge, int split) const {
  if (const Record* of = find(edge)) return of->splits[static_cast<std::size_t>(split)].parameter;
  assert(split == kFirst || split == kLast);
  double first = 0, last = 0;
  BRep_Tool::Range(edge, first, last);
  return split == kFirst ? first : last;
}

bool EdgeSplits::is_known(const TopoDS_Edge& edge, int split) const {
  const Record* of = find(edge);
  return of == nullptr || of->splits[static_cast<std::size_t>(split)].face.IsNull();
}

int EdgeSplits::count(const TopoDS_Edge& edge) const {
  const Record* of = find(edge);
  return of != nullptr ? static_cast<int>(of->splits.size()) : 2;
}

void EdgeSplits::unite(const TopoDS_Vertex& a, const TopoDS_Vertex& b) {
  if (are_one(a, b)) return;
  united_.emplace_back(a, b);
  const auto class_of = [&](const TopoDS_Vertex& vertex) {
    const auto place = static_cast<std::size_t>(vertices_.Add(vertex)) - 1;
    if (place == classes_.size()) classes_.push_back(place);
    return classes_[place];
  };
  const std::size_t kept = class_of(a), left = class_of(b);
  std::replace(classes_.begin(), classes_.end(), left, kept);
}

bool EdgeSplits::are_one(const TopoDS_Vertex& a, const TopoDS_Vertex& b) const {
  if (a.IsSame(b)) return true;
  const int x = vertices_.FindIndex(a), y = vertices_.FindIndex(b);
  return x > 0 && y > 0 &&
         classes_[static_cast<std::size_t>(x) - 1] == classes_[static_cast<std::size_t>(y) - 1];
}

const std::vector<EdgePiece>& EdgeSplits::pieces(const TopoDS_Edge& edge) {
  for (const auto& [vertex, tolerance] : widened_) BRep_Builder().UpdateVertex(vertex, tolerance);
  widened_.clear();
  Record& of = record(edge);
  if (!of.pieces.empty()) return of.pieces;
  std::vector<int> order(of.splits.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  const auto split = [&](int i) -> const Split& { return of.splits[static_cast<std::size_t>(i)]; };
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return split(a).parameter < split(b).parameter; });
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    const Split &from = split(order[i]), &to = split(order[i + 1]);
    const Interval range{from.parameter, to.parameter};
    const TopoDS_Edge piece =
        order.size() == 2 ? of.edge : piece_of(of.edge, range, from.vertex, to.vertex);
    of.pieces.push_back({piece, range, order[i], order[i + 1]});
  }
  return of.pieces;
}

}  // namespace blossom::occt
