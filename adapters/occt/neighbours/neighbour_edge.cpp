// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/neighbours/neighbour_edge.h"

#include <algorithm>
#include <cstddef>

#include "core/plane/planar_curves.h"

namespace blossom::occt {

Vec3 EdgeOnFace::point(double t) const {
  const Vec2 x = point_at(coedge_.curve, t);
  const gp_Pnt p = surface_.Value(x[0] / scale_[0], x[1] / scale_[1]);
  return {p.X(), p.Y(), p.Z()};
}

Vec3 EdgeOnFace::tangent(double t) const {
  const PlanarJet x = jet_at(coedge_.curve, t);
  gp_Pnt p;
  gp_Vec du, dv;
  surface_.D1(x.point[0] / scale_[0], x.point[1] / scale_[1], p, du, dv);
  const gp_Vec d = du * (x.first[0] / scale_[0]) + dv * (x.first[1] / scale_[1]);
  return {d.X(), d.Y(), d.Z()};
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
    for (const double part : {0.0, 0.3, 0.5, 0.8, 1.0})
      gap_ =
          std::max(gap_, distance(image_.point(at(piece, part)), image_b.point(at(piece, part))));
  }
}

std::vector<Vec3> NeighbourEdge::directions(const Interval& range) const {
  const std::vector<double>& samples = shared_.curve.sample_parameters;
  std::vector<Vec3> along;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i)
    if (samples[i] <= range.to && range.from <= samples[i + 1])
      along.insert(along.end(), directions_[i].begin(), directions_[i].end());
  return along;
}

}  // namespace blossom::occt
