// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/search/pair_search.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>

#include "core/base/parallel.h"
#include "core/base/work_limit.h"
#include "core/cells/cell_pair.h"
#include "core/cells/pair_model.h"
#include "core/math/interval.h"
#include "core/surfaces/branches/arcs_along_borders.h"
#include "core/surfaces/contacts/contact_search.h"
#include "core/surfaces/gap/gap_model.h"
#include "core/surfaces/pairs/quadric_pair.h"
#include "core/surfaces/pairs/shared_cells.h"
#include "core/surfaces/pairs/slow_crossings.h"
#include "core/surfaces/search/start_pairs.h"

namespace blossom {
namespace {

// A slab this part of the tolerance thick ends the search: below it, splitting would only tell
// contacts apart that differ by less than the tolerance.
constexpr double kSlabPart = 1.0 / 1024;
// Nor does it go on below so many roundings of the nets: no cell gets thinner.
constexpr double kSlabRoundings = 8;
constexpr int kDeepest = 90;             // halvings of a patch: 2^-45 in each direction
constexpr long kMaxStored = 30'000'000;  // control points kept, some 1 GB
constexpr std::size_t kBatch = 128;      // pairs examined at the same time
constexpr std::size_t kPairGrain = 4;    // pairs that one thread examines in a row

// Cells of one surface no farther apart than this many of their widths are near each other in it.
constexpr double kNearDiagonal = 16;

struct Pair {
  int place;  // the pair of patches
  int cell_a;
  int cell_b;
  int along;  // >= 0: already certified over this parameter, halved for its border only
  bool near;  // known not to be apart by boxes or planes
};

struct Halving {
  Pair pair;
  bool of_first;  // a cell of a, or of b
};

struct CellsPair {
  int cell_a;
  int cell_b;
};

struct CertifiedPair {
  int cell_a;
  int cell_b;
  Box4 box;
  PairArcs held;
};

// A pair of patches, and what its pairs of cells gave.
struct PatchPair {
  int patch_a, patch_b;
  CellTree* tree_a;
  CellTree* tree_b;
  SharedCells shared;
  QuadricPair quadrics;
  std::vector<CertifiedPair> certified{};
  std::vector<CellsPair> parallel{};
};

// On one quadric: a pair that covers each other or lies beside each other, or may do so.
enum class Verdict : char {
  Apart,
  Known,
  Coincident,
  Over,
  Beside,
  Regular,
  Parallel,
  Thin,
  Mixed
};

struct Finding {
  Verdict verdict = Verdict::Mixed;
  int along = -1;                    // of a regular pair
  std::optional<SharedPart> part{};  // of a coincident one
  std::optional<PairArcs> arcs{};    // of a regular pair that is certified
  bool slow = false;                 // such a pair may be within tolerance beside its arcs
};

// Pairs are examined in batches: those of one batch at the same time, for they only read the cells;
// then cells are halved in the order of the pairs. The latest pairs come first, so that small
// cells, which tell whether the surfaces coincide, are reached soon.
class Search {
 public:
  Search(SurfaceCells& a, SurfaceCells& b, double size, const KnownCurves& known,
         const IntersectionOptions& options, PairSearchResult& result)
      : a_(a),
        b_(b),
        size_(size),
        known_(known),
        options_(options),
        result_(result),
        limit_(options),
        bands_(options.tolerances.point),
        one_is_whole_(is_whole_quadric(a, bands_) || is_whole_quadric(b, bands_)) {}

  void begin(const std::vector<StartPair>& pairs) {
    const NearPairs near = near_pairs(a_, b_, pairs, reach());
    result_.certificate = near.certificate;
    examined_ = near.certificate.excluded;
    std::unordered_map<long, int> known;  // patches of one surface come again
    if (!itself()) places_.reserve(near.pairs.size());
    for (const StartPair& pair : near.pairs) {
      const int next = static_cast<int>(places_.size());
      const long key = static_cast<long>(pair.patch_a) * b_.patches() + pair.patch_b;
      const int place = itself() ? known.try_emplace(key, next).first->second : next;
      stack_.push_back({place, pair.cell_a, pair.cell_b, -1, true});
      if (place < next) continue;
      CellTree &tree_a = a_.tree(pair.patch_a), &tree_b = b_.tree(pair.patch_b);
      places_.push_back({pair.patch_a, pair.patch_b, &tree_a, &tree_b,
                         SharedCells(tree_a, tree_b, options_.tolerances.point),
                         QuadricPair(tree_a, tree_b, bands_, !itself() && one_is_whole_, size_)});
    }
  }

