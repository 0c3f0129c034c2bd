// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of LineSearch that halves: cells that one look does not settle.

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/queries/line_search.h"
#include "core/subdivision/cell_nets.h"

namespace blossom {
namespace {

constexpr double kRoundoff = 0x1p-53;
// Off the middle: singular points like dyadic lines.
constexpr double kCut = 0.5 - 1.0 / 64;
// A contact this many times longer than sqrt(tolerance * size) is no touch of curved surfaces.
constexpr double kTouchLength = 10;

ValueRange range_of(const double* values, int count) {
  ValueRange range{values[0], values[0]};
  for (int i = 1; i < count; ++i) {
    range.low = values[i] < range.low ? values[i] : range.low;
    range.high = values[i] > range.high ? values[i] : range.high;
  }
  return range;
}

double largest(const ValueRange& range) {
  return std::max(std::abs(range.low), std::abs(range.high));
}

// Derivative by u or v: degree times the differences of neighbours.
ValueRange slope_u(const double* net, int rows, int columns) {
  const double degree = rows - 1;
  ValueRange range{net[columns] - net[0], net[columns] - net[0]};
  for (int i = 0; i < (rows - 1) * columns; ++i) {
    const double d = net[i + columns] - net[i];
    range.low = d < range.low ? d : range.low;
    range.high = d > range.high ? d : range.high;
  }
  return {degree * range.low, degree * range.high};
}

ValueRange slope_v(const double* net, int rows, int columns) {
  const double degree = columns - 1;
  ValueRange range{net[1] - net[0], net[1] - net[0]};
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j + 1 < columns; ++j) {
      const double d = net[i * columns + j + 1] - net[i * columns + j];
      range.low = d < range.low ? d : range.low;
      range.high = d > range.high ? d : range.high;
    }
  return {degree * range.low, degree * range.high};
}

double middle(const ValueRange& range) { return 0.5 * (range.low + range.high); }
double radius(const ValueRange& range) { return 0.5 * (range.high - range.low); }

// Bernstein polynomials of a degree at t.
void bernstein(int degree, double t, double* b) {
  b[0] = 1;
  for (int k = 1; k <= degree; ++k) {
    double carried = 0;
    for (int i = 0; i < k; ++i) {
      const double value = b[i];
      b[i] = carried + (1 - t) * value;
      carried = t * value;
    }
    b[k] = carried;
  }
}

Vec3 any_across(const Vec3& d) {
  int least = 0;
  for (int k = 1; k < 3; ++k)
    if (std::abs(d[k]) < std::abs(d[least])) least = k;
  Vec3 axis;
  axis[least] = 1;
  return unit(cross(d, axis));
}

}  // namespace

void LineSearch::search(std::vector<RayHit>& hits) {
  rows_ = patch_->points.rows();
  columns_ = patch_->points.columns();
  net_size_ = 2 * rows_ * columns_;
  load_net();
  stack_.clear();
  stack_.push_back({cell_->u, cell_->v, 0});
  for (int looked = 0; !stack_.empty(); ++looked) {
    const Piece piece = stack_.back();
    const int place = static_cast<int>(stack_.size()) - 1;
    stack_.pop_back();
    const bool spent = looked >= kPieceBudget || place + 2 > kPlaces;
    const Next next = spent ? Next::Stop : look_at(piece, net_at(place), hits);
    if (next == Next::Contact || next == Next::Stop)
      add_contact(piece, next == Next::Stop ? Status::Stopped : Status::Tolerance, hits);
    else if (next != Next::Done)
      halve(piece, place, next == Next::HalveU);
  }
}

