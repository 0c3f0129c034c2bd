// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/branches/found_places.h"

#include <algorithm>
#include <cstddef>

#include "core/base/unbounded.h"
#include "core/forms/evaluation.h"

namespace blossom {

SurfacePoint surface_point(SurfaceCells& a, SurfaceCells& b, const Vec3& origin,
                           const ContactPoint& point) {
  const auto& [patch_a, patch_b, x, gap, crosses] = point;
  const BezierSurface &sa = a.surface(), &sb = b.surface();
  const Vec3 on_a = point_at(a.tree(patch_a).patch(), x[0], x[1]);
  const Vec3 on_b = point_at(b.tree(patch_b).patch(), x[2], x[3]);
  return {0.5 * (on_a + on_b) + origin,
          {parameter_at(sa.u_law, a.knots_u(patch_a), x[0]),
           parameter_at(sa.v_law, a.knots_v(patch_a), x[1])},
          {parameter_at(sb.u_law, b.knots_u(patch_b), x[2]),
           parameter_at(sb.v_law, b.knots_v(patch_b), x[3])}};
}

std::array<Interval, 4> parameters_of(const SurfaceCells& a, const SurfaceCells& b,
                                      const CriticalPair& pair) {
  const std::array spans{a.knots_u(pair.patch_a), a.knots_v(pair.patch_a), b.knots_u(pair.patch_b),
                         b.knots_v(pair.patch_b)};
  const std::array laws{a.surface().u_law, a.surface().v_law, b.surface().u_law, b.surface().v_law};
  std::array<Interval, 4> all;
  for (std::size_t k = 0; k < 4; ++k)
    all[k] = {parameter_at(laws[k], spans[k], pair.box[k].from),
              parameter_at(laws[k], spans[k], pair.box[k].to)};
  return all;
}

std::array<Interval, 4> parameters_of(const SurfaceCells& a, const SurfaceCells& b,
                                      const std::vector<CriticalPair>& critical,
                                      const CriticalCluster& cluster) {
  std::array<Interval, 4> all;
  all.fill({kUnbounded, -kUnbounded});
  for (const int i : cluster.pairs) {
    const std::array one = parameters_of(a, b, critical[static_cast<std::size_t>(i)]);
    for (std::size_t k = 0; k < 4; ++k) {
      all[k].from = std::min(all[k].from, one[k].from);
      all[k].to = std::max(all[k].to, one[k].to);
    }
  }
  return all;
}

Box end_box(SurfaceCells& a, const PairSearchResult& found, const Chain& chain) {
  Box box;
  for (const ChainLink& link : chain.links) {
    const FoundArc& arc = found.arcs[static_cast<std::size_t>(link.arc)];
    for (const Point4& x : {arc.arc.from, arc.arc.to}) {
      const Vec3 p = point_at(a.tree(arc.patch_a).patch(), x[0], x[1]);
      box = joined(box, {p, p});
    }
  }
  return box;
}

Place place_at(const SurfacePoint& point, double tolerance) {
  const auto& [p, uv_a, uv_b] = point;
  const Vec3 r{tolerance, tolerance, tolerance};
  Place place{PlaceKind::Open, p - r, p + r, 0, tolerance, {}};
  place.parameters = {Interval{uv_a[0], uv_a[0]}, Interval{uv_a[1], uv_a[1]},
                      Interval{uv_b[0], uv_b[0]}, Interval{uv_b[1], uv_b[1]}};
  return place;
}

}  // namespace blossom