  void run() {
    std::vector<Pair> batch;
    stored_points_ = a_.stored_points() + b_.stored_points();
    while (!stack_.empty()) {
      const auto first =
          stack_.end() - static_cast<std::ptrdiff_t>(std::min(kBatch, stack_.size()));
      batch.assign(first, stack_.end());
      stack_.erase(first, stack_.end());
      examine(batch);
    }
    for (PatchPair& place : places_) settle(place);
  }

 private:
  bool out_of_budget(std::size_t pairs) {
    if (result_.stopped) return true;
    examined_ += static_cast<long>(pairs);
    if (examined_ > options_.budget) return stop("the budget of cell pairs is spent");
    if (stored_points_ > kMaxStored) return stop("the memory for cells is spent");
    if (const char* reason = limit_.reached()) return stop(reason);
    return false;
  }

  bool stop(const char* reason) {
    result_.stopped = true;
    result_.cancelled = result_.cancelled || WorkLimit::is_cancelled(reason);
    result_.certificate.limited = true;
    result_.certificate.reasons.emplace_back(reason);
    return true;
  }

  PatchPair& place_of(const Pair& pair) { return places_[static_cast<std::size_t>(pair.place)]; }
  const PatchPair& place_of(const Pair& pair) const {
    return places_[static_cast<std::size_t>(pair.place)];
  }
  const Cell& cell_a(const Pair& pair) const { return (*place_of(pair).tree_a)[pair.cell_a]; }
  const Cell& cell_b(const Pair& pair) const { return (*place_of(pair).tree_b)[pair.cell_b]; }

  void examine(std::span<const Pair> pairs) {
    if (out_of_budget(pairs.size())) {
      for (const Pair& pair : pairs) keep(pair, false);
      return;
    }
    findings_.resize(pairs.size());
    parallel_for(pairs.size(), kPairGrain, [&](std::size_t i) {
      findings_[i] = look(pairs[i]);
      if (findings_[i].verdict == Verdict::Regular)
        findings_[i].arcs = arcs_of(pairs[i], findings_[i].along);
    });
    for (std::size_t i = 0; i < pairs.size(); ++i) apply(pairs[i], std::move(findings_[i]));
    halve_pairs();
  }

  // What a pair proves by its bounds alone; of a regular one its arcs are not looked for.
  Finding look(const Pair& pair) const {
    const PatchPair& place = place_of(pair);
    const Cell &a = cell_a(pair), &b = cell_b(pair);
    const int points_a = place.tree_a->shape().plane_size();
    const int points_b = place.tree_b->shape().plane_size();
    if (!pair.near && are_apart(*place.tree_a, a, *place.tree_b, b, reach()))
      return {Verdict::Apart};
    if (known_.hold({a.low, a.high}) || known_.hold({b.low, b.high})) return {Verdict::Known};
    if (const auto part = place.shared.part(a, b)) return {Verdict::Coincident, -1, part};
    if (place.quadrics.is_one())
      return {place.quadrics.coincide(a, b) ? Verdict::Thin : Verdict::Mixed};
    if (place.quadrics.is_common() && !place.shared.is_known() && place.quadrics.coincide(a, b))
      return {place.quadrics.cover_each_other(a, b) ? Verdict::Over : Verdict::Beside};
    const int along = pair.along >= 0 ? pair.along : JacobianBounds(a, b).certified_column();
    const bool slow =
        along >= 0 && !itself() && cross_slowly(a, b, options_.tolerances.point, size_);
    if (along >= 0 && !slow) {
      // Cheaper than to look for the ends of arcs on all borders.
      if (separated_across(a, b, points_a, points_b)) return {Verdict::Apart};
      return {Verdict::Regular, along};
    }
    if (place.quadrics.are_disjoint(a, b)) return {Verdict::Apart};
    if (itself() && beside_each_other(place, a, b)) return {Verdict::Apart};
    if (known_.compare_with(std::min(a.extent, b.extent)) &&
        known_.hold_common({a.low, a.high}, {b.low, b.high}))
      return {Verdict::Known};
    if (slow) return {Verdict::Regular, along, {}, {}, true};
    if (nearly_parallel(a, b) && !(itself() && near_diagonal(place, a, b))) {
      const PairModel model(*place.tree_a, a, *place.tree_b, b);
      return {model.are_disjoint(options_.tolerances.point) ? Verdict::Apart : Verdict::Parallel};
    }
    if (!itself() && !place.shared.is_known() && place.quadrics.touch_all_over(a, b))
      return {place.quadrics.cover_each_other(a, b) ? Verdict::Over : Verdict::Beside};
    return {is_thin(a, b, points_a, points_b) ? Verdict::Thin : Verdict::Mixed};
  }

