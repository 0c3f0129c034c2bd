// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/repair/polar_faces.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <BRepCheck_Analyzer.hxx>
#include <BRepTools.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Surface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include "adapters/occt/convert/pcurves.h"
#include "core/math/interval.h"
#include "core/math/vec.h"

namespace blossom::occt {
namespace {

/// A meridian is free when so much of the way round, as a part of it, is.
constexpr double kMinPolarGap = 1e-3;

/// Ends of the two poles that differ by no more than this part of the way round are one.
constexpr double kSameRange = 1e-6;

/// Of new edges, which lie where the surface is: model units.
constexpr double kEdgeTolerance = 1e-7;

/// An edge of a wire with its ends in the face's parameters, as the wire walks.
struct Walked {
  TopoDS_Edge edge;
  Vec2 from, to;
};

Walked walked(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  double first = 0, last = 0;
  const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
  if (curve.IsNull()) return {edge, {}, {}};
  gp_Pnt2d from = curve->Value(first), to = curve->Value(last);
  if (edge.Orientation() == TopAbs_REVERSED) std::swap(from, to);
  return {edge, {from.X(), from.Y()}, {to.X(), to.Y()}};
}

/// A face round which one parameter goes, with its outer wire from one pole to the other and back.
struct PolarFace {
  TopoDS_Face face;                      ///< forward
  int around = 0;                        ///< the parameter that goes round: 0 for u, 1 for v
  Walked start, end;                     ///< the poles
  std::vector<TopoDS_Edge> there, back;  ///< after `start`, after `end`
  std::vector<TopoDS_Wire> others;
  double meridian = 0;  ///< of `around`

  double at(const Vec2& chart) const { return chart[around]; }
  double height(const Walked& pole) const { return pole.from[1 - around]; }
};

std::vector<Walked> way_round(const TopoDS_Wire& wire, const TopoDS_Face& face) {
  std::vector<Walked> way;
  for (BRepTools_WireExplorer it(wire, face); it.More(); it.Next())
    way.push_back(walked(it.Current(), face));
  return way;
}

/// The wire that has both poles, if the face has one: with two edges without length, as wide as
/// each other and walked against each other.
std::optional<PolarFace> poles_of(const TopoDS_Face& face) {
  PolarFace polar;
  polar.face = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
  bool found = false;
  for (TopoDS_Iterator it(polar.face); it.More(); it.Next()) {
    if (it.Value().ShapeType() != TopAbs_WIRE) return std::nullopt;
    const TopoDS_Wire& wire = TopoDS::Wire(it.Value());
    std::vector<Walked> way = way_round(wire, polar.face);
    const auto is_pole = [](const Walked& each) { return BRep_Tool::Degenerated(each.edge); };
    const auto first = std::find_if(way.begin(), way.end(), is_pole);
    if (first == way.end()) {
      polar.others.push_back(wire);
      continue;
    }
    std::rotate(way.begin(), first, way.end());
    const auto second = std::find_if(way.begin() + 1, way.end(), is_pole);
    if (found || second == way.end() || std::any_of(second + 1, way.end(), is_pole))
      return std::nullopt;
    found = true;
    polar.start = way.front();
    polar.end = *second;
    for (auto each = way.begin() + 1; each != second; ++each) polar.there.push_back(each->edge);
    for (auto each = second + 1; each != way.end(); ++each) polar.back.push_back(each->edge);
  }
  if (!found) return std::nullopt;
  const Vec2 run = polar.start.to - polar.start.from;
  polar.around = std::abs(run[0]) > std::abs(run[1]) ? 0 : 1;
  const double width = std::abs(polar.at(run));
  const bool meet = std::abs(polar.at(polar.start.from - polar.end.to)) <= kSameRange * width &&
                    std::abs(polar.at(polar.start.to - polar.end.from)) <= kSameRange * width;
  return meet ? std::optional(polar) : std::nullopt;
}

bool has_seam(const PolarFace& polar) {
  return std::any_of(polar.there.begin(), polar.there.end(), [&](const TopoDS_Edge& edge) {
    return std::any_of(polar.back.begin(), polar.back.end(),
                       [&](const TopoDS_Edge& other) { return other.IsSame(edge); });
  });
}

/// Readers know whole surfaces: the seam there and back, and nothing else.
bool is_whole(const PolarFace& polar) {
  return polar.others.empty() && polar.there.size() == 1 && polar.back.size() == 1;
}

Interval extent_of(const TopoDS_Edge& edge, const PolarFace& polar) {
  double first = 0, last = 0;
  const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, polar.face, first, last);
  if (curve.IsNull()) return {-HUGE_VAL, HUGE_VAL};
  const auto box = bounds_of(curve, {first, last});
  return box[polar.around == 0 ? 0 : 1];
}

/// The middle of the widest stretch between the seam's sides that no edge covers.
std::optional<double> free_meridian(const PolarFace& polar) {
  const Interval range{std::min(polar.at(polar.start.from), polar.at(polar.start.to)),
                       std::max(polar.at(polar.start.from), polar.at(polar.start.to))};
  std::vector<Interval> covered{{range.from, range.from}, {range.to, range.to}};
  for (const auto* way : {&polar.there, &polar.back})
    for (const TopoDS_Edge& edge : *way) covered.push_back(extent_of(edge, polar));
  for (const TopoDS_Wire& wire : polar.others)
    for (TopoDS_Iterator it(wire); it.More(); it.Next())
      covered.push_back(extent_of(TopoDS::Edge(it.Value()), polar));
  std::sort(covered.begin(), covered.end(),
            [](const Interval& a, const Interval& b) { return a.from < b.from; });
  double reached = range.from, widest = kMinPolarGap * length(range);
  std::optional<double> middle;
  for (const Interval& each : covered) {
    const double gap = std::min(each.from, range.to) - reached;
    if (gap > widest) {
      widest = gap;
      middle = reached + gap / 2;
    }
    reached = std::max(reached, each.to);
  }
  return middle;
}

/// New edges on the surface of a face.
class EdgeMaker {
 public:
  explicit EdgeMaker(const PolarFace& polar) : polar_(polar) {
    surface_ = BRep_Tool::Surface(polar.face, place_);
  }

