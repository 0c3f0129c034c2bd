// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/strips/strip.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/errors.h"
#include "core/base/tolerances.h"
#include "core/blending/continuity/continuity.h"
#include "core/blending/strips/border_weights.h"
#include "core/math/binomial.h"
#include "core/math/roundoff.h"

namespace blossom {
namespace {

/// Parameters looked at in every span to measure lengths.
constexpr int kSamples = 33;

double fraction(int sample) { return sample / (kSamples - 1.0); }

/// Two parameters closer than this are one; a fraction of the border.
constexpr double kSameParameter = 1e-9;

/// Curvature that counts as none, as a part of 1 / width of the strip.
constexpr double kFlat = 1e-3;

void refuse(const std::string& what) { throw InvalidInput("strip: " + what); }

void check_weight(double weight, const char* name) {
  if (!(weight > 0) || !std::isfinite(weight))
    refuse(std::string(name) + " has to be positive and finite, got " + std::to_string(weight));
}

/// Mean distance of the two borders at corresponding inner parameters; b starts at `start`.
double mean_distance(const Border& a, const Border& b, bool backward, double start = 0) {
  double sum = 0;
  for (int i = 0; i < kSamples; ++i) {
    const double x = fraction(i);
    const double on_b = start + (backward ? 1 - x : x);
    sum += distance(point_at(a, x), point_at(b, on_b > 1 ? on_b - 1 : on_b));
  }
  return sum / kSamples;
}

/// Where a closed border b has to start to be nearest to a closed border a: the best of a grid,
/// refined by halving its step. A start within kSameParameter of 0 is 0.
double nearest_start(const Border& a, const Border& b, bool backward) {
  double best = 0, least = mean_distance(a, b, backward);
  const auto look = [&](double start) {
    start -= std::floor(start);
    const double apart = mean_distance(a, b, backward, start);
    if (!(apart < least)) return;
    least = apart;
    best = start;
  };
  for (int i = 1; i + 1 < kSamples; ++i) look(fraction(i));
  for (double step = fraction(1) / 2; step > kSameParameter; step /= 2)
    for (const double start : {best - step, best + step}) look(start);
  return best > kSameParameter && best < 1 - kSameParameter ? best : 0;
}

bool nearer_backward(const Border& a, const Border& b) {
  const double forward =
      distance(point_at(a, 0), point_at(b, 0)) + distance(point_at(a, 1), point_at(b, 1));
  const double backward =
      distance(point_at(a, 0), point_at(b, 1)) + distance(point_at(a, 1), point_at(b, 0));
  constexpr double kEqualSums = 1e-9;  // part of both: rounding does not choose
  const bool tie = std::abs(forward - backward) <= kEqualSums * (forward + backward);
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

void check_border(const Border& border, int order, const std::string& of) {
  const std::string name = border.name + " of " + of;
  const Vec3 start = point_at(border, 0);
  double extent = 0;
  double speed = 0;
  for (const BorderRows& rows : border.spans) {
    if (static_cast<int>(rows.size()) <= order)
      refuse("the border " + name + " has no derivatives of order " + std::to_string(order));
    for (int i = 0; i < kSamples; ++i) {
      extent = std::max(extent, distance(jet_at(rows[0], fraction(i)).point, start));
      speed = std::max(speed, norm(across_at(rows[0], rows[1], fraction(i))));
    }
  }
  const double point = Tolerances{}.point;
  if (extent <= point) refuse("the border " + name + " is a point");
  if (speed * border.depth <= point)
    refuse("the derivative across the border " + name + " vanishes, so there is no tangent plane");
}

/// The values of x at which a row of the strip ends: the breaks of both borders.
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

std::vector<BorderPiece> pieces_of(const Border& border, const Meeting& meeting, bool backward) {
  std::vector<BorderPiece> pieces;
  for (std::size_t i = 1; i < meeting.breaks.size(); ++i) {
    Interval x{meeting.breaks[i - 1], meeting.breaks[i]};
    if (backward) x = {1 - x.from, 1 - x.to};
    pieces.push_back(piece_of(border, x, meeting.snap));
  }
  return pieces;
}

double mean_speed(const std::vector<BorderPiece>& pieces) {
  double sum = 0;
  for (const BorderPiece& piece : pieces)
    for (int i = 0; i < kSamples; ++i)
      sum += norm(across_at(piece.rows[0], piece.rows[1], fraction(i)));
  return sum / (kSamples * static_cast<double>(pieces.size()));
}

std::size_t most_points(const std::vector<BorderPiece>& pieces) {
  std::size_t most = 0;
  for (const BorderPiece& piece : pieces) most = std::max(most, piece.rows[0].size());
  return most;
}

void check_degree(int degree) {
  if (degree > kMaxDegree)
    refuse("the strip would have degree " + std::to_string(degree) + ", at most " +
           std::to_string(kMaxDegree) + " is possible");
}

/// The pieces with rows of equal weights up to `order`.
std::vector<BorderPiece> level_pieces(const Border& border, const Meeting& meeting, bool backward,
                                      int order) {
  std::vector<BorderPiece> pieces = pieces_of(border, meeting, backward);
  for (BorderPiece& piece : pieces) piece.rows.resize(static_cast<std::size_t>(order) + 1);
  check_degree(level_degree(pieces));
  level_weights(pieces);
  return pieces;
}

/// The rows of a strip next to one of its borders, H_0 the border, in Bezier points:
///   H_i = sum_j binom(i, j) (m - j)! / m! s^j D_j,   m = 2k + 1
std::vector<Row> rows_beside(const BorderPiece& piece, double scale, int degree) {
  const int order = static_cast<int>(piece.rows.size()) - 1;
  std::vector<Row> rows(piece.rows.size(), Row(static_cast<std::size_t>(degree) + 1));
  double factor = 1;
  for (int j = 0; j <= order; ++j) {
    const Row derivative = raised(piece.rows[static_cast<std::size_t>(j)], degree);
    for (int i = j; i <= order; ++i)
      for (std::size_t p = 0; p < derivative.size(); ++p)
        rows[static_cast<std::size_t>(i)][p] += (factor * binomial(i, j)) * derivative[p];
    factor *= scale / (2 * order + 1 - j);
  }
  return rows;
}

RationalBezierPatch strip_patch(const std::vector<Row>& beside_a,
                                const std::vector<Row>& beside_b) {
  const int degree = static_cast<int>(beside_a[0].size()) - 1;
  const int last = static_cast<int>(beside_a.size() + beside_b.size()) - 1;
  RationalBezierPatch patch{Grid<Vec4>(degree + 1, last + 1)};
  for (std::size_t row = 0; row < beside_a.size(); ++row)
    for (int i = 0; i <= degree; ++i) {
      patch.points(i, static_cast<int>(row)) = beside_a[row][static_cast<std::size_t>(i)];
      patch.points(i, last - static_cast<int>(row)) = beside_b[row][static_cast<std::size_t>(i)];
    }
  return patch;
}

/// Raising the degree may round a weight of 1; in a polynomial strip it is 1.
void make_polynomial(BezierSurface& surface) {
  for (RationalBezierPatch& patch : surface.patches.values())
    for (Vec4& point : patch.points.values()) point[3] = 1;
}

Row column(const RationalBezierPatch& patch, int j) {
  Row row;
  for (int i = 0; i < patch.points.rows(); ++i) row.push_back(patch.points(i, j));
  return row;
}

/// The face beside a border, over the spans of the strip.
BorderSpans face_beside(const std::vector<BorderPiece>& pieces, const Meeting& meeting) {
  BorderSpans spans;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    BorderSpan& span = spans.emplace_back();
    span.place = {meeting.breaks[i], meeting.breaks[i + 1]};
    span.edge = pieces[i].rows[0];
    for (const Vec4& outwards : pieces[i].rows[1]) span.across.push_back(-1.0 * outwards);
    span.bend = pieces[i].rows[2];
  }
  return spans;
}

StripContact contact(const BezierSurface& strip, SurfaceSide side, const Border& border,
                     const Meeting& meeting, bool backward) {
  return strip_contact(strip, side,
                       edge_sides(face_beside(pieces_of(border, meeting, backward), meeting)),
                       meeting.breaks);
}

/// Mean distance of the two borders of a strip, at the middles of its spans.
double width_of(const BezierSurface& strip) {
  double sum = 0;
  for (const RationalBezierPatch& patch : strip.patches.values())
    sum += distance(jet_at(column(patch, 0), 0.5).point,
                    jet_at(column(patch, patch.degree_v()), 0.5).point);
  return sum / static_cast<double>(strip.patches.values().size());
}

bool is_closed(const BezierSurface& strip) {
  const RationalBezierPatch& first = strip.patches(0, 0);
  const RationalBezierPatch& last = strip.patches(strip.patches.rows() - 1, 0);
  for (int j = 0; j <= first.degree_v(); ++j)
    if (max_norm(first.points(0, j) - last.points(last.degree_u(), j)) > strip_gap_bound(strip))
      return false;
  return true;
}

Strip strip_of(const Border& a, const Border& b, bool backward, const StripOptions& options) {
  const double width = mean_distance(a, b, backward);
  if (width <= Tolerances{}.point) refuse("the borders coincide, there is nothing between them");
  Strip strip;
  strip.backward = backward;
  const Meeting meeting = meeting_of(a, b, strip.backward);
  const auto of_a = level_pieces(a, meeting, false, options.order);
  const auto of_b = level_pieces(b, meeting, strip.backward, options.order);
  const double scale_a = options.weight_a * width / mean_speed(of_a);
  const double scale_b = options.weight_b * width / mean_speed(of_b);
  const int degree = static_cast<int>(std::max(most_points(of_a), most_points(of_b))) - 1;

  strip.surface = {.u_knots = meeting.breaks,
                   .v_knots = {0, 1},
                   .patches = Grid<RationalBezierPatch>(static_cast<int>(of_a.size()), 1),
                   .rational = a.rational || b.rational,
                   .error = std::max(a.error, b.error)};
  for (std::size_t i = 0; i < of_a.size(); ++i)
    strip.surface.patches(static_cast<int>(i), 0) =
        strip_patch(rows_beside(of_a[i], scale_a, degree), rows_beside(of_b[i], scale_b, degree));
  if (!strip.surface.rational) make_polynomial(strip.surface);
  strip.surface.closed_u = a.closed && b.closed && is_closed(strip.surface);

  strip.contacts = strip_contacts(strip.surface, a, b, strip.backward);
  strip.contacts[0].scale = scale_a;
  strip.contacts[1].scale = scale_b;
  return strip;
}

}  // namespace

Strip strip_between(const Border& a, const Border& b, const StripOptions& options) {
  check_weight(options.weight_a, "weight_a");
  check_weight(options.weight_b, "weight_b");
  if (options.order < 1 || options.order > kMaxStripOrder)
    refuse("the order has to be 1 to " + std::to_string(kMaxStripOrder) + ", got " +
           std::to_string(options.order));
  const int measured = std::max(options.order, 2);
  check_border(a, measured, "a");
  check_border(b, measured, "b");
  if (options.pairing != Pairing::Nearest)
    return strip_of(a, b, options.pairing == Pairing::Backward, options);
  if (!a.closed || !b.closed) return strip_of(a, b, nearer_backward(a, b), options);
  const double forward = nearest_start(a, b, false), backward = nearest_start(a, b, true);
  const bool turns = mean_distance(a, b, true, backward) < mean_distance(a, b, false, forward);
  const double start = turns ? backward : forward;
  Strip strip = strip_of(a, start == 0 ? b : restarted(b, start), turns, options);
  strip.start_b = start;
  return strip;
}

Strip strip_between(const BezierSurface& a, SurfaceSide side_a, const BezierSurface& b,
                    SurfaceSide side_b, const StripOptions& options) {
  validate(a, "a");
  validate(b, "b");
  const int order = std::clamp(options.order, 2, kMaxStripOrder);
  return strip_between(border_of(a, side_a, order), border_of(b, side_b, order), options);
}

std::array<StripContact, 2> strip_contacts(const BezierSurface& strip, const Border& a,
                                           const Border& b, bool backward, double start_b) {
  validate(strip, "strip");
  if (start_b != 0) return strip_contacts(strip, a, restarted(b, start_b), backward);
  const Meeting meeting = meeting_of(a, b, backward);
  if (strip.u_knots.size() != meeting.breaks.size() || strip.patches.columns() != 1)
    throw InvalidInput("strip_contacts: a strip of " + std::to_string(meeting.breaks.size() - 1) +
                       " spans is wanted, got " + std::to_string(strip.patches.rows()) + " x " +
                       std::to_string(strip.patches.columns()));
  return {contact(strip, SurfaceSide::VMin, a, meeting, false),
          contact(strip, SurfaceSide::VMax, b, meeting, backward)};
}

StripContact strip_contact(const BezierSurface& strip, SurfaceSide side, const EdgeSides& beside,
                           std::span<const double> breaks) {
  const MeasuredContinuity found = measured_continuity(edge_sides(border_spans(strip, side, false)),
                                                       beside, breaks, kFlat / width_of(strip));
  return {found.gap.value, found.angle.value, found.curvature.value, 0};
}

double strip_gap_bound(const BezierSurface& strip) {
  const RationalBezierPatch& first = strip.patches(0, 0);
  double size = 0;
  for (const RationalBezierPatch& patch : strip.patches.values())
    size = std::max({size, size_of(column(patch, 0)), size_of(column(patch, patch.degree_v()))});
  return (24 * first.degree_u() + 32) * kUnitRoundoff * size;
}

double border_distance(const Border& a, const Border& b) {
  return mean_distance(a, b, nearer_backward(a, b));
}

}  // namespace blossom
