// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/nets/trimmed_nets.h"

#include <algorithm>
#include <utility>

#include <TopExp_Explorer.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/faces/face_trims.h"
#include "adapters/occt/faces/untrimmed.h"
#include "core/base/errors.h"

namespace blossom::nets {
namespace {

Interval place_of(const Interval& local, const Interval& span, ParameterLaw law) {
  return {parameter_at(law, span, local.from), parameter_at(law, span, local.to)};
}

bool is_rational(const RationalBezierTriangle& triangle) {
  return std::ranges::any_of(triangle.points, [](const Vec4& p) { return p[3] != 1; });
}

Net cell_net(const BezierSurface& surface, const RegionPiece& piece) {
  const RegionCell& cell = std::get<RegionCell>(piece.shape);
  const PatchChart chart = chart_of(surface, piece.patch_u, piece.patch_v);
  Net net;
  net.value = std::get<RationalBezierPatch>(bezier_form(surface, piece));
  net.rational = surface.rational;
  net.u = place_of(cell.u, chart.u, chart.u_law);
  net.v = place_of(cell.v, chart.v, chart.v_law);
  net.u_law = chart.u_law;
  net.v_law = chart.v_law;
  return net;
}

// A curved triangle keeps barycentric corners: the parameters are no linear functions in it.
Net triangle_net(const BezierSurface& surface, const RegionPiece& piece) {
  const BezierTriangle& map = std::get<CurvedTriangle>(piece.shape).map;
  const PatchChart chart = chart_of(surface, piece.patch_u, piece.patch_v);
  RationalBezierTriangle triangle = std::get<RationalBezierTriangle>(bezier_form(surface, piece));
  Net net;
  net.rational = surface.rational || is_rational(triangle);
  net.value = std::move(triangle);
  if (map.degree > 1) return net;
  const Vec3 corners[] = {map(1, 0), map(0, 1), map(0, 0)};
  for (std::size_t k = 0; k < 3; ++k)
    net.corners[k] = {parameter_at(chart.u_law, chart.u, corners[k][0]),
                      parameter_at(chart.v_law, chart.v, corners[k][1])};
  return net;
}

}  // namespace

bool is_trimmed(const TopoDS_Face& face) {
  if (!TopExp_Explorer(face, TopAbs_WIRE).More()) return false;
  try {
    return !occt::face_trims(face).natural;
  } catch (const occt::BadModel&) {
    return true;
  }
}

TrimmedNets trimmed_nets(const TopoDS_Face& face, const NetSource& source, double tolerance,
                         TriangleLowering& lowering, const Stop& stop) {
  TrimmedNets result;
  result.face = source.face;
  RegionOptions options;
  options.tolerance = tolerance;
  try {
    const occt::UntrimmedFace made = occt::untrimmed(face, options, lowering);
    result.obstacle = made.region.obstacle;
    for (const RegionPiece& piece : made.region.pieces) {
      ask(stop);
      Net net = std::holds_alternative<RegionCell>(piece.shape) ? cell_net(made.surface, piece)
                                                                : triangle_net(made.surface, piece);
      net.source = source;
      net.source.error = made.surface.error + piece.off_surface;
      net.border_error = piece.error;
      result.border_error = std::max(result.border_error, piece.error);
      ++(piece.exact ? result.exact : result.fitted);
      result.nets.push_back(std::move(net));
    }
  } catch (const InvalidInput& error) {
    result.obstacle = error.what();
  } catch (const occt::BadModel& error) {
    result.obstacle = error.what();
  }
  return result;
}

}  // namespace blossom::nets
