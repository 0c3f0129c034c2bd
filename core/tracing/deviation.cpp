// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tracing/deviation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/errors.h"
#include "core/base/not_zero.h"
#include "core/base/parallel.h"
#include "core/forms/algebra/degree.h"
#include "core/math/roundoff.h"
#include "core/math/series/power_series.h"
#include "core/tracing/image_gap.h"
#include "core/tracing/packed_vec7.h"
#include "core/tracing/sites.h"

namespace blossom {
namespace {

constexpr double kSlack = 1.1;            // of a bound over the largest value seen
constexpr int kMaxHalvings = 400;         // of error forms, for one of the three bounds
constexpr int kMaxSpanHalvings = 12;      // halvings of a span before its forms are made
constexpr int kUnprovenSamples = 33;      // of a piece without a bound
constexpr double kEndOfPiece = 1e-9;      // cuts so near an end of a span are none
constexpr std::size_t kSpansOfProof = 8;  // that one thread proves in a row
constexpr std::size_t kMinShared = 16;    // forms whose bounds are worth sharing out
constexpr std::size_t kUsualForms = 8;    // that are kept: memory for them at once
constexpr double kConicError = 5e-11;     // model units: of a conic's polynomials
constexpr double kConicRounding = 16 * kUnitRoundoff;

// The blossom at five parameters of the form with these points over [0, 1].
Vec7 blossom_of(QuinticPoints c, const std::array<double, 5>& parameters) {
  for (std::size_t level = 0; level < 5; ++level)
    for (std::size_t i = 0; i + level < 5; ++i)
      c[i] = (1 - parameters[level]) * c[i] + parameters[level] * c[i + 1];
  return c[0];
}

QuinticPoints piece_of(const QuinticPoints& c, double from, double to) {
  QuinticPoints result;
  for (std::size_t k = 0; k <= 5; ++k) {
    std::array<double, 5> parameters;
    for (std::size_t i = 0; i < 5; ++i) parameters[i] = i < k ? to : from;
    result[k] = blossom_of(c, parameters);
  }
  return result;
}

// The Bezier points of the spline's span [flat[span], flat[span + 1]]: blossoms at its ends. Point
// k takes the end k times, then the start; the first steps of all points are the same.
BLOSSOM_HOT QuinticPoints span_points(const std::vector<Vec7>& poles,
                                      const std::vector<double>& flat, std::size_t span) {
  const auto step = [&](QuinticPoints & d, std::size_t r, double t) __attribute__((always_inline)) {
    for (std::size_t j = 5; j >= r; --j) {
      const double low = flat[span - 5 + j], high = flat[span + 1 + j - r];
      const double s = (t - low) / (high - low);
      PackedVec7 sum;
      add(1 - s, d[j - 1], sum);
      add(s, d[j], sum);
      store(sum, d[j]);
    }
  };
  QuinticPoints result, at_end;
  std::copy_n(poles.begin() + static_cast<std::ptrdiff_t>(span - 5), 6, at_end.begin());
  for (std::size_t k = 0; k <= 5; ++k) {
    if (k > 0) step(at_end, k, flat[span + 1]);
    QuinticPoints d = at_end;
    for (std::size_t r = k + 1; r <= 5; ++r) step(d, r, flat[span]);
    result[k] = d[5];
  }
  return result;
}

// A vector function in Bezier form whose length is to be bounded.
struct ErrorForm {
  SeriesForm form;
  double factor;  // the function is the form times at most this, and at least 1 / this
  double margin;

  double bound() const {
    double largest = 0;
    for (const Vec3& p : form.points()) largest = std::max(largest, dot(p, p));
    return std::sqrt(largest) * factor * (1 + 0x1p-40) + margin;
  }

  // A value that it has.
  double seen() const {
    const Vec3 &first = form.points().front(), &last = form.points().back();
    return std::sqrt(std::max(dot(first, first), dot(last, last))) / factor;
  }
};

// Splits a form at the middle: de Casteljau's triangle.
ErrorForm cut_off_first_half(ErrorForm& whole) {
  ErrorForm first = whole;
  const std::span<Vec3> p = whole.form.points();
  for (std::size_t k = 0; k < p.size(); ++k) {
    first.form.values[k] = p[0];
    for (std::size_t i = 0; i + k + 1 < p.size(); ++i) p[i] = 0.5 * (p[i] + p[i + 1]);
  }
  return first;
}

// Forms of which the largest length is asked. One whose bound is no more than a value that occurs
// decides nothing and is not kept: most are not.
class ErrorForms {
 public:
  void add(const ErrorForm& form) { add(form, form.bound()); }

