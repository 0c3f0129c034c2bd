// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/neighbours/neighbour_edge.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/cells/net_ranges.h"
#include "core/forms/spline.h"
#include "core/math/segment.h"
#include "core/plane/planar_curves.h"

namespace blossom {

namespace {

// A bound on the distance of a part of a curve from the chord between its ends.
double sag(const Spline& curve, const Interval& part, const std::array<Vec3, 2>& chord) {
  if (!is_span(part, curve.domain())) return 0;
  double most = 0;
  for (const Vec3& p : restricted(curve, part).points)
    most = std::max(most, segment_gap(p, chord[0], chord[1]));
  return most;
}

}  // namespace

Vec3 EdgeOnFace::point(double t) const {
  const Vec2 x = point_at(coedge_.curve, t), &scale = trims_.scale;
  return trims_.jet({x[0] / scale[0], x[1] / scale[1]}).point;
}

Vec3 EdgeOnFace::tangent(double t) const {
  const PlanarJet x = jet_at(coedge_.curve, t);
  const Vec2& scale = trims_.scale;
  const SurfaceJet jet = trims_.jet({x.point[0] / scale[0], x.point[1] / scale[1]});
  return (x.first[0] / scale[0]) * jet.du + (x.first[1] / scale[1]) * jet.dv;
}

NeighbourEdge::NeighbourEdge(const FaceTrims& trims_a, const FaceTrims& trims_b,
                             const SharedEdge& shared, const Coedge& a, const Coedge& b)
    : on_a(a), on_b(b), shared_(shared), image_(trims_a, a) {
  const EdgeOnFace image_b(trims_b, b);
  const std::vector<double>& samples = shared.curve.sample_parameters;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const Interval piece{samples[i], samples[i + 1]};
    directions_.push_back({image_.tangent(piece.from),
                           image_.point(piece.to) - image_.point(piece.from),
                           image_.tangent(piece.to)});
    double& gap = gaps_.emplace_back(0);
    for (const double part : {0.0, 0.3, 0.5, 0.8, 1.0})
      gap = std::max(gap, distance(image_.point(at(piece, part)), image_b.point(at(piece, part))));
  }
}

template <class Work>
void NeighbourEdge::for_pieces(const Interval& range, Work work) const {
  const std::vector<double>& samples = shared_.curve.sample_parameters;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i)
    if (samples[i] <= range.to && range.from <= samples[i + 1]) work(i);
}

std::vector<Vec3> NeighbourEdge::directions(const Interval& range) const {
  std::vector<Vec3> along;
  for_pieces(range, [&](std::size_t i) {
    along.insert(along.end(), directions_[i].begin(), directions_[i].end());
  });
  return along;
}

double NeighbourEdge::gap(const Interval& range) const {
  double most = 0;
  for_pieces(range, [&](std::size_t i) { most = std::max(most, gaps_[i]); });
  return most;
}

bool NeighbourEdge::is_near(double foot, const double* hull, int count, const Vec3& origin,
                            double reach) const {
  const Spline& curve = shared_.curve.curve;
  const Vec3 rate = derivative_at(curve, foot);
  const double speed = norm(rate);
  if (!(speed > 0)) return false;
  const Vec3 along = rate * (1 / speed);
  const double here = dot(along, point_at(curve, foot) - origin);
  const Range heights = height_range(hull, count, along);
  const Interval domain = curve.domain();
  const Interval part{std::clamp(foot + (heights.low - here) / speed, domain.from, domain.to),
                      std::clamp(foot + (heights.high - here) / speed, domain.from, domain.to)};
  const std::array<Vec3, 2> chord{point_at(curve, part.from), point_at(curve, part.to)};
  double most = 0;
  for (int i = 0; i < count && most <= reach; ++i)
    most = std::max(most, segment_gap(origin + Vec3{hull[i], hull[count + i], hull[2 * count + i]},
                                      chord[0], chord[1]));
  return most <= reach && most + sag(curve, part, chord) <= reach;
}

}  // namespace blossom
