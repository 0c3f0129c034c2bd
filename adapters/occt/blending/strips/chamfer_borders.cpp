// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/strips/chamfer_borders.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <Geom_BSplineCurve.hxx>
#include <Geom_Conic.hxx>
#include <Geom_Line.hxx>

#include "adapters/occt/base/points.h"
#include "adapters/occt/blending/fillet_refusal.h"

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

  /// throws   FilletRefused where there are no borders, or no smooth ones
  void add(const Interval& range);

  /// As far as there are smooth borders, to where the range goes; it may run backwards.
  void add_past_end(const Interval& range);

  FittedBorders borders();

 private:
  std::optional<BorderRow> row(double x) const;
  std::optional<Piece> piece(const Interval& range, const std::optional<BorderRow>& before) const;
  bool is_near(const Piece& piece) const;
  std::optional<double> add(const Interval& range, int halvings,
                            const std::optional<BorderRow>& before,
                            std::vector<Piece>& pieces) const;
  BorderRow rate_before(std::size_t joint) const;
  BorderRow rate_after(std::size_t joint) const;
  BorderRow turn(std::size_t joint) const { return rate_after(joint) - rate_before(joint); }
  bool is_smooth(std::size_t joint) const;
  bool halve_beside(std::size_t joint);
  void halve_rough();
  void make_smooth(std::size_t joint);

  const Chamfering& of_;
  std::vector<Piece> pieces_;
};

std::optional<BorderRow> BorderFit::row(double x) const {
  const auto both = of_.at_edge(x);
  if (!both) return std::nullopt;
  const auto& [a, b] = *both;
  return BorderRow{a.point[0], a.point[1], a.point[2], a.uv[0], a.uv[1],
                   b.point[0], b.point[1], b.point[2], b.uv[0], b.uv[1]};
}

// A row with its charts in the turns of another one's, where a surface has a period.
BorderRow in_turn_of(const BorderRow& other, BorderRow row,
                     const std::array<Handle(Geom_Surface), 2>& surfaces) {
  for (const std::size_t side : {0U, 1U})
    for (const int k : {0, 1}) {
      const Handle(Geom_Surface)& surface = surfaces[side];
      if (!(k == 0 ? surface->IsUPeriodic() : surface->IsVPeriodic())) continue;
      const double turn = k == 0 ? surface->UPeriod() : surface->VPeriod();
      const int at = (side == 0 ? 3 : 8) + k;
      row[at] += turn * std::round((other[at] - row[at]) / turn);
    }
  return row;
}

// Charts go on from node to node, and from the row before: round a pole by any number of turns.
std::optional<Piece> BorderFit::piece(const Interval& range,
                                      const std::optional<BorderRow>& before) const {
  std::array<BorderRow, kBorderDegree + 1> values;
  std::optional<BorderRow> last = before;
  for (int i = 0; i <= kBorderDegree; ++i) {
    const auto known = row(at(range, node(i)));
    if (!known) return std::nullopt;
    last = last ? in_turn_of(*last, *known, of_.surfaces) : *known;
    values[static_cast<std::size_t>(i)] = *last;
  }
  return Piece{range, bezier_through(values)};
}

bool BorderFit::is_near(const Piece& piece) const {
  for (int k = 0; k < kBorderDegree; ++k) {
    const double t = node(k + 0.5);
    const BorderRow made = row_at(piece, t);
    const auto wanted = row(at(piece.range, t));
    if (!wanted) return false;
    for (const std::size_t side : {0U, 1U}) {
      const Vec3 point = side_point(made, side);
      const Vec3 image = frame_at(of_.surfaces[side], side_chart(made, side)).point;
      if (!(distance(point, side_point(*wanted, side)) <= kFitError) ||
          !(distance(point, image) <= kFitError))
        return false;
    }
  }
  return true;
}

// Pieces from `range.from` on, by halves; where they end before the other end, a place there.
//
// before   the row at the end of what the first one goes on from
std::optional<double> BorderFit::add(const Interval& range, int halvings,
                                     const std::optional<BorderRow>& before,
                                     std::vector<Piece>& pieces) const {
  const auto made = piece(range, pieces.empty() ? before : pieces.back().points.back());
  if (made && is_near(*made)) {
    pieces.push_back(*made);
    return std::nullopt;
  }
  const double middle = at(range, 0.5);
  if (halvings == 0) return middle;
  const auto ended = add({range.from, middle}, halvings - 1, before, pieces);
  return ended ? ended : add({middle, range.to}, halvings - 1, before, pieces);
}

