// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/intersection/pair_search.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "core/bounds/box_tree.h"
#include "core/intersection/cell_pair.h"
#include "core/intersection/contact_search.h"
#include "core/intersection/shared_cells.h"
#include "core/intersection/work_limit.h"

namespace blossom {
namespace {

// A slab this part of the tolerance thick ends the search: below it, splitting would only tell
// contacts apart that differ by less than the tolerance.
constexpr double kSlabPart = 1.0 / 1024;
constexpr int kDeepest = 56;              // halvings of a patch: 2^-28 in each direction
constexpr long kMostStored = 30'000'000;  // control points kept, some 1 GB
constexpr int kAskEvery = 1024;           // pairs between looks at the clock
constexpr double kExtentWeight = 0.02;    // of a cell's size beside its bend

// Nearly parallel pairs this flat go to the search for contacts: the sines of the angles by which
// the derivatives of both cells turn, added.
constexpr double kFlat = 0.15;

struct Pair {
  int cell_a;
  int cell_b;
  int along;  // >= 0: already certified over this parameter, halved for its border only
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

class Search {
 public:
  Search(SurfaceCells& a, SurfaceCells& b, double size, const IntersectionOptions& options,
         PairSearchResult& result)
      : a_(a),
        b_(b),
        size_(size),
        options_(options),
        slab_(kSlabPart * options.tolerances.point),
        result_(result),
        limit_(options) {}

  void run(int patch_a, int patch_b) {
    patch_a_ = patch_a;
    patch_b_ = patch_b;
    tree_a_ = &a_.tree(patch_a);
    tree_b_ = &b_.tree(patch_b);
    shared_.emplace(*tree_a_, *tree_b_, options_.tolerances.point);
    stack_.assign(1, {0, 0, -1});
    while (!stack_.empty()) {
      const Pair pair = stack_.back();
      stack_.pop_back();
      if (out_of_budget())
        keep(pair, false);
      else
        examine(pair);
    }
    settle();
  }

 private:
  bool out_of_budget() {
    if (result_.stopped) return true;
    ++examined_;
    if (examined_ > options_.budget) return stop("the budget of cell pairs is spent");
    if (examined_ % kAskEvery != 0) return false;
    if (a_.stored_points() + b_.stored_points() > kMostStored)
      return stop("the memory for cells is spent");
    if (const char* reason = limit_.reached()) return stop(reason);
    return false;
  }

  bool stop(const char* reason) {
    result_.stopped = true;
    result_.certificate.reasons.emplace_back(reason);
    return true;
  }

  void examine(Pair pair) {
    const Cell& a = (*tree_a_)[pair.cell_a];
    const Cell& b = (*tree_b_)[pair.cell_b];
    const int points_a = tree_a_->shape().plane_size(), points_b = tree_b_->shape().plane_size();
    Certificate& certificate = result_.certificate;
    certificate.depth = std::max({certificate.depth, a.depth, b.depth});
    certificate.rounding_bound = std::max({certificate.rounding_bound, a.margin, b.margin});
    if (separated(a, b, points_a, points_b)) {
      ++certificate.excluded;
      return;
    }
    if (const auto part = shared_->part(a, b)) return settle_shared(*part);
    const JacobianBounds bounds(a, b);
    if (pair.along < 0) pair.along = certified_column(bounds);
    if (pair.along >= 0) {
      const auto held = arcs_in(*tree_a_, a, *tree_b_, b, bounds, borders(a, b), pair.along);
      if (held) {
        certified_.push_back({pair.cell_a, pair.cell_b, box_of(a, b), *held});
        return;
      }
    } else if (nearly_parallel(a, b)) {
      shared_->look_near(a, b);
      if (const auto part = shared_->part(a, b)) return settle_shared(*part);
      parallel_.push_back({pair.cell_a, pair.cell_b});
      return;
    }
    const double tolerance = options_.tolerances.point;
    const bool thin = (a.extent <= tolerance && b.extent <= tolerance) ||
                      (a.plane.high - a.plane.low <= slab_ && b.plane.high - b.plane.low <= slab_ &&
                       within_slab(a, b, points_a, points_b, slab_));
    if (thin || (a.depth >= kDeepest && b.depth >= kDeepest))
      keep(pair, thin);
    else
      halve(pair);
  }

  // Both patches are parts of one surface: the pair coincides in a rectangle or not at all.
  void settle_shared(const SharedPart& part) {
    if (part.empty) {
      ++result_.certificate.excluded;
      return;
    }
    ++result_.certificate.critical;
    result_.critical.push_back({patch_a_, patch_b_, part.box, part.hull.low, part.hull.high, true});
  }

