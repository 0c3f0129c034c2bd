// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/intersection/valley.h"

#include <algorithm>
#include <cmath>

#include "core/forms/evaluation.h"
#include "core/intersection/contact_points.h"
#include "core/math/polynomial.h"

namespace blossom {
namespace {

constexpr double kLeastBend = 0.1;        // of the largest bend across the valley
constexpr double kErrorShare = 0.25;      // of the tolerance: most error of a gap called a contact
constexpr double kContactGap = 2;         // tolerances: gaps up to this may be called a contact
constexpr double kBorderGap = 1.5;        // the same where the valley crosses a border
constexpr double kSlowLength = 1.0 / 64;  // of the size: a gap that changes by less than kSlow
constexpr double kSlow = 4;               // tolerances over this length is a contact, not a fold
constexpr double kEdgeGap = 1.0 / 256;    // tolerances: gap along an edge that counts as contact
constexpr double kAcross = 0.7;           // cosine: a direction that crosses an edge
constexpr int kMostPieces = 400;
constexpr int kMostExactPieces = 40;
constexpr double kShallow = 1.0 / 64;
constexpr int kDepthSamples = 8;
constexpr double kShortestPiece = 1e-9;  // of the cell
constexpr int kBranchSteps = 6;
constexpr double kTurn = 0.5;  // cosine: chords of a branch that turn more are looked at
constexpr std::size_t kMostBranchPoints = 24;
constexpr int kContactSteps = 4;
constexpr double kReach = 0.05;  // of the cell: how far Newton may move a point of the model
constexpr int K = kTaylorDegree;

enum class Label { Above, Below, Contact };

// A piece of valley [from, to] in w.
struct Piece {
  double from, to;
  Label label;
};

// Where something meets the cell's border.
struct BorderEvent {
  double w, z;
  int edge;      // 0, 1: x = -1, 1; 2, 3: y = -1, 1
  double along;  // on the edge
  bool upper;    // of a root
  double gap;    // of a crossing of the valley
  double slope;  // there, along the valley
  bool contact;
};

class Reader {
 public:
  Reader(const RationalBezierPatch& patch_a, const Cell& a, const RationalBezierPatch& patch_b,
         const GapModel& model, const ValleyOptions& options)
      : patch_a_(patch_a), a_(a), patch_b_(patch_b), model_(model), options_(options) {}

  bool run(ValleyCell& found) {
    found_ = &found;
    if (!turn()) return false;
    for (int edge = 0; edge < 4; ++edge) {
      edge_gap_[static_cast<std::size_t>(edge)] = along_edge(gap_, edge);
      edge_slope_[static_cast<std::size_t>(edge)] = along_edge(gap_z_, edge);
    }
    if (find_crossings() && find_roots() && label_valley() && sweep()) return true;
    found = {};
    for (int edge = 0; edge < 4; ++edge)
      if (valley_along(edge)) return add_edge_contact(edge);
    return false;
  }

 private:
  double tolerance() const { return options_.tolerance; }

  // Axes along and across the valley, by the Hessian in the middle; proves convexity.
  bool turn() {
    const auto& g = model_.gap;
    const double xx = 2 * g[taylor_index(2, 0)], xy = g[taylor_index(1, 1)],
                 yy = 2 * g[taylor_index(0, 2)];
    // The eigenvector of the eigenvalue that is larger in size.
    const double mean = 0.5 * (xx + yy), half = std::hypot(0.5 * (xx - yy), xy);
    const double eigenvalue = mean >= 0 ? mean + half : mean - half;
    Vec2 across = std::abs(eigenvalue - xx) > std::abs(eigenvalue - yy) ? Vec2{xy, eigenvalue - xx}
                                                                        : Vec2{eigenvalue - yy, xy};
    if (!(norm(across) > 0)) return false;
    z_axis_ = unit(across);
    w_axis_ = {z_axis_[1], -z_axis_[0]};
    gap_ = substitute(g, 0, w_axis_[0], z_axis_[0], 0, w_axis_[1], z_axis_[1]);
    sign_ = eigenvalue > 0 ? 1 : -1;
    for (double& c : gap_) c *= sign_;
    reach_ = std::abs(w_axis_[0]) + std::abs(w_axis_[1]);
    gap_z_ = derivative_y(gap_);
    gap_w_ = derivative_x(gap_);
    gap_zz_ = derivative_y(gap_z_);
    const TaylorRange bend = range(gap_zz_, reach_, reach_);
    bend_low_ = bend.low - model_.gap_error[2];
    bend_high_ = bend.high + model_.gap_error[2];
    const TaylorRange twist = range(derivative_x(gap_z_), reach_, reach_);
    twist_ = std::max(std::abs(twist.low), std::abs(twist.high)) + model_.gap_error[2];
    // How fast a parameter w of the cell moves in space.
    const PatchJet jet = jet_at(patch_a_, at(a_.u, 0.5), at(a_.v, 0.5), 1);
    const double speed =
        norm(jet.u * (0.5 * length(a_.u) * w_axis_[0]) + jet.v * (0.5 * length(a_.v) * w_axis_[1]));
    slow_slope_ = kSlow * tolerance() * speed / (kSlowLength * options_.size);
    return bend_low_ > kLeastBend * bend_high_;
  }

