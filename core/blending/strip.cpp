// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/strip.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/errors.h"
#include "core/base/tolerances.h"
#include "core/blending/border_rows.h"

namespace blossom {
namespace {

/// Parameters looked at in every span to measure lengths and continuity.
constexpr int kSamples = 33;

double fraction(int sample) { return sample / (kSamples - 1.0); }

/// Two weights are in the same ratio when they differ by no more than the roundings of a product.
constexpr double kSameRatio = 1e-14;

/// Sine of the angle below which two tangents span no plane: rounding alone would turn it.
constexpr double kNoPlane = 1e-7;

void refuse(const std::string& what) { throw InvalidInput("strip_between: " + what); }

void check_weight(double weight, const char* name) {
  if (!(weight > 0) || !std::isfinite(weight))
    refuse(std::string(name) + " has to be positive and finite, got " + std::to_string(weight));
}

/// Mean distance of the two borders at corresponding inner parameters.
double mean_distance(const Border& a, const Border& b, bool backward) {
  double sum = 0;
  for (int i = 0; i < kSamples; ++i) {
    const double x = fraction(i);
    sum += distance(point_at(a, x), point_at(b, backward ? 1 - x : x));
  }
  return sum / kSamples;
}

bool nearer_backward(const Border& a, const Border& b) {
  const double forward =
      distance(point_at(a, 0), point_at(b, 0)) + distance(point_at(a, 1), point_at(b, 1));
  const double backward =
      distance(point_at(a, 0), point_at(b, 1)) + distance(point_at(a, 1), point_at(b, 0));
  const bool tie = std::abs(forward - backward) <= 1e-9 * (forward + backward);
  return tie ? mean_distance(a, b, true) < mean_distance(a, b, false) : backward < forward;
}

/// The largest coordinate of a border against its smallest weight.
double size_of(const Row& row) {
  double largest = 0;
  double smallest = row.front()[3];
  for (const Vec4& point : row) {
    largest = std::max(largest, max_norm(point));
    smallest = std::min(smallest, point[3]);
  }
  return largest / smallest;
}

void check_border(const Border& border, const std::string& name) {
  const Vec3 start = point_at(border, 0);
  double extent = 0;
  double speed = 0;
  for (std::size_t span = 0; span < border.edges.size(); ++span)
    for (int i = 0; i < kSamples; ++i) {
      const Row& edge = border.edges[span];
      extent = std::max(extent, distance(jet_at(edge, fraction(i)).point, start));
      speed = std::max(speed, norm(across_at(edge, border.across[span], fraction(i))));
    }
  const double point = Tolerances{}.point;
  if (extent <= point) refuse("the border " + name + " is a point");
  if (speed * border.depth <= point)
    refuse("the derivative across the border " + name + " vanishes, so there is no tangent plane");
}

/// The values of x at which a row of the strip ends: the breaks of both borders.
// Two parameters closer than this are one; a fraction of the border.
constexpr double kSameParameter = 1e-9;

struct Meeting {
  std::vector<double> breaks;
  double snap = 0;  ///< breaks of a and b closer than this are one
};

Meeting meeting_of(const Border& a, const Border& b, bool backward) {
  std::vector<double> of_b = b.breaks;
  if (backward) {
    std::reverse(of_b.begin(), of_b.end());
    for (double& x : of_b) x = 1 - x;
  }
  Meeting meeting{.breaks = a.breaks, .snap = kSameParameter};
  for (const auto& breaks : {a.breaks, of_b})
    for (std::size_t i = 1; i < breaks.size(); ++i)
      meeting.snap = std::min(meeting.snap, (breaks[i] - breaks[i - 1]) / 4);
  for (const double x : of_b) {
    const bool known = std::any_of(a.breaks.begin(), a.breaks.end(), [&](double other) {
      return std::abs(other - x) <= meeting.snap;
    });
    if (!known) meeting.breaks.push_back(x);
  }
  std::sort(meeting.breaks.begin(), meeting.breaks.end());
  return meeting;
}

/// The common ratio D_w / E_w of all pieces, or no value when it is not constant.
struct Ratio {
  bool constant = true;
  double value = 0;
};

Ratio weight_ratio(const std::vector<BorderPiece>& pieces) {
  Ratio ratio{true, pieces.front().across.front()[3] / pieces.front().edge.front()[3]};
  double largest = 0;
  for (const BorderPiece& piece : pieces)
    for (std::size_t i = 0; i < piece.edge.size(); ++i)
      largest = std::max(largest, std::abs(piece.across[i][3]));
  for (const BorderPiece& piece : pieces)
    for (std::size_t i = 0; i < piece.edge.size(); ++i) {
      const double off = piece.across[i][3] - ratio.value * piece.edge[i][3];
      if (std::abs(off) > kSameRatio * (largest + std::abs(ratio.value) * piece.edge[i][3]))
        ratio.constant = false;
    }
  return ratio;
}

/// Replaces D by D modulo E with weight 0, so that rows next to the border have its weights:
/// D - k E when D_w = k E_w, else E_w D - D_w E beside the border E_w E.
void drop_weights(std::vector<BorderPiece>& pieces) {
  const Ratio ratio = weight_ratio(pieces);
  for (BorderPiece& piece : pieces) {
    if (ratio.constant) {
      for (std::size_t i = 0; i < piece.edge.size(); ++i)
        piece.across[i] -= ratio.value * piece.edge[i];
    } else {
      std::vector<double> weights, cross_weights;
      for (const Vec4& point : piece.edge) weights.push_back(point[3]);
      for (const Vec4& vector : piece.across) cross_weights.push_back(vector[3]);
      Row across = product(weights, piece.across);
      const Row moving = product(cross_weights, piece.edge);
      for (std::size_t i = 0; i < across.size(); ++i) across[i] -= moving[i];
      piece.edge = product(weights, piece.edge);
      piece.across = std::move(across);
    }
    for (Vec4& vector : piece.across) vector[3] = 0;
  }
}

std::vector<BorderPiece> pieces_of(const Border& border, const Meeting& meeting, bool backward) {
  std::vector<BorderPiece> pieces;
  for (std::size_t i = 1; i < meeting.breaks.size(); ++i) {
    Interval x{meeting.breaks[i - 1], meeting.breaks[i]};
    if (backward) x = {1 - x.from, 1 - x.to};
    pieces.push_back(piece_of(border, x, meeting.snap));
  }
  drop_weights(pieces);
  return pieces;
}

double mean_speed(const std::vector<BorderPiece>& pieces) {
  double sum = 0;
  for (const BorderPiece& piece : pieces)
    for (int i = 0; i < kSamples; ++i)
      sum += norm(across_at(piece.edge, piece.across, fraction(i)));
  return sum / (kSamples * static_cast<double>(pieces.size()));
}

int common_degree(const std::vector<BorderPiece>& a, const std::vector<BorderPiece>& b) {
  std::size_t most = 0;
  for (const std::vector<BorderPiece>* pieces : {&a, &b})
    for (const BorderPiece& piece : *pieces) most = std::max(most, piece.edge.size());
  const int degree = static_cast<int>(most) - 1;
  if (degree > kMaxDegree)
    refuse("the strip would have degree " + std::to_string(degree) + ", at most " +
           std::to_string(kMaxDegree) + " is possible");
  return degree;
}

/// H_0 = E_a, H_1 = E_a + s_a / 3 D_a, H_2 = E_b + s_b / 3 D_b, H_3 = E_b.
RationalBezierPatch strip_patch(const BorderPiece& a, double scale_a, const BorderPiece& b,
                                double scale_b, int degree) {
  const Row edge_a = raised(a.edge, degree), across_a = raised(a.across, degree);
  const Row edge_b = raised(b.edge, degree), across_b = raised(b.across, degree);
  RationalBezierPatch patch{Grid<Vec4>(degree + 1, 4)};
  for (int i = 0; i <= degree; ++i) {
    const auto k = static_cast<std::size_t>(i);
    patch.points(i, 0) = edge_a[k];
    patch.points(i, 1) = edge_a[k] + (scale_a / 3) * across_a[k];
    patch.points(i, 2) = edge_b[k] + (scale_b / 3) * across_b[k];
    patch.points(i, 3) = edge_b[k];
  }
  return patch;
}

/// Raising the degree may round a weight of 1; in a polynomial strip it is 1.
void make_polynomial(BezierSurface& surface) {
  for (RationalBezierPatch& patch : surface.patches.values())
    for (Vec4& point : patch.points.values()) point[3] = 1;
}

/// The angle between the planes spanned by (a1, a2) and by (b1, b2), radians in [0, pi / 2];
/// 0 where one pair spans no plane.
double plane_angle(const Vec3& a1, const Vec3& a2, const Vec3& b1, const Vec3& b2) {
  const Vec3 a = cross(a1, a2), b = cross(b1, b2);
  const bool planes =
      norm(a) > kNoPlane * norm(a1) * norm(a2) && norm(b) > kNoPlane * norm(b1) * norm(b2);
  return planes ? std::atan2(norm(cross(a, b)), std::abs(dot(a, b))) : 0;
}

Row column(const RationalBezierPatch& patch, int j) {
  Row row;
  for (int i = 0; i < patch.points.rows(); ++i) row.push_back(patch.points(i, j));
  return row;
}

/// Compares the finished strip with the border it was made from.
StripContact contact(const BezierSurface& strip, const Border& border,
                     const std::vector<BorderPiece>& pieces, int edge_column) {
  StripContact worst;
  for (int span = 0; span < strip.patches.rows(); ++span) {
    const BorderPiece& piece = pieces[static_cast<std::size_t>(span)];
    const Row& edge = border.edges[static_cast<std::size_t>(piece.span)];
    const Row& across = border.across[static_cast<std::size_t>(piece.span)];
    const Row row = column(strip.patches(span, 0), edge_column);
    Row next = column(strip.patches(span, 0), edge_column == 0 ? 1 : 2);
    for (std::size_t i = 0; i < next.size(); ++i) next[i] -= row[i];
    for (int i = 0; i < kSamples; ++i) {
      const double t = at(piece.local, fraction(i));
      const SpaceJet ours = jet_at(row, fraction(i)), theirs = jet_at(edge, t);
      worst.gap = std::max(worst.gap, distance(ours.point, theirs.point));
      const double angle = plane_angle(ours.derivative, across_at(row, next, fraction(i)),
                                       theirs.derivative, across_at(edge, across, t));
      worst.normal_angle = std::max(worst.normal_angle, angle);
    }
  }
  return worst;
}

bool is_closed(const BezierSurface& strip) {
  const RationalBezierPatch& first = strip.patches(0, 0);
  const RationalBezierPatch& last = strip.patches(strip.patches.rows() - 1, 0);
  for (int j = 0; j < 4; ++j)
    if (max_norm(first.points(0, j) - last.points(last.degree_u(), j)) > strip_gap_bound(strip))
      return false;
  return true;
}

}  // namespace

const char* to_string(SurfaceSide side) {
  switch (side) {
    case SurfaceSide::UMin: return "umin";
    case SurfaceSide::UMax: return "umax";
    case SurfaceSide::VMin: return "vmin";
    case SurfaceSide::VMax: break;
  }
  return "vmax";
}

Strip strip_between(const BezierSurface& a, SurfaceSide side_a, const BezierSurface& b,
                    SurfaceSide side_b, const StripOptions& options) {
  validate(a, "a");
  validate(b, "b");
  check_weight(options.weight_a, "weight_a");
  check_weight(options.weight_b, "weight_b");
  const Border border_a = border_of(a, side_a), border_b = border_of(b, side_b);
  check_border(border_a, std::string(to_string(side_a)) + " of a");
  check_border(border_b, std::string(to_string(side_b)) + " of b");

  Strip strip;
  strip.backward = options.pairing == Pairing::Nearest ? nearer_backward(border_a, border_b)
                                                       : options.pairing == Pairing::Backward;
  const double width = mean_distance(border_a, border_b, strip.backward);
  if (width <= Tolerances{}.point) refuse("the borders coincide, there is nothing between them");

  const Meeting meeting = meeting_of(border_a, border_b, strip.backward);
  const std::vector<BorderPiece> of_a = pieces_of(border_a, meeting, false);
  const std::vector<BorderPiece> of_b = pieces_of(border_b, meeting, strip.backward);
  const double scale_a = options.weight_a * width / mean_speed(of_a);
  const double scale_b = options.weight_b * width / mean_speed(of_b);
  const int degree = common_degree(of_a, of_b);

  strip.surface = {.u_knots = meeting.breaks,
                   .v_knots = {0, 1},
                   .patches = Grid<RationalBezierPatch>(static_cast<int>(of_a.size()), 1),
                   .rational = a.rational || b.rational,
                   .error = std::max(a.error, b.error)};
  for (std::size_t i = 0; i < of_a.size(); ++i)
    strip.surface.patches(static_cast<int>(i), 0) =
        strip_patch(of_a[i], scale_a, of_b[i], scale_b, degree);
  if (!strip.surface.rational) make_polynomial(strip.surface);
  strip.surface.closed_u = border_a.closed && border_b.closed && is_closed(strip.surface);

  strip.contacts = strip_contacts(strip.surface, a, side_a, b, side_b, strip.backward);
  strip.contacts[0].scale = scale_a;
  strip.contacts[1].scale = scale_b;
  return strip;
}

std::array<StripContact, 2> strip_contacts(const BezierSurface& strip, const BezierSurface& a,
                                           SurfaceSide side_a, const BezierSurface& b,
                                           SurfaceSide side_b, bool backward) {
  validate(strip, "strip");
  validate(a, "a");
  validate(b, "b");
  const Border border_a = border_of(a, side_a), border_b = border_of(b, side_b);
  const Meeting meeting = meeting_of(border_a, border_b, backward);
  if (strip.u_knots.size() != meeting.breaks.size() || strip.patches.columns() != 1 ||
      strip.patches(0, 0).degree_v() != 3)
    throw InvalidInput("strip_contacts: a strip of " + std::to_string(meeting.breaks.size() - 1) +
                       " spans, cubic across, is wanted, got " +
                       std::to_string(strip.patches.rows()) + " spans");
  return {contact(strip, border_a, pieces_of(border_a, meeting, false), 0),
          contact(strip, border_b, pieces_of(border_b, meeting, backward), 3)};
}

double strip_gap_bound(const BezierSurface& strip) {
  double size = 0;
  for (const RationalBezierPatch& patch : strip.patches.values())
    size = std::max({size, size_of(column(patch, 0)), size_of(column(patch, 3))});
  return (24 * strip.patches(0, 0).degree_u() + 32) * 0x1p-53 * size;
}

double border_distance(const BezierSurface& a, SurfaceSide side_a, const BezierSurface& b,
                       SurfaceSide side_b) {
  validate(a, "a");
  validate(b, "b");
  const Border border_a = border_of(a, side_a), border_b = border_of(b, side_b);
  return mean_distance(border_a, border_b, nearer_backward(border_a, border_b));
}

}  // namespace blossom
