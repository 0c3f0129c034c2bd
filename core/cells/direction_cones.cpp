// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/cells/direction_cones.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "core/base/unbounded.h"
#include "core/forms/evaluation.h"
#include "core/subdivision/patch_subdivision.h"

namespace blossom {
namespace {

constexpr int kAxisSteps = 30;            // of the search for the main direction
constexpr std::size_t kMaxSampled = 128;  // patches, for the axes
constexpr double kAngleSlack = 1e-12;     // radians, for the roundings of projected directions

// Paths that jump by d: projected, a U and b V are no longer than d / sin(kRoom) where a U +- b V
// is no longer than d. In cones narrower than a right angle the sum of steps is no shorter than
// their lengths' sum over the square root of 2, and each step in space at most the square root of 2
// over kShown times as long. So a part of the path is no longer than 2 / (sin(kRoom) kShown) times
// d: kJumpReach.
constexpr double kRoom = 0.01;  // radians
constexpr double kShown = 0.1;

Vec3 low_of(const VectorBounds& b) { return b.middle - b.radius; }
Vec3 high_of(const VectorBounds& b) { return b.middle + b.radius; }

VectorBounds between(const Vec3& low, const Vec3& high) {
  return {0.5 * (low + high), 0.5 * (high - low)};
}

// With a largest coordinate of 1 in the middle, so that no cell outweighs its neighbours.
VectorBounds scaled_to_one(VectorBounds b) {
  const double largest = max_norm(b.middle);
  if (largest == 0 || !std::isfinite(1 / largest)) return b;
  b.middle = b.middle * (1 / largest);
  b.radius = b.radius * ((1 + 0x1p-50) / largest);
  return b;
}

VectorBounds joined(const VectorBounds& a, const VectorBounds& b) {
  Vec3 low = low_of(a), high = high_of(a);
  for (int k = 0; k < 3; ++k) {
    low[k] = std::min(low[k], low_of(b)[k]);
    high[k] = std::max(high[k], high_of(b)[k]);
  }
  VectorBounds result = between(low, high);
  result.radius = result.radius * (1 + 0x1p-50) + Vec3{0x1p-50, 0x1p-50, 0x1p-50};
  return result;
}

struct Plane {
  Vec3 e1, e2;
};

// Angles from the projected middle to the ends of the projected directions, and how much of their
// length the projection leaves them at least.
struct Sector {
  Vec2 middle;
  double low = 0;
  double high = 0;
  double shown = 1;
};

std::optional<Sector> sector_in(const Plane& plane, const VectorBounds& b) {
  Sector sector{{dot(plane.e1, b.middle), dot(plane.e2, b.middle)}};
  const Vec2& m = sector.middle;
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 x = b.middle;
    for (int k = 0; k < 3; ++k) x[k] += (corner >> k) % 2 == 0 ? b.radius[k] : -b.radius[k];
    const Vec2 p{dot(plane.e1, x), dot(plane.e2, x)};
    const double angle = std::atan2(m[0] * p[1] - m[1] * p[0], dot(m, p));
    sector.low = std::min(sector.low, angle);
    sector.high = std::max(sector.high, angle);
    sector.shown =
        std::min(sector.shown, std::abs(p[0]) + std::abs(p[1]) > 0 ? norm(p) / norm(x) : 0);
  }
  // A box that holds 0 shows a half-turn or more.
  if (!(sector.high - sector.low < std::numbers::pi - kAngleSlack)) return std::nullopt;
  return sector;
}

bool admits_jump(const Sector& sector) {
  return sector.high - sector.low < std::numbers::pi / 2 && sector.shown > kShown;
}

bool is_injective_along(const Vec3& normal, const DirectionCones& cones, bool may_jump) {
  const Vec3 e1 = any_across(normal);
  const Plane plane{e1, cross(normal, e1)};
  const auto u = sector_in(plane, cones.u), v = sector_in(plane, cones.v);
  if (!u || !v) return false;
  if (may_jump && !(admits_jump(*u) && admits_jump(*v))) return false;
  const double room = may_jump ? kRoom : kAngleSlack;
  const double turn = std::atan2(u->middle[0] * v->middle[1] - u->middle[1] * v->middle[0],
                                 dot(u->middle, v->middle));
  if (turn > 0)
    return turn + v->low - u->high > room && turn + v->high - u->low < std::numbers::pi - room;
  return -turn - v->high + u->low > room && -turn - v->low + u->high < std::numbers::pi - room;
}

bool is_injective(const DirectionCones& cones, bool may_jump) {
  const Vec3 mean = unit(cross(cones.u.middle, cones.v.middle));
  // The axes as well: along the third, surfaces of heights are injective however steep.
  for (const Vec3& normal : {mean, Vec3{0, 0, 1}, Vec3{0, 1, 0}, Vec3{1, 0, 0}})
    if (normal != Vec3{} && is_injective_along(normal, cones, may_jump)) return true;
  return false;
}

// --- cells

struct ProjectedRange {
  double low = kUnbounded;
  double high = -kUnbounded;
  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
  double middle() const { return 0.5 * (low + high); }
  double radius() const { return 0.5 * (high - low); }
};

struct Range3 {
  std::array<ProjectedRange, 3> along;
  void add(const Vec3& x) {
    for (std::size_t k = 0; k < 3; ++k) along[k].add(x[static_cast<int>(k)]);
  }
};

Vec3 in_axes(const Axes& axes, const Vec3& x) {
  return {dot(axes[0], x), dot(axes[1], x), dot(axes[2], x)};
}

// Bounds of numerator - quotient * turn, the derivative of a quotient up to positive factors.
VectorBounds derivative_direction(const Range3& numerator, const Range3& quotient,
                                  const ProjectedRange& turn, double slack) {
  VectorBounds result;
  for (std::size_t k = 0; k < 3; ++k) {
    const ProjectedRange &n = numerator.along[k], &q = quotient.along[k];
    const int axis = static_cast<int>(k);
    result.middle[axis] = n.middle() - q.middle() * turn.middle();
    result.radius[axis] = n.radius() + std::abs(q.middle()) * turn.radius() +
                          q.radius() * (std::abs(turn.middle()) + turn.radius()) + slack;
  }
  return result;
}

RationalBezierPatch differences(const RationalBezierPatch& patch, bool by_u) {
  const Grid<Vec4>& p = patch.points;
  Grid<Vec4> steps(p.rows() - (by_u ? 1 : 0), p.columns() - (by_u ? 0 : 1));
  for (int i = 0; i < steps.rows(); ++i)
    for (int j = 0; j < steps.columns(); ++j)
      steps(i, j) = (by_u ? p(i + 1, j) : p(i, j + 1)) - p(i, j);
  return {steps};
}

RationalBezierPatch part(const RationalBezierPatch& patch, const Interval& u, const Interval& v) {
  const bool whole = u.from == 0 && u.to == 1 && v.from == 0 && v.to == 1;
  return whole ? patch : sub_patch(patch, u, v);
}

// S - O over a piece of a patch, O one of its points.
struct Offsets {
  Vec3 origin;
  Range3 range;
};

Offsets offsets_of(const RationalBezierPatch& piece, const Axes& axes) {
  Offsets offsets;
  const auto points = piece.points.values();
  offsets.origin = projected(points[points.size() / 2]);
  for (const Vec4& p : points) offsets.range.add(in_axes(axes, projected(p) - offsets.origin));
  return offsets;
}

// w S_u or w S_v without the degree: X_u - O w_u - (S - O) w_u. Without weights O and S do not
// matter.
VectorBounds direction(const RationalBezierPatch& slope, const Offsets& offsets,
                       const SlopeNets& nets, const Axes& axes) {
  Range3 steps;
  ProjectedRange turn;
  for (const Vec4& p : slope.points.values()) {
    steps.add(in_axes(axes, Vec3{p[0], p[1], p[2]} - offsets.origin * p[3]));
    turn.add(p[3]);
  }
  const int degree = std::max(slope.degree_u(), slope.degree_v()) + 1;
  const double slack = 8 * subdivision_error(degree) * nets.scale * (1 + nets.scale) +
                       8 * nets.heaviest * nets.given_rounding;
  return derivative_direction(steps, offsets.range, turn, slack);
}

// --- poles

// The homogeneous points of a rectangle seen from its pole: row r of them is r steps from the pole,
// which is row 0; along each row runs the other parameter.
class PoleNet {
 public:
  PoleNet(const PolePart& of, const Vec3& pole)
      : points_(part(of.nets.points, of.u, of.v).points),
        rational_(of.nets.rational),
        across_u_(of.side == PoleSide::LowU || of.side == PoleSide::HighU),
        low_(of.side == PoleSide::LowU || of.side == PoleSide::LowV),
        pole_(pole) {
    rounding_ = subdivision_error(std::max(points_.rows(), points_.columns()) - 1) * of.nets.scale *
                    (1 + of.nets.heaviest) +
                2 * of.nets.heaviest * of.nets.given_rounding;
  }

