// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/gap/cells/valley_labels.h"

#include <algorithm>
#include <cmath>

#include "core/cells/limits.h"
#include "core/math/functions/sign_change.h"
#include "core/surfaces/gap/limits.h"

namespace blossom {
namespace {

constexpr double kContactGap = 2;      // tolerances: gaps up to this may be called a contact
constexpr double kBorderGap = 1.5;     // the same where the valley crosses a border
constexpr double kEdgeGap = 1.0 / 64;  // tolerances: gap along an edge that counts as contact
constexpr double kAcross = 0.7;        // cosine: a direction that crosses an edge
// Choices: pieces of a valley between two borders, and those if signs alone are to tell.
constexpr int kMaxPieces = 400;
constexpr int kMaxExactPieces = 40;
constexpr double kShallow = 1.0 / 64;  // of the tolerance: depth of what is no contact
constexpr int kDepthSamples = 8;       // parts of a piece, between which its depth is sampled
constexpr double kSure = 2;            // errors: a gap larger than this has a sure sign
constexpr std::array kCuts{kSurfaceOffMiddle, 0.4231,
                           0.5617};      // of a piece: where it may be halved
constexpr double kShortestPiece = 1e-9;  // of the cell
constexpr double kFoldWidth = 0x1p-51;   // likewise: how near the sign changes

std::vector<ValleyPiece> merged(const std::vector<ValleyPiece>& pieces) {
  std::vector<ValleyPiece> result;
  for (const ValleyPiece& piece : pieces)
    if (!result.empty() && result.back().label == piece.label)
      result.back().to = piece.to;
    else
      result.push_back(piece);
  return result;
}

}  // namespace

ValleyLabels::ValleyLabels(const ValleyShape& shape, double tolerance, double slow_slope)
    : shape_(shape), tolerance_(tolerance), slow_slope_(slow_slope) {
  for (int edge = 0; edge < 4; ++edge) {
    edge_gap_[static_cast<std::size_t>(edge)] = shape.along_edge(shape.gap, edge);
    edge_slope_[static_cast<std::size_t>(edge)] = shape.along_edge(shape.gap_z, edge);
  }
}

bool ValleyLabels::find_crossings() {
  for (int edge = 0; edge < 4; ++edge) {
    const auto& slope = edge_slope_[static_cast<std::size_t>(edge)];
    const auto roots = isolated_roots(slope, shape_.error[1], shape_.error[2], -1, 1);
    if (!roots) return false;
    for (const IsolatedRoot& root : *roots) {
      const Vec2 wz = shape_.on_edge(edge, root.t);
      BorderEvent event{wz[0], wz[1], edge, root.t, false, 0, 0, false};
      event.gap = value(shape_.gap, wz[0], wz[1]);
      event.slope = value(shape_.gap_w, wz[0], wz[1]);
      const bool slow = std::abs(event.slope) <= slow_slope_;
      event.contact = slow && std::abs(event.gap) <= kBorderGap * tolerance_;
      if (!event.contact && std::abs(event.gap) <= shape_.error[0]) return false;
      crossings_.push_back(event);
    }
  }
  std::sort(crossings_.begin(), crossings_.end(),
            [](const BorderEvent& a, const BorderEvent& b) { return a.w < b.w; });
  return crossings_.size() % 2 == 0;
}

// Roots on the edges, outside the zones in which a contact crosses the edge.
bool ValleyLabels::find_roots() {
  for (int edge = 0; edge < 4; ++edge) {
    const auto e = static_cast<std::size_t>(edge);
    std::vector<double> cuts{-1};
    for (const BorderEvent& crossing : crossings_)
      if (crossing.edge == edge && crossing.contact) add_zone(e, crossing.along, cuts);
    cuts.push_back(1);
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); i += 2)
      if (cuts[i] < cuts[i + 1] && !add_roots(e, cuts[i], cuts[i + 1])) return false;
  }
  return true;
}

