// SPDX-License-Identifier: LGPL-2.1-or-later
// The bounds of continuity.h: both sides of the edge as Taylor models, piece by piece.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "core/base/errors.h"
#include "core/base/unbounded.h"
#include "core/blending/continuity/continuity.h"
#include "core/blending/continuity/edge_frame.h"
#include "core/math/binomial.h"
#include "core/math/series/taylor_model.h"

namespace blossom {
namespace {

/// Breaks of two borders this close are one; angles of arcs this close, too. Both come from the
/// same numbers by a few roundings.
constexpr double kOneBreak = 1e-12;

/// Halvings of a span at most. Bounds that are this near to a value inside are close enough.
constexpr int kMaxHalvings = 8;
constexpr double kCloseEnough = 1.05;

/// So are bounds that nobody will tell from 0: of the angle, radians; of the relative curvature;
/// and of the gap, as a part of the radius that counts as flat.
constexpr double kNoAngle = 1e-10;
constexpr double kNoCurvature = 1e-6;
constexpr double kNoGap = 1e-14;

/// A half whose bound is not below this part of the whole's will not fall any more: what is left is
/// rounding.
constexpr double kStillFalling = 0.99;

/// Covers the few roundings of what is done with bounds.
constexpr double kUpwards = 1 + 0x1p-48;

using Long = long double;
using Point = Vec<Long, 4>;

/// A row of control points with what each of their coordinates is uncertain by.
struct UncertainRow {
  std::vector<Point> points;
  Vec4 error;
};

UncertainRow uncertain(const std::vector<Vec4>& row, const Vec4& error, const Vec3& centre) {
  UncertainRow result{{}, error};
  for (const Vec4& p : row) {
    Point& q = result.points.emplace_back();
    for (int c = 0; c < 3; ++c) q[c] = Long{p[c]} - Long{centre[c]} * Long{p[3]};
    q[3] = p[3];
  }
  return result;
}

UncertainRow derivative_of(const UncertainRow& row) {
  const std::size_t n = row.points.size() - 1;
  UncertainRow result{std::vector<Point>(std::max<std::size_t>(n, 1)),
                      row.error * (2.0 * static_cast<double>(n))};
  for (std::size_t i = 0; i < n; ++i)
    result.points[i] = (row.points[i + 1] - row.points[i]) * static_cast<Long>(n);
  return result;
}

/// De Casteljau's algorithm; what it leaves behind are the points over [t, 1].
void keep_behind(std::vector<Point>& points, Long t) {
  for (std::size_t left = points.size() - 1; left > 0; --left)
    for (std::size_t i = 0; i < left; ++i) points[i] = points[i] * (1 - t) + points[i + 1] * t;
}

/// The same for [0, t].
void keep_before(std::vector<Point>& points, Long t) {
  for (std::size_t level = 1; level < points.size(); ++level)
    for (std::size_t i = points.size() - 1; i >= level; --i)
      points[i] = points[i - 1] * (1 - t) + points[i] * t;
}

/// The row over a piece, as models in x of [-1, 1]: with q the points over the piece's second half,
///   c_k = binom(n, k) Delta^k q_0
/// A point goes through 2 n levels of 3 roundings and k differences; sum binom(n, k) 2^k = 3^n.
Vec<TaylorModel, 4> models_of(UncertainRow row, const Interval& piece) {
  const int n = static_cast<int>(row.points.size()) - 1;
  const Long middle = (Long{piece.from} + piece.to) / 2;
  keep_behind(row.points, middle);
  keep_before(row.points, (piece.to - middle) / (1 - middle));
  Vec4 largest;
  for (const Point& q : row.points)
    for (int c = 0; c < 4; ++c)
      largest[c] = std::max(largest[c], static_cast<double>(std::abs(q[c])));
  const double rounding =
      std::pow(3.0, n) * (8 * n + 4) * static_cast<double>(std::numeric_limits<Long>::epsilon());
  Vec<TaylorModel, 4> models;
  for (int c = 0; c < 4; ++c) models[c].rest = rounding * largest[c] + row.error[c];
  for (int k = 0; k <= n; ++k) {
    for (int c = 0; c < 4; ++c) {
      const double term = binomial(n, k) * static_cast<double>(row.points[0][c]);
      const bool kept = static_cast<std::size_t>(k) <= TaylorModel::kDegree;
      if (kept) models[c].terms[static_cast<std::size_t>(k)] = term;
      models[c].rest += kept ? 0x1p-52 * std::abs(term) : std::abs(term);
    }
    for (std::size_t i = 0; i + 1 < row.points.size(); ++i)
      row.points[i] = row.points[i + 1] - row.points[i];
    if (k < n) row.points.pop_back();
  }
  for (int c = 0; c < 4; ++c) models[c].rest *= kUpwards;
  return models;
}

using Models = Vec<TaylorModel, 3>;

Models head_of(const Vec<TaylorModel, 4>& p) { return {p[0], p[1], p[2]}; }

/// The surface along a piece of a span, u along the edge and v inwards, by the quotient rule:
///   p = X / w,  p_u = (X_u - w_u p) / w,  p_uv = (X_uv - w_u p_v - w_v p_u - w_uv p) / w, ...
EdgeJet<TaylorModel> jet_over(const BorderSpan& span, const Interval& piece, const Vec3& centre) {
  const UncertainRow edge = uncertain(span.edge, span.error, centre);
  const UncertainRow across = uncertain(span.across, span.across_error, centre);
  const UncertainRow edge_u = derivative_of(edge);
  const auto x = models_of(edge, piece), u = models_of(edge_u, piece),
             uu = models_of(derivative_of(edge_u), piece), v = models_of(across, piece),
             uv = models_of(derivative_of(across), piece),
             vv = models_of(uncertain(span.bend, span.bend_error, centre), piece);
  const TaylorModel r = reciprocal(x[3]), two(2);
  EdgeJet<TaylorModel> jet;
  jet.point = head_of(x) * r;
  jet.u = (head_of(u) - jet.point * u[3]) * r;
  jet.v = (head_of(v) - jet.point * v[3]) * r;
  jet.uu = (head_of(uu) - jet.u * (two * u[3]) - jet.point * uu[3]) * r;
  jet.uv = (head_of(uv) - jet.v * u[3] - jet.u * v[3] - jet.point * uv[3]) * r;
  jet.vv = (head_of(vv) - jet.v * (two * v[3]) - jet.point * vv[3]) * r;
  jet.along = {TaylorModel(1), TaylorModel(0)};
  return jet;
}

/// The figures in an order, to be compared one by one: gap, angle, difference, curvature.
using BoundFigures = std::array<double, 4>;

/// Values at the middle of a piece and bounds over all of it.
struct PieceFigures {
  BoundFigures middle;
  BoundFigures bounds;
};

/// A figure that is no less than 0: at the middle and bounded.
struct Size {
  double middle = 0;
  double most = 0;
};

/// |f|, by its square: f may have its largest coordinates at different places.
Size root_of(const TaylorModel& square) {
  return {std::sqrt(std::max(square.terms[0], 0.0)), std::sqrt(size_bound(square))};
}

/// The largest absolute eigenvalue, |x + z| / 2 + root of ((x - z) / 2)^2 + y^2.
Size size_of(const std::array<TaylorModel, 3>& shape) {
  const TaylorModel half(0.5), mean = (shape[0] + shape[2]) * half,
                               off = (shape[0] - shape[2]) * half;
  const Size radius = root_of(off * off + shape[1] * shape[1]);
  return {std::abs(mean.terms[0]) + radius.middle, size_bound(mean) + radius.most};
}

/// The least that the eigenvalue may be; 0 if nothing is known.
double least_size(const std::array<TaylorModel, 3>& shape) {
  const double change =
      spectral_norm(change_bound(shape[0]), change_bound(shape[1]), change_bound(shape[2]));
  const double least = size_of(shape).middle - kUpwards * change;
  return least > 0 ? least / kUpwards : 0;
}

double angle_of_chord(double chord) {
  return std::isfinite(chord) ? 2 * std::asin(std::min(1.0, chord / 2)) : chord;
}

PieceFigures compared(const EdgeFrame<TaylorModel>& a, const EdgeFrame<TaylorModel>& b,
                      double flat) {
  const Models apart = a.point - b.point, turned = a.normal - b.normal;
  std::array<TaylorModel, 3> difference;
  for (std::size_t i = 0; i < 3; ++i) difference[i] = a.shape[i] - b.shape[i];
  const Size gap = root_of(dot(apart, apart)), chord = root_of(dot(turned, turned)),
             by = size_of(difference);
  const double middle = std::max({size_of(a.shape).middle, size_of(b.shape).middle, flat});
  const double least = std::max({least_size(a.shape), least_size(b.shape), flat});
  PieceFigures result{{gap.middle, angle_of_chord(chord.middle), by.middle, by.middle / middle},
                      {gap.most, angle_of_chord(chord.most), by.most, by.most / least}};
  for (double& bound : result.bounds) {
    bound *= kUpwards;
    if (std::isnan(bound)) bound = kInfinity;
  }
  return result;
}

/// A piece of the edge: a part of a span of either border.
struct Piece {
  const BorderSpan* a;
  const BorderSpan* b;
  Interval of_a{0, 1};
  Interval of_b{0, 1};
};

PieceFigures figures_of(const Piece& piece, double flat) {
  const Vec3 centre = projected(piece.a->edge.front());
  return compared(edge_frame(jet_over(*piece.a, piece.of_a, centre), -1),
                  edge_frame(jet_over(*piece.b, piece.of_b, centre), 1), flat);
}

bool has_arcs(const BorderSpans& spans) {
  return std::any_of(spans.begin(), spans.end(), [](const BorderSpan& s) { return s.angle != 0; });
}

bool is_near(double x, double y) { return std::abs(x - y) <= kOneBreak; }

/// Arcs have to be cut alike: only then have they the same parameter.
std::vector<Piece> arc_pieces(const BorderSpans& a, const BorderSpans& b) {
  if (a.size() != b.size()) return {};
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!is_near(a[i].place.from, b[i].place.from) || !is_near(a[i].place.to, b[i].place.to) ||
        !is_near(a[i].angle, b[i].angle))
      return {};
    pieces.push_back({&a[i], &b[i]});
  }
  return pieces;
}