// Puts the halves of a piece in its place and the next one.
void LineSearch::halve(const Piece& piece, int place, bool along_u) {
  const NetShape shape{rows_, columns_, 2};
  double* const low = net_at(kPlaces);
  (along_u ? halve_bezier_u : halve_bezier_v)(shape, net_at(place), kCut, low, net_at(place + 1));
  std::copy(low, low + net_size_, net_at(place));
  Piece halves[2] = {piece, piece};
  Interval Piece::*side = along_u ? &Piece::u : &Piece::v;
  const double cut = at(piece.*side, kCut);
  (halves[0].*side).to = cut;
  (halves[1].*side).from = cut;
  for (Piece& half : halves) {
    ++half.depth;
    stack_.push_back(half);
  }
}

// f and g over the cell, in the first place. g is the height over the tangent plane as far as the
// line allows, so that it is small where the line is nearly tangent.
void LineSearch::load_net() {
  const Vec3& d = ray_.direction;
  const PatchJet jet = jet_at(*patch_, at(cell_->u, 0.5), at(cell_->v, 0.5), 1);
  const Vec3 normal = unit(cross(jet.u, jet.v));
  const Vec3 height = normal - (dot(normal, d) / square_) * d;
  across_[1] = norm(height) > 1e-3 ? unit(height) : any_across(d);
  across_[0] = unit(cross(d, across_[1]));
  double* const net = net_at(0);
  load_heights(across_[0], net);
  load_heights(across_[1], net + rows_ * columns_);
  const int degree = std::max(rows_, columns_) - 1;
  const double numbers = cells_.scale() + max_norm(ray_.origin) + max_norm(anchor_);
  margin_ = 24 * kRoundoff * placed().largest_weight * numbers +
            halving_error(degree, 4) * largest(range_of(net, net_size_));
  restrict_net(net, cell_->u, cell_->v);
  net_scale_ = largest(range_of(net, net_size_));
}

// One plane of a net: direction . (X - w anchor) over the whole patch.
void LineSearch::load_heights(const Vec3& direction, double* plane) const {
  const double shift = dot(direction, anchor_);
  for (const Vec4& p : patch_->points.values())
    *plane++ = dot(direction, Vec3{p[0], p[1], p[2]}) - p[3] * shift;
}

// A net of the whole patch becomes that of a rectangle.
void LineSearch::restrict_net(double* net, const Interval& u, const Interval& v) {
  const NetShape shape{rows_, columns_, 2};
  double* const low = net_at(kPlaces);
  double* const high = net_at(kPlaces + 1);
  const auto keep = [&](const Interval& range, auto halve_net) {
    if (range.to < 1) {
      halve_net(shape, net, range.to, low, high);
      std::copy(low, low + net_size_, net);
    }
    if (range.from > 0) {
      halve_net(shape, net, range.from / range.to, low, high);
      std::copy(high, high + net_size_, net);
    }
  };
  keep(u, halve_bezier_u);
  keep(v, halve_bezier_v);
}

LineSearch::Next LineSearch::look_at(const Piece& piece, const double* net,
                                     std::vector<RayHit>& hits) {
  const int count = rows_ * columns_;
  const double* const g = net + count;
  const int degree = std::max(rows_, columns_) - 1;
  const double margin = margin_ + halving_error(degree, piece.depth) * net_scale_;
  const bool at_border =
      piece.u.from == 0 || piece.u.to == 1 || piece.v.from == 0 || piece.v.to == 1;
  const double reach = margin + (at_border ? placed().reach * placed().largest_weight : 0);
  const ValueRange f_range = range_of(net, count), g_range = range_of(g, count);
  for (const ValueRange& range : {f_range, g_range})
    if (range.low > reach || range.high < -reach) return Next::Done;

  const Slopes slopes{{{slope_u(net, rows_, columns_), slope_v(net, rows_, columns_)},
                       {slope_u(g, rows_, columns_), slope_v(g, rows_, columns_)}}};
  const double size = std::max(largest(f_range), largest(g_range));
  const Guess found = guess(piece, net, slopes, margin, size);
  if (found.excluded) return Next::Done;
  if (found.contracts && settle(found.region, found.root, hits) != Verdict::Open) return Next::Done;
  const double along_u = std::max(largest(slopes[0][0]), largest(slopes[1][0]));
  const double along_v = std::max(largest(slopes[0][1]), largest(slopes[1][1]));
  if (extent(piece) <= tolerance_ || std::max(along_u, along_v) <= 4 * degree * margin ||
      runs_along(piece, (largest(g_range) + margin) / placed().least_weight))
    return Next::Contact;
  return along_u >= along_v ? Next::HalveU : Next::HalveV;
}

