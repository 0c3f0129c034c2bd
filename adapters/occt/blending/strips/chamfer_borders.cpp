// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/strips/chamfer_borders.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <Geom_BSplineCurve.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/blending/fillet_refusal.h"
#include "adapters/occt/faces/surface_projector.h"

namespace blossom::occt {
namespace {

constexpr int kNewtonSteps = 30;
constexpr double kConverged = 1e-13;                                         // of the distance
constexpr double kPointNoise = 64 * std::numeric_limits<double>::epsilon();  // of coordinates

constexpr double kFitError = 1e-8;  // model units
constexpr int kMaxHalvings = 32;    // a crease is then in a piece of 2e-10 of the range

// Pieces have degree 5, through points of the borders at Chebyshev's nodes with both ends; between
// the nodes, where they are farthest off, they are checked.
constexpr int kBorderDegree = 5;

// Points and charts of both sides together.
using BorderRow = Vec<double, 10>;

Vec3 side_point(const BorderRow& row, std::size_t side) {
  const int at = side == 0 ? 0 : 5;
  return {row[at], row[at + 1], row[at + 2]};
}

Vec2 side_chart(const BorderRow& row, std::size_t side) {
  const int at = side == 0 ? 3 : 8;
  return {row[at], row[at + 1]};
}

struct Piece {
  Interval range;
  std::array<BorderRow, kBorderDegree + 1> points;  // Bezier
};

// The k-th extremum of Chebyshev's polynomial over [0, 1]; in its middle to the next one for k +
// 1/2.
double node(double k) { return 0.5 * (1 - std::cos(std::numbers::pi * k / kBorderDegree)); }

// Bernstein's polynomials at t.
std::array<double, kBorderDegree + 1> weights_at(double t) {
  std::array<double, kBorderDegree + 1> weights{1};
  for (int n = 1; n <= kBorderDegree; ++n)
    for (int i = n; i >= 0; --i) {
      const auto k = static_cast<std::size_t>(i);
      weights[k] = (i < n ? (1 - t) * weights[k] : 0) + (i > 0 ? t * weights[k - 1] : 0);
    }
  return weights;
}

// The Bezier points of the polynomial through values at the nodes: Newton's form, of which each
// factor is multiplied with what is behind it in Bernstein's.
std::array<BorderRow, kBorderDegree + 1> bezier_through(
    std::array<BorderRow, kBorderDegree + 1> values) {
  for (int j = 1; j <= kBorderDegree; ++j)
    for (int i = kBorderDegree; i >= j; --i) {
      const auto k = static_cast<std::size_t>(i);
      values[k] = (1 / (node(i) - node(i - j))) * (values[k] - values[k - 1]);
    }
  std::array<BorderRow, kBorderDegree + 1> points{values.back()};
  for (int degree = 1; degree <= kBorderDegree; ++degree) {
    const int j = kBorderDegree - degree;
    for (int i = degree; i >= 0; --i) {
      const auto k = static_cast<std::size_t>(i);
      const double share = static_cast<double>(i) / degree;
      BorderRow product;
      if (i < degree) product -= ((1 - share) * node(j)) * points[k];
      if (i > 0) product += (share * (1 - node(j))) * points[k - 1];
      points[k] = product + values[static_cast<std::size_t>(j)];
    }
  }
  return points;
}

BorderRow row_at(const Piece& piece, double t) {
  const auto weights = weights_at(t);
  BorderRow sum;
  for (std::size_t k = 0; k < weights.size(); ++k) sum += weights[k] * piece.points[k];
  return sum;
}

class BorderFit {
 public:
  explicit BorderFit(const Chamfering& of) : of_(of) {}

  void add(const Interval& range, int halvings);
  FittedBorders borders();

 private:
  BorderRow row(double x) const;
  Piece piece(const Interval& range) const;
  double error(const Piece& piece) const;
  BorderRow rate_before(std::size_t joint) const;
  BorderRow rate_after(std::size_t joint) const;
  bool is_smooth(std::size_t joint) const;
  void make_smooth(std::size_t joint);

