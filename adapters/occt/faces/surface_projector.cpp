// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/faces/surface_projector.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <BRep_Tool.hxx>
#include <ElSLib.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/surfaces_detail.h"

namespace blossom::occt {
namespace {

constexpr int kNewtonSteps = 4;       // from a foot that was searched for
constexpr int kMostNewtonSteps = 16;  // from another place; fewer where they come no nearer
constexpr double kSeam = 1e-9;        // of the parameters' range: so near a seam is on it

// The point that a border of a surface is; none if it has a length, lies at infinity, or has no
// points at all, as some offsets.
std::optional<Vec3> one_point(const std::function<gp_Pnt(double)>& border, const Interval& along,
                              double value) {
  for (const double end : {along.from, along.to, value})
    if (Precision::IsInfinite(end)) return std::nullopt;
  try {
    const gp_Pnt first = border(along.from);
    for (const double part : {0.2, 0.4, 0.6, 0.8})
      if (first.Distance(border(at(along, part))) > Precision::Confusion()) return std::nullopt;
    return vec(first);
  } catch (const Standard_Failure&) {
    return std::nullopt;
  }
}

}  // namespace

Vec2 chart_step(const SurfaceJet& at, const Vec3& step) {
  const Vec3 area = cross(at.du, at.dv);
  const double square = dot(area, area);
  if (!(square > 0)) return {};
  return {dot(cross(step, at.dv), area) / square, dot(cross(at.du, step), area) / square};
}

SurfaceJet frame_at(const Handle(Geom_Surface) & surface, const Vec2& uv) {
  gp_Pnt p;
  gp_Vec du, dv;
  surface->D1(uv[0], uv[1], p, du, dv);
  return {vec(p), vec(du), vec(dv)};
}

SurfaceBend bend_at(const Handle(Geom_Surface) & surface, const Vec2& uv) {
  gp_Pnt p;
  gp_Vec du, dv, uu, vv, both;
  surface->D2(uv[0], uv[1], p, du, dv, uu, vv, both);
  return {vec(uu), vec(both), vec(vv)};
}

std::vector<SurfacePole> poles_of(const Handle(Geom_Surface) & surface) {
  const GeomAdaptor_Surface adaptor(surface);
  if (adaptor.GetType() == GeomAbs_Cone) {
    const gp_Cone cone = adaptor.Cone();
    return {{vec(cone.Apex()), 1, -cone.RefRadius() / std::sin(cone.SemiAngle())}};
  }
  Interval u, v;
  surface->Bounds(u.from, u.to, v.from, v.to);
  std::vector<SurfacePole> poles;
  for (const double value : {v.from, v.to})
    if (const auto point = one_point([&](double t) { return surface->Value(t, value); }, u, value))
      poles.push_back({*point, 1, value});
  for (const double value : {u.from, u.to})
    if (const auto point = one_point([&](double t) { return surface->Value(value, t); }, v, value))
      poles.push_back({*point, 0, value});
  return poles;
}

SurfaceProjector::SurfaceProjector(const TopoDS_Face& face, double tolerance, PolledLimit* limit)
    // Not the rectangle of it: wires bound the face, and what goes round keeps its period.
    : surface_(basis_of(BRep_Tool::Surface(face))),
      plane_(Handle(Geom_Plane)::DownCast(surface_)),
      finder_(new ShapeAnalysis_Surface(surface_)),
      tolerance_(tolerance),
      limit_(limit) {
  if (surface_->IsUPeriodic()) period_[0] = surface_->UPeriod();
  if (surface_->IsVPeriodic()) period_[1] = surface_->VPeriod();
  surface_->Bounds(low_[0], high_[0], low_[1], high_[1]);
  if (period_[0] == 0 && surface_->IsUClosed()) closed_[0] = high_[0] - low_[0];
  if (period_[1] == 0 && surface_->IsVClosed()) closed_[1] = high_[1] - low_[1];
  poles_ = poles_of(surface_);
}

Vec2 SurfaceProjector::foot(const Vec3& point, const std::optional<Vec2>& near) const {
  if (limit_ && limit_->reached()) throw LimitReached();
  const gp_Pnt p(point[0], point[1], point[2]);
  if (!plane_.IsNull()) {
    Vec2 uv;
    ElSLib::Parameters(plane_->Pln(), p, uv[0], uv[1]);
    return uv;
  }
  Vec2 uv;
  // A point that the surface has within tolerance needs no search over all of it.
  const auto beside = near ? sharpened(point, bounded(*near), kMostNewtonSteps) : Sharpened{};
  if (near && beside.gap <= tolerance_) {
    uv = beside.uv;
  } else {
    const gp_Pnt2d found = finder_->ValueOfUV(p, tolerance_);
    uv = sharpened(point, {found.X(), found.Y()}, kNewtonSteps).uv;
  }
  for (int k = 0; near && k < 2; ++k) {
    if (period_[k] > 0) uv[k] += period_[k] * std::round(((*near)[k] - uv[k]) / period_[k]);
    if (closed_[k] == 0) continue;
    const double slack = kSeam * closed_[k];
    if (uv[k] < low_[k] + slack && (*near)[k] > uv[k] + 0.5 * closed_[k])
      uv[k] = high_[k];
    else if (uv[k] > high_[k] - slack && (*near)[k] < uv[k] - 0.5 * closed_[k])
      uv[k] = low_[k];
  }
  return uv;
}

// By Newton's method as long as it comes no further away.
SurfaceProjector::Sharpened SurfaceProjector::sharpened(const Vec3& point, Vec2 uv,
                                                        int steps) const {
  SurfaceJet at = frame_at(surface_, uv);
  double gap = distance(at.point, point);
  for (int i = 0; i < steps; ++i) {
    const Vec2 next = bounded(uv + chart_step(at, point - at.point));
    const SurfaceJet there = frame_at(surface_, next);
    const double next_gap = distance(there.point, point);
    if (!(next_gap <= gap)) break;
    const bool settled = next_gap == gap || next == uv;
    uv = next;
    at = there;
    gap = next_gap;
    if (settled) break;
  }
  return {uv, gap};
}

double SurfaceProjector::gap(const Vec3& point, const Vec2& uv) const {
  return distance(point, frame_at(surface_, uv).point);
}

double SurfaceProjector::clearance(const Vec3& point, const Vec2& uv) const {
  const SurfaceJet at = frame_at(surface_, uv);
  double inside = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 2; ++k)
    if (period_[k] == 0)
      inside = std::min({inside, (uv[k] - low_[k]) * norm(k == 0 ? at.du : at.dv),
                         (high_[k] - uv[k]) * norm(k == 0 ? at.du : at.dv)});
  if (inside > 0) return inside;
  const Vec2 step = chart_step(at, point - at.point);
  return -norm(step[0] * at.du + step[1] * at.dv);
}

const SurfacePole* SurfaceProjector::pole_at(const Vec3& point) const {
  for (const SurfacePole& pole : poles_)
    if (distance(pole.point, point) <= tolerance_) return &pole;
  return nullptr;
}

double SurfaceProjector::height(const Vec3& point) const {
  const SurfaceJet at = frame_at(surface_, foot(point, {}));
  return std::copysign(distance(point, at.point), dot(point - at.point, cross(at.du, at.dv)));
}

Vec2 SurfaceProjector::bounded(Vec2 uv) const {
  for (int k = 0; k < 2; ++k)
    if (period_[k] == 0) uv[k] = std::clamp(uv[k], low_[k], high_[k]);
  return uv;
}

}  // namespace blossom::occt