  SurfaceBorders borders(const Cell& a, const Cell& b) const {
    return upper_borders(a_, patch_a_, a, b_, patch_b_, b);
  }

  // True if both cells are nearly flat and some of their normals may be parallel.
  static bool nearly_parallel(const Cell& a, const Cell& b) {
    const auto turn = [](const Cell& c) {
      return norm(c.du.radius) / norm(c.du.middle) + norm(c.dv.radius) / norm(c.dv.middle);
    };
    const double turns = turn(a) + turn(b);
    if (!(turns < kFlat)) return false;
    const Vec3 na = unit(cross(a.du.middle, a.dv.middle));
    const Vec3 nb = unit(cross(b.du.middle, b.dv.middle));
    // A skew frame turns its normal by more than its sides turn.
    const auto skew = [](const Cell& c) {
      return norm(cross(unit(c.du.middle), unit(c.dv.middle)));
    };
    return norm(cross(na, nb)) <= 2 * turns / std::min(skew(a), skew(b));
  }

  // What the pairs of two patches gave. Cells of a that some nearly parallel pair holds are
  // searched for contacts as a whole; what was certified inside them is dropped, so that nothing
  // is found twice.
  void settle() {
    const auto cells = static_cast<std::size_t>(tree_a_->size());
    std::vector<char> holds(cells, 0), dirty(cells, 0), covered(cells, 0);
    for (const CellsPair& pair : parallel_) holds[static_cast<std::size_t>(pair.cell_a)] = 1;
    dirty = holds;
    for (std::size_t i = cells; i-- > 0;) {  // children come after their parents
      const int child = (*tree_a_)[static_cast<int>(i)].child;
      if (child < 0) continue;
      const auto c = static_cast<std::size_t>(child);
      holds[i] = holds[i] | holds[c] | holds[c + 1];
    }
    for (const CertifiedPair& pair : certified_) {
      const auto i = static_cast<std::size_t>(pair.cell_a);
      dirty[i] = dirty[i] | holds[i];
    }
    ContactTask task{patch_a_, patch_b_, {}, {}};
    collect_dirty(0, false, dirty, covered, task.cells_a);
    const auto part_of = [&](int cell) {
      const Cell& b = (*tree_b_)[cell];
      return std::array{b.u, b.v};
    };
    for (const CellsPair& pair : parallel_) task.parts_b.push_back(part_of(pair.cell_b));
    for (const CertifiedPair& pair : certified_) {
      if (covered[static_cast<std::size_t>(pair.cell_a)])
        task.parts_b.push_back(part_of(pair.cell_b));
      else
        add(pair);
    }
    certified_.clear();
    parallel_.clear();
    if (!task.cells_a.empty()) search_contacts(a_, b_, task, size_, options_, limit_, result_);
  }

  void collect_dirty(int index, bool inside, const std::vector<char>& dirty,
                     std::vector<char>& covered, std::vector<int>& cells) const {
    const auto i = static_cast<std::size_t>(index);
    if (!inside && dirty[i]) {
      cells.push_back(index);
      inside = true;
    }
    covered[i] = inside;
    const int child = (*tree_a_)[index].child;
    if (child < 0) return;
    collect_dirty(child, inside, dirty, covered, cells);
    collect_dirty(child + 1, inside, dirty, covered, cells);
  }

  void add(const CertifiedPair& pair) {
    ++result_.certificate.certified;
    result_.along_border = result_.along_border || pair.held.along_border;
    for (const CellArc& arc : pair.held.arcs)
      result_.arcs.push_back({patch_a_, patch_b_, pair.box, arc, {-1, -1}});
    for (const Point4& x : pair.held.grazes) result_.grazes.push_back({patch_a_, patch_b_, x});
  }

  static int certified_column(const JacobianBounds& bounds) {
    const int best = bounds.best_column();
    if (bounds.minor(best).regular) return best;
    for (int k = 0; k < 4; ++k)
      if (k != best && bounds.minor(k).regular) return k;
    return -1;
  }

  void halve(const Pair& pair) {
    const Cell& a = (*tree_a_)[pair.cell_a];
    const Cell& b = (*tree_b_)[pair.cell_b];
    const bool halve_a = b.depth >= kDeepest ||
                         (a.depth < kDeepest &&
                          a.bend + kExtentWeight * a.extent >= b.bend + kExtentWeight * b.extent);
    const int child = halve_a ? tree_a_->split(pair.cell_a) : tree_b_->split(pair.cell_b);
    for (int half = 0; half < 2; ++half)
      stack_.push_back(halve_a ? Pair{child + half, pair.cell_b, pair.along}
                               : Pair{pair.cell_a, child + half, pair.along});
  }

