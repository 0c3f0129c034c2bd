// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/contacts/contact_search.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/cells/cell_pair.h"
#include "core/cells/cell_part.h"
#include "core/cells/limits.h"
#include "core/forms/evaluation.h"
#include "core/math/interval.h"
#include "core/surfaces/contacts/contact_cuts.h"
#include "core/surfaces/gap/cells/foot_borders.h"
#include "core/surfaces/gap/cells/odd_contact.h"
#include "core/surfaces/gap/cells/regular_cell.h"
#include "core/surfaces/gap/cells/valley.h"
#include "core/surfaces/gap/chart_ownership.h"
#include "core/surfaces/gap/contact_points.h"
#include "core/surfaces/gap/gap_model.h"
#include "core/surfaces/pairs/slow_crossings.h"

namespace blossom {
namespace {

constexpr int kMaxChartHalvings = 24;
constexpr int kShallow = 8;
constexpr double kWidening = 0.2;  // of a chart's width
constexpr double kMinWidening = 0.05;
// Halvings of a cell: 2^-32 in each direction. Near a pole a patch of b is narrower than any cell
// that is larger than the tolerance, and only smaller ones are told apart from it there.
constexpr int kDeepest = 64;
constexpr int kDeepestPiece = 60;        // likewise of a chart's piece
constexpr int kCutDepth = 26;            // from here on valleys may cross the chart's border
constexpr double kThinnest = 1.0 / 256;  // width of a cell to its length
constexpr long kMaxCells = 60'000;       // per pair of patches
constexpr long kAskEvery = 16;           // cells between looks at the clock
constexpr double kRegularMargin = 4;     // see `clearly_regular`
constexpr double kBoxReserve = 0.1;      // of the box round a cell's foot points

// A chart of b and the cells of its piece.
struct Chart {
  int index;
  GraphChart graph;
  CellTree piece;
};

class ContactSearch {
 public:
  ContactSearch(SurfaceCells& a, SurfaceCells& b, const ContactTask& task, double size,
                const KnownCurves& known, const IntersectionOptions& options,
                const WorkLimit& limit, PairSearchResult& result)
      : a_(a),
        b_(b),
        task_(task),
        tree_a_(a.tree(task.patch_a)),
        tree_b_(b.tree(task.patch_b)),
        known_(known),
        options_(options),
        limit_(limit),
        valley_options_{options.tolerances.point, size},
        result_(result) {}

  void run() {
    Interval s{1, 0}, t{1, 0};
    for (const auto& part : task_.parts_b) {
      s = {std::min(s.from, part[0].from), std::max(s.to, part[0].to)};
      t = {std::min(t.from, part[1].from), std::max(t.to, part[1].to)};
    }
    cover(s, t, 0);
  }

 private:
  double tolerance() const { return options_.tolerances.point; }

  // Charts over the part of b that matters, each searched as soon as it is found. A patch that is
  // but a curve has none anywhere, so looking for them is work that counts.
  void cover(const Interval& s, const Interval& t, int depth) {
    const bool matters =
        std::any_of(task_.parts_b.begin(), task_.parts_b.end(),
                    [&](const auto& part) { return overlap(part[0], s) && overlap(part[1], t); });
    if (!matters) return;
    CellTree cells = tree_b_.piece(s, t);
    if (const auto graph = widened_chart(s, t, depth)) {
      Chart chart{claims_.add_chart({graph->wide_s, graph->wide_t}), *graph, std::move(cells)};
      for (const int cell : task_.cells_a) examine(cell, chart);
      return;
    }
    const auto settled = [&](int cell) { return is_settled(cell, cells[0]); };
    if (cells[0].extent <= tolerance() ||
        (is_narrow(cells[0]) && std::ranges::all_of(task_.cells_a, settled))) {
      for (const int cell : task_.cells_a) narrow_down(cell, cells[0], s, t);
      return;
    }
    if (depth == kMaxChartHalvings || out_of_budget()) {
      for (const int cell : task_.cells_a)
        if (!disjoint(tree_a_[cell], cells[0])) keep(tree_a_[cell], s, t, cells[0], false);
      return;
    }
    const bool halve_s = norm(cells[0].du.middle) + norm(cells[0].du.radius) >=
                         norm(cells[0].dv.middle) + norm(cells[0].dv.radius);
    const Interval& side = halve_s ? s : t;
    const double cut = at(side, kSurfaceOffMiddle);
    const Interval low{side.from, cut}, high{cut, side.to};
    cover(halve_s ? low : s, halve_s ? t : low, depth + 1);
    cover(halve_s ? high : s, halve_s ? t : high, depth + 1);
  }

