// SPDX-License-Identifier: LGPL-2.1-or-later
// Flat knots, arcs and fits, shared by curves and surfaces.

#include "adapters/occt/convert/curves_detail.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/base/points.h"
#include "adapters/occt/convert/limits.h"

namespace blossom::occt {
namespace {

/// Parts of a span this small, relative to the range, come from rounding, not from the model.
constexpr double kSliver = 1e-12;

/// cos and sin of multiples of pi / 2 miss 0 by about this much.
constexpr double kZeroOfAngle = 4e-16;

double weighted(double x, double weight) {
  const double product = x * weight;
  if (product / weight == x) return product;
  for (const double towards : {-HUGE_VAL, HUGE_VAL}) {
    const double neighbour = std::nextafter(product, towards);
    if (neighbour / weight == x) return neighbour;
  }
  return product;
}

double snapped(double x) { return std::abs(x) <= kZeroOfAngle ? 0.0 : x; }

int floor_div(int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

}  // namespace

TColStd_Array1OfReal knot_array(const std::vector<double>& knots) {
  TColStd_Array1OfReal array(1, static_cast<int>(knots.size()));
  std::copy(knots.begin(), knots.end(), array.begin());
  return array;
}

Vec4 homogeneous(const gp_Pnt& point, double weight) {
  if (weight == 1) return with_weight(vec(point), 1);
  return {weighted(point.X(), weight), weighted(point.Y(), weight), weighted(point.Z(), weight),
          weight};
}

gp_Pnt euclidean(const Vec4& point) {
  const double w = point[3];
  return w == 1 ? gp_Pnt(point[0], point[1], point[2])
                : gp_Pnt(point[0] / w, point[1] / w, point[2] / w);
}

FlatKnots::FlatKnots(int degree) : degree_(degree) {
  knots_.assign(static_cast<std::size_t>(degree + 1), 0.0);
  knots_.resize(static_cast<std::size_t>(2 * degree + 2), 1.0);
}

FlatKnots::FlatKnots(int degree, const TColStd_Array1OfReal& knots,
                     const TColStd_Array1OfInteger& multiplicities, bool periodic)
    : degree_(degree) {
  // A periodic sequence leaves out the last knot: it is the first one of the next turn.
  const int last = periodic ? knots.Upper() - 1 : knots.Upper();
  for (int i = knots.Lower(); i <= last; ++i)
    knots_.insert(knots_.end(), static_cast<std::size_t>(multiplicities(i)), knots(i));
  if (!periodic) return;
  period_ = knots(knots.Upper()) - knots(knots.Lower());
  // Knot `degree` is the last copy of the first one: the domain begins there.
  const int count = static_cast<int>(knots_.size());
  const int first = multiplicities(multiplicities.Lower()) - 1 - degree;
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
  if (found.empty()) throw BadModel("the range lies outside of the knots");
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

std::vector<ArcSpan> arc_spans(const Interval& angles, ArcCuts cuts) {
  constexpr double kOffEven = 0.113;    // of a span
  constexpr double kRoundTurn = 1e-12;  // part of a turn: what is missing is rounding
  const double turn = 2 * std::numbers::pi;
  const double size = length(angles);
  const int count = std::max(1, static_cast<int>(std::ceil(size / (turn / 4) - kQuarterSlack)));
  const bool whole = std::abs(size - turn) <= kRoundTurn * turn;
  std::vector<ArcSpan> spans;
  const double off = cuts == ArcCuts::Shifted ? kOffEven * (size / count) : 0;
  const auto start = [&](int i) {
    return i == 0 ? angles.from : angles.from + i * (size / count) + off;
  };
  for (int i = 0; i < count; ++i) {
    const double from = start(i);
    const double to = i + 1 == count ? angles.to : start(i + 1);
    const double end = whole && i + 1 == count ? angles.from : to;
    const double middle = (from + to) / 2;
    spans.push_back({{from, to},
                     {snapped(std::cos(from)), snapped(std::cos(middle)), snapped(std::cos(end))},
                     {snapped(std::sin(from)), snapped(std::sin(middle)), snapped(std::sin(end))},
                     {1, std::cos((to - from) / 2), 1}});
  }
  return spans;
}

const std::vector<double>& fit_nodes() {
  static const std::vector<double> nodes = [] {
    std::vector<double> x;
    for (int i = 0; i <= kFitDegree; ++i)
      x.push_back((1 - std::cos(std::numbers::pi * i / kFitDegree)) / 2);
    x.back() = 1;
    return x;
  }();
  return nodes;
}

namespace {

/// Values of the Bernstein polynomials (columns) in the nodes (rows), beside the unit matrix.
Grid<long double> fit_system() {
  constexpr int n = kFitDegree;
  Grid<long double> a(n + 1, 2 * n + 2);
  for (int i = 0; i <= n; ++i) {
    const long double t = fit_nodes()[static_cast<std::size_t>(i)];
    long double binomial = 1;
    for (int j = 0; j <= n; ++j) {
      a(i, j) = binomial * std::pow(t, static_cast<long double>(j)) *
                std::pow(1 - t, static_cast<long double>(n - j));
      binomial = binomial * (n - j) / (j + 1);
    }
    a(i, n + 1 + i) = 1;
  }
  return a;
}

}  // namespace

const Grid<double>& fit_matrix() {
  static const Grid<double> matrix = [] {
    constexpr int n = kFitDegree;
    Grid<long double> a = fit_system();
    // Gauss-Jordan without pivoting: Bernstein matrices in increasing nodes are totally positive.
    for (int k = 0; k <= n; ++k) {
      const long double pivot = a(k, k);
      for (int j = 0; j < 2 * n + 2; ++j) a(k, j) /= pivot;
      for (int i = 0; i <= n; ++i) {
        const long double factor = i == k ? 0 : a(i, k);
        for (int j = 0; j < 2 * n + 2; ++j) a(i, j) -= factor * a(k, j);
      }
    }
    Grid<double> inverse(n + 1, n + 1);
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j) inverse(i, j) = static_cast<double>(a(i, n + 1 + j));
    for (int j = 0; j <= n; ++j) {
      inverse(0, j) = j == 0 ? 1 : 0;
      inverse(n, j) = j == n ? 1 : 0;
    }
    return inverse;
  }();
  return matrix;
}

Interval checked_range(const Interval& range, const Interval& natural, const std::string& what) {
  const auto text = [](const Interval& i) {
    return "[" + std::to_string(i.from) + ", " + std::to_string(i.to) + "]";
  };
  if (!std::isfinite(range.from) || !std::isfinite(range.to) ||
      std::abs(range.from) > kFarthestPlace || std::abs(range.to) > kFarthestPlace)
    throw BadModel(what + " is not finite");
  if (!(range.from < range.to)) throw BadModel(what + " is empty: " + text(range));
  const double slack = kRangeRounding * length(range);
  if (range.from < natural.from - slack || range.to > natural.to + slack)
    throw BadModel(what + ", " + text(range) + ", leaves the natural bounds " + text(natural));
  const Interval inside{std::max(range.from, natural.from), std::min(range.to, natural.to)};
  if (!(inside.from < inside.to)) throw BadModel(what + " is empty: " + text(range));
  return inside;
}

bool is_bounded(const gp_XYZ& point) {
  return std::abs(point.X()) < kFarthestPlace && std::abs(point.Y()) < kFarthestPlace &&
         std::abs(point.Z()) < kFarthestPlace;
}

void check_bounded(const gp_XYZ& point, const std::string& what) {
  if (!is_bounded(point)) throw BadModel(what + " is not finite");
}

void check_finite(const gp_XYZ& point, const std::string& what) {
  if (!std::isfinite(point.X()) || !std::isfinite(point.Y()) || !std::isfinite(point.Z()))
    throw BadModel(what + " is not finite");
}

void check_weight(double weight, const std::string& what) {
  if (!std::isfinite(weight) || weight <= 0)
    throw BadModel(what + " is " + std::to_string(weight) + ", weights must be positive");
}

}  // namespace blossom::occt
