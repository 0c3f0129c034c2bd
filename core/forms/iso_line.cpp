// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/iso_line.h"

#include <cstring>
#include <utility>

#include "core/forms/detail/evaluation_weights.h"

namespace blossom {
namespace {

using namespace detail;

// The control points of an iso-line and of its derivative by the constant parameter. `count` of
// them, `step` apart in the net; the sums are over points `stride` apart.
BLOSSOM_HOT void contract(const Vec4* net, int count, int step, int degree, int stride,
                          double constant, Vec4* points, Vec4* rates) {
  Weights b;
  make_weights<1>(degree, constant, b);
  for (int i = 0; i < count; ++i) {
    Four s0{}, s1{};
    for (int j = 0; j <= degree; ++j) {
      Four point;
      std::memcpy(&point, net + i * step + j * stride, sizeof point);
      s0 += b.value[j] * point;
      s1 += b.first[j] * point;
    }
    std::memcpy(points[i].coordinates.data(), &s0, sizeof s0);
    std::memcpy(rates[i].coordinates.data(), &s1, sizeof s1);
  }
}

// Point, derivative along the line and across it.
BLOSSOM_HOT PatchJet line_jet(int degree, const Vec4* points, const Vec4* rates, double t) {
  Weights b;
  make_weights<1>(degree, t, b);
  Four h00{}, h10{}, h01{};
  for (int i = 0; i <= degree; ++i) {
    Four point, rate;
    std::memcpy(&point, points + i, sizeof point);
    std::memcpy(&rate, rates + i, sizeof rate);
    h00 += b.value[i] * point;
    h10 += b.first[i] * point;
    h01 += b.value[i] * rate;
  }
  PatchJet result;
  const double over = 1 / h00[3];
  const Four point = h00 * over;
  result.point = head(point);
  result.u = head((h10 - h10[3] * point) * over);
  result.v = head((h01 - h01[3] * point) * over);
  return result;
}

}  // namespace

IsoLine::IsoLine(const RationalBezierPatch& patch, Along along, double constant)
    : along_(along), degree_(along == Along::U ? patch.degree_u() : patch.degree_v()) {
  const int row = patch.points.columns();
  const bool rows = along == Along::U;
  contract(patch.points.values().data(), degree_ + 1, rows ? row : 1,
           rows ? patch.degree_v() : patch.degree_u(), rows ? 1 : row, constant, points_.data(),
           rates_.data());
}

PatchJet IsoLine::jet(double t) const {
  PatchJet result = line_jet(degree_, points_.data(), rates_.data(), t);
  if (along_ == Along::V) std::swap(result.u, result.v);
  return result;
}

}  // namespace blossom