  const Chamfering& of_;
  std::vector<Piece> pieces_;
};

BorderRow BorderFit::row(double x) const {
  const auto both = of_.at_edge(x);
  if (!both) of_.refuse("a face has no point at the chamfer's distance from the edge", x);
  const auto& [a, b] = *both;
  return {a.point[0], a.point[1], a.point[2], a.uv[0], a.uv[1],
          b.point[0], b.point[1], b.point[2], b.uv[0], b.uv[1]};
}

Piece BorderFit::piece(const Interval& range) const {
  std::array<BorderRow, kBorderDegree + 1> values;
  for (int i = 0; i <= kBorderDegree; ++i)
    values[static_cast<std::size_t>(i)] = row(at(range, node(i)));
  return {range, bezier_through(values)};
}

double BorderFit::error(const Piece& piece) const {
  double largest = 0;
  for (int k = 0; k < kBorderDegree; ++k) {
    const double t = node(k + 0.5);
    const BorderRow made = row_at(piece, t), wanted = row(at(piece.range, t));
    for (const std::size_t side : {0U, 1U}) {
      const Vec3 point = side_point(made, side);
      const Vec3 image = frame_at(of_.surfaces[side], side_chart(made, side)).point;
      largest =
          std::max({largest, distance(point, side_point(wanted, side)), distance(point, image)});
    }
  }
  return largest;
}

void BorderFit::add(const Interval& range, int halvings) {
  const Piece made = piece(range);
  if (error(made) <= kFitError) {
    pieces_.push_back(made);
    return;
  }
  const double middle = at(range, 0.5);
  if (halvings == 0) of_.refuse("the chamfer's border on a face is no smooth curve", middle);
  add({range.from, middle}, halvings - 1);
  add({middle, range.to}, halvings - 1);
}

BorderRow BorderFit::rate_before(std::size_t joint) const {
  const Piece& piece = pieces_[joint - 1];
  return (kBorderDegree / length(piece.range)) *
         (piece.points[kBorderDegree] - piece.points[kBorderDegree - 1]);
}

BorderRow BorderFit::rate_after(std::size_t joint) const {
  const Piece& piece = pieces_[joint];
  return (kBorderDegree / length(piece.range)) * (piece.points[1] - piece.points[0]);
}

// Whether one tangent for both pieces moves them by less than they may be off.
bool BorderFit::is_smooth(std::size_t joint) const {
  constexpr double kMove =
      0.4096 / kBorderDegree;  // of a piece's width: by its second Bezier point
  const BorderRow turn = rate_after(joint) - rate_before(joint);
  const double bend = std::max(norm(side_point(turn, 0)), norm(side_point(turn, 1)));
  const double width = std::max(length(pieces_[joint - 1].range), length(pieces_[joint].range));
  return 0.5 * bend * kMove * width <= kFitError;
}

void BorderFit::make_smooth(std::size_t joint) {
  const BorderRow rate = 0.5 * (rate_before(joint) + rate_after(joint));
  Piece &before = pieces_[joint - 1], &after = pieces_[joint];
  before.points[kBorderDegree - 1] =
      before.points[kBorderDegree] - (length(before.range) / kBorderDegree) * rate;
  after.points[1] = after.points[0] + (length(after.range) / kBorderDegree) * rate;
}

FittedBorders BorderFit::borders() {
  std::vector<double> knots{pieces_.front().range.from};
  std::vector<int> multiplicities{kBorderDegree + 1};
  std::vector<BorderRow> points{pieces_.front().points[0]};
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const bool is_last = i + 1 == pieces_.size(), smooth = !is_last && is_smooth(i + 1);
    if (smooth) make_smooth(i + 1);
    const auto& own = pieces_[i].points;
    points.insert(points.end(), own.begin() + 1, own.end() - (smooth ? 1 : 0));
    knots.push_back(pieces_[i].range.to);
    multiplicities.push_back(is_last  ? kBorderDegree + 1
                             : smooth ? kBorderDegree - 1
                                      : kBorderDegree);
  }
  FittedBorders made;
  for (const std::size_t side : {0U, 1U}) {
    made.rows[side] = {kBorderDegree, knots, multiplicities, {}};
    made.charts[side] = {kBorderDegree, knots, multiplicities, {}};
    for (const BorderRow& row : points) {
      made.rows[side].points.push_back(side_point(row, side));
      made.charts[side].points.push_back(side_chart(row, side));
    }
  }
  return made;
}

// Where the edge's curve is less than smooth, and where it ends.
std::vector<double> breaks_of(const Chamfering& of, const Interval& range) {
  std::vector<double> breaks{range.from, range.to, of.domain.from, of.domain.to};
  if (const auto spline = Handle(Geom_BSplineCurve)::DownCast(of.curve); !spline.IsNull())
    for (int i = 1; i <= spline->NbKnots(); ++i) breaks.push_back(spline->Knot(i));
  std::erase_if(breaks, [&](double x) { return x < range.from || x > range.to; });
  std::ranges::sort(breaks);
  const auto rest = std::ranges::unique(breaks, [&](double a, double b) {
    return !is_span({a, b}, range);
  });
  breaks.erase(rest.begin(), rest.end());
  return breaks;
}

}  // namespace

