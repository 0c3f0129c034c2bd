// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/repair/rest_of_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include "adapters/occt/convert/surfaces.h"
#include "adapters/occt/faces/area.h"
#include "core/math/interval.h"
#include "core/math/vec.h"

namespace blossom::occt {
namespace {

/// Borders keep off a seam by so much of the way round, and close to within it.
constexpr double kSeamGap = 1e-6;

/// A side of the surface no longer than this is a pole; model units.
constexpr double kPoleSize = 1e-6;

/// So many points are compared to see whether a side is a pole, or two sides are one.
constexpr int kSideSamples = 8;

/// Of the whole surface, that the face and the pieces must make up together.
constexpr double kAreaTolerance = 1e-4;

/// An edge as the border of a piece runs along it, with its curve in the parameters.
struct BorderEdge {
  TopoDS_Edge edge;
  Handle(Geom2d_Curve) curve;
  double first = 0, last = 0;
};

using Border = std::vector<BorderEdge>;

/// Without poles; null curves and seams have no place in it.
std::optional<Border> border_of(const TopoDS_Wire& wire, const TopoDS_Face& face) {
  Border border;
  for (TopoDS_Iterator it(wire); it.More(); it.Next()) {
    BorderEdge each{TopoDS::Edge(it.Value()), {}, 0, 0};
    if (BRep_Tool::Degenerated(each.edge)) continue;
    each.curve = BRep_Tool::CurveOnSurface(each.edge, face, each.first, each.last);
    if (each.curve.IsNull() || BRep_Tool::IsClosed(each.edge, face)) return std::nullopt;
    border.push_back(std::move(each));
  }
  return border;
}

/// How far a border gets in the parameters: nothing, unless it goes round the surface.
Vec2 way_along(const Border& border) {
  Vec2 way{};
  for (const BorderEdge& each : border) {
    const gp_Pnt2d from = each.curve->Value(each.first), to = each.curve->Value(each.last);
    const double sign = each.edge.Orientation() == TopAbs_REVERSED ? -1 : 1;
    way = way + Vec2{to.X() - from.X(), to.Y() - from.Y()} * sign;
  }
  return way;
}

/// The box of a border in the parameters.
std::array<Interval, 2> extents_of(const Border& border) {
  constexpr Interval kNothing{HUGE_VAL, -HUGE_VAL};
  std::array all{kNothing, kNothing};
  for (const BorderEdge& each : border) {
    const auto of_edge = bounds_of(each.curve, {each.first, each.last});
    for (const std::size_t k : {0, 1})
      all[k] = {std::min(all[k].from, of_edge[k].from), std::max(all[k].to, of_edge[k].to)};
  }
  return all;
}

/// One parameter of the surface.
struct Direction {
  Interval range;
  bool periodic = false;
  bool closed = false;  ///< the surface meets itself at the ends

  static Interval moved(const Interval& extent, double by) {
    return {extent.from + by, extent.to + by};
  }

  /// So far from 0 on, less than a period.
  double wrapped(double value) const {
    const double period = length(range);
    return value - period * std::floor(value / period);
  }

  /// Where the range is to begin such that no extent has its ends in it: where it does if that is
  /// possible, else in the middle of the widest gap.
  std::optional<double> begin(std::vector<Interval> extents) const {
    const double least = kSeamGap * length(range);
    for (Interval& each : extents) each = moved(each, shift(each, range.from));
    if (std::all_of(extents.begin(), extents.end(), [&](const Interval& each) {
          return each.from > range.from + least && each.to < range.to - least;
        }))
      return range.from;
    if (!periodic) return std::nullopt;
    std::sort(extents.begin(), extents.end(),
              [](const Interval& a, const Interval& b) { return a.from < b.from; });
    double reached = -HUGE_VAL, widest = least;
    for (const Interval& each : extents) reached = std::max(reached, each.to - length(range));
    std::optional<double> found;
    for (const Interval& each : extents) {
      if (each.from - reached > widest) {
        widest = each.from - reached;
        found = (each.from + reached) / 2;
      }
      reached = std::max(reached, each.to);
    }
    return found;
  }

  /// What takes an extent into the range that begins there.
  double shift(const Interval& extent, double begins) const {
    return periodic ? begins + wrapped(extent.from - begins) - extent.from : 0;
  }
};

/// A closed surface with the place of its seams.
class ClosedSurface {
 public:
  explicit ClosedSurface(const TopoDS_Face& face) {
    TopLoc_Location place;
    surface_ = BRep_Tool::Surface(face, place);
    surface_->Bounds(directions_[0].range.from, directions_[0].range.to, directions_[1].range.from,
                     directions_[1].range.to);
    surface_ =
        Handle(Geom_Surface)::DownCast(basis_of(surface_)->Transformed(place.Transformation()));
    for (int k = 0; k < 2; ++k) find_closing(k);
  }

  const std::array<Direction, 2>& directions() const { return directions_; }

