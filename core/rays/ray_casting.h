// SPDX-License-Identifier: LGPL-2.1-or-later
// Rays and lines against surfaces: all hits or the first one, each proven or marked.
//
// Surfaces are cut into nearly flat cells where rays come near, and what is cut is kept. A ray
// visits a few cells, and in most of them one bound and three steps of Newton's method settle it.
// No hit is left out: where roundings or the tolerance leave a question, the hit says so by its
// status.

#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/base/tolerances.h"
#include "core/bounds/box_tree.h"
#include "core/forms/surface.h"
#include "core/rays/flat_cells.h"
#include "core/rays/line_search.h"
#include "core/rays/ray.h"

namespace blossom {

/// Decides whether a hit counts, as trims do; it may mark the hit.
using HitFilter = std::function<bool(RayHit&)>;

/// Surfaces made ready for rays. Any number of threads may use one, each by its own RayQuery.
class RayCaster {
 public:
  /// reaches  one for each surface: how far beyond its borders it counts, model units; empty
  ///          stands for the tolerance
  /// throws   InvalidInput if there is no surface, one is not well formed, the tolerance is not
  ///          positive, or the numbers of surfaces and reaches differ
  explicit RayCaster(std::vector<BezierSurface> surfaces, const Tolerances& tolerances = {},
                     std::vector<double> reaches = {});

  /// All hits by increasing parameter. A point on a border that patches share is one hit, and so
  /// are a stretch within tolerance and what meets it.
  /// throws   InvalidInput if a number is not finite (ends of the ray may be infinite), the
  ///          direction is zero or from > to
  std::vector<RayHit> all_hits(const Ray& ray) const;

  /// The hits up to the first one that is proven: one, unless undecided ones come before it.
  std::vector<RayHit> first_hits(const Ray& ray) const;

  /// `all_hits`, or `first_hits`, of many rays, on all processors.
  std::vector<std::vector<RayHit>> all_hits(std::span<const Ray> rays) const;
  std::vector<std::vector<RayHit>> first_hits(std::span<const Ray> rays) const;

  const FlatCells& cells() const { return cells_; }

 private:
  friend class RayQuery;

  FlatCells cells_;
  BoxTree tree_;
  double tolerance_;
};

/// One ray after the other, without allocation once the buffers have grown.
class RayQuery {
 public:
  /// caster   lives as long as this
  explicit RayQuery(const RayCaster& caster);

  /// As those of RayCaster. The hits are valid until the next question.
  /// accept   called for each hit before equal ones are joined; empty accepts all
  std::span<const RayHit> all_hits(const Ray& ray, const HitFilter& accept = {});
  std::span<const RayHit> first_hits(const Ray& ray, const HitFilter& accept = {});

 private:
  void collect(const Ray& ray, const HitFilter& accept, bool first_only);
  void keep(std::size_t from, const Ray& ray, const HitFilter& accept);

  const RayCaster& caster_;
  LineSearch search_;
  std::vector<RayHit> hits_;
};

/// Joins hits that are one: the same root seen from two sides of a border, contacts that touch,
/// and what lies on the ends of a stretch. By increasing parameter.
/// speed      length of the ray's direction
void join_hits(std::vector<RayHit>& hits, double speed, double tolerance);

}  // namespace blossom