  bool is_narrow(const Cell& piece) const {
    return std::min(norm(piece.du.middle) + norm(piece.du.radius),
                    norm(piece.dv.middle) + norm(piece.dv.radius)) <= tolerance();
  }

  bool over(const Cell& a, const Cell& piece) const {
    return lie_over(a, piece, tree_a_.shape().plane_size(), tree_b_.shape().plane_size(),
                    tolerance());
  }

  // True if all cells no larger than a piece of b miss it, or lie over it within tolerance.
  bool is_settled(int index, const Cell& piece) {
    const Cell a = tree_a_[index];
    if (a.part == PartSide::Outside || disjoint(a, piece) || over(a, piece)) return true;
    if (a.extent <= piece.extent || a.depth >= kDeepest) return false;
    const int child = tree_a_.split(index);
    return is_settled(child, piece) && is_settled(child + 1, piece);
  }

  // The cells round a piece of b that has no chart, as at a pole, but is no larger than a point, or
  // narrow and within tolerance.
  void narrow_down(int index, const Cell& piece, const Interval& s, const Interval& t) {
    const Cell a = tree_a_[index];
    if (a.part == PartSide::Outside || disjoint(a, piece)) {
      ++result_.certificate.excluded;
      return;
    }
    const bool within_tolerance = a.extent <= tolerance() || over(a, piece);
    if (within_tolerance || a.depth >= kDeepest || out_of_budget())
      return keep(a, s, t, piece, within_tolerance);
    const int child = tree_a_.split(index);
    narrow_down(child, piece, s, t);
    narrow_down(child + 1, piece, s, t);
  }

  // Near a place where the parameters stand still only a small extension is a graph.
  std::optional<GraphChart> widened_chart(const Interval& s, const Interval& t, int depth) const {
    auto graph = graph_chart(tree_b_, s, t, kWidening);
    if (!graph && depth >= kShallow) graph = graph_chart(tree_b_, s, t, kMinWidening);
    return graph;
  }

  // True if the cell lies beside the chart, seen along its normal.
  bool beside(const Cell& a, const Cell& piece, const GraphChart& graph) const {
    const int points_a = tree_a_.shape().plane_size(), points_b = tree_b_.shape().plane_size();
    return separated_along(unit(graph.to_s), a, piece, points_a, points_b) ||
           separated_along(unit(graph.to_t), a, piece, points_a, points_b);
  }

  // So small and narrow pieces are followed only where they meet.
  bool disjoint(const Cell& a, const Cell& b) const {
    return separated(a, b, tree_a_.shape().plane_size(), tree_b_.shape().plane_size());
  }

  bool are_disjoint(const Cell& a, const Cell& b) const {
    return separated(a, b, tree_a_.shape().plane_size(), tree_b_.shape().plane_size(), tolerance());
  }

  enum class Nearness : char { Misses, Within, Meets };

  // Of the cells of the chart's piece that are at least as small as `a`, the nearest: within
  // tolerance of it all over, or not known to be.
  Nearness nearness(const Cell& a, CellTree& piece, int index) const {
    const Cell b = piece[index];
    if (are_disjoint(a, b)) return Nearness::Misses;
    if (are_within(a, b, tree_a_.shape().plane_size(), tree_b_.shape().plane_size(), tolerance()))
      return Nearness::Within;
    if (b.extent <= a.extent || b.depth >= kDeepestPiece) return Nearness::Meets;
    const int child = piece.split(index);
    const Nearness low = nearness(a, piece, child);
    return low == Nearness::Meets ? low : std::max(low, nearness(a, piece, child + 1));
  }

