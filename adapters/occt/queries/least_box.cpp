// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/queries/least_box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/convert/hulls.h"
#include "adapters/occt/distance.h"
#include "core/math/vec.h"

namespace blossom::occt {
namespace {

constexpr double kPrecision = 1e-7;  // model units, what is Open CASCADE's confusion
// Of the size of a box: how far edges may be from the borders of their faces and still bound them.
// Searches end at less precise boxes where a face comes as far all along a line.
constexpr double kBorder = 1e-6;
// Of cells, for a side: where a shape comes as far all along a curve, the last digits take a time
// that nobody wants to wait; the box says how precise it is.
constexpr long kMaxCells = 20'000;

// Of a box that is not the least, but holds all of the shape.
double size_of(const TopoDS_Shape& shape) {
  const Bnd_Box found = bounds_of(shape);
  if (found.IsVoid() || found.IsOpen()) throw BadModel("the shape has no end, or nothing in it");
  Box box;
  found.Get(box.low[0], box.low[1], box.low[2], box.high[0], box.high[1], box.high[2]);
  return max_norm(box.high - box.low);
}

// Whether a surface consists of straight lines along which a parameter runs.
bool is_ruled(const BRepAdaptor_Surface& surface) {
  const auto straight = [](int degree, int spans) { return degree == 1 && spans == 1; };
  switch (surface.GetType()) {
    case GeomAbs_Plane:
    case GeomAbs_Cylinder:
    case GeomAbs_Cone:
    case GeomAbs_SurfaceOfExtrusion: return true;
    case GeomAbs_BezierSurface: return surface.UDegree() == 1 || surface.VDegree() == 1;
    case GeomAbs_BSplineSurface:
      return straight(surface.UDegree(), surface.NbUKnots() - 1) ||
             straight(surface.VDegree(), surface.NbVKnots() - 1);
    default: return false;
  }
}

// A line goes farthest in any direction at an end: where a face is made of lines, on its border.
// Its edges are that border, up to their tolerance.
//
// returns   how far edges may be from the border; none if the face goes farther
std::optional<double> ends_on_edges(const TopoDS_Face& face) {
  std::optional<double> apart;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    apart = std::max(apart.value_or(kPrecision), BRep_Tool::Tolerance(TopoDS::Edge(it.Current())));
  if (!apart || !is_ruled(BRepAdaptor_Surface(face, Standard_False))) return std::nullopt;
  return apart;
}

// Calls `take` with the places where an arc comes farthest along an axis, in the middle or at its
// ends. The arc is c + cos(t) u + sin(t) v; along an axis it turns at atan(v / u).
template <class Take>
void for_each_extreme(const gp_XYZ& centre, const gp_XYZ& u, const gp_XYZ& v, double from,
                      double to, const Take& take) {
  constexpr double kHalfTurn = std::numbers::pi;
  constexpr int kMaxTurns = 3;  // along an axis, within one turn of the arc
  const auto at = [&](double t) { take(gp_Pnt(centre + std::cos(t) * u + std::sin(t) * v)); };
  at(from);
  at(to);
  for (int axis = 1; axis <= 3; ++axis) {
    const double turn = std::atan2(v.Coord(axis), u.Coord(axis));
    double t = turn + std::ceil((from - turn) / kHalfTurn) * kHalfTurn;
    for (int turns = 0; turns < kMaxTurns && t < to; ++turns, t += kHalfTurn) at(t);
  }
}

// What of a shape may go farthest in a direction.
class Outermost {
 public:
  /// size   of the shape
  Outermost(const TopoDS_Shape& shape, double size) : size_(size) {
    builder_.MakeCompound(parts_);
    TopTools_IndexedMapOfShape faces, edges, vertices;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    TopExp::MapShapes(shape, TopAbs_EDGE, edges);
    TopExp::MapShapes(shape, TopAbs_VERTEX, vertices);
    for (int i = 1; i <= faces.Extent(); ++i) add(TopoDS::Face(faces(i)));
    for (int i = 1; i <= edges.Extent(); ++i) add(TopoDS::Edge(edges(i)));
    for (int i = 1; i <= vertices.Extent(); ++i) add(BRep_Tool::Pnt(TopoDS::Vertex(vertices(i))));
    for (const TopoDS_Shape& part : curved_)
      if (may_reach_out(part)) builder_.Add(parts_, part);
    // Searches begin with points.
    if (parts_.NbChildren() > 0)
      for (int i = 1; i <= vertices.Extent(); ++i) builder_.Add(parts_, vertices(i));
  }

