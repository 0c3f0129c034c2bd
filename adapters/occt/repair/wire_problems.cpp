// SPDX-License-Identifier: LGPL-2.1-or-later
// Degenerate and self-touching wires, by the common points of their pcurves.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>

#include <BRep_Tool.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/surfaces.h"
#include "adapters/occt/faces/face_trims.h"
#include "adapters/occt/soundness.h"
#include "core/base/unbounded.h"
#include "core/plane/loops.h"

namespace blossom::occt {
namespace {

// Two edges that leave their corner at a small angle stay close for a while: common points within
// so many tolerances of the corner are the corner.
constexpr double kCornerReach = 100;
constexpr int kRunSamples = 5;  // of two coedges between a corner and a common point
// Edges that run together from their corner over more than this part of one of them, if that is
// not within its reach, have no face between them; over less, they touch in the corner and part.
constexpr double kTouchingPart = 0.5;

struct PlacedCoedge {
  const Coedge* coedge = nullptr;
  PlanarBox box;
  int loop = 0;
};

// The nearest corner that joins the two, or infinitely far.
double from_common_corner(const FaceTrims& trims, const Coedge& a, const Coedge& b,
                          const Vec2& point) {
  double least = kInfinity;
  for (const int corner : {a.from, a.to})
    if (corner == b.from || corner == b.to)
      least = std::min(least, distance(trims.corners[static_cast<std::size_t>(corner)], point));
  return least;
}

// Of the vertices that join two edges: within it they are one point.
double common_tolerance(const TopoDS_Edge& a, const TopoDS_Edge& b) {
  double largest = 0;
  for (TopoDS_Iterator of_a(a); of_a.More(); of_a.Next())
    for (TopoDS_Iterator of_b(b); of_b.More(); of_b.Next())
      if (of_a.Value().IsSame(of_b.Value()))
        largest = std::max(largest, BRep_Tool::Tolerance(TopoDS::Vertex(of_a.Value())));
  return largest;
}

Vec3 on_surface(const FaceTrims& trims, const Vec2& point) {
  return trims.jet({point[0] / trims.scale[0], point[1] / trims.scale[1]}).point;
}

// Whether a point is at a vertex of both edges: there wires may touch, each other or themselves.
bool is_at_common_vertex(const FaceTrims& trims, const TopoDS_Edge& a, const TopoDS_Edge& b,
                         const Vec2& point, double reach) {
  for (TopoDS_Iterator of_a(a); of_a.More(); of_a.Next())
    for (TopoDS_Iterator of_b(b); of_b.More(); of_b.Next()) {
      if (!of_a.Value().IsSame(of_b.Value())) continue;
      const gp_Pnt vertex = BRep_Tool::Pnt(TopoDS::Vertex(of_a.Value()));
      if (distance(vec(vertex), on_surface(trims, point)) <= reach) return true;
    }
  return false;
}

// Whether two coedges that touch in a corner, as an arc and its tangent do, run along each other
// from there to a common point: where they are so near, it says nothing.
// is_corner   whether they touch in an end of the first
bool run_from_corner(const FaceTrims& trims, const Coedge& a, const Coedge& b, double at_point,
                     double reach, const std::function<bool(const Vec2&)>& is_corner) {
  const Interval domain = a.curve.domain();
  for (const bool first : {true, false}) {
    if (!is_corner(trims.corners[static_cast<std::size_t>(first ? a.from : a.to)])) continue;
    const double end = first != a.reversed ? domain.from : domain.to;
    bool is_near = true;
    for (int i = 1; i < kRunSamples && is_near; ++i) {
      const Vec2 point =
          point_at(a.curve, at({at_point, end}, static_cast<double>(i) / kRunSamples));
      is_near = nearest(b.curve, point).distance <= reach;
    }
    if (is_near) return true;
  }
  return false;
}

// Whether a run takes most of a coedge, which reaches farther than a corner does. A pole is a
// point: along it runs in the chart what passes it within tolerance.
bool fills(const Interval& run, const Coedge& coedge, const TopoDS_Edge& edge, double reach) {
  if (BRep_Tool::Degenerated(edge)) return false;
  const Interval domain = coedge.curve.domain();
  return std::abs(run.to - run.from) > kTouchingPart * (domain.to - domain.from) &&
         distance(point_at(coedge.curve, run.from), point_at(coedge.curve, run.to)) >
             kCornerReach * reach;
}

// A point where two coedges meet though nothing joins them there.
std::optional<Vec2> meeting_place(const FaceTrims& trims, const TrimShapes& shapes, const Coedge& a,
                                  const Coedge& b) {
  const TopoDS_Edge edge_a = shapes.edge(a), edge_b = shapes.edge(b);
  const double tolerance = Precision::Confusion();
  const double reach = std::max({kCornerReach * tolerance, a.tolerance, b.tolerance,
                                 common_tolerance(edge_a, edge_b)}) +
                       trims.largest_gap;
  const double width = std::max(tolerance, a.tolerance + b.tolerance);
  const auto is_corner = [&](const Vec2& point) {
    return from_common_corner(trims, a, b, point) <= reach ||
           is_at_common_vertex(trims, edge_a, edge_b, point, reach);
  };
  const auto joined = [&](double at_point) {
    return is_corner(point_at(a.curve, at_point)) ||
           run_from_corner(trims, a, b, at_point, width, is_corner);
  };
  const PlanarCrossings common = crossings(a.curve, b.curve, tolerance);
  for (const PlanarCrossing& crossing : common.points)
    if (!joined(crossing.a)) return crossing.point;
  for (const PlanarOverlap& run : common.overlaps)
    if (!(joined(run.a.from) || joined(run.a.to)) || fills(run.a, a, edge_a, reach) ||
        fills(run.b, b, edge_b, reach))
      return point_at(a.curve, 0.5 * (run.a.from + run.a.to));
  return std::nullopt;
}

Problem meeting_problem(const FaceTrims& trims, const PlacedCoedge& a, const PlacedCoedge& b,
                        const Vec2& place) {
  return {a.loop == b.loop ? "a wire meets itself" : "two wires meet", on_surface(trims, place)};
}

bool bounds(const TopoDS_Shape& shape) {
  return shape.Orientation() == TopAbs_FORWARD || shape.Orientation() == TopAbs_REVERSED;
}

// Edges inside of the face may end; those that bound it come to each vertex as often as they leave.
bool is_open(const TopoDS_Shape& wire) {
  TopTools_MapOfShape ends;
  for (TopoDS_Iterator edge(wire); edge.More(); edge.Next()) {
    if (!bounds(edge.Value())) continue;
    bool has_ends = false;
    for (TopoDS_Iterator vertex(edge.Value()); vertex.More(); vertex.Next()) {
      if (!bounds(vertex.Value())) continue;
      has_ends = true;
      if (!ends.Add(vertex.Value())) ends.Remove(vertex.Value());
    }
    if (!has_ends) return true;
  }
  return !ends.IsEmpty();
}

}  // namespace

bool has_open_wire(const TopoDS_Face& face) {
  for (TopoDS_Iterator it(face); it.More(); it.Next())
    if (it.Value().ShapeType() == TopAbs_WIRE && is_open(it.Value())) return true;
  return false;
}

bool is_endless(const TopoDS_Face& face) {
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  if (surface.IsNull() || TopoDS_Iterator(face).More()) return false;
  std::array<double, 4> bounds{};
  surface->Bounds(bounds[0], bounds[1], bounds[2], bounds[3]);
  return std::ranges::any_of(bounds, [](double at) { return Precision::IsInfinite(at); });
}

bool has_no_width(const TopoDS_Face& face) {
  if (is_endless(face)) return false;
  try {
    parameter_box(face);
    return false;
  } catch (const BadModel&) {
    return true;
  }
}

std::vector<Problem> wire_problems(const TopoDS_Face& face) {
  FaceTrims trims;
  try {
    trims = face_trims(face);
  } catch (const BadModel& error) {
    return {{error.what()}};
  }
  const TrimShapes shapes = trim_shapes(face);
  std::vector<Problem> problems;
  std::vector<PlacedCoedge> all;
  for (std::size_t i = 0; i < trims.loops.size(); ++i) {
    if (is_covered(trims, trims.loops[i], Precision::Confusion()))
      problems.push_back({"a wire encloses no more than its edges' tolerances cover"});
    for (const Coedge& coedge : trims.loops[i])
      all.push_back({&coedge, box_of(coedge.curve), static_cast<int>(i)});
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = i + 1; k < all.size(); ++k) {
      if (are_disjoint(all[i].box, all[k].box, Precision::Confusion())) continue;
      if (const auto place = meeting_place(trims, shapes, *all[i].coedge, *all[k].coedge))
        problems.push_back(meeting_problem(trims, all[i], all[k], *place));
    }
  return problems;
}

}  // namespace blossom::occt