  // Position of edge parameter t in the turned axes.
  Vec2 on_edge(int edge, double t) const {
    const double end = edge % 2 == 0 ? -1 : 1;
    const Vec2 xy = edge < 2 ? Vec2{end, t} : Vec2{t, end};
    return {dot(w_axis_, xy), dot(z_axis_, xy)};
  }

  // A function of the turned axes along an edge.
  Polynomial along_edge(const TaylorPolynomial& p, int edge) const {
    const Vec2 middle = on_edge(edge, 0), end = on_edge(edge, 1);
    const TaylorPolynomial line =
        substitute(p, middle[0], end[0] - middle[0], 0, middle[1], end[1] - middle[1], 0);
    Polynomial result;
    for (int i = 0; i <= K; ++i) result.push_back(line[taylor_index(i, 0)]);
    return result;
  }

  // True if the surfaces are in contact all along an edge and, since the gap is convex across
  // it, nowhere else in the cell: a zero lies at most 2 slope / bend away from the edge.
  bool valley_along(int edge) const {
    const auto e = static_cast<std::size_t>(edge);
    const PolynomialRange gap = range(edge_gap_[e]), slope = range(edge_slope_[e]);
    const double error = model_.gap_error[0];
    const double steepest = std::max(std::abs(slope.low), std::abs(slope.high));
    const double most = kEdgeGap * tolerance();
    return gap.low >= error - most && gap.high <= most - error &&
           steepest + model_.gap_error[1] <= std::sqrt(2 * most * bend_low_) &&
           std::abs(dot(z_axis_, edge < 2 ? Vec2{1, 0} : Vec2{0, 1})) > kAcross;
  }

  bool add_edge_contact(int edge) {
    const std::size_t fixed = edge < 2 ? 0 : 1;
    const Interval& side = fixed == 0 ? a_.u : a_.v;
    const Interval& run = fixed == 0 ? a_.v : a_.u;
    CellContact contact;
    contact.leaves = {true, true};
    for (int k = 0; k <= kContactSteps; ++k) {
      const double t = k / static_cast<double>(kContactSteps);
      const Vec2 wz = on_edge(edge, 2 * t - 1);
      Point4 start = point_of(wz[0], wz[1]);
      start[fixed] = edge % 2 == 0 ? side.from : side.to;
      start[1 - fixed] = at(run, t);
      const auto x = foot_point(patch_a_, patch_b_, start, reach());
      if (!x) return false;
      contact.path.push_back(*x);
      contact.gaps.push_back(std::abs(signed_gap(patch_a_, patch_b_, *x)));
    }
    found_->contacts.push_back(contact);
    return true;
  }

  bool find_crossings() {
    for (int edge = 0; edge < 4; ++edge) {
      const auto& slope = edge_slope_[static_cast<std::size_t>(edge)];
      const auto roots = isolated_roots(slope, model_.gap_error[1], model_.gap_error[2], -1, 1);
      if (!roots) return false;
      for (const IsolatedRoot& root : *roots) {
        const Vec2 wz = on_edge(edge, root.t);
        BorderEvent event{wz[0], wz[1], edge, root.t, false, 0, 0, false};
        event.gap = value(gap_, wz[0], wz[1]);
        event.slope = value(gap_w_, wz[0], wz[1]);
        const bool slow = std::abs(event.slope) <= slow_slope_;
        event.contact = slow && std::abs(event.gap) <= kBorderGap * tolerance();
        if (!event.contact && std::abs(event.gap) <= model_.gap_error[0]) return false;
        crossings_.push_back(event);
      }
    }
    std::sort(crossings_.begin(), crossings_.end(),
              [](const BorderEvent& a, const BorderEvent& b) { return a.w < b.w; });
    return crossings_.size() % 2 == 0;
  }