  void add(const ErrorForm& form, double bound) {
    if (bound <= seen_) return;
    seen_ = std::max(seen_, form.seen());
    if (forms_.empty()) {
      forms_.reserve(kUsualForms);
      heap_.reserve(kUsualForms);
    }
    heap_.push_back({bound, forms_.size()});
    std::push_heap(heap_.begin(), heap_.end());
    forms_.push_back(form);
  }

  void add(const ErrorForms& other) {
    for (const auto& [bound, i] : other.heap_) add(other.forms_[i], bound);
  }

  std::size_t size() const { return forms_.size(); }

  // A bound on the largest length of all forms: the form with the largest bound is halved until
  // that is hardly more than a value that occurs.
  double proven_maximum() && {
    for (int step = 0; step < kMaxHalvings && !heap_.empty(); ++step) {
      const auto [bound, worst] = heap_.front();
      ErrorForm second = forms_[worst];
      if (bound - second.margin <= kSlack * seen_ || bound <= 2 * second.margin) break;
      std::pop_heap(heap_.begin(), heap_.end());
      heap_.pop_back();
      add(cut_off_first_half(second));
      add(second);
    }
    return heap_.empty() ? seen_ : heap_.front().first;
  }

 private:
  std::vector<ErrorForm> forms_;
  std::vector<std::pair<double, std::size_t>> heap_;  // bounds, and of which form
  double seen_ = 0;                                   // the largest value known to occur
};

SeriesForm of_degree(const SeriesForm& form, std::size_t degree) {
  const BezierCurve curve =
      elevated(BezierCurve{{form.points().begin(), form.points().end()}}, static_cast<int>(degree));
  SeriesForm result;
  result.count = curve.points.size();
  std::ranges::copy(curve.points, result.values.begin());
  return result;
}

SeriesForm difference(const SeriesForm& a, const SeriesForm& b) {
  if (a.count < b.count) return difference(of_degree(a, b.count - 1), b);
  if (b.count < a.count) return difference(a, of_degree(b, a.count - 1));
  SeriesForm result = a;
  for (std::size_t k = 0; k < a.count; ++k) result.values[k] -= b.values[k];
  return result;
}

class Proof {
 public:
  Proof(const BezierSurface& a, const BezierSurface& b)
      : surface_a_(a), surface_b_(b), a_(a, 3), b_(b, 5) {}

  // A span of the curve, cut where a chart passes into another patch.
  void add_span(const QuinticPoints& points) {
    std::vector<double> cuts;
    a_.add_cuts(points, cuts);
    b_.add_cuts(points, cuts);
    std::sort(cuts.begin(), cuts.end());
    double last = 0;
    for (const double cut : cuts) {
      if (cut - last < kEndOfPiece || 1 - cut < kEndOfPiece) continue;
      add_piece(piece_of(points, last, cut), 0);
      last = cut;
    }
    add_piece(last > 0 ? piece_of(points, last, 1) : points, 0);
  }

  // The same with the conic in place of the spline in space.
  void add_span(const QuinticPoints& points, const Interval& range, const Conic& conic) {
    const double bend = sixth_derivative_bound(conic, range);
    const double widest = std::pow(46080 * kConicError / std::max(bend, kNotZero), 1.0 / 6);
    const int count = static_cast<int>(std::ceil(length(range) / std::min(widest, length(range))));
    const auto cut = [&](int i) { return static_cast<double>(i) / count; };
    for (int i = 0; i < count; ++i) {
      QuinticPoints piece = count > 1 ? piece_of(points, cut(i), cut(i + 1)) : points;
      const Interval place{at(range, cut(i)), at(range, cut(i + 1))};
      const auto jet = [&](double t) {
        return std::array{point_at(conic, t), derivative_at(conic, t),
                          second_derivative_at(conic, t)};
      };
      const auto exact = hermite_points(jet(place.from), jet(place.to), length(place));
      double gap = 0, size = 0;
      for (std::size_t k = 0; k < exact.size(); ++k) {
        gap = std::max(gap, distance(exact[k], space(piece[k])));
        size = std::max(size, norm(exact[k]) + norm(exact[k] - conic.centre));
        piece[k] = seven(exact[k], chart_a(piece[k]), chart_b(piece[k]));
      }
      const double error = bend * std::pow(length(place), 6) / 46080 + kConicRounding * size;
      conic_error_ = std::max(conic_error_, error);
      result_.conic = std::max(result_.conic, gap + error);
      add_span(piece);
    }
  }

  // What another part of the curve gave.
  void add(const Proof& other) {
    forms_a_.add(other.forms_a_);
    forms_b_.add(other.forms_b_);
    forms_between_.add(other.forms_between_);
    result_.a = std::max(result_.a, other.result_.a);
    result_.b = std::max(result_.b, other.result_.b);
    result_.between = std::max(result_.between, other.result_.between);
    result_.proven = result_.proven && other.result_.proven;
    result_.conic = std::max(result_.conic, other.result_.conic);
    conic_error_ = std::max(conic_error_, other.conic_error_);
  }