void Chamfering::refuse(const std::string& cause, double x) const {
  throw FilletRefused(
      {FilletFault::NoBall, edge, cause, x, vec(curve->Value(x).XYZ()), std::nullopt});
}

// Newton's method for (S - origin) . across = 0 and a second function with its gradient.
std::optional<BorderPoint> Chamfering::solved(
    std::size_t side, Vec2 uv, const Vec3& across,
    const std::function<std::pair<double, Vec3>(const Vec3&)>& f, const Vec3& origin) const {
  const double enough =
      kConverged * (profile.distance[0] + profile.distance[1]) + kPointNoise * norm(origin);
  for (int i = 0; i < kNewtonSteps; ++i) {
    const SurfaceJet at = frame_at(surfaces[side], uv);
    const double g = dot(at.point - origin, across);
    const auto [h, gradient] = f(at.point);
    if (std::abs(g) + std::abs(h) <= enough) return BorderPoint{at.point, uv};
    const double a = dot(at.du, across), b = dot(at.dv, across);
    const double c = dot(at.du, gradient), d = dot(at.dv, gradient);
    const double det = a * d - b * c;
    if (det == 0 || !std::isfinite(det)) return std::nullopt;
    uv -= Vec2{(g * d - b * h) / det, (a * h - g * c) / det};
  }
  return std::nullopt;
}

std::optional<std::array<BorderPoint, 2>> Chamfering::at_edge(double x) const {
  const double inside = std::clamp(x, domain.from, domain.to);
  gp_Pnt p;
  gp_Vec rate;
  curve->D1(x, p, rate);
  const Vec3 origin = vec(p.XYZ()), along = unit(vec(rate.XYZ()));
  std::array<BodyEdges::Corner, 2> corners;
  std::array<Vec2, 2> charts;
  for (const std::size_t k : {0U, 1U}) {
    const EdgeUseInFace& use = body.use(edge, k == 0);
    corners[k] = body.corner(use, inside);
    const Vec2 chart = point_at(use.coedge->curve, inside), scale = body.trims(use.face).scale;
    charts[k] = {chart[0] / scale[0], chart[1] / scale[1]};
  }
  std::array<double, 2> reach = profile.distance;
  const std::size_t given = profile.given, other = 1 - given;
  if (profile.angle) {
    // The triangle of the tangent planes.
    const double opening =
        std::acos(std::clamp(dot(corners[0].inwards, corners[1].inwards), -1., 1.));
    const double rest = std::numbers::pi - *profile.angle - opening;
    if (rest <= 0) refuse("the chamfer at that angle does not meet the other face", inside);
    reach[other] = reach[given] * std::sin(*profile.angle) / std::sin(rest);
  }
  std::array<BorderPoint, 2> found;
  for (const std::size_t k : {given, other}) {
    const SurfaceJet frame = frame_at(surfaces[k], charts[k]);
    const Vec3 step = origin + reach[k] * corners[k].inwards - frame.point;
    const Vec2 start = charts[k] + chart_step(frame, step);
    std::optional<BorderPoint> made;
    if (k == other && profile.angle) {
      const double turn = concave ? 1 : -1;
      const Vec3 chord = -std::cos(*profile.angle) * corners[given].inwards +
                         turn * std::sin(*profile.angle) * corners[given].normal;
      const Vec3 normal = unit(cross(along, chord)), from = found[given].point;
      made = solved(
          k, start, along,
          [&](const Vec3& s) {
            return std::pair{dot(s - from, normal), normal};
          },
          origin);
    } else {
      const double distance_wanted = reach[k];
      made = solved(
          k, start, along,
          [&](const Vec3& s) {
            const double far = norm(s - origin);
            return std::pair{far - distance_wanted, (1 / far) * (s - origin)};
          },
          origin);
    }
    if (!made) return std::nullopt;
    found[k] = *made;
  }
  return found;
}

FittedBorders fitted_borders(const Chamfering& of, const Interval& range) {
  BorderFit fit(of);
  const std::vector<double> breaks = breaks_of(of, range);
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    fit.add({breaks[i], breaks[i + 1]}, kMaxHalvings);
  return fit.borders();
}

}  // namespace blossom::occt