  bool itself() const { return &a_ == &b_; }

  // What is so near is a contact, but for neighbouring cells of one surface.
  double reach() const { return itself() ? 0 : options_.tolerances.point; }

  // Of one surface: true if the cells are apart along it, or in one piece of it that does not meet
  // itself.
  static bool beside_each_other(const PatchPair& place, const Cell& a, const Cell& b) {
    const int points_a = place.tree_a->shape().plane_size();
    const int points_b = place.tree_b->shape().plane_size();
    for (const Vec3& along : {a.du.middle, a.dv.middle, b.du.middle, b.dv.middle})
      if (separated_along(along, a, b, points_a, points_b)) return true;
    if (place.patch_a != place.patch_b) return false;
    return graph_chart(*place.tree_a, hull(a.u, b.u), hull(a.v, b.v), 0).has_value();
  }

  // Of one surface: true if the cells are near each other in it. Round singular points and edges
  // such pairs are nearly parallel on every scale; halving gets on there, charts do not.
  bool near_diagonal(const PatchPair& place, const Cell& a, const Cell& b) const {
    const auto near = [](const Interval& x, const Interval& y, int step, int spans, bool closed) {
      const double reach = kNearDiagonal * std::max(length(x), length(y));
      const auto within = [&](int turn) {
        return std::max(y.from - x.to, x.from - y.to - 2 * (step + turn)) + step + turn < reach;
      };
      return within(0) || (closed && (within(spans) || within(-spans)));
    };
    const BezierSurface& s = a_.surface();
    const int step_u = a_.span_u(place.patch_b) - a_.span_u(place.patch_a);
    const int step_v = a_.span_v(place.patch_b) - a_.span_v(place.patch_a);
    return near(a.u, b.u, step_u, s.patches.rows(), s.closed_u) &&
           near(a.v, b.v, step_v, s.patches.columns(), s.closed_v);
  }

  bool is_thin(const Cell& a, const Cell& b, int points_a, int points_b) const {
    const double tolerance = options_.tolerances.point;
    if (!itself() && are_within(a, b, points_a, points_b, tolerance)) return true;
    const double rounding = kSlabRoundings * (a.margin + b.margin);
    const double slab = std::min(tolerance, std::max(kSlabPart * tolerance, rounding));
    return (a.extent <= tolerance && b.extent <= tolerance) ||
           (a.plane.high - a.plane.low <= slab && b.plane.high - b.plane.low <= slab &&
            within_slab(a, b, points_a, points_b, slab));
  }

  std::optional<PairArcs> arcs_of(const Pair& pair, int along) const {
    const PatchPair& place = place_of(pair);
    const Cell &a = cell_a(pair), &b = cell_b(pair);
    return arcs_in(*place.tree_a, a, *place.tree_b, b, JacobianBounds(a, b),
                   upper_borders(a_, place.patch_a, a, b_, place.patch_b, b), along);
  }

  void apply(Pair pair, Finding&& finding) {
    PatchPair& place = place_of(pair);
    const Cell &a = cell_a(pair), &b = cell_b(pair);
    Certificate& certificate = result_.certificate;
    certificate.depth = std::max({certificate.depth, a.depth, b.depth});
    certificate.rounding_bound = std::max({certificate.rounding_bound, a.margin, b.margin});
    if (finding.verdict == Verdict::Apart) {
      ++certificate.excluded;
      return;
    }
    if (finding.verdict == Verdict::Known) {
      ++certificate.critical;
      result_.beside_known = true;
      return;
    }
    if (finding.part) return settle_shared(place, *finding.part);
    if (finding.arcs && finding.slow)
      add_near_part({place.patch_a, place.patch_b}, *place.tree_a, a, *place.tree_b, b,
                    options_.tolerances.point, result_.slow);
    if (finding.arcs) {
      place.certified.push_back({pair.cell_a, pair.cell_b, box_of(a, b), std::move(*finding.arcs)});
      return;
    }
    const bool over = finding.verdict == Verdict::Over, beside = finding.verdict == Verdict::Beside;
    if (over || beside || finding.verdict == Verdict::Parallel) {
      const bool flat = !(over || beside) || nearly_parallel(a, b);  // as at no pole
      const bool known = flat ? place.shared.look_near(a, b) : place.shared.is_known();
      if (known)
        if (const auto part = place.shared.part(a, b)) return settle_shared(place, *part);
      if (over || beside) return over && !known ? keep(pair, true) : halve(pair);
      if (known || !place.quadrics.is_common() || !place.quadrics.is_steep(a, b))
        return place.parallel.push_back({pair.cell_a, pair.cell_b});
      return halve(pair);
    }
    pair.along = finding.along;
    const bool within_tolerance =
        finding.verdict == Verdict::Thin ||
        (finding.verdict == Verdict::Regular &&
         is_thin(a, b, place.tree_a->shape().plane_size(), place.tree_b->shape().plane_size()));
    // Where one cell cannot be halved any more, halves of smaller ones would tell nothing new.
    if (within_tolerance || (is_halved_first(a, b) ? a : b).depth >= kDeepest)
      keep(pair, within_tolerance);
    else
      halve(pair);
  }