// As for the cell, with the mean Jacobian of f and g in the place of the tangent plane.
LineSearch::Guess LineSearch::guess(const Piece& piece, const double* net, const Slopes& slopes,
                                    double margin, double size) const {
  Guess result;
  Region& region = result.region;
  region.net = net;
  region.u = piece.u;
  region.v = piece.v;
  const Matrix2 m{
      {{middle(slopes[0][0]), middle(slopes[0][1])}, {middle(slopes[1][0]), middle(slopes[1][1])}}};
  const double per_area = 1 / (m[0][0] * m[1][1] - m[0][1] * m[1][0]);
  if (!std::isfinite(per_area)) return result;
  const Matrix2& c = region.inverse = {
      {{m[1][1] * per_area, -m[0][1] * per_area}, {-m[1][0] * per_area, m[0][0] * per_area}}};
  const int degree = std::max(rows_, columns_) - 1;
  const Vec2 value = offset_at(region, {at(piece.u, 0.5), at(piece.v, 0.5)});
  const Vec2 part{length(piece.u) / length(cell_->u), length(piece.v) / length(cell_->v)};
  bool exact = true;
  for (std::size_t i = 0; i < 2; ++i) {
    const int k = static_cast<int>(i);
    for (std::size_t j = 0; j < 2; ++j)
      for (std::size_t l = 0; l < 2; ++l)
        region.spread[i][j] += std::abs(c[i][l]) * (radius(slopes[l][j]) + 2 * degree * margin +
                                                    8 * kRoundoff * std::abs(m[l][j]));
    region.rounding[k] = 2 * (std::abs(c[i][0]) + std::abs(c[i][1])) *
                         (margin + (8 * degree + 8) * kRoundoff * size);
    region.slack[k] =
        clamped_slack(placed().reach * cell_->dual_length[i] / part[k], region.rounding[k]);
    const double bound = 0.5 * (1 + region.spread[i][0] + region.spread[i][1]) +
                         region.rounding[k] + region.slack[k];
    result.excluded = result.excluded || std::abs(value[k]) > bound;
    exact = exact && region.rounding[k] < kExact;
  }
  result.root = {at(piece.u, 0.5 - value[0]), at(piece.v, 0.5 - value[1])};
  result.contracts = exact && is_contraction(region.spread);
  return result;
}

// The piece is as good as flat, and the line lies in it: a stretch in common, not a point.
bool LineSearch::runs_along(const Piece& piece, double height) const {
  return height <= tolerance_ &&
         extent(piece) >=
             kTouchLength * std::sqrt(tolerance_ * (cell_->reach[0] + cell_->reach[1]));
}

double LineSearch::extent(const Piece& piece) const {
  return cell_->reach[0] * length(piece.u) / length(cell_->u) +
         cell_->reach[1] * length(piece.v) / length(cell_->v);
}

Vec2 LineSearch::value_at(const double* net, double s, double t) const {
  std::array<double, kMaxDegree + 1> in_u, in_v;
  bernstein(rows_ - 1, s, in_u.data());
  bernstein(columns_ - 1, t, in_v.data());
  Vec2 value;
  for (int k = 0; k < 2; ++k)
    for (int i = 0; i < rows_; ++i) {
      double row = 0;
      for (int j = 0; j < columns_; ++j)
        row += in_v[static_cast<std::size_t>(j)] * net[(k * rows_ + i) * columns_ + j];
      value[k] += in_u[static_cast<std::size_t>(i)] * row;
    }
  return value;
}