  Deviation bounds() && {
    const std::array forms{&forms_a_, &forms_b_, &forms_between_};
    const std::array bounds{&result_.a, &result_.b, &result_.between};
    parallel_for(forms.size(), forms_a_.size() < kMinShared ? forms.size() : 1, [&](std::size_t k) {
      *bounds[k] = std::max(*bounds[k], std::move(*forms[k]).proven_maximum());
    });
    result_.a += conic_error_;
    result_.b += conic_error_;
    return result_;
  }

 private:
  void add_piece(const QuinticPoints& piece, int depth) {
    auto a = a_.on(piece, depth), b = a ? b_.on(piece, depth) : std::optional<ImageGap>{};
    if (a && b) return add_forms(*a, *b);
    if (depth == kMaxSpanHalvings || unprovable_) return sample(piece);
    add_piece(piece_of(piece, 0, 0.5), depth + 1);
    add_piece(piece_of(piece, 0.5, 1), depth + 1);
  }

  // What the forms leave out is a part of either function.
  void add_forms(const ImageGap& a, const ImageGap& b) {
    const ErrorForm on_a{a.form, 1 / (1 - a.relative), a.margin};
    const ErrorForm on_b{b.form, 1 / (1 - b.relative), b.margin};
    const double bound_a = on_a.bound(), bound_b = on_b.bound();
    forms_a_.add(on_a, bound_a);
    forms_b_.add(on_b, bound_b);
    const double margin = bound_a * a.relative + a.margin + bound_b * b.relative + b.margin;
    forms_between_.add({difference(a.form, b.form), 1, margin});
  }

  void sample(const QuinticPoints& piece) {
    unprovable_ = true;
    result_.proven = false;
    for (int i = 0; i < kUnprovenSamples; ++i) {
      const double t = i / (kUnprovenSamples - 1.0);
      const Gaps gaps = gaps_at(surface_a_, surface_b_, value_at(piece, t));
      result_.a = std::max(result_.a, gaps.a);
      result_.b = std::max(result_.b, gaps.b);
      result_.between = std::max(result_.between, gaps.between);
    }
  }

  const BezierSurface& surface_a_;
  const BezierSurface& surface_b_;
  ImageGaps a_, b_;
  ErrorForms forms_a_, forms_b_, forms_between_;
  Deviation result_;
  double conic_error_ = 0;  // of the polynomials that stand for the conic
  bool unprovable_ = false;
};

void check(const IntersectionCurve& curve) {
  const auto same = [&](const auto& chart) {
    return chart.degree == kFitDegree && chart.knots == curve.curve.knots &&
           chart.multiplicities == curve.curve.multiplicities &&
           chart.points.size() == curve.curve.points.size();
  };
  if (curve.curve.degree != kFitDegree || !same(curve.chart_a) || !same(curve.chart_b))
    throw InvalidInput("proven_deviation: the three splines must have degree 5 and the same knots");
}

}  // namespace

Deviation proven_deviation(const IntersectionCurve& curve, const BezierSurface& a,
                           const BezierSurface& b) {
  check(curve);
  std::vector<Vec7> poles;
  for (std::size_t i = 0; i < curve.curve.points.size(); ++i)
    poles.push_back(seven(curve.curve.points[i], curve.chart_a.points[i], curve.chart_b.points[i]));
  std::vector<double> flat;
  for (std::size_t i = 0; i < curve.curve.knots.size(); ++i)
    flat.insert(flat.end(), static_cast<std::size_t>(curve.curve.multiplicities[i]),
                curve.curve.knots[i]);
  std::vector<std::size_t> spans;
  for (std::size_t span = kFitDegree; span + kFitDegree + 1 < flat.size(); ++span)
    if (flat[span] < flat[span + 1]) spans.push_back(span);
  std::vector<Proof> proofs(1 + spans.size() / kSpansOfProof, Proof(a, b));
  parallel_for(proofs.size(), 1, [&](std::size_t i) {
    for (std::size_t k = i * kSpansOfProof; k < std::min((i + 1) * kSpansOfProof, spans.size());
         ++k) {
      const QuinticPoints points = span_points(poles, flat, spans[k]);
      const Interval range{flat[spans[k]], flat[spans[k] + 1]};
      curve.conic ? proofs[i].add_span(points, range, *curve.conic) : proofs[i].add_span(points);
    }
  });
  for (std::size_t i = 1; i < proofs.size(); ++i) proofs.front().add(proofs[i]);
  return std::move(proofs.front()).bounds();
}

}  // namespace blossom
