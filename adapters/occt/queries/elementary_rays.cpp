// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/queries/elementary_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <BRep_Tool.hxx>
#include <ElSLib.hxx>
#include <Geom_Surface.hxx>
#include <gp_Ax3.hxx>

#include "adapters/occt/base/points.h"
#include "core/math/functions/polynomial.h"
#include "core/plane/planar_curves.h"
#include "core/topology/face_trims.h"

namespace blossom::occt {
namespace {

// |sin| of the angle between ray and surface. Below it, a hit is left to others; above, what is off
// the surface by some distance is off the hit by less than a thousand times that.
constexpr double kMinSine = 1e-3;
// In tolerances of wires and points: hits are known within one, and so are wires; chart lengths of
// cylinders are right to a factor of 1.42.
constexpr double kReach = 2;
// How many times shorter than in the chart a length on the surface may be; more so near poles.
constexpr double kMaxStretch = 4;
constexpr int kHalvings = 24;  // of wires, as for points in face_trims.cpp
// Of the coefficients of a quartic, whose sums have some twenty roundings.
constexpr double kQuarticRounding = 1e-14;

using Roots = std::optional<std::vector<double>>;

// A line in the axes of a surface, by arc length from its point nearest to the origin; and what of
// the ray's parameter that is.
struct LocalLine {
  Vec3 point, direction;
  double origin = 0;  // of the ray, along the line
  double speed = 0;   // of the ray