  // Roots on the edges, outside the zones in which a contact crosses the edge.
  bool find_roots() {
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
  void add_zone(std::size_t edge, double along, std::vector<double>& cuts) const {
    const double limit = std::sqrt(8 * tolerance() * bend_high_) + model_.gap_error[1];
    const Polynomial& slope = edge_slope_[edge];
    for (const double direction : {-1.0, 1.0}) {
      double step = 1e-4, t = along;
      while (std::abs(value(slope, t)) < limit && std::abs(t) < 1) {
        t = std::clamp(t + direction * step, -1.0, 1.0);
        step *= 1.3;
      }
      cuts.push_back(t);
    }
  }

  bool add_roots(std::size_t edge, double from, double to) {
    // Derivatives along an edge are at most those in directions of largest entry 1.
    const auto roots =
        isolated_roots(edge_gap_[edge], model_.gap_error[0], model_.gap_error[1], from, to);
    if (!roots) return false;
    for (const IsolatedRoot& root : *roots) {
      const Vec2 wz = on_edge(static_cast<int>(edge), root.t);
      const double slope = value(edge_slope_[edge], root.t);
      if (std::abs(slope) <= model_.gap_error[1]) return false;
      roots_.push_back({wz[0], wz[1], static_cast<int>(edge), root.t, slope > 0, 0, 0, false});
    }
    return true;
  }

  // The valley at w by Newton's method; nothing if it leaves the range of the cell.
  std::optional<double> valley_at(double w) const {
    double z = 0;
    for (int step = 0; step < 30; ++step) {
      const double move = value(gap_z_, w, z) / value(gap_zz_, w, z);
      z -= move;
      if (!(std::abs(z) < 2 * reach_)) return std::nullopt;
      if (std::abs(move) < 1e-15) break;
    }
    return z;
  }

  // A cubic close to the valley over [from, to], in t on [-1, 1].
  std::optional<Polynomial> valley_cubic(double from, double to) const {
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    constexpr std::array kNodes{-0.9238795325112867, -0.3826834323650898, 0.3826834323650898,
                                0.9238795325112867};
    std::array<double, 4> z;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto found = valley_at(middle + half * kNodes[i]);
      if (!found) return std::nullopt;
      z[i] = *found;
    }
    Polynomial cubic{0};
    for (std::size_t i = 0; i < 4; ++i) {
      Polynomial basis{z[i]};
      for (std::size_t j = 0; j < 4; ++j)
        if (j != i) {
          const double d = kNodes[i] - kNodes[j];
          basis = product(basis, {-kNodes[j] / d, 1 / d});
        }
      cubic.resize(basis.size(), 0.0);
      for (std::size_t k = 0; k < basis.size(); ++k) cubic[k] += basis[k];
    }
    return cubic;
  }

  // p(w(t), z(t)).
  static Polynomial composed(const TaylorPolynomial& p, const Polynomial& w, const Polynomial& z) {
    Polynomial result{0};
    for (int i = K; i >= 0; --i) {
      Polynomial row{0};
      for (int j = K - i; j >= 0; --j) {
        row = product(row, z);
        row[0] += p[taylor_index(i, j)];
      }
      result = product(result, w);
      if (result.size() < row.size()) result.resize(row.size(), 0.0);
      for (std::size_t k = 0; k < row.size(); ++k) result[k] += row[k];
    }
    return result;
  }

  struct ValleyBounds {
    double low, high;              // of m
    double slope_low, slope_high;  // of m'
  };

  std::optional<ValleyBounds> bounds_on(double from, double to) const {
    const auto cubic = valley_cubic(from, to);
    if (!cubic) return std::nullopt;
    const Polynomial w{0.5 * (from + to), 0.5 * (to - from)};
    const PolynomialRange gap = range(composed(gap_, w, *cubic));
    const PolynomialRange off = range(composed(gap_z_, w, *cubic));
    const PolynomialRange slope = range(composed(gap_w_, w, *cubic));
    const double rest = std::max(std::abs(off.low), std::abs(off.high)) + model_.gap_error[1];
    const double slack = twist_ * rest / bend_low_ + model_.gap_error[1];
    const double error = model_.gap_error[0];
    return ValleyBounds{gap.low - rest * rest / (2 * bend_low_) - error, gap.high + error,
                        slope.low - slack, slope.high + slack};
  }

