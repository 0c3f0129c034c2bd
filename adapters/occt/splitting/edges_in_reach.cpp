// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/splitting/edges_in_reach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <BRep_Tool.hxx>
#include <Geom_Plane.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/curves.h"
#include "adapters/occt/splitting/edge_images.h"
#include "adapters/occt/splitting/edges/edge_stretches.h"
#include "core/base/sampled_margin.h"
#include "core/forms/curve_spans.h"

namespace blossom::occt {
namespace {

// Of the angle between faces: below it they hardly cross. Double precision tells normals apart to
// 1e-16, and the root of that where they come from differences.
constexpr double kMinSine = 1e-8;

constexpr int kEvenPoints = 8;  // of a curve that may keep to edges

bool is_near(const Vec3& point, const std::vector<EdgeInReach>& edges) {
  return std::any_of(edges.begin(), edges.end(), [&](const EdgeInReach& each) {
    return meet(each.box, {point, point}) &&
           foot_on(curve_of(each.edge), pnt(point)).distance <= each.reach;
  });
}

// Whether some point of an edge, not its ends alone, is as near as that to what `height` measures.
template <class Height>
bool comes_near(const TopoDS_Edge& edge, double reach, const Height& height) {
  const RangedCurve of = curve_of(edge);
  return std::ranges::any_of(std::array{0.5, 0.25, 0.75}, [&](double part) {
    return std::abs(height(of.curve->Value(at(of.range, part)))) <= reach;
  });
}

}  // namespace

std::vector<TopoDS_Edge> bounding_edges(const TopoDS_Face& face) {
  TopTools_IndexedMapOfShape found;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    if (it.Current().Orientation() != TopAbs_INTERNAL &&
        !BRep_Tool::Degenerated(TopoDS::Edge(it.Current())))
      found.Add(it.Current().Oriented(TopAbs_FORWARD));
  std::vector<TopoDS_Edge> edges;
  for (int i = 1; i <= found.Extent(); ++i) edges.push_back(TopoDS::Edge(found(i)));
  return edges;
}

std::vector<EdgeInReach> edges_in_reach(const std::vector<TopoDS_Edge>& edges,
                                        const EdgeReach& reach_of) {
  std::vector<EdgeInReach> all;
  for (const TopoDS_Edge& edge : edges) {
    const RangedCurve of = curve_of(edge);
    const double reach = reach_of(edge);
    const CurveSpans spans = bezier_spans(of.curve, of.range, reach);
    Box box;
    for (const auto& span : spans.spans)
      for (const Vec4& p : span.curve.points) {
        const Vec3 x = projected(p);
        box = joined(box, {x, x});
      }
    all.push_back({edge, widened(box, spans.error + kSampledMargin * reach), reach});
  }
  return all;
}

double CrossedFaces::reach_at(const SurfacePoint& of) const {
  const SurfaceJet on_a = frame_at(a, of.uv_a), on_b = frame_at(b, of.uv_b);
  const Vec3 normal_a = cross(on_a.du, on_a.dv), normal_b = cross(on_b.du, on_b.dv);
  const double size = norm(normal_a) * norm(normal_b);
  const double sine = size > 0 ? norm(cross(normal_a, normal_b)) / size : 1;
  return 2 * tolerance / std::max(sine, kMinSine);
}

bool follows(const IntersectionCurve& curve, const std::vector<EdgeInReach>& edges,
             const CrossedFaces& crossed) {
  const auto is_along = [&](const SurfacePoint& x) {
    if (is_near(x.point, edges)) return true;
    if (curve.tangential) return false;
    const double reach = crossed.reach_at(x);
    return std::ranges::any_of(edges, [&](const EdgeInReach& each) {
      return reach > each.reach && foot_on(curve_of(each.edge), pnt(x.point)).distance <= reach;
    });
  };
  for (int i = 1; i < kEvenPoints && !edges.empty(); ++i) {
    const double t = at(curve.curve.domain(), static_cast<double>(i) / kEvenPoints);
    if (!is_along(
            {point_at(curve.curve, t), point_at(curve.chart_a, t), point_at(curve.chart_b, t)}))
      return false;
  }
  return !edges.empty() && std::ranges::all_of(curve.samples, is_along);
}

Box spline_box(const Spline& curve) {
  Box box;
  for (const Vec3& p : curve.points) box = joined(box, {p, p});
  return box;
}

bool may_follow(const IntersectionCurve& curve, const std::vector<EdgeInReach>& edges) {
  const std::size_t last = curve.samples.size() - 1;
  return is_near(curve.samples[last / 2].point, edges) ||
         is_near(curve.samples[last / 4].point, edges) ||
         is_near(curve.samples[3 * last / 4].point, edges);
}

bool may_lie_on(const std::vector<TopoDS_Edge>& edges, const TopoDS_Face& of,
                const TopoDS_Face& other, double tolerance, const EdgeReach& reach) {
  const Handle(Geom_Plane) plane = Handle(Geom_Plane)::DownCast(BRep_Tool::Surface(other));
  if (!plane.IsNull())
    return std::ranges::any_of(edges, [&](const TopoDS_Edge& edge) {
      return comes_near(edge, reach(edge),
                        [&](const gp_Pnt& p) { return plane->Pln().Distance(p); });
    });
  std::optional<SurfaceProjector> feet;
  return std::ranges::any_of(edges, [&](const TopoDS_Edge& edge) {
    if (!BRep_Tool::IsClosed(edge, of)) return false;
    if (!feet) feet.emplace(other, tolerance);
    return comes_near(edge, reach(edge), [&](const gp_Pnt& p) {
      return feet->height({p.X(), p.Y(), p.Z()});
    });
  });
}

}  // namespace blossom::occt
