// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solids/validity/polygon_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <BRep_CurveRepresentation.hxx>
#include <BRep_GCurve.hxx>
#include <BRep_ListIteratorOfListOfCurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_TVertex.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Trsf.hxx>

#include "core/math/vec.h"

namespace blossom::occt {
namespace {

constexpr std::size_t kMaxEdges = 100;
// Of the angle between edges that leave a vertex to the same side.
constexpr double kMinSine = 1e-2;

Vec2 in_plane(const Vec3& p) { return {p[0], p[1]}; }

double across(const Vec2& a, const Vec2& b) { return a[0] * b[1] - a[1] * b[0]; }

// Coordinates in a plane, with the height above it as the third one.
class PlaneFrame {
 public:
  explicit PlaneFrame(const gp_Ax3& axes) : axes_(axes) {}

  Vec3 at(const gp_Pnt& point) const {
    const gp_Vec off(axes_.Location(), point);
    return {off.Dot(axes_.XDirection()), off.Dot(axes_.YDirection()), off.Dot(axes_.Direction())};
  }

 private:
  gp_Ax3 axes_;
};

struct VertexPlace {
  TopoDS_Vertex vertex;
  Vec3 place;  // of the vertex, in the frame
  double tolerance = 0;
};

// An edge as it runs in its wire.
struct RingSide {
  VertexPlace first, last;
  Vec2 from, to;  // by the curve in the plane's parameters
  double tolerance = 0;
};

using Ring = std::vector<RingSide>;

bool is_rigid(const TopLoc_Location& place) {
  return place.IsIdentity() || place.Transformation().ScaleFactor() == 1;
}

std::optional<VertexPlace> corner_of(const TopoDS_Shape& shape, const PlaneFrame& frame) {
  const TopoDS_Vertex& vertex = TopoDS::Vertex(shape);
  const auto* record = static_cast<const BRep_TVertex*>(vertex.TShape().get());
  if (!record->Points().IsEmpty() || !is_rigid(vertex.Location())) return std::nullopt;
  return VertexPlace{vertex, frame.at(BRep_Tool::Pnt(vertex)), record->Tolerance()};
}

// Whether a corner holds an end of an edge, in space and by the curve in the plane.
bool holds(const VertexPlace& corner, const Vec3& end, const Vec2& chart_end) {
  const Vec3 off = corner.place - Vec3{chart_end[0], chart_end[1], 0};
  return norm(corner.place - end) <= corner.tolerance && norm(off) <= corner.tolerance;
}

class PolygonReader {
 public:
  PolygonReader(const Handle(Geom_Surface) & surface, const TopLoc_Location& place,
                const PlaneFrame& frame)
      : surface_(surface), place_(place), frame_(frame) {}

  std::optional<Ring> ring_of(const TopoDS_Shape& wire) const {
    Ring ring;
    for (TopoDS_Iterator it(wire); it.More(); it.Next()) {
      const auto side = side_of(TopoDS::Edge(it.Value()));
      if (!side || ring.size() == kMaxEdges) return std::nullopt;
      ring.push_back(*side);
    }
    return in_order(ring) ? std::optional(std::move(ring)) : std::nullopt;
  }

 private:
  struct Stored {
    int curves = 0;                 // in space
    const BRep_GCurve* chart = {};  // on this surface
    bool others = false;            // of unknown kinds
  };

  Stored stored_of(const TopoDS_Edge& edge, const BRep_TEdge& record) const {
    Stored stored;
    const TopLoc_Location place = place_.Predivided(edge.Location());
    for (BRep_ListIteratorOfListOfCurveRepresentation it(record.Curves()); it.More(); it.Next()) {
      const BRep_CurveRepresentation& each = *it.Value();
      if (each.IsCurve3D()) {
        ++stored.curves;
      } else if (!each.IsCurveOnSurface()) {
        stored.others = stored.others || !each.IsRegularity();
      } else if (each.IsCurveOnSurface(surface_, place)) {
        stored.others = stored.others || stored.chart != nullptr || each.IsCurveOnClosedSurface();
        stored.chart = static_cast<const BRep_GCurve*>(&each);
      }
    }
    return stored;
  }

  std::optional<RingSide> side_of(const TopoDS_Edge& edge) const;

