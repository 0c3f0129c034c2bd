// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/spans/fitted_spans.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <utility>

#include "core/forms/spans/homogeneous.h"
#include "core/math/grid.h"
#include "core/math/interval.h"

namespace blossom {
namespace {

/// A choice: at 1e-8 of the size, the patches that a bent surface needs are a seventh of those of
/// degree 5, and each takes twice as long to search.
constexpr int kNodeDegree = 8;

/// What sampled errors are multiplied with, since samples may miss the largest one.
constexpr double kErrorSafety = 2.0;

/// A span that does not meet the tolerance is halved at most this often.
constexpr int kMaxHalvings = 10;

/// Samples of the error in a span, between the nodes.
constexpr int kSpanSamples = 4 * kNodeDegree + 3;

/// Spans per direction after which an unmet tolerance is left as it is, and reported.
constexpr std::size_t kMaxSpans = 96;

/// Rounds of halving.
constexpr int kMaxRounds = 8;

/// Halving a span halves the error at a kink, and takes a root's to 0.71 of it; that of a jump
/// remains, but also that of a crest that is far narrower than the span.
constexpr double kLessened = 0.75;

/// Bisections of what lies between two samples, after which it is as narrow as between those of the
/// smallest patches that there can be: what differs there as before is a jump to all of them.
constexpr int kBisections = kMaxRounds;

/// Those between all samples of a curve, which make a jump of an eighth of the error stand out.
constexpr int kFirstBisections = 3;

/// Local parameters of the nodes in [0, 1].
const std::vector<double>& fit_nodes() {
  static const std::vector<double> nodes = [] {
    std::vector<double> x;
    for (int i = 0; i <= kNodeDegree; ++i)
      x.push_back((1 - std::cos(std::numbers::pi * i / kNodeDegree)) / 2);
    x.back() = 1;
    return x;
  }();
  return nodes;
}

double node(int i) { return fit_nodes()[static_cast<std::size_t>(i)]; }

/// Where the error of interpolation is largest between the nodes i and i + 1, as far as the
/// product of the distances from all nodes says it.
double between_nodes(int i) {
  return (1 - std::cos(std::numbers::pi * (i + 0.5) / kNodeDegree)) / 2;
}

/// Where a patch is compared with what it fits, in each direction: between the nodes, and in the
/// first, the middle and the last of them.
constexpr int kPatchSamples = kNodeDegree + 3;

bool is_node(int sample) { return sample >= kNodeDegree; }

const std::array<double, kPatchSamples>& sample_places() {
  static const std::array<double, kPatchSamples> all = [] {
    std::array<double, kPatchSamples> places{};
    for (int k = 0; k < kPatchSamples; ++k)
      places[static_cast<std::size_t>(k)] =
          is_node(k) ? node((k - kNodeDegree) * kNodeDegree / 2) : between_nodes(k);
    return places;
  }();
  return all;
}

double sample(int k) { return sample_places()[static_cast<std::size_t>(k)]; }

/// Values of the Bernstein polynomials in [0, 1].
std::array<long double, kNodeDegree + 1> bernstein(long double t) {
  constexpr int n = kNodeDegree;
  std::array<long double, n + 1> values{};
  long double binomial = 1;
  for (int j = 0; j <= n; ++j) {
    values[static_cast<std::size_t>(j)] = binomial * std::pow(t, static_cast<long double>(j)) *
                                          std::pow(1 - t, static_cast<long double>(n - j));
    binomial = binomial * (n - j) / (j + 1);
  }
  return values;
}

/// Those of each sample, by rows: patches have the same ones, of which there are many.
const Grid<double>& sample_basis() {
  static const Grid<double> basis = [] {
    Grid<double> b(kPatchSamples, kNodeDegree + 1);
    for (int k = 0; k < kPatchSamples; ++k)
      for (int j = 0; j <= kNodeDegree; ++j)
        b(k, j) = static_cast<double>(bernstein(sample(k))[static_cast<std::size_t>(j)]);
    return b;
  }();
  return basis;
}

/// Values of the Bernstein polynomials (columns) in the nodes (rows), beside the unit matrix.
Grid<long double> fit_system() {
  constexpr int n = kNodeDegree;
  Grid<long double> a(n + 1, 2 * n + 2);
  for (int i = 0; i <= n; ++i) {
    const std::array<long double, n + 1> values = bernstein(node(i));
    for (int j = 0; j <= n; ++j) a(i, j) = values[static_cast<std::size_t>(j)];
    a(i, n + 1 + i) = 1;
  }
  return a;
}

/// Takes values in the nodes to Bezier points. The first and the last row are exact.
const Grid<double>& fit_matrix() {
  static const Grid<double> matrix = [] {
    constexpr int n = kNodeDegree;
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

using FitPoints = std::array<Vec4, kNodeDegree + 1>;

Vec4 casteljau(FitPoints points, double t) {
  for (std::size_t n = points.size() - 1; n > 0; --n)
    for (std::size_t i = 0; i < n; ++i) points[i] = (1 - t) * points[i] + t * points[i + 1];
  return points.front();
}

class CurveFit {
 public:
  CurveFit(const std::function<Vec3(double)>& value, double tolerance)
      : value_(value), tolerance_(tolerance) {}

  void add(const Interval& place, int halvings = 0) {
    RationalBezierCurve fitted = fit(place);
    const double error = kErrorSafety * error_of(fitted, place);
    if (error > tolerance_ && halvings < kMaxHalvings) {
      const double middle = at(place, 0.5);
      add({place.from, middle}, halvings + 1);
      add({middle, place.to}, halvings + 1);
      return;
    }
    result.error = std::max(result.error, error);
    result.spans.push_back({std::move(fitted), place, ParameterLaw::Linear});
  }

  CurveSpans result;

 private:
  RationalBezierCurve fit(const Interval& place) const {
    RationalBezierCurve fitted;
    fitted.points.resize(kNodeDegree + 1, Vec4{0, 0, 0, 1});
    for (int j = 0; j <= kNodeDegree; ++j) {
      const Vec3 p = value_(at(place, node(j)));
      for (int i = 0; i <= kNodeDegree; ++i)
        fitted.points[static_cast<std::size_t>(i)] += fit_matrix()(i, j) * with_weight(p, 0);
    }
    return fitted;
  }

  double error_of(const RationalBezierCurve& fitted, const Interval& place) const {
    FitPoints points;
    std::ranges::copy(fitted.points, points.begin());
    double largest = 0;
    for (int k = 1; k < kSpanSamples; ++k) {
      const double t = static_cast<double>(k) / kSpanSamples;
      largest = std::max(largest, distance(head(casteljau(points, t)), value_(at(place, t))));
    }
    return largest;
  }

  const std::function<Vec3(double)>& value_;
  double tolerance_;
};

/// Error of a patch, and its parts by the direction in which the interpolation runs.
struct PatchError {
  double all = 0;
  double u = 0;
  double v = 0;
  Vec2 worst{};  ///< local parameters of the sample that is off most
};

/// Two places on a curve, and what it is off by there.
struct Step {
  Interval places;
  Vec3 from, to;

  double height() const { return distance(from, to); }

  void keep_steeper_half(const std::function<Vec3(double)>& error) {
    const double middle = at(places, 0.5);
    const Vec3 between = error(middle);
    const bool first = distance(from, between) > distance(between, to);
    (first ? places.to : places.from) = middle;
    (first ? to : from) = between;
  }
};

/// By how much values jump. Halving a step between samples takes half of its height where the error
/// is smooth, nothing where it jumps: after a few halvings the highest step has the jump in it.
///
/// fitted   the curve that is off by the error, in [0, 1]
double jump_along(const std::function<Vec3(double)>& value, const FitPoints& fitted) {
  const auto error = [&](double t) { return value(t) - head(casteljau(fitted, t)); };
  std::array<Step, 2 * kNodeDegree> steps;
  double before = 0;
  Vec3 last = error(before);
  for (int i = 0; i < 2 * kNodeDegree; ++i) {
    const double t = i % 2 == 0 ? between_nodes(i / 2) : node(i / 2 + 1);
    const Vec3 here = error(t);
    steps[static_cast<std::size_t>(i)] = {{before, t}, last, here};
    before = t;
    last = here;
  }
  for (Step& step : steps)
    for (int i = 0; i < kFirstBisections; ++i) step.keep_steeper_half(error);
  Step highest = *std::ranges::max_element(steps, {}, &Step::height);
  for (int i = kFirstBisections; i < kBisections; ++i) highest.keep_steeper_half(error);
  return highest.height();
}

/// The curve of a patch at a local parameter in the other direction.
FitPoints curve_of(const RationalBezierPatch& patch, double other, bool along_u) {
  FitPoints curve{}, across{};
  for (int i = 0; i <= kNodeDegree; ++i) {
    for (int j = 0; j <= kNodeDegree; ++j)
      across[static_cast<std::size_t>(j)] = along_u ? patch.points(i, j) : patch.points(j, i);
    curve[static_cast<std::size_t>(i)] = casteljau(across, other);
  }
  return curve;
}

class SurfaceFit {
 public:
  SurfaceFit(const std::function<Vec3(double, double)>& value, double tolerance)
      : value_(value), tolerance_(tolerance) {}

  BezierSurface run(std::vector<double> u_knots, std::vector<double> v_knots) const {
    Pieces pieces;
    BezierSurface result;
    double tolerance = tolerance_;
    for (int round = 0;; ++round) {
      pieces = fitted(u_knots, v_knots, result, std::move(pieces));
      result.u_knots = u_knots;
      result.v_knots = v_knots;
      // No patch is nearer to a jump than half of it, and errors are of the whole surface.
      for (const Piece& piece : pieces.values())
        tolerance = std::max(tolerance, kErrorSafety * piece.jump);
      Cuts u_cuts, v_cuts;
      result.error = find_cuts(pieces, tolerance, u_knots, v_knots, u_cuts, v_cuts);
      if (result.error <= tolerance || round == kMaxRounds) break;
      const bool more_u = add(u_cuts, u_knots), more_v = add(v_cuts, v_knots);
      if (!more_u && !more_v) break;
    }
    result.patches = Grid<RationalBezierPatch>(pieces.rows(), pieces.columns());
    for (int r = 0; r < pieces.rows(); ++r)
      for (int c = 0; c < pieces.columns(); ++c)
        result.patches(r, c) = std::move(pieces(r, c).patch);
    return result;
  }

 private:
  using Cuts = std::map<double, double>;  ///< places, and the largest error that each is to lessen

  struct Piece {
    RationalBezierPatch patch;
    PatchError error;
    double jump =
        0;  ///< by which the surface jumps in it, where halving has not lessened the error
  };
  using Pieces = Grid<Piece>;

  /// Adds the cuts that lessen the largest errors, as many as there is room for; whether any.
  static bool add(const Cuts& cuts, std::vector<double>& knots) {
    std::vector<std::pair<double, double>> largest;  // errors, negative, and places
    for (const auto& [place, error] : cuts) largest.emplace_back(-error, place);
    std::ranges::sort(largest);
    const std::size_t room = kMaxSpans + 1 - std::min(knots.size(), kMaxSpans + 1);
    largest.resize(std::min(largest.size(), room));
    for (const auto& [error, place] : largest) knots.push_back(place);
    std::ranges::sort(knots);
    return !largest.empty();
  }

  /// Values in the nodes, then the fit in one direction and in the other. Borders depend on
  /// values on the border alone, so neighbours share them bit for bit.
  RationalBezierPatch patch(const Interval& u, const Interval& v) const {
    constexpr int n = kNodeDegree;
    const Grid<double>& m = fit_matrix();
    Grid<Vec3> values(n + 1, n + 1), half(n + 1, n + 1);
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j) values(i, j) = value_(at(u, node(i)), at(v, node(j)));
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j)
        for (int k = 0; k <= n; ++k) half(i, j) += m(i, k) * values(k, j);
    RationalBezierPatch result{Grid<Vec4>(n + 1, n + 1, {0, 0, 0, 1})};
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j)
        for (int k = 0; k <= n; ++k) result.points(i, j) += m(j, k) * with_weight(half(i, k), 0);
    return result;
  }