// What the piece may have in common with the line.
void LineSearch::add_contact(const Piece& piece, Status status, std::vector<RayHit>& hits) {
  const Interval parameters = clipped(piece, stretch_of(piece));
  Region region;
  region.u = piece.u;
  region.v = piece.v;
  const Vec2 centre{at(piece.u, 0.5), at(piece.v, 0.5)};
  Newton best = newton(region, centre);
  if (!best.converged) {
    best.local = centre;
    best.jet = jet_at(*patch_, centre[0], centre[1], 1);
    const Vec2 nearest = foot(piece, best.jet, at(parameters, 0.5));
    if (runs_along(piece, 0)) best.local = nearest;
    best.point = jet_at(*patch_, best.local[0], best.local[1], 1).point;
  }
  if (!add_hit(best, hits)) return;
  RayHit& hit = hits.back();
  hit.status = status;
  hit.first = std::min(hit.parameter, parameters.from);
  hit.last = std::max(hit.parameter, parameters.to);
  hit.grazing = hit.grazing || (hit.last - hit.first) * std::sqrt(square_) > tolerance_;
}

// Parameters of the line between which the points of a piece lie, seen across the line.
Interval LineSearch::stretch_of(const Piece& piece) {
  const int count = rows_ * columns_;
  double* const net = net_at(kPlaces + 2);
  load_heights(ray_.direction, net);
  for (int i = 0; i < count; ++i)
    net[count + i] = patch_->points.values()[static_cast<std::size_t>(i)][3];
  restrict_net(net, piece.u, piece.v);
  for (int i = 0; i < count; ++i) net[i] /= net[count + i];
  const ValueRange heights = range_of(net, count);
  const double t = dot(anchor_ - ray_.origin, ray_.direction) / square_;
  return {t + heights.low / square_, t + heights.high / square_};
}

// Parameters of a point of the line, by the tangent plane at the centre of a piece.
Vec2 LineSearch::foot(const Piece& piece, const PatchJet& centre, double parameter) const {
  const Vec3 area = cross(centre.u, centre.v);
  const Vec3 r = (point_at(ray_, parameter) - centre.point) * (1 / dot(area, area));
  return {std::clamp(at(piece.u, 0.5) + dot(r, cross(centre.v, area)), piece.u.from, piece.u.to),
          std::clamp(at(piece.v, 0.5) + dot(r, cross(area, centre.u)), piece.v.from, piece.v.to)};
}

// What of a stretch along the piece lies over it, by the tangent plane at its centre.
Interval LineSearch::clipped(const Piece& piece, Interval stretch) const {
  if (!runs_along(piece, 0)) return stretch;
  const Vec2 centre{at(piece.u, 0.5), at(piece.v, 0.5)};
  const PatchJet jet = jet_at(*patch_, centre[0], centre[1], 1);
  const Vec3 area = cross(jet.u, jet.v);
  const double per_square = 1 / dot(area, area);
  if (!std::isfinite(per_square)) return stretch;
  const std::array<Vec3, 2> dual{per_square * cross(jet.v, area), per_square * cross(area, jet.u)};
  const std::array<Interval, 2> sides{piece.u, piece.v};
  const double t = dot(jet.point - ray_.origin, ray_.direction) / square_;
  for (std::size_t i = 0; i < 2; ++i) {
    const double speed = dot(dual[i], ray_.direction);
    const double x = centre[static_cast<int>(i)] + dot(dual[i], point_at(ray_, t) - jet.point);
    const double slack = tolerance_ * norm(dual[i]);
    const double a = (sides[i].from - slack - x) / speed + t;
    const double b = (sides[i].to + slack - x) / speed + t;
    const double from = std::max(stretch.from, std::min(a, b));
    const double to = std::min(stretch.to, std::max(a, b));
    if (from <= to) stretch = {from, to};
  }
  return stretch;
}

}  // namespace blossom