  bool across_u() const { return across_u_; }
  int degree() const { return (across_u_ ? points_.rows() : points_.columns()) - 1; }
  int along() const { return across_u_ ? points_.columns() : points_.rows(); }

  double weight(int row, int i) const { return rational_ ? point(row, i)[3] : 1; }

  // w (S - P), divided by the distance to the pole: degree - 1 in that direction.
  Vec3 from_pole(int row, int i) const {
    const Vec4& p = point(row, i);
    return (Vec3{p[0], p[1], p[2]} - weight(row, i) * pole_) *
           (static_cast<double>(degree()) / row);
  }

  // Of a coordinate of w (S - P).
  double rounding() const { return rounding_; }

 private:
  const Vec4& point(int row, int i) const {
    const int r = low_ ? row : degree() - row;
    return across_u_ ? points_(r, i) : points_(i, r);
  }

  Grid<Vec4> points_;
  bool rational_, across_u_, low_;
  Vec3 pole_;
  double rounding_ = 0;
};

// Bounds of w T_u = (w T)_u - T w_u along the pole, without the degree.
VectorBounds along_pole(const PoleNet& net, const Axes& axes) {
  Range3 steps, quotient;
  ProjectedRange weight, turn;
  for (int r = 0; r <= net.degree(); ++r)
    for (int i = 0; i < net.along(); ++i) {
      const double w = net.weight(r, i);
      weight.add(w);
      if (i > 0) turn.add(w - net.weight(r, i - 1));
    }
  for (int r = 1; r <= net.degree(); ++r)
    for (int i = 0; i < net.along(); ++i) {
      const Vec3 x = in_axes(axes, net.from_pole(r, i));
      quotient.add(x * (1 / weight.low));
      quotient.add(x * (1 / weight.high));
      if (i > 0) steps.add(x - in_axes(axes, net.from_pole(r, i - 1)));
    }
  const double slack = 8 * net.degree() * (weight.high / weight.low) * net.rounding();
  return derivative_direction(steps, quotient, turn, slack);
}

// Adds x x^T.
void add_square(Grid<double>& sum, const Vec3& x) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) sum(i, j) += x[i] * x[j];
}

