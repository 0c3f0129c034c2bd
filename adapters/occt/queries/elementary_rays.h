// SPDX-License-Identifier: LGPL-2.1-or-later
// Lines against faces of planes, cylinders, spheres and tori, in closed form.

#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <GeomAdaptor_Surface.hxx>
#include <TopoDS_Face.hxx>

#include "adapters/occt/faces/face_trims.h"
#include "core/math/vec.h"
#include "core/rays/ray.h"

namespace blossom::occt {

/// A face made ready for single rays.
class ElementaryFace {
 public:
  struct Hit {
    double parameter = 0;  ///< of the ray
    Vec3 normal;           ///< turned as the face is
  };

  /// tolerance   within which a hit is on a wire, model units
  /// returns     null for faces of other surfaces
  /// throws      BadModel as `face_trims`
  static std::unique_ptr<ElementaryFace> of(const TopoDS_Face& face, double tolerance);

  /// Where the ray crosses the face, in no order; nothing if that is not certain: a hit may be on a
  /// wire, or the ray is nearly tangent to the surface. All that is said is proven but for
  /// roundings, for which there is room in the margins.
  std::optional<std::vector<Hit>> hits(const Ray& ray) const;

 private:
  ElementaryFace(const TopoDS_Face& face, GeomAdaptor_Surface surface, double tolerance);

  enum class Place { Inside, Outside, Near };
  struct Turns {
    std::array<double, 3> values{};
    std::size_t count = 0;
  };
  std::optional<std::vector<double>> crossings(const Ray& ray) const;
  Vec2 parameters(const gp_Pnt& point) const;
  Turns turns(double parameter, int k) const;
  Place place(const Vec2& uv, const Vec2& speeds) const;

  GeomAdaptor_Surface surface_;
  FaceTrims trims_;
  bool reversed_ = false;
  double tolerance_ = 0;
  double reach_ = 0;  // model units: no hit is certain that is as near to a wire
};

}  // namespace blossom::occt
