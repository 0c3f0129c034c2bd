// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/intersection/contact_reach.h"

#include <algorithm>
#include <cmath>

#include "core/forms/evaluation.h"
#include "core/intersection/contact_points.h"

namespace blossom {
namespace {

constexpr double kAttachGap = 4;       // tolerances: the most on the way to a contact
constexpr double kPolishReach = 0.02;  // fraction of a patch

// The point nearest to x, in space, on the lines along which the surfaces touch and cross.
std::optional<ContactPoint> nearest_on_lines(const PairSearchResult& found, SurfaceCells& a,
                                             const Vec3& x) {
  std::optional<ContactPoint> nearest;
  double least = 1e300;
  for (const FoundContact& line : found.contacts) {
    if (!line.contact.crosses) continue;
    const auto& patch = a.tree(line.patch_a).patch();
    const auto& path = line.contact.path;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      const Vec3 from = jet_at(patch, path[i][0], path[i][1], 1).point;
      const Vec3 step = jet_at(patch, path[i + 1][0], path[i + 1][1], 1).point - from;
      const double t =
          std::clamp(dot(x - from, step) / std::max(dot(step, step), 1e-300), 0.0, 1.0);
      const double gap = distance(x, from + step * t);
      if (gap >= least) continue;
      least = gap;
      ContactPoint p{line.patch_a, line.patch_b, {}, line.contact.gaps[i], true};
      for (std::size_t k = 0; k < 4; ++k) p.x[k] = (1 - t) * path[i][k] + t * path[i + 1][k];
      nearest = p;
    }
  }
  return nearest;
}

}  // namespace

Point4 in_patches(const SurfaceCells& a, const SurfaceCells& b, int from_a, int from_b,
                  const Point4& x, const ContactPoint& to) {
  return {x[0] + a.span_u(from_a) - a.span_u(to.patch_a),
          x[1] + a.span_v(from_a) - a.span_v(to.patch_a),
          x[2] + b.span_u(from_b) - b.span_u(to.patch_b),
          x[3] + b.span_v(from_b) - b.span_v(to.patch_b)};
}

bool in_contact(SurfaceCells& a, SurfaceCells& b, const ContactPoint& p, const ContactPoint& q,
                double tolerance) {
  const Point4 end = in_patches(a, b, q.patch_a, q.patch_b, q.x, p);
  const auto &patch_a = a.tree(p.patch_a).patch(), &patch_b = b.tree(p.patch_b).patch();
  for (const double t : {0.25, 0.5, 0.75}) {
    Point4 x;
    for (std::size_t k = 0; k < 4; ++k) x[k] = (1 - t) * p.x[k] + t * end[k];
    const auto foot = foot_point(patch_a, patch_b, x, kPolishReach);
    if (!foot || std::abs(signed_gap(patch_a, patch_b, *foot)) > kAttachGap * tolerance)
      return false;
  }
  return true;
}

void drop_beside_contacts(PairSearchResult& found, SurfaceCells& a, SurfaceCells& b,
                          double tolerance) {
  std::erase_if(found.critical, [&](const CriticalPair& pair) {
    if (!pair.beside) return false;
    const ContactPoint start{pair.patch_a, pair.patch_b, *pair.beside};
    const Vec3 x = jet_at(a.tree(pair.patch_a).patch(), start.x[0], start.x[1], 1).point;
    const auto goal = nearest_on_lines(found, a, x);
    return goal && in_contact(a, b, start, *goal, tolerance);
  });
}

}  // namespace blossom