// The direction of the largest eigenvalue, by powers; any will do if there are several.
Vec3 main_direction(const Grid<double>& square) {
  Vec3 x = unit(Vec3{1, 0.7320508, 0.4142136});
  for (int step = 0; step < kAxisSteps; ++step) {
    Vec3 y;
    for (int i = 0; i < 3; ++i)
      y[i] = square(i, 0) * x[0] + square(i, 1) * x[1] + square(i, 2) * x[2];
    if (!(norm(y) > 0)) return {0, 0, 1};
    x = unit(y);
  }
  return x;
}

}  // namespace

Axes axes_of(const BezierSurface& surface) {
  Grid<double> square(3, 3);
  const auto patches = surface.patches.values();
  const std::size_t step = patches.size() / kMaxSampled + 1;
  for (std::size_t p = 0; p < patches.size(); p += step) {
    const PatchJet middle = jet_at(patches[p], 0.5, 0.5, 1);
    for (const double v : {0.0, 1.0})
      for (const double u : {0.0, 1.0}) {
        const PatchJet corner = jet_at(patches[p], u, v, 1);
        add_square(square, corner.u - middle.u);
        add_square(square, corner.v - middle.v);
      }
  }
  const Vec3 third = main_direction(square);
  const Vec3 first = any_across(third);
  return {first, cross(third, first), third};
}