void BorderFit::add(const Interval& range) {
  const auto ended = add(range, kMaxHalvings, std::nullopt, pieces_);
  if (!ended) return;
  of_.refuse(row(*ended) ? "the chamfer's border on a face is no smooth curve" : kNoBorderPoint,
             *ended);
}

void BorderFit::add_past_end(const Interval& range) {
  const bool rises = range.from <= range.to;
  std::vector<Piece> found;
  add(range, kMaxHalvings, rises ? pieces_.back().points.back() : pieces_.front().points.front(),
      found);
  if (rises) {
    pieces_.insert(pieces_.end(), found.begin(), found.end());
    return;
  }
  for (Piece& each : found) {
    std::swap(each.range.from, each.range.to);
    std::ranges::reverse(each.points);
  }
  pieces_.insert(pieces_.begin(), found.rbegin(), found.rend());
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

double bend_of(const BorderRow& turn) {
  return std::max(norm(side_point(turn, 0)), norm(side_point(turn, 1)));
}

// Whether one tangent for both pieces moves them by less than they may be off.
bool BorderFit::is_smooth(std::size_t joint) const {
  constexpr double kMove =
      0.4096 / kBorderDegree;  // of a piece's width: by its second Bezier point
  const double bend = bend_of(turn(joint));
  const double width = std::max(length(pieces_[joint - 1].range), length(pieces_[joint].range));
  return 0.5 * bend * kMove * width <= kFitError;
}

// Puts halves in the place of both pieces at a joint. False, and nothing changes, if some have
// none.
bool BorderFit::halve_beside(std::size_t joint) {
  std::vector<Piece> halves;
  for (const std::size_t of : {joint - 1, joint}) {
    const Piece& whole = pieces_[of];
    const double middle = at(whole.range, 0.5);
    const auto low = piece({whole.range.from, middle}, whole.points.front());
    const auto high = low ? piece({middle, whole.range.to}, low->points.back()) : std::nullopt;
    if (!high) return false;
    halves.insert(halves.end(), {*low, *high});
  }
  const auto first = pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(joint) - 1,
                                   pieces_.begin() + static_cast<std::ptrdiff_t>(joint) + 1);
  pieces_.insert(first, halves.begin(), halves.end());
  return true;
}

// One tangent moves shorter pieces by less. A border that turns by more than edges that are one is
// left with its kink.
void BorderFit::halve_rough() {
  for (std::size_t joint = 1; joint < pieces_.size();) {
    const BorderRow rate = rate_before(joint);
    const double speed = std::min(norm(side_point(rate, 0)), norm(side_point(rate, 1)));
    const bool is_kink = !(bend_of(turn(joint)) <= kSmoothJoint * speed);
    if (is_smooth(joint) || is_kink || !halve_beside(joint)) ++joint;
  }
}

void BorderFit::make_smooth(std::size_t joint) {
  const BorderRow rate = 0.5 * (rate_before(joint) + rate_after(joint));
  Piece &before = pieces_[joint - 1], &after = pieces_[joint];
  before.points[kBorderDegree - 1] =
      before.points[kBorderDegree] - (length(before.range) / kBorderDegree) * rate;
  after.points[1] = after.points[0] + (length(after.range) / kBorderDegree) * rate;
}