  bool out_of_budget() {
    if (result_.stopped) return true;
    ++result_.contact_cells;
    const bool is_spent =
        options_.contact_budget > 0 && result_.contact_cells > options_.contact_budget;
    if (++cells_ > kMaxCells || is_spent) return stop("the budget of contact cells is spent");
    if (cells_ % kAskEvery != 0) return false;
    const char* reason = limit_.reached();
    if (reason == nullptr) return false;
    result_.certificate.limited = true;
    return stop(reason);
  }

  bool stop(const char* reason) {
    result_.stopped = true;
    result_.cancelled = result_.cancelled || WorkLimit::is_cancelled(reason);
    result_.certificate.reasons.emplace_back(reason);
    return true;
  }

  void examine(int index, Chart& chart) {
    const Cell a = tree_a_[index];
    const Cell piece = chart.piece[0];
    const GraphChart& graph = chart.graph;
    if (a.part == PartSide::Outside || are_disjoint(a, piece) || beside(a, piece, graph) ||
        (task_.band_b != nullptr && task_.band_b->misses(a, tree_a_.shape()))) {
      ++result_.certificate.excluded;
      return;
    }
    if (known_.compare_with(a.extent) &&
        known_.hold_common({a.low, a.high}, {piece.low, piece.high})) {
      ++result_.certificate.critical;
      result_.beside_known = true;
      return;
    }
    if (out_of_budget()) return keep(a, graph.s, graph.t, piece, false);
    result_.certificate.depth = std::max(result_.certificate.depth, a.depth);
    claims_.enter(index);
    const auto model =
        may_have_model(a, graph) ? gap_model(tree_a_, a, tree_b_, graph) : std::nullopt;
    if (model) {
      if (decide(index, *model, chart)) return claims_.leave();
    } else if (const Nearness near = nearness(a, chart.piece, 0); near != Nearness::Meets) {
      near == Nearness::Within ? keep(a, graph.s, graph.t, piece, true)
                               : void(++result_.certificate.excluded);
      return claims_.leave();
    }
    if (a.depth >= kDeepest || a.extent <= tolerance()) {
      keep(a, graph.s, graph.t, piece, a.extent <= tolerance());
    } else {
      const auto along_u = model ? halving_of(*model, tolerance()) : halving_of(a, graph);
      if (along_u && a.depth < kCutDepth && !is_thin(a, *along_u)) tree_a_.prefer(index, *along_u);
      const int child = tree_a_.split(index);
      examine(child, chart);
      examine(child + 1, chart);
    }
    claims_.leave();
  }

  // True if the cell is much thinner in a direction than in the other one.
  static bool is_thin(const Cell& a, bool along_u) {
    const double u = norm(a.du.middle), v = norm(a.dv.middle);
    return along_u ? u < kThinnest * v : v < kThinnest * u;
  }

  // True if the cell needs no halving.
  bool decide(int index, const GapModel& model, const Chart& chart) {
    const Cell a = tree_a_[index];
    const GraphChart& graph = chart.graph;
    const Box2 foot = foot_box(model);
    const TaylorRange gap = close_range(model.gap);
    const double error = model.gap_error[0];
    const bool outside = !overlap(foot[0], graph.s) || !overlap(foot[1], graph.t);
    if (outside || gap.low > error + tolerance() || gap.high < -error - tolerance()) {
      ++result_.certificate.excluded;
      return true;
    }
    const ChartOwnership::Claim claimed = claims_.claim_of(foot, chart.index);
    if (claimed == ChartOwnership::Claim::Taken) return true;
    if (claimed == ChartOwnership::Claim::Partly) return false;
    const double most = std::max(std::abs(gap.low), std::abs(gap.high));
    if (most + error <= tolerance()) {
      const bool flat = most < std::max(kRoundingGap * tolerance(), error);
      if (flat || !add_crossing(a, model, foot, chart))
        keep(a, foot[0], foot[1], chart.piece[0], true);
      claims_.claim(chart.index);
      return true;
    }
    const GapSlope slope = regular_slope(model);
    const auto regular = [&] {
      return slope.least > 0 && (add_graphs(a, model, slope, foot) || add_regular(a, foot));
    };
    const bool clearly = clearly_regular(model, slope.least);
    if ((clearly && regular()) || add_valley(a, model, foot) ||
        add_crossing(a, model, foot, chart) || (!clearly && regular())) {
      claims_.claim(chart.index);
      return true;
    }
    return false;
  }

