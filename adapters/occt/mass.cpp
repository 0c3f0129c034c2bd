// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/mass.h"

#include <cmath>

#include <Bnd_Box.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/base/shared_limit.h"
#include "adapters/occt/convert/hulls.h"
#include "adapters/occt/faces/area.h"
#include "adapters/occt/trim_tool.h"

namespace blossom::occt {
namespace {

constexpr const char* kWork = "measuring the mass";

using Tensor = Vec<double, 6>;  // xx, yy, zz, xy, xz, yz

// Of a point mass at d, times `factor`: the integrals of r r^T.
Tensor squares(const Vec3& d, double factor) {
  return {factor * d[0] * d[0], factor * d[1] * d[1], factor * d[2] * d[2],
          factor * d[0] * d[1], factor * d[0] * d[2], factor * d[1] * d[2]};
}

Tensor inertia_of(const Tensor& second) {
  const auto& [xx, yy, zz, xy, xz, yz] = second.coordinates;
  return {yy + zz, xx + zz, xx + yy, -xy, -xz, -yz};
}

void measure_solid(const TopoDS_Shape& solid, const WorkLimit* limit, Mass& mass) {
  const Vec3 apex = middle_of(solid);  // amid the body, so that cones from there are small
  Vec3 first;
  Tensor second;
  for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) {
    check_limit(limit, kWork);
    const ConeMoments cone = cone_moments(TopoDS::Face(it.Current()), apex);
    mass.volume += cone.volume;
    first += cone.first;
    second += cone.second;
  }
  if (mass.volume == 0) return;
  const Vec3 from_apex = first * (1 / mass.volume);
  mass.centre = apex + from_apex;
  second += squares(from_apex, -mass.volume);
  mass.inertia = inertia_of(second);
}

void measure_surface(const TopoDS_Shape& surface, const WorkLimit* limit, Mass& mass) {
  const Vec3 origin = middle_of(surface);
  Vec3 moment;
  for (TopExp_Explorer it(surface, TopAbs_FACE); it.More(); it.Next()) {
    check_limit(limit, kWork);
    moment += area_moment(TopoDS::Face(it.Current()), origin);
  }
  if (mass.area > 0) mass.centre = origin + moment * (1 / mass.area);
}

}  // namespace

Mass& Mass::operator+=(const Mass& other) {
  const double own = is_solid ? volume : area, its = other.is_solid ? other.volume : other.area;
  if (its == 0) return *this;
  const Vec3 common = (centre * own + other.centre * its) * (1 / (own + its));
  inertia += other.inertia;
  if (is_solid) {
    inertia += inertia_of(squares(centre - common, own));
    inertia += inertia_of(squares(other.centre - common, its));
  }
  centre = common;
  area += other.area;
  volume += other.volume;
  return *this;
}

Mass mass_of(const TopoDS_Shape& body, const WorkLimit* limit) {
  Mass mass;
  for (TopExp_Explorer it(body, TopAbs_FACE); it.More(); it.Next()) {
    check_limit(limit, kWork);
    mass.area += std::abs(area(TopoDS::Face(it.Current())));
  }
  mass.is_solid = body.ShapeType() == TopAbs_SOLID && is_closed_solid(body);
  if (mass.is_solid)
    measure_solid(body, limit, mass);
  else
    measure_surface(body, limit, mass);
  return mass;
}

}  // namespace blossom::occt
