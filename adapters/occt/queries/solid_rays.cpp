// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/queries/solid_rays.h"

#include <cstddef>
#include <utility>

#include "adapters/occt/faces/face_list.h"
#include "core/base/unbounded.h"

namespace blossom::occt {
namespace {

// A hit beside an edge of two faces may be one of each of them, so no edge is to be near. Away from
// edges a surface and one that stands for it are met as often as each other, but for pairs of hits.
std::optional<std::vector<ElementaryFace::Hit>> certain(const std::vector<ShapeHit>& all) {
  std::vector<ElementaryFace::Hit> hits;
  for (const auto& [hit, on] : all) {
    const bool is_proven = hit.status == Status::Complete || hit.approximate;
    if (!is_proven || hit.grazing || hit.mark != 0 || !on.IsNull() || hit.first != hit.last)
      return {};
    hits.push_back({hit.parameter, hit.normal});
  }
  return hits;
}

}  // namespace

SolidRays::SolidRays(std::vector<TopoDS_Face> faces, double tolerance)
    : faces_(std::move(faces)),
      tolerance_(tolerance),
      tree_(FaceList(faces_, "", tolerance, Extent::Trims).boxes()),
      rayed_(faces_.size()) {}

SolidRays::Hits SolidRays::hits_of(std::size_t face, const Ray& ray, RayMeans means) {
  Rayed& of = rayed_[face];
  if (!of.known) of.elementary = ElementaryFace::of(faces_[face], tolerance_);
  of.known = true;
  if (of.elementary) {
    Hits hits = of.elementary->hits(ray);
    if (hits || means == RayMeans::ClosedForms) return hits;
  }
  if (!of.rays) of.rays = std::make_unique<ShapeRays>(std::vector{faces_[face]}, tolerance_);
  return certain(of.rays->all_hits(ray));
}

template <class Found>
bool SolidRays::for_each_hit(const Ray& ray, RayMeans means, Found found) {
  bool certain = true;
  tree_.for_each_along({ray.origin, ray.direction, ray.from, ray.to}, [&](int face, double) {
    const Hits hits = hits_of(static_cast<std::size_t>(face), ray, means);
    certain = certain && hits.has_value();
    if (hits)
      for (const ElementaryFace::Hit& hit : *hits) found(hit);
    return certain ? kInfinity : -kInfinity;
  });
  return certain;
}

std::optional<bool> SolidRays::is_inside(const Vec3& point, const Vec3& direction, RayMeans means) {
  std::size_t count = 0;
  bool starts_on_a_face = false;
  const double reach = tolerance_ / norm(direction);
  const bool certain =
      for_each_hit({point, direction, -reach}, means, [&](const ElementaryFace::Hit& hit) {
        starts_on_a_face = starts_on_a_face || hit.parameter <= reach;
        ++count;
      });
  if (!certain || starts_on_a_face) return std::nullopt;
  return count % 2 == 1;
}

std::optional<bool> SolidRays::is_inside(const Vec3& point) {
  for (const RayMeans means : {RayMeans::ClosedForms, RayMeans::All})
    for (const Vec3& direction : kRayDirections)
      if (const std::optional<bool> inside = is_inside(point, direction, means)) return inside;
  return std::nullopt;
}

std::optional<bool> SolidRays::leaves(const Vec3& point, const Vec3& direction) {
  ElementaryFace::Hit last{-kInfinity, {}};
  const bool certain = for_each_hit({point, direction, -kInfinity, kInfinity}, RayMeans::All,
                                    [&](const ElementaryFace::Hit& hit) {
                                      if (hit.parameter > last.parameter) last = hit;
                                    });
  if (!certain || last.parameter == -kInfinity) return std::nullopt;
  return dot(last.normal, direction) > 0;
}

}  // namespace blossom::occt