  // The direction in which the gap's slope has the best bound, as far as it is positive.
  static GapSlope regular_slope(const GapModel& model) {
    const TaylorPolynomial gx = derivative_x(model.gap), gy = derivative_y(model.gap);
    const Vec2 mean = unit(Vec2{gx[0], gy[0]});
    GapSlope best;
    for (const Vec2& d : {mean, Vec2{1, 0}, Vec2{0, 1}}) {
      TaylorPolynomial along;
      for (std::size_t i = 0; i < along.size(); ++i) along[i] = d[0] * gx[i] + d[1] * gy[i];
      const TaylorRange r = range(along, 1, 1);
      const double error = model.gap_error[1];
      if (r.low - error > best.least) best = {d, r.low - error};
      if (-r.high - error > best.least) best = {-d, -r.high - error};
    }
    return best;
  }

  // Not one of two branches less than the tolerance apart: those belong to a valley.
  bool clearly_regular(const GapModel& model, double slope) const {
    double bend = model.gap_error[2];
    for (int k = 2; k <= kTaylorDegree; ++k)
      for (int j = 0; j <= k; ++j)
        bend += k * (k - 1) * std::abs(model.gap[taylor_index(k - j, j)]);
    return slope > kRegularMargin * std::sqrt(tolerance() * bend);
  }

  // By the gap alone, where all foot points lie in the patch or branches leave it but once.
  bool add_graphs(const Cell& a, const GapModel& model, const GapSlope& slope, const Box2& foot) {
    const bool inside = within(foot, kWholePatch);
    if (!inside && !crosses_border_once(model, slope)) return false;
    const auto read = regular_cell(tree_a_.patch(), a, tree_b_.patch(), model, slope);
    if (!read) return false;
    ++result_.certificate.certified;
    add(inside ? *read : part_inside(tree_a_.patch(), tree_b_.patch(), *read));
    return true;
  }

  // The four-variable certificate on the cell and the box of its foot points.
  bool add_regular(const Cell& a, const Box2& foot) {
    const auto clipped = [](const Interval& x) {
      const double by = kBoxReserve * length(x);
      return Interval{std::max(x.from - by, 0.0), std::min(x.to + by, 1.0)};
    };
    const Interval s = clipped(foot[0]), t = clipped(foot[1]);
    if (!(s.from < s.to && t.from < t.to)) return false;
    const CellTree cells = tree_b_.piece(s, t);
    Cell b = cells[0];
    b.u = s;
    b.v = t;
    if (are_disjoint(a, b)) {
      ++result_.certificate.excluded;
      return true;
    }
    const JacobianBounds bounds(a, b);
    const int best = bounds.best_column();
    for (int k = 0; k < 4; ++k) {
      const int column = (best + k) % 4;
      if (!bounds.minor(column).regular) continue;
      const auto held = arcs_in(tree_a_, a, tree_b_, b, bounds, borders(a, b), column);
      if (!held) return false;
      ++result_.certificate.certified;
      result_.along_border = result_.along_border || held->along_border;
      for (const CellArc& arc : held->arcs)
        result_.arcs.push_back({task_.patch_a, task_.patch_b, box_of(a, b), arc, {-1, -1}});
      for (const Point4& x : held->corner_contacts)
        result_.corner_contacts.push_back({task_.patch_a, task_.patch_b, x});
      return true;
    }
    return false;
  }

  SurfaceBorders borders(const Cell& a, const Cell& b) const {
    return upper_borders(a_, task_.patch_a, a, b_, task_.patch_b, b);
  }

  bool add_valley(const Cell& a, const GapModel& model, const Box2& foot) {
    const auto read = valley_cell(tree_a_.patch(), a, tree_b_.patch(), model, valley_options_);
    return read && add_inside(a, *read, foot);
  }