  /// Which spans of `knots` are spans of `before`, by their indices there; -1 for others.
  static std::vector<int> kept_spans(const std::vector<double>& knots,
                                     const std::vector<double>& before) {
    std::vector<int> kept(knots.size() - 1, -1);
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      const auto found = std::ranges::lower_bound(before, knots[i]);
      if (found == before.end() || *found != knots[i]) continue;
      if (std::next(found) != before.end() && *std::next(found) == knots[i + 1])
        kept[i] = static_cast<int>(found - before.begin());
    }
    return kept;
  }

  /// The span of `before` in which that of `knots` lies.
  static int span_around(const std::vector<double>& before, double from) {
    return static_cast<int>(std::ranges::upper_bound(before, from) - before.begin()) - 1;
  }

  /// before   that it is a part of; may be null
  Piece new_piece(const Interval& u, const Interval& v, const Piece* before) const {
    Piece piece;
    piece.patch = patch(u, v);
    piece.error = error_of(piece.patch, u, v);
    const double error = piece.error.all;
    if (before == nullptr || kErrorSafety * error <= tolerance_) return piece;
    if (before->jump == 0 && error <= kLessened * before->error.all) return piece;
    const double worst_u = piece.error.worst[0], worst_v = piece.error.worst[1];
    const double jump =
        std::max(jump_along([&, v = at(v, worst_v)](double t) { return value_(at(u, t), v); },
                            curve_of(piece.patch, worst_v, true)),
                 jump_along([&, u = at(u, worst_u)](double t) { return value_(u, at(v, t)); },
                            curve_of(piece.patch, worst_u, false)));
    if (2 * jump >= error) piece.jump = jump;  // else the jump is not what the piece is off by
    return piece;
  }

