// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/neighbours/sliver_spans.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/unbounded.h"
#include "core/bounds/box_tree.h"
#include "core/plane/planar_curves.h"
#include "core/self_intersection.h"

namespace blossom {
namespace {

constexpr double kOnSide = 1e-7;       // chart coordinates: an edge so near to a border is on it
constexpr double kSameBorder = 1e-12;  // of the coordinates: borders that near are a seam

Vec3 over_weight(const Vec4& p) { return {p[0] / p[3], p[1] / p[3], p[2] / p[3]}; }

// A border of the surface, seen across: its spans and points are counted from there.
struct Border {
  int across = 0;     // 0: a border of u
  bool high = false;  // the last one

  int spans(const BezierSurface& surface) const {
    return across == 0 ? surface.patches.rows() : surface.patches.columns();
  }
  int spans_along(const BezierSurface& surface) const {
    return across == 0 ? surface.patches.columns() : surface.patches.rows();
  }
  template <class Surface>
  auto& patch(Surface& surface, int along) const {
    const int outer = high ? spans(surface) - 1 : 0;
    return across == 0 ? surface.patches(outer, along) : surface.patches(along, outer);
  }
  int points(const RationalBezierPatch& patch) const {
    return across == 0 ? patch.points.rows() : patch.points.columns();
  }
  int points_along(const RationalBezierPatch& patch) const {
    return across == 0 ? patch.points.columns() : patch.points.rows();
  }
  template <class Patch>
  auto& point(Patch& patch, int inwards, int along) const {
    const int i = high ? points(patch) - 1 - inwards : inwards;
    return across == 0 ? patch.points(i, along) : patch.points(along, i);
  }
  Border opposite() const { return {across, !high}; }
  const std::vector<double>& knots(const BezierSurface& surface) const {
    return across == 0 ? surface.u_knots : surface.v_knots;
  }
};

// The least tolerance of the edges along a border; 0 if there are none.
double tolerance_along(const Border& border, const FaceData& face) {
  const std::vector<double>& knots = border.knots(face.surface);
  const double scale = face.trims.scale[border.across];
  const std::size_t n = knots.size();
  const Interval span = border.high ? Interval{knots[n - 2] * scale, knots[n - 1] * scale}
                                    : Interval{knots[0] * scale, knots[1] * scale};
  double least = kInfinity;
  for (const auto& loop : face.trims.loops)
    for (const Coedge& coedge : loop) {
      const PlanarBox box = box_of(coedge.curve);
      if (box.low[border.across] >= span.from - kOnSide &&
          box.high[border.across] <= span.to + kOnSide)
        least = std::min(least, coedge.tolerance);
    }
  return std::isfinite(least) ? least : 0;
}

// By how much, relatively, weights are off products w_ij = a_i b_j.
double weights_off_products(const RationalBezierPatch& patch) {
  const auto& p = patch.points;
  double off = 0;
  for (int i = 0; i < p.rows(); ++i)
    for (int j = 0; j < p.columns(); ++j)
      off = std::max(off, std::abs(p(i, j)[3] * p(0, 0)[3] / (p(i, 0)[3] * p(0, j)[3]) - 1));
  return off;
}

// With weights that are products, points of a patch are as far from those across as the control
// points are; others move its points by no more than 2 d / (1 - d) times its size, d being how far
// they are off.
double moved_by_weights(const RationalBezierPatch& patch, const Box& box) {
  const double off = std::min(weights_off_products(patch), 0.5);
  return 2 * off / (1 - off) * diagonal(box);
}

// A bound on the distance of the outer spans' points from their inner border.
double sliver_width(const Border& border, const BezierSurface& surface) {
  double width = 0;
  for (int k = 0; k < border.spans_along(surface); ++k) {
    const RationalBezierPatch& patch = border.patch(surface, k);
    const int inner = border.points(patch) - 1;
    Box box;
    double across = 0;
    for (int along = 0; along < border.points_along(patch); ++along)
      for (int i = 0; i <= inner; ++i) {
        const Vec3 x = over_weight(border.point(patch, i, along));
        box = joined(box, {x, x});
        across = std::max(across, distance(x, over_weight(border.point(patch, inner, along))));
      }
    width = std::max(width, across + moved_by_weights(patch, box));
  }
  return width;
}

// The largest distance of control points of a border from those of the opposite one.
double distance_of_borders(const Border& border, const BezierSurface& surface) {
  double gap = 0;
  for (int k = 0; k < border.spans_along(surface); ++k) {
    const RationalBezierPatch& here = border.patch(surface, k);
    const RationalBezierPatch& there = border.opposite().patch(surface, k);
    for (int along = 0; along < border.points_along(here); ++along)
      gap = std::max(gap, distance(over_weight(border.point(here, 0, along)),
                                   over_weight(border.opposite().point(there, 0, along))));
  }
  return gap;
}

void move_to_opposite(const Border& border, BezierSurface& surface) {
  for (int k = 0; k < border.spans_along(surface); ++k) {
    RationalBezierPatch& here = border.patch(surface, k);
    const RationalBezierPatch& there = border.opposite().patch(surface, k);
    for (int along = 0; along < border.points_along(here); ++along) {
      Vec4& p = border.point(here, 0, along);
      const Vec3 x = over_weight(border.opposite().point(there, 0, along));
      p = {x[0] * p[3], x[1] * p[3], x[2] * p[3], p[3]};
    }
  }
}

BezierSurface without_outer_span(const Border& border, const BezierSurface& surface) {
  BezierSurface rest = surface;
  const bool of_u = border.across == 0;
  const int from_u = of_u && !border.high ? 1 : 0, from_v = !of_u && !border.high ? 1 : 0;
  rest.patches = Grid<RationalBezierPatch>(surface.patches.rows() - (of_u ? 1 : 0),
                                           surface.patches.columns() - (of_u ? 0 : 1));
  for (int i = 0; i < rest.patches.rows(); ++i)
    for (int j = 0; j < rest.patches.columns(); ++j)
      rest.patches(i, j) = surface.patches(i + from_u, j + from_v);
  std::vector<double>& knots = of_u ? rest.u_knots : rest.v_knots;
  knots.erase(border.high ? knots.end() - 1 : knots.begin());
  return rest;
}

// Leaves the outer span at a border out, if it is a sliver.
void leave_sliver_out(const Border& border, const FaceData& face,
                      std::optional<WithoutSlivers>& rest) {
  const BezierSurface& surface = rest ? rest->surface : face.surface;
  if (border.spans(surface) < 2) return;
  const double tolerance = tolerance_along(border, face);
  double off = sliver_width(border, surface);
  if (!(off <= tolerance)) return;
  BezierSurface less = without_outer_span(border, surface);
  const double same = kSameBorder * (max_norm(face.box.low) + max_norm(face.box.high));
  if (distance_of_borders(border, surface) <= same) {
    off = std::max(off, distance_of_borders(border, less));
    if (!(off <= tolerance)) return;
    move_to_opposite(border, less);
  }
  rest = WithoutSlivers{std::move(less), std::max(off, rest ? rest->within : 0)};
}

}  // namespace

std::optional<WithoutSlivers> without_sliver_spans(const FaceData& face) {
  std::optional<WithoutSlivers> rest;
  for (const int across : {0, 1})
    for (const bool high : {false, true}) leave_sliver_out({across, high}, face, rest);
  return rest;
}

double width_across(const RationalBezierPatch& patch, int across) {
  const Border lines{across, false};
  const int last = lines.points(patch) - 1;
  Box box;
  double width = 0;
  for (int along = 0; along < lines.points_along(patch); ++along)
    for (int i = 0; i <= last; ++i) {
      const Vec3 x = over_weight(lines.point(patch, i, along));
      box = joined(box, {x, x});
      for (int k = 0; k < i; ++k)
        width = std::max(width, distance(x, over_weight(lines.point(patch, k, along))));
    }
  return width + moved_by_weights(patch, box);
}

SurfaceIntersection with_itself(const FaceData& face, const IntersectionOptions& options) {
  const std::optional<WithoutSlivers> rest = without_sliver_spans(face);
  SurfaceIntersection found = self_intersect(rest ? rest->surface : face.surface, options);
  if (!rest) return found;
  identify(found.certificate, rest->within);
  if (found.curves.empty() && found.points.empty() && found.places.empty()) return found;
  for (IntersectionCurve& curve : found.curves)
    for (double* off : {&curve.deviation.a, &curve.deviation.b, &curve.deviation.between})
      *off += rest->within;
  found.status = weaker(found.status, Status::Tolerance);
  found.certificate.reasons.emplace_back("a sliver of the surface was taken for the edge along it");
  return found;
}

}  // namespace blossom