  bool add_crossing(const Cell& a, const GapModel& model, const Box2& foot, const Chart& chart) {
    const auto read = crossing_contact(tree_a_.patch(), a, tree_b_.patch(), model, tolerance());
    if (!read) return false;
    if (read->contact) return add_inside(a, {{}, {*read->contact}}, foot);
    keep(over_patch(a, model), foot[0], foot[1], chart.piece[0], false, &read->closest);
    return true;
  }

  // The part of a cell whose foot points may lie in the patch, with a box of its own.
  Cell over_patch(const Cell& a, const GapModel& model) const {
    const std::array<Interval, 2> part = part_over_patch(model);
    const bool empty = !(part[0].from < part[0].to && part[1].from < part[1].to);
    return empty ? a : part_of(tree_a_, a, part[0], part[1]);
  }

  // What was read from a valley, as far as its foot points lie in the patch.
  bool add_inside(const Cell& a, const ValleyCell& read, const Box2& foot) {
    const bool empty = read.contacts.empty() && read.branches.empty();
    const bool inside = within(foot, kWholePatch);
    if (!inside && !empty && read.contacts.empty() && a.depth < kCutDepth) return false;
    ++result_.certificate.certified;
    if (inside || empty) {
      add(read);
    } else {
      result_.cut_by_samples = true;
      add(part_inside(tree_a_.patch(), tree_b_.patch(), read));
    }
    return true;
  }

  void add(const ValleyCell& cell) {
    const int first = static_cast<int>(result_.contacts.size());
    for (const CellContact& contact : cell.contacts)
      result_.contacts.push_back({task_.patch_a, task_.patch_b, contact});
    for (const CellBranch& branch : cell.branches)
      add_path(branch.path, branch.contact, first, false);
  }

  void add_path(const std::vector<Point4>& path, const std::array<int, 2>& contact, int first,
                bool tangential) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      FoundArc arc{task_.patch_a, task_.patch_b, kNoBox, {path[i], path[i + 1]}, {-1, -1}};
      for (std::size_t k = 0; k < 4; ++k) arc.arc.direction[k] = path[i + 1][k] - path[i][k];
      arc.arc.tangential = tangential;
      const auto number = [&](int c) { return c >= 0 ? first + c : c; };
      if (i == 0) arc.contact[0] = number(contact[0]);
      if (i + 2 == path.size()) arc.contact[1] = number(contact[1]);
      result_.arcs.push_back(arc);
    }
  }

  // beside    a point of a cell whose only contacts are those of the line that passes beside it
  void keep(const Cell& a, const Interval& s, const Interval& t, const Cell& b,
            bool within_tolerance, const Point4* beside = nullptr) {
    CriticalPair critical{task_.patch_a, task_.patch_b, {a.u, a.v, s, t}, {}, {}, within_tolerance};
    if (beside != nullptr) critical.beside = *beside;
    for (int k = 0; k < 3; ++k) {
      const double low = std::max(a.low[k], b.low[k]), high = std::min(a.high[k], b.high[k]);
      if (low > high + tolerance()) return;
      critical.low[k] = std::min(low, high);
      critical.high[k] = std::max(low, high);
    }
    ++result_.certificate.critical;
    if (is_known(known_, tree_a_, a, {b.low, b.high}))
      result_.beside_known = true;
    else
      result_.critical.push_back(critical);
  }

  SurfaceCells& a_;
  SurfaceCells& b_;
  const ContactTask& task_;
  CellTree& tree_a_;
  CellTree& tree_b_;
  const KnownCurves& known_;
  const IntersectionOptions& options_;
  const WorkLimit& limit_;
  const ValleyOptions valley_options_;
  PairSearchResult& result_;
  long cells_ = 0;
  ChartOwnership claims_;
};

}  // namespace

void search_contacts(SurfaceCells& a, SurfaceCells& b, const ContactTask& task, double size,
                     const KnownCurves& known, const IntersectionOptions& options,
                     const WorkLimit& limit, PairSearchResult& result) {
  ContactSearch(a, b, task, size, known, options, limit, result).run();
}

}  // namespace blossom
