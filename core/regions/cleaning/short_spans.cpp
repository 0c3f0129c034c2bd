// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/regions/cleaning/short_spans.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/forms/algebra/interpolation.h"

namespace blossom {
namespace {

constexpr int kSamples = 8;     // of a span
constexpr double kShort = 100;  // of what points may move by: lengths of spans

double length_in_space(const BezierSurface& surface, const PlanarSpan& span) {
  double sum = 0;
  Vec3 last;
  for (int k = 0; k <= kSamples; ++k) {
    const Vec2 uv = jet_at(span.curve, static_cast<double>(k) / kSamples).point;
    const Vec3 p = point_at(surface, uv);
    if (k > 0) sum += distance(last, p);
    last = p;
  }
  return sum;
}

class Joiner {
 public:
  Joiner(const BezierSurface& surface, const PlanarCurve& curve, double within)
      : surface_(surface), curve_(curve), within_(within) {}

  PlanarCurve joined() const {
    PlanarCurve result;
    for (const PlanarSpan& span : curve_.spans) {
      if (!result.spans.empty() && (is_short(span) || is_short(result.spans.back())))
        if (const auto both = over_both(result.spans.back(), span)) {
          result.spans.back() = *both;
          continue;
        }
      result.spans.push_back(span);
    }
    return result;
  }

 private:
  bool is_short(const PlanarSpan& span) const {
    return length_in_space(surface_, span) <= kShort * within_;
  }

  // One span through points of the curve, if it stays near enough.
  std::optional<PlanarSpan> over_both(const PlanarSpan& first, const PlanarSpan& second) const {
    if (first.law != ParameterLaw::Linear || second.law != ParameterLaw::Linear)
      return std::nullopt;
    PlanarSpan both{{}, {first.place.from, second.place.to}};
    const int degree = std::max({first.curve.degree(), second.curve.degree(), 1});
    std::vector<Vec2> through;
    for (const double t : extreme_points(degree))
      through.push_back(point_at(curve_, at(both.place, t)));
    through.front() = projected(first.curve.points.front());
    through.back() = projected(second.curve.points.back());
    for (const Vec2& p : bezier_through(through).points)
      both.curve.points.push_back({p[0], p[1], 1});
    return is_near(both) ? std::optional(both) : std::nullopt;
  }

  bool is_near(const PlanarSpan& span) const {
    for (int k = 1; k < 2 * kSamples; ++k) {
      const double t = static_cast<double>(k) / (2 * kSamples);
      const Vec3 was = point_at(surface_, point_at(curve_, at(span.place, t)));
      if (distance(was, point_at(surface_, jet_at(span.curve, t).point)) > within_) return false;
    }
    return true;
  }

  const BezierSurface& surface_;
  const PlanarCurve& curve_;
  double within_;
};

}  // namespace

PlanarCurve without_short_spans(const BezierSurface& surface, PlanarCurve curve, double within) {
  return curve.spans.size() < 2 ? curve : Joiner(surface, curve, within).joined();
}

TrimmedChart without_short_spans(const BezierSurface& surface, TrimmedChart chart, double within) {
  for (RegionBorder& border : chart.borders)
    border.curve = without_short_spans(surface, std::move(border.curve), within);
  return chart;
}

}  // namespace blossom
