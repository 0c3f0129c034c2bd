// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/gap/cells/regular_cell.h"

#include <algorithm>
#include <cmath>

#include "core/math/functions/sign_change.h"
#include "core/surfaces/gap/contact_points.h"
#include "core/surfaces/gap/model_points.h"
#include "core/surfaces/gap/turned_axes.h"

namespace blossom {
namespace {

constexpr double kMaxBranchTurn = 1;  // tangent of the angle by which a branch may leave its axis
constexpr double kStepTurn = 0.25;    // likewise, of an arc: longer branches are cut
constexpr double kArcRootWidth = 0x1p-40;  // of the cell

struct BorderRoot {
  double w, z;
  int edge;
};

class RegularReader {
 public:
  RegularReader(const RationalBezierPatch& patch_a, const Cell& a,
                const RationalBezierPatch& patch_b, const GapModel& model, const GapSlope& slope)
      : patch_a_(patch_a),
        patch_b_(patch_b),
        model_(model),
        axes_(slope.direction),
        gap_(axes_.turned(model.gap)),
        slope_(slope.least),
        points_(patch_a, a, patch_b, model, axes_) {}

  std::optional<ValleyCell> run() {
    const TaylorRange across = range(derivative_x(gap_), axes_.reach, axes_.reach);
    const double turn =
        (std::max(std::abs(across.low), std::abs(across.high)) + model_.gap_error[1]) / slope_;
    if (turn > kMaxBranchTurn) return std::nullopt;
    steps_ = static_cast<int>(std::ceil(std::max(turn / kStepTurn, 1.0)));
    if (!find_roots() || roots_.size() % 2 != 0) return std::nullopt;
    ValleyCell cell;
    for (std::size_t i = 0; i < roots_.size(); i += 2) {
      auto branch = branch_between(roots_[i], roots_[i + 1]);
      if (!branch) return std::nullopt;
      cell.branches.push_back(std::move(*branch));
    }
    return cell;
  }

 private:
  bool find_roots() {
    for (int edge = 0; edge < 4; ++edge) {
      const auto roots = isolated_roots(axes_.along_edge(gap_, edge), model_.gap_error[0],
                                        model_.gap_error[1], -1, 1);
      if (!roots) return false;
      for (const IsolatedRoot& root : *roots) {
        const Vec2 wz = axes_.on_edge(edge, root.t);
        roots_.push_back({wz[0], wz[1], edge});
      }
    }
    std::sort(roots_.begin(), roots_.end(),
              [](const BorderRoot& p, const BorderRoot& q) { return p.w < q.w; });
    return true;
  }

  std::optional<CellBranch> branch_between(const BorderRoot& from, const BorderRoot& to) const {
    CellBranch branch;
    for (int k = 0; k <= steps_; ++k) {
      const auto x = k == 0        ? on_border(from)
                     : k == steps_ ? on_border(to)
                                   : on_line(from.w + (to.w - from.w) * k / steps_);
      if (!x) return std::nullopt;
      branch.path.push_back(*x);
    }
    return branch;
  }

  std::optional<Point4> on_border(const BorderRoot& root) const {
    Point4 start = points_.at(root.w, root.z);
    const Point4 plane = points_.fix_edge(root.edge, start);
    auto x = curve_point(patch_a_, patch_b_, start, plane, points_.reach());
    if (x) points_.fix_edge(root.edge, *x);
    return x;
  }

  // The zero on the line w = const.
  std::optional<Point4> on_line(double w) const {
    const Polynomial across = along_y(gap_, w);
    const auto gap = [&](double z) { return value(across, z); };
    const double low = axes_.chord_end(w, 0), high = axes_.chord_end(w, 1);
    const double low_gap = gap(low), high_gap = gap(high);
    if (!(low_gap < 0 && high_gap > 0)) return std::nullopt;
    const double z = narrowed(gap, {low, high}, low_gap, high_gap, kArcRootWidth).below;
    return curve_point(patch_a_, patch_b_, points_.at(w, z), points_.line(), points_.reach());
  }

  const RationalBezierPatch& patch_a_;
  const RationalBezierPatch& patch_b_;
  const GapModel& model_;
  const TurnedAxes axes_;
  const TaylorPolynomial gap_;  // of w, z
  const double slope_;
  int steps_ = 1;
  const ModelPoints points_;
  std::vector<BorderRoot> roots_;
};

}  // namespace

std::optional<ValleyCell> regular_cell(const RationalBezierPatch& patch_a, const Cell& a,
                                       const RationalBezierPatch& patch_b, const GapModel& model,
                                       const GapSlope& slope) {
  return RegularReader(patch_a, a, patch_b, model, slope).run();
}

}  // namespace blossom
