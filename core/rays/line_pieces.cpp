// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of LineSearch that halves: cells that one look does not settle.

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/cells/limits.h"
#include "core/math/roundoff.h"
#include "core/rays/limits.h"
#include "core/rays/line_search.h"
#include "core/subdivision/cell_nets.h"

namespace blossom {
namespace {

// A contact this many times longer than sqrt(tolerance * size) is no touch of curved surfaces.
constexpr double kTouchLength = 10;

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
  (along_u ? halve_bezier_u : halve_bezier_v)(shape, net_at(place), kOffMiddle, low,
                                              net_at(place + 1));
  std::copy(low, low + net_size_, net_at(place));
  Piece halves[2] = {piece, piece};
  Interval Piece::*side = along_u ? &Piece::u : &Piece::v;
  const double cut = at(piece.*side, kOffMiddle);
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
  constexpr double kAlongNormal = 1e-3;  // radians: a normal so near to the line gives no direction
  const Vec3& d = ray_.direction;
  const PatchJet jet = jet_at(*patch_, at(cell_->u, 0.5), at(cell_->v, 0.5), 1);
  const Vec3 normal = unit(cross(jet.u, jet.v));
  const Vec3 height = normal - (dot(normal, d) / square_) * d;
  across_[1] = norm(height) > kAlongNormal ? unit(height) : any_across(d);
  across_[0] = unit(cross(d, across_[1]));
  double* const net = net_at(0);
  load_heights(across_[0], net);
  load_heights(across_[1], net + rows_ * columns_);
  const int degree = std::max(rows_, columns_) - 1;
  const double numbers = cells_.scale() + max_norm(ray_.origin) + max_norm(anchor_);
  margin_ = 24 * kUnitRoundoff * placed().largest_weight * numbers +
            halving_error(degree, 4) * largest_of(range_of(net, net_size_));
  restrict_net(net, cell_->u, cell_->v);
  net_scale_ = largest_of(range_of(net, net_size_));
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
  const int degree = std::max(rows_, columns_) - 1;
  const double margin = margin_ + halving_error(degree, piece.depth) * net_scale_;
  const bool at_border =
      piece.u.from == 0 || piece.u.to == 1 || piece.v.from == 0 || piece.v.to == 1;
  const double reach = margin + (at_border ? placed().reach * placed().largest_weight : 0);
  const int count = rows_ * columns_;
  for (const double* plane : {net, net + count}) {
    const ValueRange range = range_of(plane, count);
    if (range.low > reach || range.high < -reach) return Next::Done;
  }
  const TwoForms forms = two_forms({rows_, columns_, 2}, net, margin);
  const Guess found = guess(piece, net, forms);
  if (found.excluded) return Next::Done;
  if (found.contracts && settle(found.region, found.root, hits) != Verdict::Open) return Next::Done;
  const auto& slopes = forms.slopes;
  const double along_u = std::max(largest_of(slopes[0][0]), largest_of(slopes[1][0]));
  const double along_v = std::max(largest_of(slopes[0][1]), largest_of(slopes[1][1]));
  if (extent(piece) <= tolerance_ || std::max(along_u, along_v) <= 4 * degree * margin ||
      runs_along(piece, (largest_of(forms.g) + margin) / placed().least_weight))
    return Next::Contact;
  return along_u >= along_v ? Next::HalveU : Next::HalveV;
}

// As for the cell, with the mean Jacobian of f and g in the place of the tangent plane.
LineSearch::Guess LineSearch::guess(const Piece& piece, const double* net,
                                    const TwoForms& forms) const {
  Guess result;
  if (!forms.regular) return result;
  Region& region = result.region;
  region = {piece.u, piece.v, forms.spread, forms.rounding, {}, net, forms.inverse};
  const Vec2 value = offset_at(region, {at(piece.u, 0.5), at(piece.v, 0.5)});
  const Vec2 part{length(piece.u) / length(cell_->u), length(piece.v) / length(cell_->v)};
  bool exact = true;
  for (std::size_t i = 0; i < 2; ++i) {
    const int k = static_cast<int>(i);
    region.slack[k] =
        clamped_slack(placed().reach * cell_->dual_length[i] / part[k], region.rounding[k]);
    const double bound = 0.5 * (1 + region.spread[i][0] + region.spread[i][1]) +
                         region.rounding[k] + region.slack[k];
    result.excluded = result.excluded || std::abs(value[k]) > bound;
    exact = exact && region.rounding[k] < kPlaceable;
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
