// SPDX-License-Identifier: LGPL-2.1-or-later
// Rays against whole shapes: faces within their trims, hits on edges and vertices by name.

#pragma once

#include <memory>
#include <span>
#include <vector>

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "adapters/occt/base/shared_limit.h"
#include "core/base/tolerances.h"
#include "core/rays/ray_casting.h"

namespace blossom::occt {

struct ShapeHit {
  /// With the face's index as the surface, the face's own parameters, and the normal turned as the
  /// face is. Complete as in the core, and inside of the trims or within tolerance of an edge.
  /// Tolerance is also a hit outside of the trims that the tolerance of an edge still covers.
  RayHit hit;
  TopoDS_Shape on;  ///< the edge or vertex within tolerance of it; null inside of a face
};

/// Faces made ready for rays. Any number of threads may use one.
class ShapeRays {
 public:
  /// tolerance  within which a hit is on an edge or vertex, model units
  /// limit      of making them ready; null: none
  /// throws     BadModel if there is no face or one cannot be used, InvalidInput if the tolerance
  ///            is not positive, LimitFailure
  explicit ShapeRays(const std::vector<TopoDS_Face>& faces, double tolerance = Tolerances{}.point,
                     const WorkLimit* limit = nullptr);
  explicit ShapeRays(const TopoDS_Shape& shape, double tolerance = Tolerances{}.point);
  ~ShapeRays();
  ShapeRays(ShapeRays&&) noexcept;
  ShapeRays& operator=(ShapeRays&&) noexcept;

  /// As those of RayCaster: by increasing parameter; a point of an edge or vertex that faces share
  /// is one hit.
  std::vector<ShapeHit> all_hits(const Ray& ray) const;
  std::vector<ShapeHit> first_hits(const Ray& ray) const;

  /// Many rays, on all processors.
  std::vector<std::vector<ShapeHit>> all_hits(std::span<const Ray> rays) const;
  std::vector<std::vector<ShapeHit>> first_hits(std::span<const Ray> rays) const;

  const std::vector<TopoDS_Face>& faces() const;

 private:
  friend class ShapeRayQuery;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// One ray after the other, without allocation once the buffers have grown.
class ShapeRayQuery {
 public:
  /// rays   lives as long as this
  explicit ShapeRayQuery(const ShapeRays& rays);
  ShapeRayQuery(const ShapeRayQuery&) = delete;
  ShapeRayQuery& operator=(const ShapeRayQuery&) = delete;

  /// Valid until the next question.
  std::span<const ShapeHit> all_hits(const Ray& ray);
  std::span<const ShapeHit> first_hits(const Ray& ray);

 private:
  bool accept(const Ray& ray, RayHit& hit);
  bool clip_stretch(const Ray& ray, RayHit& hit);
  bool is_repeated(const Ray& ray, std::size_t index) const;
  std::span<const ShapeHit> finished(const Ray& ray, std::span<const RayHit> hits, bool first_only);

  const ShapeRays::Impl& rays_;
  RayQuery query_;
  Ray ray_;
  HitFilter filter_;
  std::vector<RayHit> raw_;
  std::vector<RayHit> more_;  // further pieces of stretches that trims cut
  std::vector<ShapeHit> hits_;
};

}  // namespace blossom::occt