  /// The pieces between the knots; those that were there `before` are taken over.
  Pieces fitted(const std::vector<double>& u, const std::vector<double>& v,
                const BezierSurface& before, Pieces pieces) const {
    const std::vector<int> rows = kept_spans(u, before.u_knots);
    const std::vector<int> columns = kept_spans(v, before.v_knots);
    Pieces result(static_cast<int>(rows.size()), static_cast<int>(columns.size()));
    for (int r = 0; r < result.rows(); ++r)
      for (int c = 0; c < result.columns(); ++c) {
        const int row = rows[static_cast<std::size_t>(r)];
        const int column = columns[static_cast<std::size_t>(c)];
        if (row >= 0 && column >= 0) {
          result(r, c) = std::move(pieces(row, column));
          continue;
        }
        const Interval its_u = span(u, r), its_v = span(v, c);
        const Piece* const around = pieces.empty()
                                        ? nullptr
                                        : &pieces(span_around(before.u_knots, its_u.from),
                                                  span_around(before.v_knots, its_v.from));
        result(r, c) = new_piece(its_u, its_v, around);
      }
    return result;
  }

  static Interval span(const std::vector<double>& knots, int i) {
    return {knots[static_cast<std::size_t>(i)], knots[static_cast<std::size_t>(i + 1)]};
  }