  // Both patches are parts of one surface: the pair coincides in a rectangle or not at all.
  void settle_shared(const PatchPair& place, const SharedPart& part) {
    if (part.empty) {
      ++result_.certificate.excluded;
      return;
    }
    ++result_.certificate.critical;
    CriticalPair critical{place.patch_a, place.patch_b,  part.box,
                          part.hull.low, part.hull.high, true};
    critical.shared = true;
    result_.critical.push_back(critical);
  }

  // What the pairs of two patches gave. Cells of a that some nearly parallel pair holds are
  // searched for contacts as a whole; what was certified inside them is dropped, so that nothing
  // is found twice.
  void settle(PatchPair& place) {
    if (place.parallel.empty()) {
      for (const CertifiedPair& pair : place.certified) add(place, pair);
      return;
    }
    const CellTree &tree_a = *place.tree_a, &tree_b = *place.tree_b;
    const auto cells = static_cast<std::size_t>(tree_a.size());
    std::vector<char> holds(cells, 0), dirty(cells, 0), covered(cells, 0);
    for (const CellsPair& pair : place.parallel) holds[static_cast<std::size_t>(pair.cell_a)] = 1;
    dirty = holds;
    for (std::size_t i = cells; i-- > 0;) {  // children come after their parents
      const int child = tree_a[static_cast<int>(i)].child;
      if (child < 0) continue;
      const auto c = static_cast<std::size_t>(child);
      holds[i] = holds[i] | holds[c] | holds[c + 1];
    }
    for (const CertifiedPair& pair : place.certified) {
      const auto i = static_cast<std::size_t>(pair.cell_a);
      dirty[i] = dirty[i] | holds[i];
    }
    ContactTask task{place.patch_a, place.patch_b, {}, {}, place.quadrics.band_b()};
    collect_dirty(tree_a, 0, false, dirty, covered, task.cells_a);
    std::vector<CellsPair> near(place.parallel);
    for (const CertifiedPair& pair : place.certified) {
      if (covered[static_cast<std::size_t>(pair.cell_a)])
        near.push_back({pair.cell_a, pair.cell_b});
      else
        add(place, pair);
    }
    const auto part_of = [&](int cell) {
      const Cell& b = tree_b[cell];
      return std::array{b.u, b.v};
    };
    if (place.patch_a == place.patch_b && itself()) return settle_one_by_one(task, near, tree_a);
    for (const CellsPair& pair : near) task.parts_b.push_back(part_of(pair.cell_b));
    if (!task.cells_a.empty())
      search_contacts(a_, b_, task, size_, known_, options_, limit_, result_);
  }

  // Within one patch every cell gets charts of its own, over what may come close to it alone: other
  // charts might hold the cell itself.
  void settle_one_by_one(const ContactTask& all, const std::vector<CellsPair>& near,
                         const CellTree& tree) {
    for (const int index : all.cells_a) {
      const Cell whole = tree[index];
      ContactTask task{all.patch_a, all.patch_b, {index}, {}, all.band_b};
      for (const CellsPair& pair : near) {
        const Cell& a = tree[pair.cell_a];
        if (blossom::within(a.u, whole.u) && blossom::within(a.v, whole.v))
          task.parts_b.push_back({tree[pair.cell_b].u, tree[pair.cell_b].v});
      }
      search_contacts(a_, b_, task, size_, known_, options_, limit_, result_);
    }
  }