  // Labels of the valley inside the cell; folds are where Above and Below meet.
  bool label_valley() {
    for (std::size_t i = 0; i < crossings_.size(); i += 2) {
      const BorderEvent &in = crossings_[i], &out = crossings_[i + 1];
      std::vector<Piece> pieces;
      // By signs alone where that is possible, so that shallow loops stay loops.
      exact_ = !in.contact && !out.contact;
      pieces_left_ = kMostExactPieces;
      if (!exact_ || !label(in.w, out.w, in, out, pieces) || !beyond_tolerance(merged(pieces))) {
        exact_ = false;
        pieces.clear();
        pieces_left_ = kMostPieces;
        if (!label(in.w, out.w, in, out, pieces)) return false;
      }
      if (in.contact != (pieces.front().label == Label::Contact)) return false;
      if (out.contact != (pieces.back().label == Label::Contact)) return false;
      valleys_.push_back(merged(pieces));
    }
    return true;
  }

  // True if between two changes of sign the gap always grows to a part of the tolerance: what is
  // shallower is a contact.
  bool beyond_tolerance(const std::vector<Piece>& pieces) const {
    for (std::size_t i = 1; i + 1 < pieces.size(); ++i) {
      double most = 0;
      for (int k = 0; k <= kDepthSamples; ++k) {
        const double w = pieces[i].from + (pieces[i].to - pieces[i].from) * k / kDepthSamples;
        if (const auto z = valley_at(w)) most = std::max(most, std::abs(value(gap_, w, *z)));
      }
      if (most <= kShallow * tolerance()) return false;
    }
    return true;
  }

  static std::vector<Piece> merged(const std::vector<Piece>& pieces) {
    std::vector<Piece> result;
    for (const Piece& piece : pieces)
      if (!result.empty() && result.back().label == piece.label)
        result.back().to = piece.to;
      else
        result.push_back(piece);
    return result;
  }

  bool label(double from, double to, const BorderEvent& in, const BorderEvent& out,
             std::vector<Piece>& pieces) {
    if (--pieces_left_ < 0 || to - from < kShortestPiece) return false;
    const auto bounds = bounds_on(from, to);
    if (!bounds) return false;
    const bool first = from == in.w, last = to == out.w;
    const bool touches_contact = (first && in.contact) || (last && out.contact);
    const bool touches_other = (first && !in.contact) || (last && !out.contact);
    const bool fast = bounds->slope_low > slow_slope_ || bounds->slope_high < -slow_slope_;
    const bool monotone = bounds->slope_low > 0 || bounds->slope_high < 0;
    // Where the gap changes fast its sign counts, elsewhere the tolerance does.
    const double sure = exact_ || fast || touches_other ? 0 : tolerance();
    if (!touches_contact && bounds->low > sure) {
      pieces.push_back({from, to, Label::Above});
      return true;
    }
    if (!touches_contact && bounds->high < -sure) {
      pieces.push_back({from, to, Label::Below});
      return true;
    }
    if (!touches_contact && (fast || exact_) && monotone && add_fold(from, to, pieces)) return true;
    const double most = kContactGap * tolerance();
    if (!exact_ && !touches_other && model_.gap_error[0] <= kErrorShare * tolerance() &&
        bounds->low >= -most && bounds->high <= most) {
      pieces.push_back({from, to, Label::Contact});
      return true;
    }
    const double cut = from + 0.4865 * (to - from);
    return label(from, cut, in, out, pieces) && label(cut, to, in, out, pieces);
  }