FittedBorders BorderFit::borders() {
  halve_rough();
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
  made.range = {knots.front(), knots.back()};
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

// The ends of a range of the edge, and where its curve is less than smooth between them.
std::vector<double> breaks_of(const Chamfering& of, const Interval& range) {
  std::vector<double> breaks{range.from, range.to};
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

// The directions at a place past an edge's end. Nothing where the way has turned too far.
std::optional<EdgePlace> turned(const EdgePlace& end, EdgePlace place,
                                const std::array<Vec3, 2>& normals, const Vec3& crossing) {
  place.along = unit(dot(crossing, end.along) > 0 ? crossing : -crossing);
  if (dot(place.along, end.along) < std::cos(kMaxTurn)) return std::nullopt;
  for (const std::size_t k : {0U, 1U}) {
    const BesideEdge& from = end.sides[k];
    BesideEdge& side = place.sides[k];
    side.normal = dot(normals[k], from.normal) > 0 ? normals[k] : -normals[k];
    const Vec3 inwards = unit(cross(side.normal, place.along));
    side.inwards = dot(inwards, from.inwards) > 0 ? inwards : -inwards;
  }
  return place;
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

EdgePlace Chamfering::on_edge(double x) const {
  EdgePlace place{vec(curve->Value(x).XYZ()), unit(vec(curve->DN(x, 1))), {}};
  for (const std::size_t k : {0U, 1U}) {
    const EdgeUseInFace& use = body.use(edge, k == 0);
    const BodyEdges::Corner corner = body.corner(use, x);
    const Vec2 chart = point_at(use.coedge->curve, x), scale = body.trims(use.face).scale;
    place.sides[k] = {corner.normal, corner.inwards,
                      near[k].value_or(Vec2{chart[0] / scale[0], chart[1] / scale[1]})};
  }
  return place;
}

// Parameters near a point that is near one whose are known: those of its foot point where there is
// a formula for it, which poles do not disturb, else by the tangent plane.
Vec2 Chamfering::step_to(std::size_t side, const Vec2& from, const Vec3& point) const {
  if (feet[side]) return feet[side]->foot(point, from);
  const SurfaceJet frame = frame_at(surfaces[side], from);
  return from + chart_step(frame, point - frame.point);
}

// The point of both surfaces, and of the plane across the edge's end at a way from it: the tangent
// planes at the feet of the last point, and that plane, meet in the next one.
std::optional<EdgePlace> Chamfering::past_end(const EdgePlace& end, double way) const {
  const Vec3 goal = end.point + way * end.along;
  const double enough = kConverged * std::abs(way) + kPointNoise * norm(goal);
  EdgePlace place{goal, end.along, end.sides};
  for (int i = 0; i < kNewtonSteps; ++i) {
    std::array<Vec3, 2> normals, points;
    double off = 0;
    for (const std::size_t k : {0U, 1U}) {
      Vec2& uv = place.sides[k].uv;
      uv = step_to(k, uv, place.point);
      const SurfaceJet at = frame_at(surfaces[k], uv);
      points[k] = at.point;
      normals[k] = unit(cross(at.du, at.dv));
      off = std::max(off, distance(at.point, place.point));
    }
    const Vec3 crossing = cross(normals[0], normals[1]);
    const double volume = dot(crossing, end.along);
    if (!std::isfinite(off) || !std::isfinite(volume) || volume == 0) return std::nullopt;
    if (off <= enough) return turned(end, place, normals, crossing);
    place.point = (1 / volume) * (dot(normals[0], points[0]) * cross(normals[1], end.along) +
                                  dot(normals[1], points[1]) * cross(end.along, normals[0]) +
                                  dot(end.along, goal) * crossing);
  }
  return std::nullopt;
}

std::optional<EdgePlace> Chamfering::place_at(double x) const {
  const double inside = std::clamp(x, domain.from, domain.to);
  EdgePlace place = on_edge(inside);
  if (x == inside) return place;
  const bool is_exact =
      !Handle(Geom_Line)::DownCast(curve).IsNull() || !Handle(Geom_Conic)::DownCast(curve).IsNull();
  if (!is_exact) return past_end(place, (x - inside) * curve->DN(inside, 1).Magnitude());
  place.point = vec(curve->Value(x).XYZ());
  place.along = unit(vec(curve->DN(x, 1)));
  return place;
}

std::optional<std::array<BorderPoint, 2>> Chamfering::at_edge(double x) const {
  const auto place = place_at(x);
  if (!place) return std::nullopt;
  const Vec3 &origin = place->point, &along = place->along;
  const std::array<BesideEdge, 2>& sides = place->sides;
  std::array<double, 2> reach = profile.distance;
  const std::size_t given = profile.given, other = 1 - given;
  if (profile.angle) {
    // The triangle of the tangent planes.
    const double opening = std::acos(std::clamp(dot(sides[0].inwards, sides[1].inwards), -1., 1.));
    const double rest = std::numbers::pi - *profile.angle - opening;
    if (rest <= 0) refuse("the chamfer at that angle does not meet the other face", x);
    reach[other] = reach[given] * std::sin(*profile.angle) / std::sin(rest);
  }
  std::array<BorderPoint, 2> found;
  for (const std::size_t k : {given, other}) {
    const Vec2 start = step_to(k, sides[k].uv, origin + reach[k] * sides[k].inwards);
    std::optional<BorderPoint> made;
    if (k == other && profile.angle) {
      const double turn = concave ? 1 : -1;
      const Vec3 chord = -std::cos(*profile.angle) * sides[given].inwards +
                         turn * std::sin(*profile.angle) * sides[given].normal;
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
  const Interval inside{std::max(range.from, of.sure.from), std::min(range.to, of.sure.to)};
  const std::vector<double> breaks = breaks_of(of, inside);
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) fit.add({breaks[i], breaks[i + 1]});
  for (const Interval& past : {Interval{inside.from, range.from}, Interval{inside.to, range.to}})
    if (is_span({std::min(past.from, past.to), std::max(past.from, past.to)}, range))
      fit.add_past_end(past);
  return fit.borders();
}

}  // namespace blossom::occt