SlopeNets slope_nets(const RationalBezierPatch& patch, bool rational, double given_rounding) {
  SlopeNets nets{patch, differences(patch, true), differences(patch, false), rational};
  nets.given_rounding = given_rounding;
  for (const Vec4& p : patch.points.values()) {
    nets.scale = std::max({nets.scale, max_norm(p), max_norm(projected(p))});
    nets.heaviest = std::max(nets.heaviest, p[3]);
  }
  return nets;
}

DirectionCones cones_of(const SlopeNets& nets, const Interval& u, const Interval& v,
                        const Axes& axes) {
  Offsets offsets{{}, {}};
  if (nets.rational)
    offsets = offsets_of(part(nets.points, u, v), axes);
  else
    offsets.range.add({});
  return {scaled_to_one(direction(part(nets.u, u, v), offsets, nets, axes)),
          scaled_to_one(direction(part(nets.v, u, v), offsets, nets, axes))};
}

DirectionCones cones_at_pole(const SlopeNets& nets, const Interval& u, const Interval& v,
                             PoleSide side, const Vec3& pole, const Axes& axes) {
  DirectionCones cones = cones_of(nets, u, v, axes);
  const PoleNet net({nets, u, v, side}, pole);
  (net.across_u() ? cones.v : cones.u) = scaled_to_one(along_pole(net, axes));
  return cones;
}

DirectionCones joined(const DirectionCones& a, const DirectionCones& b) {
  return {joined(a.u, b.u), joined(a.v, b.v)};
}

bool is_injective(const DirectionCones& cones) { return is_injective(cones, false); }

bool is_injective_with_jump(const DirectionCones& cones) { return is_injective(cones, true); }

bool meet_in_pole_only(const PolePart& a, const PolePart& b, const Vec3& pole, double sine) {
  // Each up to a positive factor, which does not matter.
  const auto vectors = [](const PoleNet& net) {
    std::vector<Vec3> all;
    for (int r = 1; r <= net.degree(); ++r)
      for (int i = 0; i < net.along(); ++i) all.push_back(net.from_pole(r, i));
    return all;
  };
  const auto mean = [](const std::vector<Vec3>& all) {
    Vec3 sum;
    for (const Vec3& x : all) sum = sum + unit(x);
    return unit(sum);
  };
  const PoleNet net_a(a, pole), net_b(b, pole);
  const auto from_a = vectors(net_a), from_b = vectors(net_b);
  const Vec3 normal = unit(mean(from_a) - mean(from_b));
  const auto beside = [&](const std::vector<Vec3>& all, const Vec3& to, const PoleNet& net) {
    const double slack = 8 * net.degree() * net.rounding();
    return std::ranges::all_of(
        all, [&](const Vec3& x) { return dot(to, x) > slack + sine * (norm(x) + slack); });
  };
  return beside(from_a, normal, net_a) && beside(from_b, -normal, net_b);
}

}  // namespace blossom