  // Into the order in which they run; false if they are not one ring.
  static bool in_order(Ring& ring) {
    for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
      const auto rest = ring.begin() + static_cast<std::ptrdiff_t>(i) + 1;
      const auto next = std::find_if(rest, ring.end(), [&](const RingSide& side) {
        return side.first.vertex.IsSame(ring[i].last.vertex);
      });
      if (next == ring.end()) return false;
      std::iter_swap(rest, next);
    }
    return ring.size() >= 3 && ring.back().last.vertex.IsSame(ring.front().first.vertex);
  }

  Handle(Geom_Surface) surface_;
  TopLoc_Location place_;
  PlaneFrame frame_;
};

// Nothing where an end is not held or the edge is of another kind.
std::optional<RingSide> PolygonReader::side_of(const TopoDS_Edge& edge) const {
  const auto& record = static_cast<const BRep_TEdge&>(*edge.TShape());
  const bool forward = edge.Orientation() == TopAbs_FORWARD;
  if ((!forward && edge.Orientation() != TopAbs_REVERSED) || record.Degenerated() ||
      !record.SameParameter() || !record.SameRange() || !is_rigid(edge.Location()))
    return std::nullopt;
  const Stored stored = stored_of(edge, record);
  if (stored.others || stored.curves != 1) return std::nullopt;
  TopLoc_Location move;
  double from = 0, to = 0;
  const auto line = Handle(Geom_Line)::DownCast(BRep_Tool::Curve(edge, move, from, to));
  if (line.IsNull() || !is_rigid(move) || !(to - from > Precision::PConfusion()))
    return std::nullopt;
  const double tolerance = record.Tolerance();
  std::array<Vec3, 2> ends;
  for (const bool last : {false, true})
    ends[last] = frame_.at(line->Value(last ? to : from).Transformed(move.Transformation()));
  std::array<Vec2, 2> chart{in_plane(ends[0]), in_plane(ends[1])};
  if (stored.chart != nullptr) {
    const auto pcurve = Handle(Geom2d_Line)::DownCast(stored.chart->PCurve());
    if (pcurve.IsNull() || stored.chart->First() != from || stored.chart->Last() != to)
      return std::nullopt;
    for (const bool last : {false, true}) {
      const gp_Pnt2d point = pcurve->Value(last ? to : from);
      chart[last] = {point.X(), point.Y()};
    }
  }
  for (const bool last : {false, true})
    if (!(norm(ends[last] - Vec3{chart[last][0], chart[last][1], 0}) <= tolerance))
      return std::nullopt;
  std::array<std::optional<VertexPlace>, 2> corners;
  for (TopoDS_Iterator it(edge.Oriented(TopAbs_FORWARD)); it.More(); it.Next()) {
    const TopAbs_Orientation end = it.Value().Orientation();
    if (end != TopAbs_FORWARD && end != TopAbs_REVERSED) return std::nullopt;
    auto& corner = corners[end == TopAbs_REVERSED];
    if (corner) return std::nullopt;
    corner = corner_of(it.Value(), frame_);
    if (!corner) return std::nullopt;
  }
  for (const bool last : {false, true})
    if (!corners[last] || !holds(*corners[last], ends[last], chart[last])) return std::nullopt;
  return RingSide{*corners[!forward], *corners[forward], chart[!forward], chart[forward],
                  tolerance};
}

// Whether two sides, the second one from where the first one ends, have no point in common that is
// outside of the corner's tolerance. Both ends there are a gap apart; if the angle between the
// sides is not acute, what they have in common is no farther than the gap from the second's end,
// else the gap by the sine of the angle.
bool meet_in_corner(const RingSide& before, const RingSide& after) {
  const Vec2 back = before.from - before.to, on = after.to - after.from;
  const double gap = norm(before.to - after.from);
  const double sine = std::abs(across(back, on)) / (norm(back) * norm(on));
  const bool acute = dot(back, on) > 0;
  if (acute && !(sine >= kMinSine)) return false;
  const VertexPlace& corner = after.first;
  const Vec3 off = corner.place - Vec3{after.from[0], after.from[1], 0};
  return norm(off) + (acute ? gap / sine : gap) <= corner.tolerance;
}

// Whether a line along a side, or one across it, parts the two by more than the margin.
bool parts(const RingSide& along, const RingSide& other, double margin) {
  const Vec2 way = along.to - along.from;
  const double length = norm(way);
  const Vec2 unit = (1 / length) * way;
  const double x0 = dot(unit, other.from - along.from), x1 = dot(unit, other.to - along.from);
  const double y0 = across(unit, other.from - along.from), y1 = across(unit, other.to - along.from);
  return std::max(x0, x1) < -margin || std::min(x0, x1) > length + margin ||
         std::min(y0, y1) > margin || std::max(y0, y1) < -margin;
}

bool are_apart(const RingSide& a, const RingSide& b, double margin) {
  return parts(a, b, margin) || parts(b, a, margin);
}

bool passes_once(const Ring& ring, double margin) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    for (std::size_t j = i + 1; j < ring.size(); ++j) {
      const bool fine = j == i + 1                       ? meet_in_corner(ring[i], ring[j])
                        : i == 0 && j + 1 == ring.size() ? meet_in_corner(ring[j], ring[i])
                                                         : are_apart(ring[i], ring[j], margin);
      if (!fine) return false;
    }
  return true;
}