  // A piece over which m is monotone with sure signs at its ends: one fold.
  bool add_fold(double from, double to, std::vector<Piece>& pieces) const {
    const auto z0 = valley_at(from), z1 = valley_at(to);
    if (!z0 || !z1) return false;
    const double m0 = value(gap_, from, *z0), m1 = value(gap_, to, *z1);
    const double error = model_.gap_error[0];
    if (std::abs(m0) <= 2 * error || std::abs(m1) <= 2 * error || (m0 > 0) == (m1 > 0))
      return false;
    double a = from, b = to;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (a + b);
      const auto z = valley_at(middle);
      if (!z) return false;
      ((value(gap_, middle, *z) > 0) == (m0 > 0) ? a : b) = middle;
    }
    pieces.push_back({from, a, m0 > 0 ? Label::Above : Label::Below});
    pieces.push_back({a, to, m1 > 0 ? Label::Above : Label::Below});
    return true;
  }

  // --- the sweep

  struct Open {
    bool active = false;
    bool fold = false;
    double w = 0;
    Point4 start{};
    int contact = -1;
  };

  struct Stop {
    bool fold = false;
    double w = 0;
    Point4 point{};
    int contact = -1;
  };

  // A change of the valley: from one label to the next, at w; `enter`, `leave` at borders.
  struct Change {
    double w;
    std::optional<Label> before, after;
    const BorderEvent* border = nullptr;
  };

  bool sweep() {
    std::vector<Change> changes;
    for (std::size_t i = 0; i < valleys_.size(); ++i) {
      const auto& pieces = valleys_[i];
      changes.push_back({pieces.front().from, {}, pieces.front().label, &crossings_[2 * i]});
      for (std::size_t k = 1; k < pieces.size(); ++k)
        changes.push_back({pieces[k].from, pieces[k - 1].label, pieces[k].label, nullptr});
      changes.push_back({pieces.back().to, pieces.back().label, {}, &crossings_[2 * i + 1]});
    }
    std::sort(roots_.begin(), roots_.end(),
              [](const BorderEvent& a, const BorderEvent& b) { return a.w < b.w; });
    std::size_t r = 0, c = 0;
    while (r < roots_.size() || c < changes.size()) {
      const bool root_first =
          c == changes.size() || (r < roots_.size() && roots_[r].w < changes[c].w);
      if (!(root_first ? meet_root(roots_[r++]) : meet_change(changes[c++]))) return false;
    }
    return !slot_[0].active && !slot_[1].active && open_contact_ < 0;
  }

  bool meet_root(const BorderEvent& root) {
    if (open_contact_ >= 0) return false;
    const auto point = border_point(root);
    if (!point) return false;
    const int side = root.upper ? 1 : 0;
    Open& slot = slot_[static_cast<std::size_t>(side)];
    if (!slot.active) {
      slot = {true, false, root.w, *point, -1};
      return true;
    }
    return close(side, {false, root.w, *point, -1});
  }

  bool meet_change(const Change& change) {
    if (change.border != nullptr) {
      const Label label = change.before ? *change.before : *change.after;
      if (label != Label::Contact) return true;
      return change.after ? begin_contact(change.w, change.border)
                          : end_contact(change.w, change.border);
    }
    if (*change.before == Label::Contact) {
      if (!end_contact(change.w, nullptr)) return false;
      if (*change.after == Label::Above) return true;
      return open_both(change.w, static_cast<int>(found_->contacts.size()) - 1);
    }
    if (*change.after == Label::Contact) {
      if (*change.before == Label::Below &&
          !close_both(change.w, static_cast<int>(found_->contacts.size())))
        return false;
      return begin_contact(change.w, nullptr);
    }
    return *change.after == Label::Below ? open_fold(change.w) : close_fold(change.w);
  }

  bool begin_contact(double w, const BorderEvent* border) {
    if (slot_[0].active || slot_[1].active) return false;
    open_contact_ = 1;
    contact_from_ = w;
    contact_border_ = border;
    return true;
  }

  bool end_contact(double w, const BorderEvent* border) {
    CellContact contact;
    contact.leaves = {contact_border_ != nullptr, border != nullptr};
    for (int k = 0; k <= kContactSteps; ++k) {
      const double at_w = contact_from_ + (w - contact_from_) * k / kContactSteps;
      const BorderEvent* on = k == 0 ? contact_border_ : k == kContactSteps ? border : nullptr;
      const auto x = polished_valley(at_w, on);
      if (!x) return false;
      contact.path.push_back(*x);
      contact.gaps.push_back(std::abs(signed_gap(patch_a_, patch_b_, *x)));
    }
    found_->contacts.push_back(contact);
    open_contact_ = -1;
    return true;
  }

