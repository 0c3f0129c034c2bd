// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/queries/section_frame.h"

#include <algorithm>
#include <cmath>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <gp_Ax3.hxx>
#include <gp_Pln.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "core/forms/spans/homogeneous.h"
#include "core/math/roundoff.h"

namespace blossom::occt {
namespace {

constexpr double kRounding = 16 * kUnitRoundoff;  // of a height, relative to the coordinates
constexpr double kMargin = 0.05;  // of a box's diagonal: so far the rectangle goes beyond it

void add(const Vec3& p, const SectionFrame& frame, Heights& heights) {
  const double height = frame.height(p);
  heights.low = std::min(heights.low, height);
  heights.high = std::max(heights.high, height);
  heights.margin = std::max(heights.margin, frame.rounding(p));
  heights.box = joined(heights.box, {p, p});
}

void add(const Vec4& point, const SectionFrame& frame, Heights& heights) {
  add(head(point) * (1 / point[3]), frame, heights);
}

}  // namespace

SectionFrame::SectionFrame(const Plane& plane) : origin_(plane.point) {
  const double largest = max_norm(plane.normal);
  double sum = 0;  // finite if and only if all are, or nearly as large as doubles get
  for (int k = 0; k < 3; ++k) sum += plane.normal[k] + plane.point[k];
  if (!(largest > 0) || !std::isfinite(sum))
    throw BadModel("the plane has no direction, or a number of it is not finite");
  normal_ = unit(plane.normal * (1 / largest));
  int least = 0;
  for (int k = 1; k < 3; ++k)
    if (std::abs(normal_[k]) < std::abs(normal_[least])) least = k;
  Vec3 axis;
  axis[least] = 1;
  x_ = unit(cross(axis, normal_));
  y_ = cross(normal_, x_);
}

double SectionFrame::rounding(const Vec3& p) const {
  return kRounding * (max_norm(p) + max_norm(origin_));
}

SectionFrame::Rectangle SectionFrame::rectangle_over(const Box& box) const {
  const Vec3 middle = 0.5 * (box.low + box.high) - origin_;
  const double r = (0.5 + kMargin) * diagonal(box);
  const double u = dot(middle, x_), v = dot(middle, y_);
  return {{u - r, u + r}, {v - r, v + r}};
}

TopoDS_Face SectionFrame::face_over(const Box& box) const {
  const auto [u, v] = rectangle_over(box);
  const gp_Pln plane(gp_Ax3(pnt(origin_), dir(normal_), dir(x_)));
  return BRepBuilderAPI_MakeFace(plane, u.from, u.to, v.from, v.to);
}

BezierSurface SectionFrame::over(const Box& box) const {
  const auto [u, v] = rectangle_over(box);
  BezierSurface surface;
  surface.u_knots = {u.from, u.to};
  surface.v_knots = {v.from, v.to};
  surface.patches = Grid<RationalBezierPatch>(1, 1);
  Grid<Vec4> net(2, 2);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      net(i, j) = with_weight(origin_ + surface.u_knots[static_cast<std::size_t>(i)] * x_ +
                                  surface.v_knots[static_cast<std::size_t>(j)] * y_,
                              1);
  surface.patches(0, 0).points = std::move(net);
  return surface;
}

Heights heights_of(const BezierSurface& surface, const SectionFrame& frame) {
  Heights heights;
  for (const RationalBezierPatch& patch : surface.patches.values())
    for (const Vec4& p : patch.points.values()) add(p, frame, heights);
  heights.margin += surface.error;
  return heights;
}

Heights heights_of(const CurveSpans& curve, const SectionFrame& frame) {
  Heights heights;
  for (const CurveSpan& span : curve.spans)
    for (const Vec4& p : span.curve.points) add(p, frame, heights);
  heights.margin += curve.error;
  return heights;
}

Heights heights_of(const HullBound& hull, const SectionFrame& frame) {
  Heights heights;
  for (const Vec3& p : hull.points) add(p, frame, heights);
  heights.margin += 2 * hull.margin;  // of each coordinate; a height has at most sqrt(3) of it
  return heights;
}

}  // namespace blossom::occt
