// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/branches/seam_chains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace blossom {
namespace {

// Relative to the range of the parameter: places as near as this are one, or a whole turn apart.
constexpr double kSameParameter = 1e-6;
// Cosine between the directions in which ends leave: less opposite ones are no continuation.
constexpr double kStraightOn = -0.9;

// An end of a curve; its number is 2 x curve + (0 at the start, 1 at the end).
const SurfacePoint& end_of(std::span<const IntersectionCurve> curves, std::size_t end) {
  const auto& samples = curves[end / 2].samples;
  return end % 2 == 0 ? samples.front() : samples.back();
}

// The direction in which the curve leaves its end, as a unit vector.
Vec3 direction_of(std::span<const IntersectionCurve> curves, std::size_t end) {
  const IntersectionCurve& curve = curves[end / 2];
  const Interval domain = curve.curve.domain();
  const Vec3 along = end % 2 == 0 ? derivative_at(curve.curve, domain.from)
                                  : -1.0 * derivative_at(curve.curve, domain.to);
  const double size = norm(along);
  return size > 0 ? (1 / size) * along : along;
}

enum class Meeting { Apart, Same, AcrossSeam, InPole };

// Whether the surface maps all between two places to one point.
bool are_in_pole(const BezierSurface& surface, const Vec2& p, const Vec2& q, double tolerance) {
  const Vec3 point = point_at(surface, p);
  return std::ranges::all_of(std::array{0.25, 0.5, 0.75, 1.0}, [&](double part) {
    return distance(point_at(surface, (1 - part) * p + part * q), point) <= tolerance;
  });
}

Meeting meeting(const BezierSurface& surface, const Vec2& p, const Vec2& q, double tolerance) {
  if (!(p == q) && are_in_pole(surface, p, q, tolerance)) return Meeting::InPole;
  Meeting result = Meeting::Same;
  for (int k = 0; k < 2; ++k) {
    const auto& knots = k == 0 ? surface.u_knots : surface.v_knots;
    const double turn = knots.back() - knots.front(), gap = std::abs(p[k] - q[k]);
    if (gap <= kSameParameter * turn) continue;
    const bool closed = k == 0 ? surface.closed_u : surface.closed_v;
    if (!closed || std::abs(gap - turn) > kSameParameter * turn) return Meeting::Apart;
    result = Meeting::AcrossSeam;
  }
  return result;
}

bool on_border(CurveEnd end) { return end == CurveEnd::BorderA || end == CurveEnd::BorderB; }

struct Joint {
  std::size_t p = 0, q = 0;  // ends
  double cosine = 0;
};

std::vector<Joint> joints(std::span<const IntersectionCurve> curves, const BezierSurface& a,
                          const BezierSurface& b, double tolerance) {
  std::vector<Joint> found;
  const auto is_free = [&](std::size_t end) {
    const IntersectionCurve& curve = curves[end / 2];
    return !curve.closed && !curve.samples.empty() && on_border(curve.ends[end % 2]);
  };
  for (std::size_t p = 0; p < 2 * curves.size(); ++p)
    for (std::size_t q = p + 1; is_free(p) && q < 2 * curves.size(); ++q) {
      if (!is_free(q)) continue;
      const SurfacePoint &x = end_of(curves, p), &y = end_of(curves, q);
      if (distance(x.point, y.point) > tolerance) continue;
      const Meeting in_a = meeting(a, x.uv_a, y.uv_a, tolerance),
                    in_b = meeting(b, x.uv_b, y.uv_b, tolerance);
      if (in_a == Meeting::Apart || in_b == Meeting::Apart) continue;
      if (in_a == Meeting::Same && in_b == Meeting::Same) continue;
      const double cosine = dot(direction_of(curves, p), direction_of(curves, q));
      if (cosine <= kStraightOn) found.push_back({p, q, cosine});
    }
  std::sort(found.begin(), found.end(),
            [](const Joint& x, const Joint& y) { return x.cosine < y.cosine; });
  return found;
}

}  // namespace

std::vector<CurveChain> chains_over_seams(std::span<const IntersectionCurve> curves,
                                          const BezierSurface& a, const BezierSurface& b,
                                          double tolerance) {
  constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> next(2 * curves.size(), kNone);
  for (const Joint& joint : joints(curves, a, b, tolerance)) {
    if (next[joint.p] != kNone || next[joint.q] != kNone) continue;
    next[joint.p] = joint.q;
    next[joint.q] = joint.p;
  }
  std::vector<CurveChain> chains;
  std::vector<char> used(curves.size());
  for (std::size_t first = 0; first < curves.size(); ++first) {
    if (used[first]) continue;
    // Back to where the chain starts, or once round.
    std::size_t start = 2 * first;
    while (next[start] != kNone && next[start] / 2 != first) start = next[start] ^ 1;
    const bool closed = next[start] != kNone;
    if (closed) start = 2 * first;
    CurveChain chain{{}, closed || curves[first].closed};
    for (std::size_t at = start; at != kNone && !used[at / 2]; at = next[at ^ 1]) {
      used[at / 2] = 1;
      chain.uses.push_back({static_cast<int>(at / 2), at % 2 == 0});
    }
    chains.push_back(std::move(chain));
  }
  return chains;
}

}  // namespace blossom