  LocalLine(const Ray& ray, const gp_Ax3& axes) : speed(norm(ray.direction)) {
    const std::array<Vec3, 3> frame{vec(axes.XDirection().XYZ()), vec(axes.YDirection().XYZ()),
                                    vec(axes.Direction().XYZ())};
    const Vec3 from = ray.origin - vec(axes.Location()), along = (1 / speed) * ray.direction;
    for (int k = 0; k < 3; ++k) {
      point[k] = dot(from, frame[static_cast<std::size_t>(k)]);
      direction[k] = dot(along, frame[static_cast<std::size_t>(k)]);
    }
    origin = dot(point, direction);
    point = point - origin * direction;
  }
  double parameter(double length) const { return (length - origin) / speed; }
};

Roots plane_roots(const LocalLine& line) {
  if (std::abs(line.direction[2]) < kMinSine) return {};
  return std::vector{line.parameter(-line.point[2] / line.direction[2])};
}

// Of a circle in the plane of x and y, which the line's image meets at a distance from the centre.
// per_length   of the image, by the line's
Roots circle_roots(const LocalLine& line, double middle, double distance, double radius,
                   double per_length) {
  if (distance > (1 + kMinSine) * radius) return std::vector<double>{};
  const double half = std::sqrt(std::max(0.0, (radius - distance) * (radius + distance)));
  if (half * per_length < kMinSine * radius) return {};
  return std::vector{line.parameter(middle - half / per_length),
                     line.parameter(middle + half / per_length)};
}

Roots cylinder_roots(const LocalLine& line, double radius) {
  const Vec2 p{line.point[0], line.point[1]}, d{line.direction[0], line.direction[1]};
  const double square = dot(d, d);
  if (square < kMinSine * kMinSine) return {};
  const double per_length = std::sqrt(square);
  return circle_roots(line, -dot(p, d) / square, std::abs(cross(p, d)) / per_length, radius,
                      per_length);
}

Roots sphere_roots(const LocalLine& line, double radius) {
  return circle_roots(line, 0, norm(line.point), radius, 1);
}

// (x^2 + R^2 - r^2)^2 = 4 R^2 (x_0^2 + x_1^2), where |x| <= R + r: that is the unit here.
Roots torus_roots(const LocalLine& line, double major, double minor) {
  const double size = (1 + kMinSine) * (major + minor), nearest = norm(line.point) / size;
  if (minor > (1 - kMinSine) * major) return {};  // it touches or meets itself
  if (nearest > 1) return std::vector<double>{};
  const double ring = major / size, tube = minor / size;
  const double square = nearest * nearest, k = square + ring * ring - tube * tube;
  const double z = line.point[2] / size, slope = line.direction[2], four = 4 * ring * ring;
  const Polynomial quartic{k * k - four * (square - z * z), four * 2 * z * slope,
                           2 * k - four * (1 - slope * slope), 0, 1};
  double sum = 0;
  for (const double c : quartic) sum += std::abs(c);
  const double error = kQuarticRounding * (1 + sum);
  const auto found = isolated_roots(quartic, error, 4 * error, -1, 1);
  if (!found) return {};
  std::vector<double> roots;
  for (const IsolatedRoot& root : *found) roots.push_back(line.parameter(size * root.t));
  return roots;
}

// Whether hits on surfaces of this kind can be told.
bool is_elementary(GeomAbs_SurfaceType type) {
  return type == GeomAbs_Plane || type == GeomAbs_Cylinder || type == GeomAbs_Sphere ||
         type == GeomAbs_Torus;
}

}  // namespace

std::unique_ptr<ElementaryFace> ElementaryFace::of(const TopoDS_Face& face, double tolerance) {
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  if (surface.IsNull()) return nullptr;
  GeomAdaptor_Surface adaptor(surface);
  if (!is_elementary(adaptor.GetType())) return nullptr;
  return std::unique_ptr<ElementaryFace>(new ElementaryFace(face, std::move(adaptor), tolerance));
}

ElementaryFace::ElementaryFace(const TopoDS_Face& face, GeomAdaptor_Surface surface,
                               double tolerance)
    : surface_(std::move(surface)),
      trims_(face_trims(face)),
      reversed_(face.Orientation() == TopAbs_REVERSED),
      tolerance_(tolerance) {
  double loose = tolerance;
  for (const auto& loop : trims_.loops)
    for (const Coedge& coedge : loop) loose = std::max(loose, coedge.tolerance);
  reach_ = kReach * (tolerance + loose) + trims_.largest_gap;
}

Roots ElementaryFace::crossings(const Ray& ray) const {
  switch (surface_.GetType()) {
    case GeomAbs_Plane: return plane_roots({ray, surface_.Plane().Position()});
    case GeomAbs_Cylinder: {
      const gp_Cylinder cylinder = surface_.Cylinder();
      return cylinder_roots({ray, cylinder.Position()}, cylinder.Radius());
    }
    case GeomAbs_Sphere: {
      const gp_Sphere sphere = surface_.Sphere();
      return sphere_roots({ray, sphere.Position()}, sphere.Radius());
    }
    default: {
      const gp_Torus torus = surface_.Torus();
      return torus_roots({ray, torus.Position()}, torus.MajorRadius(), torus.MinorRadius());
    }
  }
}

Vec2 ElementaryFace::parameters(const gp_Pnt& point) const {
  Vec2 uv;
  switch (surface_.GetType()) {
    case GeomAbs_Plane: ElSLib::Parameters(surface_.Plane(), point, uv[0], uv[1]); break;
    case GeomAbs_Cylinder: ElSLib::Parameters(surface_.Cylinder(), point, uv[0], uv[1]); break;
    case GeomAbs_Sphere: ElSLib::Parameters(surface_.Sphere(), point, uv[0], uv[1]); break;
    default: ElSLib::Parameters(surface_.Torus(), point, uv[0], uv[1]); break;
  }
  return uv;
}

// The values of a chart coordinate, whole periods apart, that may lie in the trims or beside them.
ElementaryFace::Turns ElementaryFace::turns(double parameter, int k) const {
  const double x = parameter * trims_.scale[k], period = trims_.period[k];
  if (period == 0) return {{x}, 1};
  const double first = x - std::floor((x - trims_.box.low[k]) / period) * period;
  return {{first, first - period, first + period}, 3};
}

// speeds   of the surface's parameter lines at the point, which are orthogonal
ElementaryFace::Place ElementaryFace::place(const Vec2& uv, const Vec2& speeds) const {
  double margin = reach_;
  for (int k = 0; k < 2; ++k) {
    if (kMaxStretch * speeds[k] < trims_.scale[k]) return Place::Near;
    margin = std::max(margin, reach_ * trims_.scale[k] / speeds[k]);
  }
  const Turns along_u = turns(uv[0], 0), along_v = turns(uv[1], 1);
  bool inside = false;
  for (std::size_t i = 0; i < along_u.count; ++i)
    for (std::size_t j = 0; j < along_v.count; ++j) {
      const Vec2 point{along_u.values[i], along_v.values[j]};
      if (coedge_near(trims_, {point, point}, margin, kHalvings) != nullptr) return Place::Near;
      inside = inside || is_inside(trims_, point);
    }
  return inside ? Place::Inside : Place::Outside;
}

std::optional<std::vector<ElementaryFace::Hit>> ElementaryFace::hits(const Ray& ray) const {
  const Roots all = crossings(ray);
  if (!all) return {};
  const double speed = norm(ray.direction), slack = reach_ / speed;
  std::vector<Hit> found;
  for (const double t : *all) {
    if (t < ray.from - slack || t > ray.to + slack) continue;
    const gp_Pnt point = pnt(point_at(ray, t));
    const Vec2 uv = parameters(point);
    gp_Pnt on_surface;
    gp_Vec du, dv;
    surface_.D1(uv[0], uv[1], on_surface, du, dv);
    if (point.Distance(on_surface) > kMinSine * tolerance_) return {};
    const Place where = place(uv, {du.Magnitude(), dv.Magnitude()});
    if (where == Place::Outside) continue;
    const Vec3 normal = unit(vec(du.Crossed(dv).XYZ()));
    if (where == Place::Near || std::abs(dot(normal, ray.direction)) < kMinSine * speed) return {};
    found.push_back({t, reversed_ ? -normal : normal});
  }
  return found;
}

}  // namespace blossom::occt