// The zone round a contact's crossing in which the gap may fall below its valley's bound:
// gap >= m + slope^2 / (2 bend), so it ends where slope^2 = 8 tolerance bend.
void ValleyLabels::add_zone(std::size_t edge, double along, std::vector<double>& cuts) const {
  const double limit = std::sqrt(8 * tolerance_ * shape_.bend_high) + shape_.error[1];
  constexpr double kFirstOfZone = 1e-4, kZoneGrowth = 1.3;  // part of half an edge; steps go on so
  const Polynomial& slope = edge_slope_[edge];
  for (const double direction : {-1.0, 1.0}) {
    double step = kFirstOfZone, t = along;
    while (std::abs(value(slope, t)) < limit && std::abs(t) < 1) {
      t = std::clamp(t + direction * step, -1.0, 1.0);
      step *= kZoneGrowth;
    }
    cuts.push_back(t);
  }
}

bool ValleyLabels::add_roots(std::size_t edge, double from, double to) {
  // Derivatives along an edge are at most those in directions of largest entry 1.
  const auto roots = isolated_roots(edge_gap_[edge], shape_.error[0], shape_.error[1], from, to);
  if (!roots) return false;
  for (const IsolatedRoot& root : *roots) {
    const Vec2 wz = shape_.on_edge(static_cast<int>(edge), root.t);
    const double slope = value(edge_slope_[edge], root.t);
    if (std::abs(slope) <= shape_.error[1]) return false;
    roots_.push_back({wz[0], wz[1], static_cast<int>(edge), root.t, slope > 0, 0, 0, false});
  }
  return true;
}

// Labels of the valley inside the cell; folds are where Above and Below meet.
bool ValleyLabels::label_valley() {
  for (std::size_t i = 0; i < crossings_.size(); i += 2) {
    const BorderEvent &in = crossings_[i], &out = crossings_[i + 1];
    const auto whole = shape_.stretch(in.w, out.w);
    if (!whole) return false;
    std::vector<ValleyPiece> pieces;
    // By signs alone where that is possible, so that shallow loops stay loops.
    exact_ = !in.contact && !out.contact;
    pieces_left_ = kMaxExactPieces;
    const auto is_reported = [&] {
      return label(*whole, in, out, pieces) && changes_sign(pieces) &&
             beyond_tolerance(merged(pieces));
    };
    if (!exact_ || !is_reported()) {
      exact_ = false;
      pieces.clear();
      pieces_left_ = kMaxPieces;
      if (!label(*whole, in, out, pieces)) return false;
    }
    if (in.contact != (pieces.front().label == ValleyLabel::Contact)) return false;
    if (out.contact != (pieces.back().label == ValleyLabel::Contact)) return false;
    valleys_.push_back(merged(pieces));
  }
  return true;
}

// False if the surfaces do not cross along the valley: signs do not tell how near they come.
bool ValleyLabels::changes_sign(const std::vector<ValleyPiece>& pieces) {
  return std::ranges::any_of(
      pieces, [](const ValleyPiece& piece) { return piece.label == ValleyLabel::Below; });
}

// True if between two changes of sign the gap always grows to a part of the tolerance: what is
// shallower is a contact.
bool ValleyLabels::beyond_tolerance(const std::vector<ValleyPiece>& pieces) const {
  for (std::size_t i = 1; i + 1 < pieces.size(); ++i) {
    double most = 0;
    for (int k = 0; k <= kDepthSamples; ++k) {
      const double w = pieces[i].from + (pieces[i].to - pieces[i].from) * k / kDepthSamples;
      if (const auto z = shape_.valley_at(w))
        most = std::max(most, std::abs(value(shape_.gap, w, *z)));
    }
    if (most <= kShallow * tolerance_) return false;
  }
  return true;
}

