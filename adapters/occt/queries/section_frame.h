// SPDX-License-Identifier: LGPL-2.1-or-later
// A plane with coordinates of its own, and how forms lie to it. For the plane section only.

#pragma once

#include <TopoDS_Face.hxx>

#include "adapters/occt/plane_section.h"
#include "core/base/unbounded.h"
#include "core/bounds/box_tree.h"
#include "core/distance.h"
#include "core/forms/curve_spans.h"
#include "core/forms/surface.h"
#include "core/math/interval.h"

namespace blossom::occt {

class SectionFrame {
 public:
  /// throws   BadModel if the normal is zero or a number is not finite
  explicit SectionFrame(const Plane& plane);

  const Vec3& normal() const { return normal_; }

  /// Signed distance from the plane, model units.
  double height(const Vec3& p) const { return dot(normal_, p - origin_); }

  /// Bound on the rounding of a height.
  double rounding(const Vec3& p) const;

  /// The rectangle of the plane that a box may meet, and a little more; its parameters are the
  /// plane's coordinates, model units.
  BezierSurface over(const Box& box) const;

  /// The same as a face.
  TopoDS_Face face_over(const Box& box) const;

 private:
  struct Rectangle {
    Interval u, v;
  };
  Rectangle rectangle_over(const Box& box) const;

  Vec3 origin_, normal_, x_, y_;
};

/// The heights of control points: what is in their hull lies between them.
struct Heights {
  double low = kInfinity;
  double high = -kInfinity;
  double margin = 0;  ///< roundings, and the error of the form
  Box box;            ///< of the points

  bool apart(double tolerance) const {
    return low > tolerance + margin || high < -tolerance - margin;
  }
  bool within(double tolerance) const {
    return low >= -tolerance - margin && high <= tolerance + margin;
  }
};

Heights heights_of(const BezierSurface& surface, const SectionFrame& frame);
Heights heights_of(const CurveSpans& curve, const SectionFrame& frame);
Heights heights_of(const HullBound& hull, const SectionFrame& frame);

}  // namespace blossom::occt