bool are_apart(const Ring& a, const Ring& b, double margin) {
  return std::ranges::all_of(a, [&](const RingSide& side) {
    return std::ranges::all_of(
        b, [&](const RingSide& other) { return are_apart(side, other, margin); });
  });
}

// Twice the area, positive if the ring runs counter-clockwise.
double turn_of(const Ring& ring) {
  double sum = 0;
  for (const RingSide& side : ring)
    sum += across(side.from - ring.front().from, side.to - ring.front().from);
  return sum;
}

bool surrounds(const Ring& ring, const Vec2& point) {
  bool inside = false;
  for (const RingSide& side : ring) {
    const Vec2 a = side.from - point, b = side.to - point;
    if ((a[1] > 0) != (b[1] > 0)) inside ^= (across(a, b) > 0) == (b[1] > a[1]);
  }
  return inside;
}

double largest_tolerance(std::span<const Ring> rings) {
  double largest = 0;
  for (const Ring& ring : rings)
    for (const RingSide& side : ring)
      largest = std::max({largest, side.tolerance, side.first.tolerance});
  return largest;
}

// Whether one ring has all others as its holes; they are apart.
bool has_one_outside(std::span<const Ring> rings, double margin) {
  const Ring* outer = nullptr;
  for (const Ring& ring : rings) {
    const double turn = turn_of(ring);
    double around = 0;
    for (const RingSide& side : ring) around += norm(side.to - side.from);
    if (!(std::abs(turn) > margin * around) || (turn > 0 && outer != nullptr)) return false;
    if (turn > 0) outer = &ring;
  }
  return outer != nullptr && std::ranges::all_of(rings, [&](const Ring& hole) {
           return &hole == outer || std::ranges::all_of(rings, [&](const Ring& other) {
             return &other == &hole || surrounds(other, hole.front().from) == (&other == outer);
           });
         });
}

}  // namespace

bool is_sound_polygon(const TopoDS_Face& face) {
  TopLoc_Location place;
  const Handle(Geom_Surface)& surface = BRep_Tool::Surface(face, place);
  const auto plane = Handle(Geom_Plane)::DownCast(surface);
  if (plane.IsNull() || !is_rigid(place)) return false;
  const PlaneFrame frame(plane->Position().Transformed(place.Transformation()));
  const PolygonReader reader(surface, place, frame);
  std::vector<Ring> rings;
  std::size_t edges = 0;
  for (TopoDS_Iterator it(face.Oriented(TopAbs_FORWARD)); it.More(); it.Next()) {
    const TopoDS_Shape& wire = it.Value();
    if (wire.ShapeType() != TopAbs_WIRE ||
        (wire.Orientation() != TopAbs_FORWARD && wire.Orientation() != TopAbs_REVERSED))
      return false;
    auto ring = reader.ring_of(wire);
    if (!ring || (edges += ring->size()) > kMaxEdges) return false;
    rings.push_back(std::move(*ring));
  }
  const double margin = 2 * largest_tolerance(rings);
  for (std::size_t i = 0; i < rings.size(); ++i) {
    if (!passes_once(rings[i], margin)) return false;
    for (std::size_t j = i + 1; j < rings.size(); ++j)
      if (!are_apart(rings[i], rings[j], margin)) return false;
  }
  return has_one_outside(rings, margin);
}

}  // namespace blossom::occt
