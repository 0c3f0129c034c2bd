// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/evaluation.h"

#include <cstring>

#include "core/forms/detail/evaluation_weights.h"

namespace blossom {
namespace {

using namespace detail;

// Of the degrees (kN, kM) if they are not negative: bicubic patches are by far the most frequent.
template <int kOrder, int kN = -1, int kM = -1>
[[gnu::always_inline]] inline PatchJet jet(const RationalBezierPatch& patch, double u, double v) {
  const int n = kN < 0 ? patch.degree_u() : kN, m = kM < 0 ? patch.degree_v() : kM;
  Weights bu, bv;
  make_weights<kOrder>(n, u, bu);
  make_weights<kOrder>(m, v, bv);
  Four h00{}, h10{}, h01{}, h20{}, h11{}, h02{};
  const Vec4* p = patch.points.values().data();
  for (int i = 0; i <= n; ++i) {
    Four s0{}, s1{}, s2{};
    for (int j = 0; j <= m; ++j, ++p) {
      Four point;
      std::memcpy(&point, p, sizeof point);
      s0 += bv.value[j] * point;
      if (kOrder > 0) s1 += bv.first[j] * point;
      if (kOrder > 1) s2 += bv.second[j] * point;
    }
    h00 += bu.value[i] * s0;
    if (kOrder > 0) {
      h10 += bu.first[i] * s0;
      h01 += bu.value[i] * s1;
    }
    if (kOrder > 1) {
      h20 += bu.second[i] * s0;
      h11 += bu.first[i] * s1;
      h02 += bu.value[i] * s2;
    }
  }
  // X / w and its derivatives, by the quotient rule.
  const double over = 1 / h00[3];
  PatchJet result;
  const Four point = h00 * over;
  result.point = head(point);
  if (kOrder == 0) return result;
  const Four by_u = (h10 - h10[3] * point) * over, by_v = (h01 - h01[3] * point) * over;
  result.u = head(by_u);
  result.v = head(by_v);
  if (kOrder == 1) return result;
  result.uu = head((h20 - 2 * h10[3] * by_u - h20[3] * point) * over);
  result.uv = head((h11 - h10[3] * by_v - h01[3] * by_u - h11[3] * point) * over);
  result.vv = head((h02 - 2 * h01[3] * by_v - h02[3] * point) * over);
  return result;
}

template <int kOrder>
[[gnu::always_inline]] inline PatchJet jet_of(const RationalBezierPatch& patch, double u,
                                              double v) {
  const bool bicubic = patch.degree_u() == 3 && patch.degree_v() == 3;
  return bicubic ? jet<kOrder, 3, 3>(patch, u, v) : jet<kOrder>(patch, u, v);
}

BLOSSOM_HOT Vec3 value(const RationalBezierPatch& patch, double u, double v) {
  return jet_of<0>(patch, u, v).point;
}

BLOSSOM_HOT PatchJet first_jet(const RationalBezierPatch& patch, double u, double v) {
  return jet_of<1>(patch, u, v);
}

BLOSSOM_HOT PatchJet second_jet(const RationalBezierPatch& patch, double u, double v) {
  return jet_of<2>(patch, u, v);
}

BLOSSOM_HOT CurveJet curve_jet(const RationalBezierCurve& curve, double t) {
  const int n = curve.degree();
  Four b[kMaxDegree + 1];
  std::memcpy(b, curve.points.data(), curve.points.size() * sizeof(Vec4));
  const double s = 1 - t;
  for (int count = n; count > 2; --count)
    for (int i = 0; i < count; ++i) b[i] = s * b[i] + t * b[i + 1];
  Four h1{}, h2{};
  if (n >= 2) {
    h2 = (n * (n - 1.0)) * (b[2] - 2 * b[1] + b[0]);
    b[0] = s * b[0] + t * b[1];
    b[1] = s * b[1] + t * b[2];
  }
  if (n >= 1) {
    h1 = static_cast<double>(n) * (b[1] - b[0]);
    b[0] = s * b[0] + t * b[1];
  }
  const double w = b[0][3];
  const Four point = b[0] / w;
  const Four first = (h1 - h1[3] * point) / w;
  const Four second = (h2 - 2 * h1[3] * first - h2[3] * point) / w;
  return {head(point), head(first), head(second)};
}

}  // namespace

Vec3 point_at(const RationalBezierPatch& patch, double u, double v) { return value(patch, u, v); }

PatchJet jet_at(const RationalBezierPatch& patch, double u, double v, int order) {
  return order < 2 ? first_jet(patch, u, v) : second_jet(patch, u, v);
}

CurveJet jet_at(const RationalBezierCurve& curve, double t) { return curve_jet(curve, t); }

}  // namespace blossom