  /// Spline surfaces are to begin at a knot, else their areas are integrated badly by others.
  void begin_at(const Vec2& begin) {
    const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface_);
    if (spline.IsNull()) return;
    if (directions_[0].periodic && begin[0] != directions_[0].range.from) {
      spline->InsertUKnot(begin[0], 1, Precision::PConfusion(), false);
      spline->SetUOrigin(nearest_knot(*spline, 0, begin[0]));
    }
    if (directions_[1].periodic && begin[1] != directions_[1].range.from) {
      spline->InsertVKnot(begin[1], 1, Precision::PConfusion(), false);
      spline->SetVOrigin(nearest_knot(*spline, 1, begin[1]));
    }
  }

  /// Whether nothing of it has an end: it is closed in each direction, or has a pole at both ends.
  bool is_closed() const {
    if (!directions_[0].closed && !directions_[1].closed) return false;
    return is_closed_along(0) && is_closed_along(1);
  }

  /// The face with the surface's seams and poles alone.
  TopoDS_Face whole(const Vec2& begin) const {
    const BRep_Builder builder;
    TopoDS_Face face;
    builder.MakeFace(face, surface_, TopLoc_Location(), Precision::Confusion());
    std::array<TopoDS_Vertex, 2> corners;  // at the begin, and at the other pole if there are poles
    const Vec2 end = begin + Vec2{length(directions_[0].range), length(directions_[1].range)};
    const bool poles = !directions_[0].closed || !directions_[1].closed;
    builder.MakeVertex(corners[0], point(begin), Precision::Confusion());
    corners[1] = corners[0];
    if (poles) builder.MakeVertex(corners[1], point(end), Precision::Confusion());
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    for (int along = 0; along < 2; ++along) {
      const bool pole = !directions_[1 - along].closed, seam_ends = !directions_[along].closed;
      // Counterclockwise: along u on the lower side, along v on the upper.
      const double near = begin[1 - along], far = end[1 - along];
      const Interval range{begin[along], end[along]};
      const TopAbs_Orientation first = along == 0 ? TopAbs_FORWARD : TopAbs_REVERSED;
      if (pole) {
        builder.Add(wire, pole_edge(along, near, range, corners[0]).Oriented(first));
        builder.Add(wire, pole_edge(along, far, range, corners[1]).Oriented(reversed(first)));
        continue;
      }
      const TopoDS_Edge edge =
          seam(along, near, far, range, corners[0], corners[seam_ends ? 1 : 0]);
      builder.Add(wire, edge.Oriented(first));
      builder.Add(wire, edge.Oriented(reversed(first)));
    }
    wire.Closed(true);
    builder.Add(face, wire);
    return face;
  }

 private:
  static TopAbs_Orientation reversed(TopAbs_Orientation orientation) {
    return orientation == TopAbs_FORWARD ? TopAbs_REVERSED : TopAbs_FORWARD;
  }

  gp_Pnt point(const Vec2& at) const { return surface_->Value(at[0], at[1]); }

  /// A point on a line of the parameters: `constant` is that of the other one.
  gp_Pnt point(int along, double value, double constant) const {
    return along == 0 ? point({value, constant}) : point({constant, value});
  }

  static int nearest_knot(const Geom_BSplineSurface& spline, int k, double value) {
    int low = 0, high = 0;
    if (k == 0)
      spline.LocateU(value, Precision::PConfusion(), low, high);
    else
      spline.LocateV(value, Precision::PConfusion(), low, high);
    return low;
  }

  void find_closing(int k) {
    Direction& direction = directions_[k];
    if (Precision::IsInfinite(direction.range.from) || Precision::IsInfinite(direction.range.to))
      return;
    const bool periodic = k == 0 ? surface_->IsUPeriodic() : surface_->IsVPeriodic();
    const double period = !periodic ? 0 : k == 0 ? surface_->UPeriod() : surface_->VPeriod();
    const double size = length(direction.range);
    direction.periodic = periodic && std::abs(period - size) <= kSeamGap * size;
    direction.closed = direction.periodic || same_points(k, direction.range);
  }

  /// Whether the lines across the ends of a direction are one.
  bool same_points(int k, const Interval& range) const {
    const Interval across = directions_[1 - k].range;
    if (Precision::IsInfinite(across.from) || Precision::IsInfinite(across.to)) return false;
    for (int i = 0; i <= kSideSamples; ++i) {
      const double c = at(across, double(i) / kSideSamples);
      if (point(k, range.from, c).Distance(point(k, range.to, c)) > kPoleSize) return false;
    }
    return true;
  }

  bool is_pole(int along, double constant) const {
    const Interval& range = directions_[along].range;
    const gp_Pnt first = point(along, range.from, constant);
    for (int i = 1; i <= kSideSamples; ++i)
      if (point(along, at(range, double(i) / kSideSamples), constant).Distance(first) > kPoleSize)
        return false;
    return true;
  }

  bool is_closed_along(int k) const {
    const Interval& range = directions_[k].range;
    return directions_[k].closed || (is_pole(1 - k, range.from) && is_pole(1 - k, range.to));
  }

  static Handle(Geom2d_Curve) line(int along, double constant) {
    return along == 0 ? new Geom2d_Line(gp_Pnt2d(0, constant), gp_Dir2d(1, 0))
                      : new Geom2d_Line(gp_Pnt2d(constant, 0), gp_Dir2d(0, 1));
  }