  bool open_both(double w, int contact) {
    for (const int side : {0, 1}) {
      const auto point = branch_point(w, side);
      if (!point) return false;
      slot_[static_cast<std::size_t>(side)] = {true, false, w, *point, contact};
    }
    return true;
  }

  bool close_both(double w, int contact) {
    for (const int side : {0, 1}) {
      const auto point = branch_point(w, side);
      if (!point || !slot_[static_cast<std::size_t>(side)].active ||
          !close(side, {false, w, *point, contact}))
        return false;
    }
    return true;
  }

  bool open_fold(double w) {
    if (slot_[0].active || slot_[1].active) return false;
    const auto point = polished_fold(w);
    if (!point) return false;
    for (Open& slot : slot_) slot = {true, true, w, *point, -1};
    return true;
  }

  bool close_fold(double w) {
    if (!slot_[0].active || !slot_[1].active) return false;
    const auto point = polished_fold(w);
    return point && close(0, {true, w, *point, -1}) && close(1, {true, w, *point, -1});
  }

  // Points in between, denser towards folds, where w stands still.
  bool close(int side, const Stop& stop) {
    Open& slot = slot_[static_cast<std::size_t>(side)];
    CellBranch branch;
    branch.contact = {slot.contact, stop.contact};
    branch.path.push_back(slot.start);
    std::vector<double> places{slot.w};
    for (int k = 1; k < kBranchSteps; ++k) {
      const double t = k / static_cast<double>(kBranchSteps);
      double s = t;
      if (slot.fold && stop.fold)
        s = 0.5 - 0.5 * std::cos(M_PI * t);
      else if (slot.fold)
        s = t * t;
      else if (stop.fold)
        s = t * (2 - t);
      const auto point = branch_point(slot.w + s * (stop.w - slot.w), side);
      if (!point) return false;
      branch.path.push_back(*point);
      places.push_back(slot.w + s * (stop.w - slot.w));
    }
    branch.path.push_back(stop.point);
    places.push_back(stop.w);
    round_turns(branch.path, places, side);
    found_->branches.push_back(std::move(branch));
    slot.active = false;
    return true;
  }

  // True if a path turns by more than kTurn before or after its chord i.
  static bool turns_at(const std::vector<Point4>& path, std::size_t i) {
    const auto chord = [&](std::size_t k) {
      return unit(Vec2{path[k + 1][0] - path[k][0], path[k + 1][1] - path[k][1]});
    };
    return (i > 0 && dot(chord(i - 1), chord(i)) < kTurn) ||
           (i + 2 < path.size() && dot(chord(i), chord(i + 1)) < kTurn);
  }

  // Where a branch turns sharply a chord may lead off it, to its other side even: points are added
  // until none does.
  void round_turns(std::vector<Point4>& path, std::vector<double>& w, int side) const {
    for (std::size_t i = 0; i + 1 < path.size();) {
      const bool leads = path.size() >= kMostBranchPoints || !turns_at(path, i) ||
                         leads_to(patch_a_, patch_b_, {path[i], path[i]}, path[i + 1]);
      const double middle = 0.5 * (w[i] + w[i + 1]);
      const auto point = leads ? std::nullopt : branch_point(middle, side);
      if (point) {
        path.insert(path.begin() + static_cast<std::ptrdiff_t>(i) + 1, *point);
        w.insert(w.begin() + static_cast<std::ptrdiff_t>(i) + 1, middle);
      } else {
        ++i;
      }
    }
  }

  // --- points

  Point4 point_of(double w, double z) const {
    const double x = w_axis_[0] * w + z_axis_[0] * z, y = w_axis_[1] * w + z_axis_[1] * z;
    return {at(a_.u, 0.5 * (x + 1)), at(a_.v, 0.5 * (y + 1)), value(model_.foot[0], x, y),
            value(model_.foot[1], x, y)};
  }

  // How far a parameter may move from what the model says.
  double reach() const {
    const TaylorPolynomial &s = model_.foot[0], &t = model_.foot[1];
    return kReach * std::max({length(a_.u), length(a_.v), std::abs(s[1]) + std::abs(s[2]),
                              std::abs(t[1]) + std::abs(t[2])});
  }

  // w = const in the parameters of a.
  Point4 line() const {
    return {w_axis_[0] * 2 / length(a_.u), w_axis_[1] * 2 / length(a_.v), 0, 0};
  }

