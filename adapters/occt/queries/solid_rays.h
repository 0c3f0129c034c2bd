// SPDX-License-Identifier: LGPL-2.1-or-later
// Whether points lie inside of a solid, by single rays: only the faces that a ray may meet are made
// ready for it.

#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include <TopoDS_Face.hxx>

#include "adapters/occt/queries/elementary_rays.h"
#include "adapters/occt/ray_casting.h"
#include "core/bounds/box_tree.h"
#include "core/math/vec.h"

namespace blossom::occt {

/// Directions that no model prefers, to try one after the other: some rays hit edges.
inline constexpr std::array<Vec3, 9> kRayDirections{{{0.577, 0.211, 0.789},
                                                     {-0.381, 0.907, 0.179},
                                                     {0.131, -0.617, -0.776},
                                                     {-0.709, -0.503, 0.494},
                                                     {0.887, -0.337, 0.316},
                                                     {0.271, 0.653, -0.707},
                                                     {-0.953, 0.283, -0.109},
                                                     {-0.163, -0.941, 0.296},
                                                     {0.449, 0.097, -0.888}}};

/// What may be asked about faces that have closed forms: these alone, or also what searches, and so
/// takes long to be made ready, where they are in doubt.
enum class RayMeans { ClosedForms, All };

class SolidRays {
 public:
  /// faces      all of the solid's
  /// tolerance  model units
  /// throws     BadModel if a face has no surface; the questions, if one that a ray may meet cannot
  ///            be converted
  SolidRays(std::vector<TopoDS_Face> faces, double tolerance);

  /// Whether the ray leaves the solid as often as it has to from inside; nothing if it comes within
  /// tolerance of an edge, is tangent or starts on a face, or a hit is not proven.
  std::optional<bool> is_inside(const Vec3& point, const Vec3& direction,
                                RayMeans means = RayMeans::All);

  /// The same by the first of kRayDirections that tells, by closed forms if any does.
  std::optional<bool> is_inside(const Vec3& point);

  /// Whether the faces are turned outwards where the line leaves the solid for good; nothing as
  /// above, or if it meets none.
  std::optional<bool> leaves(const Vec3& point, const Vec3& direction);

 private:
  /// Calls `found(hit)` for all hits, in no order; false if one is not certain.
  template <class Found>
  bool for_each_hit(const Ray& ray, RayMeans means, Found found);
  using Hits = std::optional<std::vector<ElementaryFace::Hit>>;  // nothing if one is not certain
  Hits hits_of(std::size_t face, const Ray& ray, RayMeans means);

  std::vector<TopoDS_Face> faces_;
  double tolerance_;
  BoxTree tree_;
  // One for each face, made when asked for: in closed form, and what answers where that cannot.
  struct Rayed {
    bool known = false;  // whether the surface is an elementary one
    std::unique_ptr<ElementaryFace> elementary;
    std::unique_ptr<ShapeRays> rays;
  };
  std::vector<Rayed> rayed_;
};

}  // namespace blossom::occt
