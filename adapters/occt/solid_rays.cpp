// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/solid_rays.h"

#include <cstddef>
#include <limits>
#include <utility>

#include "adapters/occt/face_list.h"

namespace blossom::occt {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

}  // namespace

SolidRays::SolidRays(std::vector<TopoDS_Face> faces, double tolerance)
    : faces_(std::move(faces)),
      tolerance_(tolerance),
      tree_(FaceList(faces_, "", tolerance, Extent::Trims).boxes()),
      rays_(faces_.size()) {}

const ShapeRays& SolidRays::rays_of(std::size_t face) {
  if (!rays_[face])
    rays_[face] = std::make_unique<ShapeRays>(std::vector{faces_[face]}, tolerance_);
  return *rays_[face];
}

// A hit beside an edge of two faces may be one of each of them, so no edge is to be near.
template <class Found>
bool SolidRays::for_each_hit(const Ray& ray, Found found) {
  bool certain = true;
  tree_.for_each_along({ray.origin, ray.direction, ray.from, ray.to}, [&](int face, double) {
    for (const ShapeHit& hit : rays_of(static_cast<std::size_t>(face)).all_hits(ray)) {
      certain = certain && hit.hit.status == Status::Complete && !hit.hit.grazing &&
                hit.hit.mark == 0 && hit.on.IsNull() && hit.hit.first == hit.hit.last;
      found(hit.hit);
    }
    return certain ? kEndless : -kEndless;
  });
  return certain;
}

std::optional<bool> SolidRays::is_inside(const Vec3& point, const Vec3& direction) {
  std::size_t count = 0;
  bool starts_on_a_face = false;
  const double reach = tolerance_ / norm(direction);
  const bool certain = for_each_hit({point, direction, -reach}, [&](const RayHit& hit) {
    starts_on_a_face = starts_on_a_face || hit.parameter <= reach;
    ++count;
  });
  if (!certain || starts_on_a_face) return std::nullopt;
  return count % 2 == 1;
}

std::optional<bool> SolidRays::leaves(const Vec3& point, const Vec3& direction) {
  RayHit last;
  last.parameter = -kEndless;
  const bool certain =
      for_each_hit({point, direction, -kEndless, kEndless}, [&](const RayHit& hit) {
        if (hit.parameter > last.parameter) last = hit;
      });
  if (!certain || last.parameter == -kEndless) return std::nullopt;
  return dot(last.normal, direction) > 0;
}

}  // namespace blossom::occt