  /// A part of a pole, walked from one value of `around` to another.
  TopoDS_Edge pole(const Walked& whole, double from, double to) const {
    const TopoDS_Vertex vertex = TopExp::FirstVertex(whole.edge);
    TopoDS_Edge edge;
    builder_.MakeEdge(edge);
    builder_.Degenerated(edge, true);
    put(edge, line(polar_.height(whole), polar_.around), {std::min(from, to), std::max(from, to)},
        vertex, vertex);
    return from < to ? edge : TopoDS::Edge(edge.Reversed());
  }

  /// The meridian, in the direction of its growing parameter.
  TopoDS_Edge meridian() const {
    const double a = polar_.height(polar_.start), b = polar_.height(polar_.end);
    const TopoDS_Vertex first = TopExp::FirstVertex((a < b ? polar_.start : polar_.end).edge);
    const TopoDS_Vertex last = TopExp::FirstVertex((a < b ? polar_.end : polar_.start).edge);
    Handle(Geom_Curve) curve =
        polar_.around == 0 ? surface_->UIso(polar_.meridian) : surface_->VIso(polar_.meridian);
    TopoDS_Edge edge;
    builder_.MakeEdge(edge, curve, place_, kEdgeTolerance);
    put(edge, line(polar_.meridian, 1 - polar_.around), {std::min(a, b), std::max(a, b)}, first,
        last);
    return edge;
  }

