// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/topology/border_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/base/unbounded.h"
#include "core/blossom/composition.h"
#include "core/forms/algebra/degree.h"
#include "core/math/spans.h"
#include "core/subdivision/curve_subdivision.h"
#include "core/tracing/local_form.h"

namespace blossom {
namespace {

constexpr double kBesideKnot = 1e-9;  // of a span: what is no farther beyond it is on its border
constexpr int kKnotHalvings = 40;     // of a curve that crosses a knot: what is left is a point
constexpr int kAngleForm = 5;         // degree of a polynomial for an angle's tangent
constexpr int kFormHalvings = 12;     // of a curve that has no form: each divides the error by 64
constexpr double kFormError = 1e-12;  // of a span: what may be left of it

class Lifting {
 public:
  Lifting(const FaceTrims& trims, const BezierSurface& surface)
      : trims_(trims), surface_(surface) {}

  std::optional<std::vector<RationalBezierCurve>> run() {
    for (const std::vector<Coedge>& loop : trims_.loops)
      for (const Coedge& coedge : loop) {
        if (coedge.degenerated) continue;
        for (const PlanarSpan& span : coedge.curve.spans)
          if (!add(in_own_parameters(span.curve), 0)) return std::nullopt;
      }
    return std::move(lifted_);
  }

 private:
  PlanarBezier in_own_parameters(PlanarBezier curve) const {
    for (Vec3& p : curve.points) p = {p[0] / trims_.scale[0], p[1] / trims_.scale[1], p[2]};
    return curve;
  }

  // False if the surface along it is no curve of allowed degree.
  bool add(const PlanarBezier& curve, int depth) {
    const std::array knots{&surface_.u_knots, &surface_.v_knots};
    std::array<std::size_t, 2> span;
    Vec2 widths;
    PlanarBezier local = curve;
    bool inside = true;
    for (std::size_t k = 0; k < 2; ++k) {
      const int axis = static_cast<int>(k);
      double low = kUnbounded, high = -kUnbounded;
      for (const Vec3& p : curve.points) {
        low = std::min(low, p[axis] / p[2]);
        high = std::max(high, p[axis] / p[2]);
      }
      const std::vector<double>& at = *knots[k];
      const double middle = 0.5 * (low + high), period = trims_.period[axis] / trims_.scale[axis];
      // The turn of a closed surface in which the curve lies, half a period beside its knots at
      // most.
      const double off = middle - 0.5 * (at.front() + at.back());
      const double shift = period > 0 ? std::round(off / period) * period : 0;
      span[k] = span_of(at, middle - shift);
      const double from = at[span[k]], width = at[span[k] + 1] - from;
      const bool first = span[k] == 0, last = span[k] + 2 == at.size();
      inside = inside && (first || low - shift >= from - kBesideKnot * width) &&
               (last || high - shift <= from + (1 + kBesideKnot) * width);
      widths[axis] = width;
      for (Vec3& p : local.points) p[axis] = (p[axis] - (from + shift) * p[2]) / width;
    }
    if (!inside && depth < kKnotHalvings)
      return add(sub_curve(curve, {0, 0.5}), depth + 1) &&
             add(sub_curve(curve, {0.5, 1}), depth + 1);
    const RationalBezierPatch& patch =
        surface_.patches(static_cast<int>(span[0]), static_cast<int>(span[1]));
    const auto known = in_allowed_degree(local, widths, patch.degree_u() + patch.degree_v());
    if (!known) return false;
    if (!(known->error <= kFormError)) {
      if (depth >= kFormHalvings) return false;
      return add(sub_curve(curve, {0, 0.5}), depth + 1) &&
             add(sub_curve(curve, {0.5, 1}), depth + 1);
    }
    lifted_.push_back(composition(patch, known->form));
    return std::ranges::all_of(lifted_.back().points, [](const Vec4& p) { return p[3] > 0; });
  }

  // A curve whose coordinates are parts of spans, in the local parameters of a patch, and of a
  // degree that allows to compose them. None if it is rational where a parameter is an angle.
  //
  // degree   of the patch, the sum of both
  std::optional<ReducedOf<PlanarBezier>> in_allowed_degree(PlanarBezier curve, const Vec2& widths,
                                                           int degree) const {
    const bool angles =
        surface_.u_law != ParameterLaw::Linear || surface_.v_law != ParameterLaw::Linear;
    const int most = angles ? std::min(kAngleForm, kMaxDegree / degree) : kMaxDegree / degree;
    if (most < (angles ? kAngleForm : 1)) return std::nullopt;
    ReducedOf<PlanarBezier> form{std::move(curve), 0};
    if (form.form.degree() > most) form = reduced(form.form, most);
    if (angles && !replace_angles(form, widths)) return std::nullopt;
    return form;
  }

  // False if the curve is rational.
  bool replace_angles(ReducedOf<PlanarBezier>& form, const Vec2& widths) const {
    const double weight = form.form.points.front()[2];
    for (Vec3& p : form.form.points) {
      if (std::abs(p[2] - weight) > kFormError * weight) return false;
      p = {p[0] / weight, p[1] / weight, 1};
    }
    form.form = elevated(form.form, kAngleForm);
    for (const int axis : {0, 1}) {
      const ParameterLaw law = axis == 0 ? surface_.u_law : surface_.v_law;
      if (law == ParameterLaw::Linear) continue;
      const Interval span{0, widths[axis]};
      std::array<double, kAngleForm + 1> angles;
      for (std::size_t i = 0; i < angles.size(); ++i)
        angles[i] = form.form.points[i][axis] * length(span);
      const LocalForm local = local_form(angles, law, span, kAngleForm);
      for (std::size_t i = 0; i < angles.size(); ++i) form.form.points[i][axis] = local.points()[i];
      form.error = std::max(form.error, local.error);
    }
    return true;
  }

  const FaceTrims& trims_;
  const BezierSurface& surface_;
  std::vector<RationalBezierCurve> lifted_;
};

}  // namespace

std::optional<std::vector<RationalBezierCurve>> border_curves(const FaceTrims& trims,
                                                              const BezierSurface& surface) {
  return Lifting(trims, surface).run();
}

}  // namespace blossom