  /// Faces and edges, and all vertices if there are any. What is not in it goes no farther than it
  /// and the box of points by more than the slack; nor does any of it on a side that is not open.
  const TopoDS_Compound& parts() const { return parts_; }
  const Box& points() const { return points_; }
  double slack() const { return slack_; }
  /// Digits below what is not known anyhow are not looked for.
  double resolution() const { return std::max(kPrecision, slack_); }
  bool is_open(int axis, bool high) const { return high ? open_high_[axis] : open_low_[axis]; }

 private:
  // Whether control points of a face or edge lie beyond the box of points; opens these sides.
  bool may_reach_out(const TopoDS_Shape& part) {
    std::vector<Vec3> hull;
    const bool bounded = part.ShapeType() == TopAbs_FACE ? add_hull(TopoDS::Face(part), hull)
                                                         : add_hull(TopoDS::Edge(part), hull);
    if (!bounded || !has_end(hull)) {
      open_low_.fill(true);
      open_high_.fill(true);
      return true;
    }
    const HullBound bound = placed_hull(std::move(hull), part.Location().Transformation());
    Box box;
    for (const Vec3& point : bound.points) box = joined(box, {point, point});
    bool beyond = false;
    for (int axis = 0; axis < 3; ++axis) {
      const double below = points_.low[axis] - (box.low[axis] - bound.margin);
      const double above = box.high[axis] + bound.margin - points_.high[axis];
      beyond |= goes_on(below, open_low_[axis]) | goes_on(above, open_high_[axis]);
    }
    return beyond;
  }

  // What is beyond by no more than the resolution counts as slack.
  bool goes_on(double beyond, bool& open) {
    if (beyond > resolution()) return open = true;
    slack_ = std::max(slack_, beyond);
    return false;
  }

  void add(const TopoDS_Face& face) {
    const std::optional<double> apart = ends_on_edges(face);
    if (apart && *apart <= std::max(kPrecision, kBorder * size_))
      slack_ = std::max(slack_, *apart);
    else
      curved_.push_back(face);
  }

  void add(const TopoDS_Edge& edge) {
    double from = 0, to = 0;
    if (BRep_Tool::Degenerated(edge)) return;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, from, to);
    if (const auto circle = Handle(Geom_Circle)::DownCast(curve); !circle.IsNull()) {
      add_arc(circle->Position(), circle->Radius(), circle->Radius(), from, to);
    } else if (const auto ellipse = Handle(Geom_Ellipse)::DownCast(curve); !ellipse.IsNull()) {
      add_arc(ellipse->Position(), ellipse->MajorRadius(), ellipse->MinorRadius(), from, to);
    } else if (!curve.IsNull() && curve->IsKind(STANDARD_TYPE(Geom_Line))) {
      add(curve->Value(from));
      add(curve->Value(to));
    } else if (!curve.IsNull()) {
      curved_.push_back(edge);
    } else {
      throw BadModel("an edge has no curve in space");
    }
  }

  void add_arc(const gp_Ax2& place, double along_x, double along_y, double from, double to) {
    for_each_extreme(place.Location().XYZ(), along_x * place.XDirection().XYZ(),
                     along_y * place.YDirection().XYZ(), from, to,
                     [&](const gp_Pnt& point) { add(point); });
  }

  void add(const gp_Pnt& point) {
    const Vec3 place{point.X(), point.Y(), point.Z()};
    points_ = joined(points_, {place, place});
  }

  BRep_Builder builder_;
  TopoDS_Compound parts_;
  std::vector<TopoDS_Shape> curved_;  // faces and edges without a closed form
  std::array<bool, 3> open_low_{}, open_high_{};
  Box points_;
  double slack_ = 0;
  double size_;
};

}  // namespace

LeastBox least_box(const TopoDS_Shape& shape, const std::function<bool()>& cancelled,
                   KeptForms* forms) {
  const Outermost outermost(shape, size_of(shape));
  LeastBox least{outermost.points(), outermost.slack()};
  if (outermost.parts().NbChildren() == 0) return least;
  const MeasuredShape parts(outermost.parts(), forms);
  const double resolution = std::max(outermost.resolution(), parts.error());
  double gap = 0;
  const auto farthest = [&](int axis, bool backwards, double known) {
    const FarthestResult found =
        farthest_along(parts.set(), axis, backwards, known,
                       {.budget = kMaxCells, .cancelled = cancelled, .resolution = resolution});
    gap = std::max(gap, found.upper - found.lower);
    return found.lower;
  };
  for (int axis = 0; axis < 3; ++axis) {
    double &low = least.box.low[axis], &high = least.box.high[axis];
    if (outermost.is_open(axis, false)) low = -farthest(axis, true, -low);
    if (outermost.is_open(axis, true)) high = farthest(axis, false, high);
  }
  // A side is passed by what was searched, or by what was not.
  least.precision = std::max(least.precision, gap + parts.error());
  return least;
}

}  // namespace blossom::occt