  /// The patch at all pairs of `sample`.
  static Grid<Vec3> samples_of(const RationalBezierPatch& net) {
    const Grid<double>& basis = sample_basis();
    Grid<Vec4> half(kPatchSamples, kNodeDegree + 1);
    for (int i = 0; i < kPatchSamples; ++i)
      for (int c = 0; c <= kNodeDegree; ++c)
        for (int r = 0; r <= kNodeDegree; ++r) half(i, c) += basis(i, r) * net.points(r, c);
    Grid<Vec3> samples(kPatchSamples, kPatchSamples);
    for (int i = 0; i < kPatchSamples; ++i)
      for (int j = 0; j < kPatchSamples; ++j) {
        Vec4 sum{};
        for (int c = 0; c <= kNodeDegree; ++c) sum += basis(j, c) * half(i, c);
        samples(i, j) = head(sum);
      }
    return samples;
  }

  PatchError error_of(const RationalBezierPatch& net, const Interval& u, const Interval& v) const {
    const Grid<Vec3> samples = samples_of(net);
    PatchError error;
    for (int i = 0; i < kPatchSamples; ++i)
      for (int j = 0; j < kPatchSamples; ++j) {
        if (is_node(i) && is_node(j)) continue;
        const double gap = distance(samples(i, j), value_(at(u, sample(i)), at(v, sample(j))));
        if (gap > error.all) {
          error.all = gap;
          error.worst = {sample(i), sample(j)};
        }
        // On lines through nodes the interpolation errs in one direction alone.
        if (is_node(j)) error.u = std::max(error.u, gap);
        if (is_node(i)) error.v = std::max(error.v, gap);
      }
    return error;
  }

  /// The middles of spans that miss the tolerance without a jump; returns the largest error, with
  /// safety.
  static double find_cuts(const Pieces& pieces, double tolerance,
                          const std::vector<double>& u_knots, const std::vector<double>& v_knots,
                          Cuts& u_cuts, Cuts& v_cuts) {
    const auto cut = [](Cuts& cuts, const Interval& span, double error) {
      double& known = cuts[at(span, 0.5)];
      known = std::max(known, error);
    };
    double largest = 0;
    for (int r = 0; r < pieces.rows(); ++r)
      for (int c = 0; c < pieces.columns(); ++c) {
        const Interval u = span(u_knots, r), v = span(v_knots, c);
        const PatchError& error = pieces(r, c).error;
        largest = std::max(largest, kErrorSafety * error.all);
        if (kErrorSafety * error.all <= tolerance || pieces(r, c).jump > 0) continue;
        if (error.u >= error.v / 4) cut(u_cuts, u, error.all);
        if (error.v >= error.u / 4) cut(v_cuts, v, error.all);
      }
    return largest;
  }

  const std::function<Vec3(double, double)>& value_;
  double tolerance_;
};

}  // namespace

CurveSpans fitted_spans(const std::function<Vec3(double)>& value, const std::vector<double>& breaks,
                        double tolerance) {
  CurveFit fit(value, tolerance);
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    if (breaks[i] < breaks[i + 1]) fit.add({breaks[i], breaks[i + 1]});
  return std::move(fit.result);
}

BezierSurface fitted_surface(const std::function<Vec3(double, double)>& value,
                             std::vector<double> u_breaks, std::vector<double> v_breaks,
                             double tolerance) {
  return SurfaceFit(value, tolerance).run(std::move(u_breaks), std::move(v_breaks));
}

}  // namespace blossom
