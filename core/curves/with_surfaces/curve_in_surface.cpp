// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/curves/with_surfaces/curve_in_surface.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/blossom/composition.h"
#include "core/curves/limits.h"
#include "core/curves/shared_curve.h"
#include "core/subdivision/curve_subdivision.h"

namespace blossom {
namespace {

constexpr int kDepth = 6;
constexpr double kFootRounding = 1e-15;

// The cubic through its values at 0, 1/3, 2/3, 1.
BezierCurve2 cubic_through(const std::array<Vec2, 4>& p) {
  const Vec2 a = p[1] * 3.0 - p[0] * (5.0 / 6) - p[2] * 1.5 + p[3] * (1.0 / 3);
  const Vec2 b = p[2] * 3.0 - p[3] * (5.0 / 6) - p[1] * 1.5 + p[0] * (1.0 / 3);
  return {{p[0], a, b, p[3]}};
}

bool is_graph(const Cell& cell) {
  const VectorBounds normal{cross(cell.du.middle, cell.dv.middle), Vec3{}};
  return JacobianBounds(normal, cell).minor(1).regular;
}

class PieceFinder {
 public:
  PieceFinder(const CurveTree& curve, SurfaceTrees& surface, SharedWork& work, long most,
              double tolerance)
      : curve_(curve), surface_(surface), work_(work), steps_left_(most), tolerance_(tolerance) {}

  void examine(int span, const Interval& t, int depth) {
    const auto point = [&](double part) { return curve_.jet({span, at(t, part)}).point; };
    const auto middle = feet_near(point(0.5));
    if (middle.empty()) {
      if (depth > 0) return;  // an end may still lie in the surface, but half of a piece does not
    } else {
      for (const SurfaceFoot& foot : middle)
        if (lies_on(span, t, foot)) return;
    }
    if (depth == kDepth || is_spent_) return;
    if (middle.empty() && feet_near(point(0.25)).empty() && feet_near(point(0.75)).empty()) return;
    examine(span, {t.from, at(t, 0.5)}, depth + 1);
    examine(span, {at(t, 0.5), t.to}, depth + 1);
  }

  std::vector<CurveInSurface> found;

 private:
  bool lies_on(int span, const Interval& t, const SurfaceFoot& middle) {
    std::array<Vec2, 4> uv;
    Vec2 start = middle.uv;
    for (const std::size_t i : {1U, 0U, 2U, 3U}) {
      const Vec3 point = curve_.jet({span, at(t, static_cast<double>(i) / 3)}).point;
      const SurfaceFoot foot = foot_on(surface_, middle.patch, start, point);
      if (foot.distance > tolerance_) return false;
      uv[i] = foot.uv;
      start = i == 0 ? uv[1] : foot.uv;
    }
    const BezierCurve2 preimage = cubic_through(uv);
    const RationalBezierPatch& patch = surface_[middle.patch].patch();
    const RationalBezierCurve& curve = curve_.curve().spans[static_cast<std::size_t>(span)].curve;
    const int n = patch.degree_u(), m = patch.degree_v();
    if (3 * (n + m) + curve.degree() > kMaxProductDegree) return false;
    const double error = composition_error(n, m, 3) * composition_growth(n, m, preimage) +
                         curve_subdivision_error(curve.degree());
    const double gap = distance_bound(sub_curve(curve, t), composition(patch, preimage), error);
    if (!(gap <= tolerance_)) return false;
    CurveInSurface piece{{span, t, middle.patch, {1, 0}, {1, 0}, -1, -1}, uv[0], uv[3], gap};
    for (const Vec2& p : preimage.points) {
      piece.piece.u = {std::min(piece.piece.u.from, p[0]), std::max(piece.piece.u.to, p[0])};
      piece.piece.v = {std::min(piece.piece.v.from, p[1]), std::max(piece.piece.v.to, p[1])};
    }
    found.push_back(piece);
    return true;
  }

  /// Where the surface is within the tolerance of a point; none once the work or the steps are
  /// spent. A surface that is folded or collapsed there is no graph in any of its cells, however
  /// small: they are as many as there are down to the tolerance.
  std::vector<SurfaceFoot> feet_near(const Vec3& point) {
    std::vector<SurfaceFoot> feet;
    for (int patch = 0; patch < surface_.count(); ++patch) {
      cells_.assign(1, 0);
      while (!cells_.empty()) {
        const int index = cells_.back();
        cells_.pop_back();
        const Cell& cell = surface_[patch][index];
        if (is_apart(cell, point)) continue;
        if (!is_graph(cell) && cell.extent > tolerance_ + 8 * cell.margin) {
          if (!may_split()) return {};
          const int child = surface_[patch].split(index);
          cells_.push_back(child);
          cells_.push_back(child + 1);
          continue;
        }
        const SurfaceFoot foot =
            foot_on(surface_, patch, {at(cell.u, 0.5), at(cell.v, 0.5)}, point);
        if (foot.distance <= tolerance_ + surface_.evaluation_margin()) feet.push_back(foot);
      }
    }
    return feet;
  }

  bool is_apart(const Cell& cell, const Vec3& point) const {
    for (int k = 0; k < 3; ++k)
      if (point[k] < cell.low[k] - tolerance_ || point[k] > cell.high[k] + tolerance_) return true;
    const double height = dot(cell.plane.normal, point);
    return height < cell.plane.low - tolerance_ || height > cell.plane.high + tolerance_;
  }

  bool may_split() {
    is_spent_ = is_spent_ || steps_left_-- <= 0 || work_.step() != nullptr;
    return !is_spent_;
  }

  const CurveTree& curve_;
  SurfaceTrees& surface_;
  SharedWork& work_;
  long steps_left_;
  double tolerance_;
  bool is_spent_ = false;
  std::vector<int> cells_;  // that feet_near has to look at; kept for its memory
};

}  // namespace

SurfaceFoot foot_on(const SurfaceTrees& surface, int patch, const Vec2& start, const Vec3& point) {
  const RationalBezierPatch& net = surface[patch].patch();
  SurfaceFoot foot{patch, start, distance(jet_at(net, start[0], start[1], 1).point, point)};
  for (int k = 0; k < kFootSteps; ++k) {
    const PatchJet jet = jet_at(net, foot.uv[0], foot.uv[1], 2);
    const Vec3 gap = jet.point - point;
    const double a = dot(jet.u, jet.u) + dot(gap, jet.uu), b = dot(jet.u, jet.v) + dot(gap, jet.uv);
    const double c = dot(jet.v, jet.v) + dot(gap, jet.vv);
    const double d = a * c - b * b, f = dot(gap, jet.u), g = dot(gap, jet.v);
    if (!(std::abs(d) > 0)) break;
    Vec2 next{foot.uv[0] - (c * f - b * g) / d, foot.uv[1] - (a * g - b * f) / d};
    for (int i = 0; i < 2; ++i) next[i] = std::clamp(next[i], 0.0, 1.0);
    const double moved = max_norm(next - foot.uv);
    foot = {patch, next, distance(jet_at(net, next[0], next[1], 1).point, point)};
    if (moved <= kFootRounding) break;
  }
  return foot;
}

std::vector<CurveInSurface> pieces_in_surface(const CurveTree& curve, SurfaceTrees& surface,
                                              SharedWork& work, long most, double tolerance) {
  PieceFinder finder(curve, surface, work, most, tolerance);
  for (int span = 0; span < curve.spans(); ++span) finder.examine(span, {0, 1}, 0);
  return std::move(finder.found);
}

}  // namespace blossom