  static void collect_dirty(const CellTree& tree, int index, bool inside,
                            const std::vector<char>& dirty, std::vector<char>& covered,
                            std::vector<int>& cells) {
    const auto i = static_cast<std::size_t>(index);
    if (!inside && dirty[i]) {
      cells.push_back(index);
      inside = true;
    }
    covered[i] = inside;
    const int child = tree[index].child;
    if (child < 0) return;
    collect_dirty(tree, child, inside, dirty, covered, cells);
    collect_dirty(tree, child + 1, inside, dirty, covered, cells);
  }

  void add(const PatchPair& place, const CertifiedPair& pair) {
    ++result_.certificate.certified;
    result_.along_border = result_.along_border || pair.held.along_border;
    for (const CellArc& arc : pair.held.arcs)
      result_.arcs.push_back({place.patch_a, place.patch_b, pair.box, arc, {-1, -1}});
    for (const Point4& x : pair.held.corner_contacts)
      result_.corner_contacts.push_back({place.patch_a, place.patch_b, x});
  }

  void halve(const Pair& pair) {
    halvings_.push_back({pair, is_halved_first(cell_a(pair), cell_b(pair))});
  }

  // The cells of a batch in the order of its pairs, those of both surfaces at the same time.
  void halve_pairs() {
    std::array<long, 2> added{};  // control points
    const auto halve = [&](bool of_a) {
      for (const auto& [pair, of_first] : halvings_) {
        if (of_first != of_a) continue;
        CellTree& tree = of_a ? *place_of(pair).tree_a : *place_of(pair).tree_b;
        const int cells = tree.size();
        tree.split(of_a ? pair.cell_a : pair.cell_b);
        added[of_a] += (tree.size() - cells) * static_cast<long>(tree.shape().plane_size());
      }
    };
    parallel_for(2, itself() ? 2 : 1, [&](std::size_t i) { halve(i == 0); });
    stored_points_ += (added[0] + added[1]) * (itself() ? 2 : 1);
    for (const auto& [pair, of_first] : halvings_) {
      const int child = of_first ? cell_a(pair).child : cell_b(pair).child;
      for (int half = 0; half < 2; ++half)
        stack_.push_back(of_first ? Pair{pair.place, child + half, pair.cell_b, pair.along, false}
                                  : Pair{pair.place, pair.cell_a, child + half, pair.along, false});
    }
    halvings_.clear();
  }

  void keep(const Pair& pair, bool within_tolerance) {
    const PatchPair& place = place_of(pair);
    const Cell &a = cell_a(pair), &b = cell_b(pair);
    CriticalPair critical{place.patch_a, place.patch_b, box_of(a, b), {}, {}, within_tolerance};
    for (int k = 0; k < 3; ++k) {
      const double low = std::max(a.low[k], b.low[k]), high = std::min(a.high[k], b.high[k]);
      if (low > high + reach()) return;  // apart, though never examined
      critical.low[k] = std::min(low, high);
      critical.high[k] = std::max(low, high);
    }
    critical.shared = within_tolerance && place.quadrics.is_one();
    ++result_.certificate.critical;
    result_.critical.push_back(critical);
  }

  SurfaceCells& a_;
  SurfaceCells& b_;
  const double size_;
  const KnownCurves& known_;
  const IntersectionOptions& options_;
  PairSearchResult& result_;
  const WorkLimit limit_;
  long examined_ = 0;
  long stored_points_ = 0;
  std::vector<PatchPair> places_;
  QuadricBands bands_;
  const bool one_is_whole_;  // of the surfaces, of a quadric
  std::vector<Pair> stack_;
  std::vector<Finding> findings_;  // about the batch at work
  std::vector<Halving> halvings_;  // that it asks for
};

}  // namespace

PairSearchResult search_pairs(SurfaceCells& a, SurfaceCells& b, const std::vector<StartPair>& pairs,
                              double size, const KnownCurves& known,
                              const IntersectionOptions& options) {
  PairSearchResult result;
  Search search(a, b, size, known, options, result);
  search.begin(pairs);
  search.run();
  drop_repeated_arcs(result, a, b, size, options.tolerances.point);
  Certificate& certificate = result.certificate;
  (a.monomial() ? certificate.cells_monomial : certificate.cells_bezier) += a.cells();
  if (&a != &b) (b.monomial() ? certificate.cells_monomial : certificate.cells_bezier) += b.cells();
  return result;
}

}  // namespace blossom
