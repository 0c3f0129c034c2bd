// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/pairs/touched_planes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

#include <BRepAdaptor_Surface.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/faces/pairs/shared_edges.h"
#include "core/base/tolerances.h"
#include "core/surfaces/retry/exchanged_order.h"

namespace blossom::occt {
namespace {

bool is_plane(const FaceData& face) {
  return face.elementary && face.elementary->kind == ElementaryKind::Plane;
}

std::vector<std::vector<int>> planes_beside(const FaceList& faces, const std::vector<char>& asked) {
  std::vector<std::vector<int>> beside(faces.size());
  TopTools_IndexedMapOfShape edges;
  std::vector<std::vector<int>> planes_at;  // by edge
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (!is_plane(faces.data(i))) continue;
    TopTools_IndexedMapOfShape own;
    TopExp::MapShapes(faces.face(i), TopAbs_EDGE, own);
    for (int k = 1; k <= own.Extent(); ++k) {
      const auto edge = static_cast<std::size_t>(edges.Add(own(k)));
      if (planes_at.size() < edge) planes_at.resize(edge);
      planes_at[edge - 1].push_back(static_cast<int>(i));
    }
  }
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (!asked[i]) continue;
    TopTools_IndexedMapOfShape own;
    TopExp::MapShapes(faces.face(i), TopAbs_EDGE, own);
    for (int k = 1; k <= own.Extent(); ++k)
      if (const int edge = edges.FindIndex(own(k)); edge > 0)
        for (const int plane : planes_at[static_cast<std::size_t>(edge - 1)])
          if (!std::ranges::count(beside[i], plane)) beside[i].push_back(plane);
  }
  return beside;
}

// An edge of a face and a plane's, with its image in another plane that is off by no more than a
// gap instead: the foot points of the edge, as affine a map as that of charts of planes.
void lay_into(const gp_Pln& plane, double gap, Spline2 IntersectionCurve::*chart,
              Vec2 SurfacePoint::*uv, SharedEdge& edge) {
  const gp_Ax3& at = plane.Position();
  const Vec3 origin = vec(at.Location().XYZ()), x = vec(at.XDirection().XYZ()),
             y = vec(at.YDirection().XYZ());
  const auto foot = [&](const Vec3& p) { return Vec2{dot(p - origin, x), dot(p - origin, y)}; };
  IntersectionCurve& curve = edge.curve;
  const double speed = length(curve.curve.domain()) / curve.length;
  for (std::vector<double>* parameters :
       {&curve.curve.knots, &curve.chart_a.knots, &curve.chart_b.knots, &curve.sample_parameters})
    for (double& t : *parameters) t /= speed;
  Spline2& image = curve.*chart;
  image = {curve.curve.degree, curve.curve.knots, curve.curve.multiplicities, {}};
  for (const Vec3& p : curve.curve.points) image.points.push_back(foot(p));
  for (SurfacePoint& sample : curve.samples) sample.*uv = foot(sample.point);
  curve.deviation.a += gap;
  curve.deviation.b += gap;
  curve.deviation.between += gap;
  edge.gap += gap;
}

// Gauss's rule of two points between samples, which are near each other: of so short a piece of a
// cubic the speed hardly changes.
double length_of(const IntersectionCurve& curve) {
  const double off = std::sqrt(1.0 / 12);
  double sum = 0;
  for (std::size_t i = 0; i + 1 < curve.samples.size(); ++i) {
    const Interval piece{curve.sample_parameters[i], curve.sample_parameters[i + 1]};
    sum += 0.5 * length(piece) *
           (norm(derivative_at(curve.curve, at(piece, 0.5 - off))) +
            norm(derivative_at(curve.curve, at(piece, 0.5 + off))));
  }
  return sum;
}

}  // namespace

