// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/spans/flat_knots.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace blossom {
namespace {

/// Parts of a span this small, relative to the range, come from rounding, not from the model.
constexpr double kSliver = 1e-12;

int floor_div(int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

Grid<Vec4> transposed(const Grid<Vec4>& net) {
  Grid<Vec4> result(net.columns(), net.rows());
  for (int i = 0; i < net.rows(); ++i)
    for (int j = 0; j < net.columns(); ++j) result(j, i) = net(i, j);
  return result;
}

/// All columns of a net in Bezier form along the rows: degree + 1 rows for each span.
Grid<Vec4> bezier_rows(const FlatKnots& knots, const std::vector<FlatKnots::Span>& spans,
                       const Grid<Vec4>& net) {
  const int order = knots.degree() + 1;
  Grid<Vec4> result(order * static_cast<int>(spans.size()), net.columns());
  std::vector<Vec4> local(static_cast<std::size_t>(order)), points(local);
  for (int s = 0; s < static_cast<int>(spans.size()); ++s) {
    const FlatKnots::Span& span = spans[static_cast<std::size_t>(s)];
    const SpanForm form(knots, span);
    for (int j = 0; j < net.columns(); ++j) {
      for (int i = 0; i < order; ++i)
        local[static_cast<std::size_t>(i)] = net(knots.pole(span.index - order + 1 + i), j);
      form.bezier_points(local.data(), points.data());
      for (int i = 0; i < order; ++i)
        result(order * s + i, j) = points[static_cast<std::size_t>(i)];
    }
  }
  return result;
}

std::vector<double> breaks_of(const std::vector<FlatKnots::Span>& spans) {
  std::vector<double> knots{spans.front().place.from};
  for (const FlatKnots::Span& span : spans) knots.push_back(span.place.to);
  return knots;
}

}  // namespace

FlatKnots::FlatKnots(int degree) : degree_(degree) {
  knots_.assign(static_cast<std::size_t>(degree + 1), 0.0);
  knots_.resize(static_cast<std::size_t>(2 * degree + 2), 1.0);
}

FlatKnots::FlatKnots(int degree, std::span<const double> knots, std::span<const int> multiplicities,
                     bool periodic)
    : degree_(degree) {
  // A periodic sequence leaves out the last knot: it is the first one of the next turn.
  const std::size_t used = knots.size() - (periodic ? 1 : 0);
  for (std::size_t i = 0; i < used; ++i)
    knots_.insert(knots_.end(), static_cast<std::size_t>(multiplicities[i]), knots[i]);
  if (!periodic) return;
  period_ = knots.back() - knots.front();
  // Knot `degree` is the last copy of the first one: the domain begins there.
  const int count = static_cast<int>(knots_.size());
  const int first = multiplicities.front() - 1 - degree;
  std::vector<double> turned(knots_.size());
  for (int i = 0; i < count; ++i) {
    const int turn = floor_div(i + first, count);
    turned[static_cast<std::size_t>(i)] =
        knots_[static_cast<std::size_t>(i + first - turn * count)] + turn * period_;
  }
  knots_ = std::move(turned);
}

double FlatKnots::knot(int i) const {
  if (period_ == 0) return knots_[static_cast<std::size_t>(i)];
  const int count = static_cast<int>(knots_.size());
  const int turn = floor_div(i, count);
  return knots_[static_cast<std::size_t>(i - turn * count)] + turn * period_;
}

int FlatKnots::pole(int i) const {
  if (period_ == 0) return i;
  const int count = static_cast<int>(knots_.size());
  return i - floor_div(i, count) * count;
}

std::vector<FlatKnots::Span> FlatKnots::spans(const Interval& range) const {
  const int count = static_cast<int>(knots_.size());
  int first = degree_;
  int last = count - degree_ - 2;
  if (period_ > 0) {
    first = count * static_cast<int>(std::floor((range.from - knots_.front()) / period_) - 1);
    last = count * static_cast<int>(std::ceil((range.to - knots_.front()) / period_) + 1);
  }
  const double sliver = kSliver * (range.to - range.from);
  std::vector<Span> found;
  for (int i = first; i <= last; ++i) {
    if (knot(i) >= knot(i + 1)) continue;
    const Interval place{std::max(knot(i), range.from), std::min(knot(i + 1), range.to)};
    if (length(place) > sliver) found.push_back({i, place});
  }
  if (found.empty()) return found;
  found.front().place.from = range.from;
  found.back().place.to = range.to;
  for (std::size_t i = 1; i < found.size(); ++i) found[i].place.from = found[i - 1].place.to;
  return found;
}

SpanForm::SpanForm(const FlatKnots& knots, const FlatKnots::Span& span) : degree_(knots.degree()) {
  const int n = degree_;
  std::vector<double> near;  // the knots that count
  near.reserve(static_cast<std::size_t>(2 * n));
  for (int i = span.index - n + 1; i <= span.index + n; ++i) near.push_back(knots.knot(i));
  // Between knots of full multiplicity the poles are the Bezier points.
  const auto middle = near.begin() + n;
  if (std::count(near.begin(), middle, span.place.from) == n &&
      std::count(middle, near.end(), span.place.to) == n)
    return;
  alphas_.reserve(static_cast<std::size_t>(n * (n + 1) / 2 * (n + 1)));
  for (int k = 0; k <= n; ++k)
    for (int r = 1; r <= n; ++r) {
      const double x = r <= n - k ? span.place.from : span.place.to;
      for (int i = n; i >= r; --i) {
        const double low = near[static_cast<std::size_t>(i - 1)];
        const double high = near[static_cast<std::size_t>(n + i - r)];
        alphas_.push_back(x == low ? 0 : x == high ? 1 : (x - low) / (high - low));
      }
    }
}

void SpanForm::bezier_points(const Vec4* poles, Vec4* points) const {
  const int n = degree_;
  if (alphas_.empty()) {
    std::copy(poles, poles + n + 1, points);
    return;
  }
  Vec4 d[kMaxDegree + 1];
  const double* alpha = alphas_.data();
  for (int k = 0; k <= n; ++k) {
    std::copy(poles, poles + n + 1, d);
    for (int r = 1; r <= n; ++r)
      for (int i = n; i >= r; --i, ++alpha) {
        if (*alpha == 0)
          d[i] = d[i - 1];
        else if (*alpha != 1)
          d[i] = (1 - *alpha) * d[i - 1] + *alpha * d[i];
      }
    points[k] = d[n];
  }
}

CurveSpans spline_spans(const FlatKnots& knots, const std::vector<FlatKnots::Span>& spans,
                        const std::vector<Vec4>& poles) {
  CurveSpans result;
  for (const FlatKnots::Span& span : spans) {
    std::vector<Vec4> local;
    for (int i = span.index - knots.degree(); i <= span.index; ++i)
      local.push_back(poles[static_cast<std::size_t>(knots.pole(i))]);
    RationalBezierCurve curve{std::vector<Vec4>(local.size())};
    SpanForm(knots, span).bezier_points(local.data(), curve.points.data());
    result.spans.push_back({std::move(curve), span.place, ParameterLaw::Linear});
  }
  for (const Vec4& p : poles) result.rational = result.rational || p[3] != 1;
  return result;
}

BezierSurface spline_patches(const FlatKnots& u, const std::vector<FlatKnots::Span>& u_spans,
                             const FlatKnots& v, const std::vector<FlatKnots::Span>& v_spans,
                             const Grid<Vec4>& net) {
  const Grid<Vec4> along_u = bezier_rows(u, u_spans, net);
  const Grid<Vec4> all = transposed(bezier_rows(v, v_spans, transposed(along_u)));
  BezierSurface result;
  result.u_knots = breaks_of(u_spans);
  result.v_knots = breaks_of(v_spans);
  const int rows = u.degree() + 1, columns = v.degree() + 1;
  result.patches =
      Grid<RationalBezierPatch>(static_cast<int>(u_spans.size()), static_cast<int>(v_spans.size()),
                                {Grid<Vec4>(rows, columns)});
  for (int i = 0; i < all.rows(); ++i)
    for (int j = 0; j < all.columns(); ++j)
      result.patches(i / rows, j / columns).points(i % rows, j % columns) = all(i, j);
  return result;
}

}  // namespace blossom