bool ValleyLabels::label(const ValleyStretch& stretch, const BorderEvent& in,
                         const BorderEvent& out, std::vector<ValleyPiece>& pieces) {
  const double from = stretch.from, to = stretch.to;
  if (--pieces_left_ < 0 || to - from < kShortestPiece) return false;
  const ValleyBounds bounds = shape_.bounds_on(stretch);
  const bool first = from == in.w, last = to == out.w;
  const bool touches_contact = (first && in.contact) || (last && out.contact);
  const bool touches_other = (first && !in.contact) || (last && !out.contact);
  const bool fast = bounds.slope_low > slow_slope_ || bounds.slope_high < -slow_slope_;
  const bool monotone = bounds.slope_low > 0 || bounds.slope_high < 0;
  // Where the gap changes fast its sign counts, elsewhere the tolerance does.
  const double sure = exact_ || fast ? 0 : tolerance_;
  if (!touches_contact && bounds.low > sure) {
    pieces.push_back({from, to, ValleyLabel::Above});
    return true;
  }
  if (!touches_contact && bounds.high < -sure) {
    pieces.push_back({from, to, ValleyLabel::Below});
    return true;
  }
  if (!touches_contact && (fast || exact_) && monotone && add_fold(from, to, pieces)) return true;
  const double most = kContactGap * tolerance_;
  if (!exact_ && !touches_other && shape_.error[0] <= kErrorShare * tolerance_ &&
      bounds.low >= -most && bounds.high <= most) {
    pieces.push_back({from, to, ValleyLabel::Contact});
    return true;
  }
  return label_parts(stretch, in, out, pieces);
}

bool ValleyLabels::label_parts(const ValleyStretch& stretch, const BorderEvent& in,
                               const BorderEvent& out, std::vector<ValleyPiece>& pieces) {
  const auto parts = stretch.parts(cut_between(stretch.from, stretch.to));
  const bool coarse = shape_.is_coarse(stretch);
  for (const ValleyStretch& part : parts) {
    const auto own = coarse ? shape_.stretch(part.from, part.to) : part;
    if (!own || !label(*own, in, out, pieces)) return false;
  }
  return true;
}

// A fold too near a cut could not be told from the cut: signs at cuts are sure if they can be.
double ValleyLabels::cut_between(double from, double to) const {
  for (const double part : kCuts) {
    const double cut = from + part * (to - from);
    const auto z = shape_.valley_at(cut);
    if (z && std::abs(value(shape_.gap, cut, *z)) > kSure * shape_.error[0]) return cut;
  }
  return from + kCuts[0] * (to - from);
}

// A piece over which m is monotone with sure signs at its ends: one fold.
bool ValleyLabels::add_fold(double from, double to, std::vector<ValleyPiece>& pieces) const {
  const auto z0 = shape_.valley_at(from), z1 = shape_.valley_at(to);
  if (!z0 || !z1) return false;
  const double m0 = value(shape_.gap, from, *z0), m1 = value(shape_.gap, to, *z1);
  const double error = shape_.error[0];
  if (std::abs(m0) <= kSure * error || std::abs(m1) <= kSure * error || (m0 > 0) == (m1 > 0))
    return false;
  bool lost = false;
  const auto depth = [&](double w) {
    const auto z = shape_.valley_at(w, *z0);
    lost = lost || !z;
    return z ? value(shape_.gap, w, *z) : 0;
  };
  const bool falls = m0 > 0;
  const SignChange ends = falls ? SignChange{to, from} : SignChange{from, to};
  const double fold = narrowed(depth, ends, std::min(m0, m1), std::max(m0, m1), kFoldWidth).below;
  if (lost) return false;
  pieces.push_back({from, fold, falls ? ValleyLabel::Above : ValleyLabel::Below});
  pieces.push_back({fold, to, falls ? ValleyLabel::Below : ValleyLabel::Above});
  return true;
}

// True if the surfaces are in contact all along an edge and, since the gap is convex across
// it, nowhere else in the cell: a zero lies at most 2 slope / bend away from the edge.
bool ValleyLabels::valley_along(int edge) const {
  const auto e = static_cast<std::size_t>(edge);
  const PolynomialRange gap = range(edge_gap_[e]), slope = range(edge_slope_[e]);
  const double error = shape_.error[0];
  const double steepest = std::max(std::abs(slope.low), std::abs(slope.high));
  const double most = kEdgeGap * tolerance_;
  return gap.low >= error - most && gap.high <= most - error &&
         steepest + shape_.error[1] <= std::sqrt(2 * most * shape_.bend_low) &&
         std::abs(dot(shape_.z_axis, edge < 2 ? Vec2{1, 0} : Vec2{0, 1})) > kAcross;
}

}  // namespace blossom
