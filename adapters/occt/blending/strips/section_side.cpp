// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/strips/section_side.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/blending/hole_side.h"
#include "adapters/occt/convert/surfaces.h"
#include "adapters/occt/faces/surface_projector.h"
#include "core/blending/surface_side.h"
#include "core/forms/algebra/interpolation.h"

namespace blossom::occt {
namespace {

// Of the strip's range: what of it is written as patches. Any part gives the same derivatives but
// for their length.
constexpr double kDepth = 0.1;
constexpr int kFirstDegree = 3;
constexpr int kChecks = 4;  // places between the nodes of a fit, for each node

struct SectionJet {
  Vec3 point, away;
};

class SectionOfStrip {
 public:
  SectionOfStrip(const RolledStrip& strip, double t, bool ahead, std::size_t from)
      : strip_(strip),
        t_(t),
        sign_(ahead ? 1 : -1),
        across_{strip.contacts[from].w, strip.contacts[1 - from].w} {}

  std::optional<FillSide> arc() const;
  std::optional<FillSide> exact() const;
  SectionJet jet(double x) const;
  FillSide fitted(int degree, double& error) const;

 private:
  const RolledStrip& strip_;
  double t_, sign_;
  Interval across_;  // from > to where the side runs against the strip's parameter
};

bool is_swept(const Handle(Geom_Surface) & surface) {
  return surface->IsKind(STANDARD_TYPE(Geom_CylindricalSurface)) ||
         surface->IsKind(STANDARD_TYPE(Geom_ConicalSurface)) ||
         surface->IsKind(STANDARD_TYPE(Geom_ToroidalSurface)) ||
         surface->IsKind(STANDARD_TYPE(Geom_SphericalSurface));
}

// Of cylinders, cones, tori and spheres the sections are circles, and the way on from a point of
// one, as of a motion along an axis or about it, or of a growth from an apex, is affine in the
// point. With P at its ends and in its middle, w the cosine of half of its angle:
//
//   w M = (1 + w) P(1/2) - (P(0) + P(1)) / 2,   and the same for the ways on.
std::optional<FillSide> SectionOfStrip::arc() const {
  const double angle = std::abs(length(across_));
  const double w = std::cos(0.5 * angle);
  if (!is_swept(strip_.surface) || !(w > 0)) return std::nullopt;
  const SectionJet first = jet(0), middle = jet(0.5), last = jet(1);
  const auto inner = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    return (1 + w) * b - 0.5 * (a + c);
  };
  const auto in_space = [](const Vec3& p, double weight) { return Vec4{p[0], p[1], p[2], weight}; };
  return FillSide{
      {in_space(first.point, 1), in_space(inner(first.point, middle.point, last.point), w),
       in_space(last.point, 1)},
      {in_space(first.away, 0), in_space(inner(first.away, middle.away, last.away), 0),
       in_space(last.away, 0)},
      {},
      FillContinuity::G1};
}

std::optional<FillSide> SectionOfStrip::exact() const {
  const Interval across{std::min(across_.from, across_.to), std::max(across_.from, across_.to)};
  const double depth = kDepth * length(strip_.range);
  const bool ahead = sign_ > 0;
  const Interval part = ahead ? Interval{t_, std::min(t_ + depth, strip_.range.to)}
                              : Interval{std::max(t_ - depth, strip_.range.from), t_};
  const BezierSurface surface = bezier_surface(
      strip_.surface, strip_.along_u ? ParameterBox{part, across} : ParameterBox{across, part});
  const int along = strip_.along_u ? surface.patches.rows() : surface.patches.columns();
  if ((strip_.along_u ? surface.patches.columns() : surface.patches.rows()) != 1)
    return std::nullopt;
  const int span = ahead ? 0 : along - 1;
  const bool backward = across_.from > across_.to;
  if (strip_.along_u)
    return fill_side(surface.patches(span, 0), ahead ? SurfaceSide::UMin : SurfaceSide::UMax,
                     backward, FillContinuity::G1);
  return fill_side(surface.patches(0, span), ahead ? SurfaceSide::VMin : SurfaceSide::VMax,
                   backward, FillContinuity::G1);
}

SectionJet SectionOfStrip::jet(double x) const {
  const SurfaceJet frame = frame_at(strip_.surface, strip_.chart(t_, at(across_, x)));
  return {frame.point, sign_ * (strip_.along_u ? frame.du : frame.dv)};
}

Row homogeneous(const std::vector<Vec3>& points, double weight) {
  Row row;
  for (const Vec3& p : bezier_through(points).points) row.push_back({p[0], p[1], p[2], weight});
  return row;
}

FillSide SectionOfStrip::fitted(int degree, double& error) const {
  std::vector<Vec3> points, away;
  for (const double x : extreme_points(degree)) {
    const SectionJet at = jet(x);
    points.push_back(at.point);
    away.push_back(at.away);
  }
  FillSide side{homogeneous(points, 1), homogeneous(away, 0), {}, FillContinuity::G1};
  const double width = distance(points.front(), points.back());
  error = 0;
  for (int i = 0; i < kChecks * (degree + 1); ++i) {
    const double x = (i + 0.5) / (kChecks * (degree + 1));
    const SectionJet wanted = jet(x);
    const SpaceJet made = jet_at(side.edge, x);
    const Vec3 normal = unit(cross(made.derivative, across_at(side.edge, side.across, x)));
    error = std::max({error, distance(made.point, wanted.point),
                      width * std::abs(dot(normal, unit(wanted.away)))});
  }
  return side;
}

}  // namespace

FillSide section_side(const RolledStrip& strip, double t, bool ahead, std::size_t from,
                      double tolerance) {
  const SectionOfStrip section(strip, t, ahead, from);
  if (auto side = section.arc()) return *std::move(side);
  if (auto side = section.exact()) return *std::move(side);
  for (int degree = kFirstDegree; degree <= kMaxFitDegree; ++degree) {
    double error = 0;
    FillSide side = section.fitted(degree, error);
    if (error <= tolerance) return side;
  }
  throw Failure("the section of a strip cannot be followed by polynomials");
}

}  // namespace blossom::occt
