// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/curve_surface_intersection.h"

#include <algorithm>

#include "core/base/errors.h"
#include "core/base/unbounded.h"
#include "core/curves/curve_closing.h"
#include "core/curves/with_surfaces/curve_surface_assembly.h"

namespace blossom {
namespace {

// Pieces in the surface get this part of the budget, and the search for points what is left: where
// the surface is collapsed, pieces may take all they get. A choice, as for long patches.
constexpr long kPiecePart = 16;

// The middle of the curve's control points.
Vec3 origin_of(const CurveSpans& curve) {
  Vec3 low{kUnbounded, kUnbounded, kUnbounded}, high = -low;
  for (const CurveSpan& span : curve.spans)
    for (const Vec4& p : span.curve.points)
      for (int k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], p[k] / p[3]);
        high[k] = std::max(high[k], p[k] / p[3]);
      }
  const Vec3 middle = (low + high) * 0.5;
  return max_norm(middle) > max_norm(high - low) ? middle : Vec3{};
}

CurvePlace open_place(const CurveTree& curve, const CurveSurfaceContact& pair) {
  const CurveCell& cell = curve[pair.span];
  return {PlaceKind::Open,
          cell.low,
          cell.high,
          0,
          distance(cell.low, cell.high),
          {curve.parameter({pair.span, pair.t.from}), curve.parameter({pair.span, pair.t.to})},
          {0, 0}};
}

}  // namespace

CurveSurfaceIntersection intersect(const CurveSpans& curve, const BezierSurface& surface,
                                   const IntersectionOptions& options) {
  validate(curve, "the curve");
  validate(surface, "of the curve/surface intersection");
  if (!(options.tolerances.point > 0))
    throw InvalidInput("intersect: the tolerance must be positive");
  const Vec3 origin = origin_of(curve);
  const double error = curve.error + surface.error;
  const double tolerance = options.tolerances.point + error;
  CurveTree tree(curve, origin, 3);
  SurfaceTrees trees(surface, origin, options.form);
  SharedWork work(options);
  const auto inside =
      pieces_in_surface(tree, trees, work, std::max(options.budget / kPiecePart, 1L), tolerance);
  std::vector<CurveSurfaceContact> pieces;
  for (const CurveInSurface& piece : inside) pieces.push_back(piece.piece);
  const CurveSurfaceFindings found = CurveSurfaceSearch(tree, trees, work, tolerance).run(pieces);
  const auto closer = [&](const std::vector<CurveSurfaceContact>& contacts, double smaller) {
    return CurveSurfaceSearch(tree, trees, work, smaller).run_within(contacts, pieces);
  };
  CurveSurfaceIntersection result =
      CurveSurfaceAssembly(tree, surface, trees, tolerance).finish(inside, found, closer);
  for (const CurveSurfaceContact& pair : found.open)
    result.places.push_back(open_place(tree, pair));
  CurveCertificate& certificate = result.certificate;
  certificate.contacts = static_cast<long>(found.contacts.size() + found.touches.size());
  certificate.depth = tree.depth();
  certificate.rounding_bound = std::max(tree.largest_margin(), trees.evaluation_margin());
  close_search(result, found, origin,
               error > 0 ? "the curve or the surface is an approximation" : nullptr, work.reason());
  return result;
}

}  // namespace blossom