  TopoDS_Face face(const std::vector<TopoDS_Edge>& border, double side) const {
    TopoDS_Face made;
    builder_.MakeFace(made, surface_, place_, BRep_Tool::Tolerance(polar_.face));
    TopoDS_Wire wire;
    builder_.MakeWire(wire);
    for (const TopoDS_Edge& edge : border) builder_.Add(wire, edge);
    wire.Closed(true);
    builder_.Add(made, wire);
    for (const TopoDS_Wire& other : polar_.others) {
      TopoDS_Iterator first(other);
      const Interval extent = extent_of(TopoDS::Edge(first.Value()), polar_);
      if ((extent.from > polar_.meridian) == (side > polar_.meridian)) builder_.Add(made, other);
    }
    return made;
  }

 private:
  /// The parameter of the line is that of the direction in which it runs.
  Handle(Geom2d_Curve) line(double constant, int along) const {
    return along == 0 ? new Geom2d_Line(gp_Pnt2d(0, constant), gp_Dir2d(1, 0))
                      : new Geom2d_Line(gp_Pnt2d(constant, 0), gp_Dir2d(0, 1));
  }

  void put(TopoDS_Edge& edge, const Handle(Geom2d_Curve) & chart, const Interval& range,
           const TopoDS_Vertex& first, const TopoDS_Vertex& last) const {
    builder_.UpdateEdge(edge, chart, surface_, place_, kEdgeTolerance);
    builder_.Range(edge, range.from, range.to);
    builder_.SameRange(edge, true);
    builder_.SameParameter(edge, true);
    builder_.Add(edge, first.Oriented(TopAbs_FORWARD));
    builder_.Add(edge, last.Oriented(TopAbs_REVERSED));
  }

  const PolarFace& polar_;
  Handle(Geom_Surface) surface_;
  TopLoc_Location place_;
  BRep_Builder builder_;
};

/// One half: from the meridian along the first pole to the seam, by the way to the other pole and
/// back.
TopoDS_Face half_of(const PolarFace& polar, const EdgeMaker& maker, const TopoDS_Edge& meridian,
                    bool first) {
  const Walked& pole = first ? polar.start : polar.end;
  const Walked& other = first ? polar.end : polar.start;
  std::vector<TopoDS_Edge> border{maker.pole(pole, polar.meridian, polar.at(pole.to))};
  for (const TopoDS_Edge& edge : first ? polar.there : polar.back) border.push_back(edge);
  border.push_back(maker.pole(other, polar.at(other.from), polar.meridian));
  const bool rises = polar.height(other) < polar.height(pole);
  border.push_back(TopoDS::Edge(meridian.Oriented(rises ? TopAbs_FORWARD : TopAbs_REVERSED)));
  return maker.face(border, polar.at(pole.to));
}

int count_poles(const TopoDS_Face& face) {
  int count = 0;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    count += BRep_Tool::Degenerated(TopoDS::Edge(it.Current())) ? 1 : 0;
  return count;
}

}  // namespace

std::vector<TopoDS_Face> polar_halves(const TopoDS_Face& face) {
  if (count_poles(face) != 2) return {};
  std::optional<PolarFace> polar = poles_of(face);
  if (!polar || !has_seam(*polar) || is_whole(*polar)) return {};
  const std::optional<double> meridian = free_meridian(*polar);
  if (!meridian) return {};
  polar->meridian = *meridian;
  const EdgeMaker maker(*polar);
  const TopoDS_Edge edge = maker.meridian();
  std::vector<TopoDS_Face> halves;
  for (const bool first : {true, false}) {
    const TopoDS_Face half = half_of(*polar, maker, edge, first);
    if (!BRepCheck_Analyzer(half).IsValid()) return {};
    halves.push_back(TopoDS::Face(half.Oriented(face.Orientation())));
  }
  return halves;
}

std::map<int, std::vector<TopoDS_Face>> polar_faces(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  std::map<int, std::vector<TopoDS_Face>> found;
  for (int i = 1; i <= faces.Extent(); ++i)
    if (auto halves = polar_halves(TopoDS::Face(faces(i))); !halves.empty())
      found.emplace(i, std::move(halves));
  return found;
}

}  // namespace blossom::occt