  // The direction z in the parameters of a.
  Vec2 across() const { return {z_axis_[0] * 0.5 * length(a_.u), z_axis_[1] * 0.5 * length(a_.v)}; }

  std::optional<Point4> border_point(const BorderEvent& root) const {
    Point4 start = point_of(root.w, root.z);
    const Point4 plane = fix_edge(root.edge, start);
    auto x = curve_point(patch_a_, patch_b_, start, plane, reach());
    if (x) fix_edge(root.edge, *x);
    return x;
  }

  // The end of the line w = const in the cell, and a little beyond.
  double chord_end(double w, int side) const {
    double end = 1e300;
    for (int k = 0; k < 2; ++k) {
      const double rate = side == 0 ? -z_axis_[k] : z_axis_[k];
      const double start = w_axis_[k] * w;
      if (std::abs(rate) > 1e-9) end = std::min(end, ((rate > 0 ? 1 : -1) - start) / rate);
    }
    end += 0.02;
    return side == 0 ? -end : end;
  }

  // The zero below or above the valley at w, within the cell.
  std::optional<Point4> branch_point(double w, int side) const {
    const auto valley = valley_at(w);
    if (!valley || !(value(gap_, w, *valley) < 0)) return std::nullopt;
    double inner = *valley, outer = chord_end(w, side);
    if (!(value(gap_, w, outer) > 0)) return std::nullopt;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (inner + outer);
      (value(gap_, w, middle) < 0 ? inner : outer) = middle;
    }
    return curve_point(patch_a_, patch_b_, point_of(w, outer), line(), reach());
  }

  std::optional<Point4> polished_fold(double w) const {
    const auto z = valley_at(w);
    if (!z) return std::nullopt;
    return fold_point(patch_a_, patch_b_, point_of(w, *z), across(), reach());
  }

  // The point of the valley at w, or exactly on the edge where it crosses the border.
  std::optional<Point4> polished_valley(double w, const BorderEvent* border) const {
    if (border == nullptr) {
      const auto z = valley_at(w);
      if (!z) return std::nullopt;
      return valley_point(patch_a_, patch_b_, point_of(w, *z), across(), line(), reach());
    }
    Point4 start = point_of(border->w, border->z);
    const Point4 plane = fix_edge(border->edge, start);
    auto x = valley_point(patch_a_, patch_b_, start, across(), plane, reach());
    if (x) fix_edge(border->edge, *x);
    return x;
  }

  // Puts a point on an edge of the cell and returns the plane of that edge.
  Point4 fix_edge(int edge, Point4& x) const {
    const std::size_t fixed = edge < 2 ? 0 : 1;
    const Interval& side = fixed == 0 ? a_.u : a_.v;
    x[fixed] = edge % 2 == 0 ? side.from : side.to;
    Point4 plane{};
    plane[fixed] = 1;
    return plane;
  }

  const RationalBezierPatch& patch_a_;
  const Cell& a_;
  const RationalBezierPatch& patch_b_;
  const GapModel& model_;
  const ValleyOptions& options_;
  ValleyCell* found_ = nullptr;

  Vec2 w_axis_, z_axis_;
  double sign_ = 1;
  double reach_ = 0;  // |w|, |z| in the cell are at most this
  double bend_low_ = 0, bend_high_ = 0, twist_ = 0, slow_slope_ = 0;
  TaylorPolynomial gap_{}, gap_w_{}, gap_z_{}, gap_zz_{};  // of w, z
  std::array<Polynomial, 4> edge_gap_, edge_slope_;
  std::vector<BorderEvent> crossings_, roots_;
  std::vector<std::vector<Piece>> valleys_;
  int pieces_left_ = 0;
  bool exact_ = false;  // labels by signs alone, no contact

  std::array<Open, 2> slot_;
  int open_contact_ = -1;
  double contact_from_ = 0;
  const BorderEvent* contact_border_ = nullptr;
};

}  // namespace

std::optional<ValleyCell> valley_cell(const RationalBezierPatch& patch_a, const Cell& a,
                                      const RationalBezierPatch& patch_b, const GapModel& model,
                                      const ValleyOptions& options) {
  ValleyCell found;
  if (!Reader(patch_a, a, patch_b, model, options).run(found)) return std::nullopt;
  return found;
}

}  // namespace blossom
