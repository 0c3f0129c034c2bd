// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/curve_spans.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/errors.h"
#include "core/forms/evaluation.h"

namespace blossom {

CurveSpans curve_spans(RationalBezierCurve curve) {
  CurveSpans result;
  result.rational = std::any_of(curve.points.begin(), curve.points.end(),
                                [](const Vec4& p) { return p[3] != 1; });
  result.spans.push_back({std::move(curve), {0, 1}, ParameterLaw::Linear});
  return result;
}

CurveSpans curve_spans(const BezierCurve& curve) {
  RationalBezierCurve homogeneous;
  homogeneous.points.reserve(curve.points.size());
  for (const Vec3& p : curve.points) homogeneous.points.push_back({p[0], p[1], p[2], 1});
  return curve_spans(std::move(homogeneous));
}

Vec3 point_at(const CurveSpans& curve, double parameter) {
  const Interval domain = curve.domain();
  const double at = std::clamp(parameter, domain.from, domain.to);
  const auto after =
      std::upper_bound(curve.spans.begin() + 1, curve.spans.end(), at,
                       [](double value, const CurveSpan& s) { return value < s.place.from; });
  const CurveSpan& span = *(after - 1);
  return jet_at(span.curve, std::clamp(local_parameter(span.law, span.place, at), 0.0, 1.0)).point;
}

void validate(const CurveSpans& curve, const char* name) {
  const auto refuse = [&](const std::string& what) {
    throw InvalidInput(std::string(name) + ": " + what);
  };
  if (curve.spans.empty()) refuse("the curve has no span");
  if (!(curve.error >= 0 && std::isfinite(curve.error))) refuse("its error must be 0 or more");
  for (std::size_t i = 0; i < curve.spans.size(); ++i) {
    const CurveSpan& span = curve.spans[i];
    if (!(std::isfinite(span.place.from) && std::isfinite(span.place.to) &&
          span.place.from < span.place.to))
      refuse("the place of span " + std::to_string(i) + " does not increase");
    if (i > 0 && span.place.from != curve.spans[i - 1].place.to)
      refuse("span " + std::to_string(i) + " does not start where the one before ends");
    if (span.curve.degree() < 1 || span.curve.degree() > kMaxDegree)
      refuse("span " + std::to_string(i) + " has degree " + std::to_string(span.curve.degree()) +
             ", wanted 1.." + std::to_string(kMaxDegree));
    for (const Vec4& p : span.curve.points) {
      if (!(std::isfinite(max_norm(p)) && p == p)) refuse("a control point is not finite");
      if (!(p[3] > 0)) refuse("a weight is not positive");
    }
  }
}

}  // namespace blossom