  static void finish(TopoDS_Edge& edge, const Interval& range, const TopoDS_Vertex& from,
                     const TopoDS_Vertex& to) {
    const BRep_Builder builder;
    builder.Range(edge, range.from, range.to);
    builder.SameRange(edge, true);
    builder.SameParameter(edge, true);
    builder.Add(edge, from.Oriented(TopAbs_FORWARD));
    builder.Add(edge, to.Oriented(TopAbs_REVERSED));
  }

  TopoDS_Edge pole_edge(int along, double constant, const Interval& range,
                        const TopoDS_Vertex& pole) const {
    const BRep_Builder builder;
    TopoDS_Edge edge;
    builder.MakeEdge(edge);
    builder.UpdateEdge(edge, line(along, constant), surface_, TopLoc_Location(),
                       Precision::Confusion());
    builder.Degenerated(edge, true);
    finish(edge, range, pole, pole);
    return edge;
  }

  /// Used first, it lies on the near side when it runs along u, and on the far side along v.
  TopoDS_Edge seam(int along, double near, double far, const Interval& range,
                   const TopoDS_Vertex& from, const TopoDS_Vertex& to) const {
    const BRep_Builder builder;
    TopoDS_Edge edge;
    builder.MakeEdge(edge, along == 0 ? surface_->VIso(near) : surface_->UIso(near),
                     Precision::Confusion());
    builder.UpdateEdge(edge, line(along, along == 0 ? near : far),
                       line(along, along == 0 ? far : near), surface_, TopLoc_Location(),
                       Precision::Confusion());
    finish(edge, range, from, to);
    return edge;
  }

  Handle(Geom_Surface) surface_;
  std::array<Direction, 2> directions_;
};

/// The borders of all pieces; nothing if one is no hole's.
std::optional<std::vector<Border>> holes_of(const std::vector<TopoDS_Face>& pieces,
                                            const std::array<Direction, 2>& directions) {
  std::vector<Border> holes;
  for (const TopoDS_Face& piece : pieces) {
    const TopoDS_Face face = TopoDS::Face(piece.Oriented(TopAbs_FORWARD));
    for (TopoDS_Iterator it(face); it.More(); it.Next()) {
      if (it.Value().ShapeType() != TopAbs_WIRE) return std::nullopt;
      const std::optional<Border> border = border_of(TopoDS::Wire(it.Value()), face);
      if (!border) return std::nullopt;
      if (border->empty()) continue;
      const Vec2 way = way_along(*border);
      for (int k = 0; k < 2; ++k)
        if (std::abs(way[k]) > kSeamGap * length(directions[k].range)) return std::nullopt;
      holes.push_back(*border);
    }
  }
  return holes;
}

/// Adds a hole whose curves are moved by so much in the parameters.
void add_hole(TopoDS_Face& face, const Border& hole, const gp_Vec2d& move) {
  const BRep_Builder builder;
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for (const BorderEdge& each : hole) {
    const Handle(Geom2d_Curve) curve = Handle(Geom2d_Curve)::DownCast(each.curve->Translated(move));
    builder.UpdateEdge(each.edge, curve, surface, TopLoc_Location(),
                       BRep_Tool::Tolerance(each.edge));
    builder.Add(wire, each.edge.Reversed());
  }
  wire.Closed(true);
  builder.Add(face, wire);
}

bool make_up(const TopoDS_Face& face, const std::vector<TopoDS_Face>& pieces, double whole) {
  double sum = area(face);
  for (const TopoDS_Face& piece : pieces) sum += area(piece);
  return std::abs(sum - whole) <= kAreaTolerance * whole;
}

}  // namespace

TopoDS_Face rest_of_surface(const std::vector<TopoDS_Face>& pieces) {
  TopLoc_Location place, other;
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(pieces.front(), place);
  for (const TopoDS_Face& piece : pieces)
    if (BRep_Tool::Surface(piece, other) != surface || !other.IsEqual(place)) return {};
  ClosedSurface closed(pieces.front());
  if (!closed.is_closed()) return {};
  const auto& directions = closed.directions();
  const auto holes = holes_of(pieces, directions);
  if (!holes || holes->empty()) return {};
  std::array<std::vector<Interval>, 2> extents;
  for (const Border& hole : *holes)
    for (int k = 0; k < 2; ++k) extents[k].push_back(extents_of(hole)[k]);
  const auto u = directions[0].begin(extents[0]), v = directions[1].begin(extents[1]);
  if (!u || !v) return {};
  closed.begin_at({*u, *v});
  TopoDS_Face face = closed.whole({*u, *v});
  const double whole = area(face);
  for (std::size_t i = 0; i < holes->size(); ++i)
    add_hole(
        face, (*holes)[i],
        gp_Vec2d(directions[0].shift(extents[0][i], *u), directions[1].shift(extents[1][i], *v)));
  return BRepCheck_Analyzer(face).IsValid() && make_up(face, pieces, whole) ? face : TopoDS_Face();
}

}  // namespace blossom::occt