double local_in(const BorderSpan& span, double x) {
  if (is_near(x, span.place.from)) return 0;
  if (is_near(x, span.place.to)) return 1;
  return (x - span.place.from) / length(span.place);
}

/// Between all breaks of both.
std::vector<Piece> merged_pieces(const BorderSpans& a, const BorderSpans& b) {
  std::vector<Piece> pieces;
  double from = 0;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const double to = std::min(a[i].place.to, b[j].place.to);
    pieces.push_back({&a[i],
                      &b[j],
                      {local_in(a[i], from), local_in(a[i], to)},
                      {local_in(b[j], from), local_in(b[j], to)}});
    from = to;
    const bool ends_a = a[i].place.to <= to + kOneBreak, ends_b = b[j].place.to <= to + kOneBreak;
    i += ends_a ? 1 : 0;
    j += ends_b ? 1 : 0;
  }
  return pieces;
}

/// Bounds of all pieces, halved as far as it helps.
class Bounds {
 public:
  Bounds(double flat, const std::vector<Piece>& pieces)
      : flat_(flat), enough_{kNoGap / flat, kNoAngle, kNoCurvature * flat, kNoCurvature} {
    std::vector<PieceFigures> whole;
    for (const Piece& piece : pieces) whole.push_back(look(piece));
    BoundFigures none;
    none.fill(kInfinity);
    for (std::size_t i = 0; i < pieces.size(); ++i) add(pieces[i], whole[i].bounds, none, 0);
  }