TouchedPlanes::TouchedPlanes(const FaceList& a, const FaceList& b,
                             const std::vector<std::pair<int, int>>& pairs, double tolerance)
    : lists_{&a, &b}, tolerance_(tolerance) {
  std::array<std::vector<char>, 2> asked{std::vector<char>(a.size()), std::vector<char>(b.size())};
  for (const auto& [i, j] : pairs) {
    const auto in_a = static_cast<std::size_t>(i), in_b = static_cast<std::size_t>(j);
    if (is_plane(b.data(in_b)) && !a.data(in_a).elementary) asked[0][in_a] = 1;
    if (is_plane(a.data(in_a)) && !b.data(in_b).elementary) asked[1][in_b] = 1;
  }
  for (std::size_t side = 0; side < 2; ++side)
    if (std::ranges::count(asked[side], 1) > 0)
      neighbours_[side] = planes_beside(*lists_[side], asked[side]);
}

std::vector<SharedEdge> TouchedPlanes::of(int a, int b, double smooth) const {
  const std::array faces{static_cast<std::size_t>(a), static_cast<std::size_t>(b)};
  const std::array data{&lists_[0]->data(faces[0]), &lists_[1]->data(faces[1])};
  const std::size_t flat = is_plane(*data[1]) ? 1 : 0, curved = 1 - flat;
  if (!is_plane(*data[flat]) || data[curved]->elementary || neighbours_[curved].empty()) return {};
  const BRepAdaptor_Surface surface(lists_[flat]->face(faces[flat]), false);
  if (surface.GetType() != GeomAbs_Plane) return {};
  Ball ball{0.5 * (data[curved]->box.low + data[curved]->box.high),
            0.5 * diagonal(data[curved]->box)};
  const double within = one_within(
      {tolerance_}, std::max({max_norm(data[curved]->box.low), max_norm(data[curved]->box.high)}));
  std::vector<SharedEdge> edges;
  for (const int k : neighbours_[curved][faces[curved]]) {
    const FaceData& beside = lists_[curved]->data(static_cast<std::size_t>(k));
    const double gap = distance_bound(*beside.elementary, *data[flat]->elementary, ball);
    if (gap > within) continue;
    std::array pair{lists_[curved]->face(faces[curved]),
                    lists_[curved]->face(static_cast<std::size_t>(k))};
    if (curved == 1) std::swap(pair[0], pair[1]);
    for (SharedEdge& edge : shared_edges(pair[0], pair[1])) {
      if (edge.curve.least_angle >= smooth) continue;
      if (flat == 1)
        lay_into(surface.Plane(), gap, &IntersectionCurve::chart_b, &SurfacePoint::uv_b, edge);
      else
        lay_into(surface.Plane(), gap, &IntersectionCurve::chart_a, &SurfacePoint::uv_a, edge);
      (flat == 1 ? edge.in_b : edge.in_a) = -1;
      if (!edge.curve.closed && flat == 0) edge.curve.ends = {CurveEnd::BorderB, CurveEnd::BorderB};
      edges.push_back(std::move(edge));
    }
  }
  return edges;
}

void add_touching(const FaceData& a, const FaceData& b, const std::vector<SharedEdge>& edges,
                  double tolerance, SurfaceIntersection& found, std::vector<Touch>& touches) {
  if (edges.empty()) return;
  SurfaceIntersection touching;
  for (const SharedEdge& edge : edges) touching.curves.push_back(edge.curve);
  const bool is_in_b = edges.front().in_b < 0;
  if (is_in_b) touching = exchanged(std::move(touching), b.surface, a.surface);
  std::vector<Touch> ends =
      clip(touching, is_in_b ? b.trims : a.trims, nullptr, 0, std::max(kOnWire, tolerance));
  if (is_in_b) {
    touching = exchanged(std::move(touching), a.surface, b.surface);
    for (Touch& end : ends) std::swap(end.at.uv_a, end.at.uv_b);
  }
  for (IntersectionCurve& curve : touching.curves) {
    curve.length = length_of(curve);
    found.curves.push_back(std::move(curve));
  }
  std::ranges::move(ends, std::back_inserter(touches));
}

}  // namespace blossom::occt
