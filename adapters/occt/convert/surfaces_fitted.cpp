// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces without an exact Bezier form, by interpolation with a measured error.

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <GeomAdaptor_Surface.hxx>
#include <TColStd_Array1OfReal.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/curves_detail.h"
#include "adapters/occt/convert/limits.h"
#include "adapters/occt/convert/surfaces_detail.h"

namespace blossom::occt {
namespace {

/// Spans per direction after which an unmet tolerance is left as it is, and reported.
constexpr std::size_t kMaxSpans = 96;

/// Rounds of halving.
constexpr int kMaxRounds = 8;

/// Samples of the error per direction of a patch, at odd places between the nodes.
constexpr int kSamples = 2 * kFitDegree + 3;

/// Error of a patch, and its parts by the direction in which the interpolation runs.
struct PatchError {
  double all = 0;
  double u = 0;
  double v = 0;
};

class SurfaceFit {
 public:
  SurfaceFit(const Geom_Surface& surface, double tolerance)
      : surface_(surface), tolerance_(tolerance) {}

  BezierSurface run(std::vector<double> u_knots, std::vector<double> v_knots) const {
    BezierSurface result;
    for (int round = 0;; ++round) {
      result = fitted(u_knots, v_knots);
      std::set<double> u_cuts(u_knots.begin(), u_knots.end());
      std::set<double> v_cuts(v_knots.begin(), v_knots.end());
      result.error = add_cuts(result, u_cuts, v_cuts);
      const bool full = u_cuts.size() > kMaxSpans + 1 || v_cuts.size() > kMaxSpans + 1;
      if (result.error <= tolerance_ || full || round == kMaxRounds) return result;
      u_knots.assign(u_cuts.begin(), u_cuts.end());
      v_knots.assign(v_cuts.begin(), v_cuts.end());
    }
  }

 private:
  Vec3 value(double u, double v) const {
    const gp_Pnt point = surface_.Value(u, v);
    check_finite(point.XYZ(),
                 "the surface at (" + std::to_string(u) + ", " + std::to_string(v) + ")");
    return vec(point);
  }

  /// Values in the nodes, then the fit in one direction and in the other. Borders depend on
  /// values on the border alone, so neighbours share them bit for bit.
  RationalBezierPatch patch(const Interval& u, const Interval& v) const {
    constexpr int n = kFitDegree;
    const Grid<double>& m = fit_matrix();
    Grid<Vec3> values(n + 1, n + 1), half(n + 1, n + 1);
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j)
        values(i, j) = value(at(u, fit_nodes()[static_cast<std::size_t>(i)]),
                             at(v, fit_nodes()[static_cast<std::size_t>(j)]));
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j)
        for (int k = 0; k <= n; ++k) half(i, j) += m(i, k) * values(k, j);
    RationalBezierPatch result{Grid<Vec4>(n + 1, n + 1, {0, 0, 0, 1})};
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j)
        for (int k = 0; k <= n; ++k) result.points(i, j) += m(j, k) * with_weight(half(i, k), 0);
    return result;
  }

  BezierSurface fitted(const std::vector<double>& u, const std::vector<double>& v) const {
    BezierSurface result;
    result.u_knots = u;
    result.v_knots = v;
    result.patches =
        Grid<RationalBezierPatch>(static_cast<int>(u.size()) - 1, static_cast<int>(v.size()) - 1);
    for (int r = 0; r < result.patches.rows(); ++r)
      for (int c = 0; c < result.patches.columns(); ++c)
        result.patches(r, c) = patch(span(u, r), span(v, c));
    return result;
  }

  static Interval span(const std::vector<double>& knots, int i) {
    return {knots[static_cast<std::size_t>(i)], knots[static_cast<std::size_t>(i + 1)]};
  }

  static Vec3 point(const RationalBezierPatch& net, double s, double t) {
    std::vector<Vec4> rows;
    const auto along = [](std::vector<Vec4> p, double x) {
      for (std::size_t n = p.size() - 1; n > 0; --n)
        for (std::size_t i = 0; i < n; ++i) p[i] = (1 - x) * p[i] + x * p[i + 1];
      return p.front();
    };
    for (int i = 0; i < net.points.rows(); ++i) {
      std::vector<Vec4> row;
      for (int j = 0; j < net.points.columns(); ++j) row.push_back(net.points(i, j));
      rows.push_back(along(std::move(row), t));
    }
    return head(along(std::move(rows), s));
  }

  PatchError error_of(const RationalBezierPatch& net, const Interval& u, const Interval& v) const {
    PatchError error;
    const auto gap = [&](double s, double t) {
      const double found = distance(point(net, s, t), value(at(u, s), at(v, t)));
      error.all = std::max(error.all, found);
      return found;
    };
    const auto sample = [](int k) { return static_cast<double>(k) / kSamples; };
    for (int k = 0; k < kSamples; ++k) {
      for (const double node : fit_nodes()) {
        error.u = std::max(error.u, gap(sample(k) + 0.5 / kSamples, node));
        error.v = std::max(error.v, gap(node, sample(k) + 0.5 / kSamples));
      }
      for (int l = 1; l < kSamples; ++l) gap(sample(k) + 0.25 / kSamples, sample(l));
    }
    return error;
  }

  /// Adds the middles of spans that miss the tolerance; returns the largest error, with safety.
  double add_cuts(const BezierSurface& fit, std::set<double>& u_cuts,
                  std::set<double>& v_cuts) const {
    double largest = 0;
    for (int r = 0; r < fit.patches.rows(); ++r)
      for (int c = 0; c < fit.patches.columns(); ++c) {
        const Interval u = span(fit.u_knots, r), v = span(fit.v_knots, c);
        const PatchError error = error_of(fit.patches(r, c), u, v);
        largest = std::max(largest, kErrorSafety * error.all);
        if (kErrorSafety * error.all <= tolerance_) continue;
        if (error.u >= error.v / 4) u_cuts.insert(at(u, 0.5));
        if (error.v >= error.u / 4) v_cuts.insert(at(v, 0.5));
      }
    return largest;
  }

  const Geom_Surface& surface_;
  double tolerance_;
};

/// The ends of a range and the places inside where the surface is not smooth.
std::vector<double> smooth_breaks(const TColStd_Array1OfReal& found, const Interval& range) {
  std::vector<double> breaks{range.from};
  const double sliver = kRangeRounding * length(range);
  for (const double place : found)
    if (place > breaks.back() + sliver && place < range.to - sliver) breaks.push_back(place);
  breaks.push_back(range.to);
  return breaks;
}

}  // namespace

BezierSurface fitted_patches(const Handle(Geom_Surface) & surface, const ParameterBox& box,
                             double tolerance) {
  const GeomAdaptor_Surface adaptor(surface, box.u.from, box.u.to, box.v.from, box.v.to);
  TColStd_Array1OfReal u(1, adaptor.NbUIntervals(GeomAbs_CN) + 1);
  TColStd_Array1OfReal v(1, adaptor.NbVIntervals(GeomAbs_CN) + 1);
  adaptor.UIntervals(u, GeomAbs_CN);
  adaptor.VIntervals(v, GeomAbs_CN);
  return SurfaceFit(*surface, tolerance).run(smooth_breaks(u, box.u), smooth_breaks(v, box.v));
}

}  // namespace blossom::occt