  const BoundFigures& most() const { return most_; }

 private:
  PieceFigures look(const Piece& piece) {
    const PieceFigures figures = figures_of(piece, flat_);
    for (std::size_t i = 0; i < figures.middle.size(); ++i)
      if (figures.middle[i] > inside_[i]) inside_[i] = figures.middle[i];
    return figures;
  }

  /// Whether halving helps a figure, with its bound over the piece and that over the piece's whole.
  bool may_fall(std::size_t i, double bound, double of_whole) const {
    return !(bound <= kCloseEnough * inside_[i]) && !(bound <= enough_[i]) &&
           !(bound >= kStillFalling * of_whole && std::isfinite(bound));
  }

  void add(const Piece& piece, const BoundFigures& bounds, const BoundFigures& of_whole,
           int halvings) {
    bool may = false;
    for (std::size_t i = 0; i < bounds.size(); ++i) may |= may_fall(i, bounds[i], of_whole[i]);
    if (halvings == kMaxHalvings || !may) return take(bounds);
    std::array<Piece, 2> halves{piece, piece};
    std::array<BoundFigures, 2> of;
    for (std::size_t h = 0; h < 2; ++h) {
      const double from = h == 0 ? 0 : 0.5;
      halves[h].of_a = {at(piece.of_a, from), at(piece.of_a, from + 0.5)};
      halves[h].of_b = {at(piece.of_b, from), at(piece.of_b, from + 0.5)};
      of[h] = look(halves[h]).bounds;
      for (std::size_t i = 0; i < bounds.size(); ++i) of[h][i] = std::min(of[h][i], bounds[i]);
    }
    for (std::size_t h = 0; h < 2; ++h) add(halves[h], of[h], bounds, halvings + 1);
  }

  void take(const BoundFigures& bounds) {
    for (std::size_t i = 0; i < bounds.size(); ++i) most_[i] = std::max(most_[i], bounds[i]);
  }

  double flat_;
  BoundFigures enough_;
  BoundFigures inside_{};
  BoundFigures most_{};
};

}  // namespace

std::optional<ContinuityBounds> continuity_bounds(const BorderSpans& a, const BorderSpans& b,
                                                  double flat) {
  if (!(flat > 0)) throw InvalidInput("continuity_bounds: flat has to be positive");
  const std::vector<Piece> pieces =
      has_arcs(a) || has_arcs(b) ? arc_pieces(a, b) : merged_pieces(a, b);
  if (pieces.empty()) return {};
  const BoundFigures most = Bounds(flat, pieces).most();
  return ContinuityBounds{most[0], most[1], most[2], most[3]};
}

}  // namespace blossom
