// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/side_sampler.h"

#include <algorithm>
#include <optional>
#include <string>

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <gp_Vec.hxx>
#include <gp_Vec2d.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"

namespace blossom::occt {
namespace {

/// A surface at a point: all derivatives up to the third, [i][j] i times by u and j times by v.
struct SurfaceDerivatives {
  std::array<std::array<Vec3, 4>, 4> by{};
};

SurfaceDerivatives derivatives_at(const Geom_Surface& surface, const Vec2& uv, int order) {
  gp_Pnt p;
  gp_Vec u, v, uu, vv, uv2, uuu, vvv, uuv, uvv;
  if (order < 3)
    surface.D2(uv[0], uv[1], p, u, v, uu, vv, uv2);
  else
    surface.D3(uv[0], uv[1], p, u, v, uu, vv, uv2, uuu, vvv, uuv, uvv);
  SurfaceDerivatives result;
  result.by[0] = {vec(p), vec(v), vec(vv), vec(vvv)};
  result.by[1] = {vec(u), vec(uv2), vec(uvv), {}};
  result.by[2] = {vec(uu), vec(uuv), {}, {}};
  result.by[3] = {vec(uuu), {}, {}, {}};
  return result;
}

}  // namespace

EdgeInChart::EdgeInChart(const HoleEdge& edge) : backwards_(edge.backwards) {
  pcurve_ = BRep_Tool::CurveOnSurface(edge.edge, edge.face, range_.from, range_.to);
  if (pcurve_.IsNull())
    throw BadModel("edge " + std::to_string(edge.number) + " has no curve on its face");
  // The inside of a face lies left of its edges as the face has them, seen by the surface.
  const bool reversed =
      (edge.edge.Orientation() == TopAbs_REVERSED) != (edge.face.Orientation() == TopAbs_REVERSED);
  away_is_left_ = reversed == backwards_;
}

Vec2 EdgeInChart::at(double x) const {
  const gp_Pnt2d p = pcurve_->Value(parameter(x));
  return {p.X(), p.Y()};
}

Vec2 EdgeInChart::direction(double x) const {
  gp_Pnt2d p;
  gp_Vec2d d;
  pcurve_->D1(parameter(x), p, d);
  const double speed = (backwards_ ? -1 : 1) * length(range_);
  return {speed * d.X(), speed * d.Y()};
}

double EdgeInChart::parameter(double x) const {
  return blossom::at(range_, backwards_ ? 1 - x : x);
}

struct SideSampler::Parts {
  std::optional<double> reach;
  bool backwards = false;
  std::optional<EdgeInChart> chart;
  Handle(Geom_Surface) surface;
  BRepAdaptor_Curve curve;
};

SideSampler::SideSampler(const HoleEdge& edge, std::optional<double> reach)
    : parts_(std::make_unique<Parts>()) {
  parts_->reach = reach;
  parts_->backwards = edge.backwards;
  if (edge.face.IsNull()) {
    parts_->curve.Initialize(edge.edge);
    return;
  }
  parts_->chart.emplace(edge);
  parts_->surface = BRep_Tool::Surface(edge.face);
}

SideSampler::~SideSampler() = default;

SideSample SideSampler::at(double x, int order) const {
  SideSample sample;
  if (!parts_->chart) {
    const Interval range{parts_->curve.FirstParameter(), parts_->curve.LastParameter()};
    sample.derivatives[0] =
        vec(parts_->curve.Value(blossom::at(range, parts_->backwards ? 1 - x : x)));
    return sample;
  }
  const Vec2 along = parts_->chart->direction(x);
  const SurfaceDerivatives surface = derivatives_at(*parts_->surface, parts_->chart->at(x), order);
  const Vec3 &su = surface.by[1][0], &sv = surface.by[0][1];
  const Vec3 cross_uv = cross(su, sv);
  sample.normal = unit(cross_uv);
  const double side = parts_->chart->away_is_left() ? 1 : -1;
  const Vec3 square_to = cross(sample.normal, along[0] * su + along[1] * sv);
  const Vec3 across =
      parts_->reach ? (side * *parts_->reach) * unit(square_to) : 0.5 * side * square_to;
  // The line of the parameters with this derivative: across = a S_u + b S_v.
  const double square = dot(cross_uv, cross_uv);
  const double a = dot(cross(across, sv), cross_uv) / square;
  const double b = dot(cross(su, across), cross_uv) / square;
  sample.derivatives = {
      surface.by[0][0], across,
      a * a * surface.by[2][0] + 2 * a * b * surface.by[1][1] + b * b * surface.by[0][2],
      a * a * a * surface.by[3][0] + 3 * a * a * b * surface.by[2][1] +
          3 * a * b * b * surface.by[1][2] + b * b * b * surface.by[0][3]};
  return sample;
}

double half_chord(const HoleEdge& edge) {
  const SideSampler rough(edge, 1);
  const auto point = [&](double x) { return rough.at(x, 0).derivatives[0]; };
  return std::max(distance(point(0), point(0.5)), distance(point(0.5), point(1)));
}

}  // namespace blossom::occt