  void keep(const Pair& pair, bool thin) {
    const Cell& a = (*tree_a_)[pair.cell_a];
    const Cell& b = (*tree_b_)[pair.cell_b];
    CriticalPair critical{patch_a_, patch_b_, box_of(a, b), {}, {}, thin};
    for (int k = 0; k < 3; ++k) {
      critical.low[k] = std::max(a.low[k], b.low[k]);
      critical.high[k] = std::min(a.high[k], b.high[k]);
      if (critical.low[k] > critical.high[k]) return;  // apart, though never examined
    }
    ++result_.certificate.critical;
    result_.critical.push_back(critical);
  }

  SurfaceCells& a_;
  SurfaceCells& b_;
  const double size_;
  const IntersectionOptions& options_;
  const double slab_;
  PairSearchResult& result_;
  const WorkLimit limit_;
  long examined_ = 0;
  int patch_a_ = 0, patch_b_ = 0;
  CellTree* tree_a_ = nullptr;
  CellTree* tree_b_ = nullptr;
  std::optional<SharedCells> shared_;  // of the pair of patches at work
  std::vector<Pair> stack_;
  std::vector<CertifiedPair> certified_;  // of the pair of patches at work
  std::vector<CellsPair> parallel_;
};

std::vector<Box> patch_boxes(SurfaceCells& cells) {
  std::vector<Box> boxes;
  for (int i = 0; i < cells.patches(); ++i) {
    const Cell& root = cells.tree(i)[0];
    boxes.push_back({root.low, root.high});
  }
  return boxes;
}

}  // namespace

SurfaceCells::SurfaceCells(const BezierSurface& surface, const Vec3& origin, CellForm form,
                           double cut)
    : surface_(surface), origin_(origin), form_(form), cut_(cut) {
  trees_.resize(surface.patches.values().size());
}

CellTree& SurfaceCells::tree(int patch) {
  auto& tree = trees_[static_cast<std::size_t>(patch)];
  if (!tree)
    tree = std::make_unique<CellTree>(surface_.patches.values()[static_cast<std::size_t>(patch)],
                                      surface_.rational, origin_, form_, cut_);
  return *tree;
}

Interval SurfaceCells::knots_u(int patch) const {
  const auto i = static_cast<std::size_t>(span_u(patch));
  return {surface_.u_knots[i], surface_.u_knots[i + 1]};
}

Interval SurfaceCells::knots_v(int patch) const {
  const auto j = static_cast<std::size_t>(span_v(patch));
  return {surface_.v_knots[j], surface_.v_knots[j + 1]};
}

long SurfaceCells::cells() const {
  return std::accumulate(trees_.begin(), trees_.end(), 0L,
                         [](long sum, const auto& t) { return t ? sum + t->size() : sum; });
}

long SurfaceCells::stored_points() const {
  return std::accumulate(trees_.begin(), trees_.end(), 0L, [](long sum, const auto& t) {
    return t ? sum + static_cast<long>(t->size()) * t->shape().plane_size() : sum;
  });
}

bool SurfaceCells::monomial() const {
  return std::any_of(trees_.begin(), trees_.end(),
                     [](const auto& t) { return t && t->monomial(); });
}

SurfaceBorders upper_borders(const SurfaceCells& a, int patch_a, const Cell& cell_a,
                             const SurfaceCells& b, int patch_b, const Cell& cell_b) {
  const auto last = [](const Interval& place, int span, int spans, bool closed) {
    return place.to == 1 && span == spans - 1 && !closed;
  };
  const BezierSurface &sa = a.surface(), &sb = b.surface();
  return {{last(cell_a.u, a.span_u(patch_a), sa.patches.rows(), sa.closed_u),
           last(cell_a.v, a.span_v(patch_a), sa.patches.columns(), sa.closed_v),
           last(cell_b.u, b.span_u(patch_b), sb.patches.rows(), sb.closed_u),
           last(cell_b.v, b.span_v(patch_b), sb.patches.columns(), sb.closed_v)}};
}

PairSearchResult search_pairs(SurfaceCells& a, SurfaceCells& b, double size,
                              const IntersectionOptions& options) {
  PairSearchResult result;
  Search search(a, b, size, options, result);
  const BoxTree boxes_a(patch_boxes(a)), boxes_b(patch_boxes(b));
  boxes_a.for_each_meeting(boxes_b, [&](int i, int j) { search.run(i, j); });
  (a.monomial() ? result.certificate.cells_monomial : result.certificate.cells_bezier) += a.cells();
  (b.monomial() ? result.certificate.cells_monomial : result.certificate.cells_bezier) += b.cells();
  return result;
}

}  // namespace blossom
