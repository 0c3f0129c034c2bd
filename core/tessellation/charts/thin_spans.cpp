// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tessellation/charts/thin_spans.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/unbounded.h"
#include "core/math/index.h"
#include "core/tessellation/charts/cell_jets.h"

namespace blossom {
namespace {

constexpr double kShort = 1e-3;  // of the range of a parameter: longer spans are not asked

using Column = std::vector<Vec4>;  // of a net

Column column_of(const RationalBezierPatch& patch, bool last) {
  Column result;
  for (int i = 0; i < patch.points.rows(); ++i)
    result.push_back(patch.points(i, last ? patch.points.columns() - 1 : 0));
  return result;
}

// With weights w_ij = a_i b_j (1 + e_ij): a bound on |e_ij|, a_i the weights of the border.
double uneven_weights(const RationalBezierPatch& patch, const Column& border) {
  const auto ratio = [&](int i, int j) { return patch.points(i, j)[3] / border[index(i)][3]; };
  double most = 0;
  for (int j = 0; j < patch.points.columns(); ++j)
    for (int i = 1; i < patch.points.rows(); ++i)
      most = std::max(most, std::abs(ratio(i, j) / ratio(0, j) - 1));
  return most;
}

// How far the patch is at most from a curve with the same parameter u. Were its weights a product,
// both would be means by the same weights of u, and no farther apart than control points of the
// same row. Weights that are uneven by e move a mean of points within R of each other by
// 2 e R / (1 - e).
double distance_to(const RationalBezierPatch& patch, const Column& border) {
  const double uneven = uneven_weights(patch, border);
  if (border.size() != index(patch.points.rows()) || !(uneven < 1)) return kInfinity;
  double most = 0, size = 0;
  for (int i = 0; i < patch.points.rows(); ++i)
    for (int j = 0; j < patch.points.columns(); ++j) {
      const Vec3 p = projected(patch.points(i, j));
      most = std::max(most, distance(p, projected(border[index(i)])));
      size = std::max(size, distance(p, projected(border[0])));
    }
  return most + 4 * uneven * size / (1 - uneven);
}

// Makes the patch end with a border; how far that moves it. Points move by the more, the nearer to
// the end their parameters are: so the patch is stretched, and derivatives are about as before.
double end_with(RationalBezierPatch& patch, const Column& border) {
  const int last = patch.points.columns() - 1;
  const Vec3 origin = projected(border[0]);
  const double scale = patch.points(0, last)[3] / border[0][3];
  double moved = 0, uneven = 0, size = 0;
  for (const Vec4& p : patch.points.values()) size = std::max(size, distance(projected(p), origin));
  for (int i = 0; i < patch.points.rows(); ++i) {
    const Vec4 wanted = scale * border[index(i)];
    const Vec4 given = patch.points(i, last);
    const Vec3 move = projected(wanted) - projected(given);
    for (int j = 0; j < last; ++j) {
      Vec4& p = patch.points(i, j);
      for (int k = 0; k < 3; ++k) p[k] += p[3] * move[k] * j / last;
    }
    patch.points(i, last) = wanted;
    moved = std::max(moved, norm(move));
    uneven = std::max(uneven, std::abs(wanted[3] / given[3] - 1));
  }
  return moved + 4 * uneven * size;
}

// The columns of patches that stay, in v.
class Thinning {
 public:
  Thinning(BezierSurface& surface, double thin) : surface_(surface), thin_(thin) {}

  // What moves, at most.
  double done() {
    const std::vector<double>& knots = surface_.v_knots;
    const double short_span = kShort * (knots.back() - knots.front());
    const int columns = surface_.patches.columns();
    for (int j = 0; j < columns; ++j) {
      const bool may = knots[index(j + 1)] - knots[index(j)] < short_span;
      if (may && !kept_.empty() && reaches_over(j)) continue;
      if (may && kept_.empty() && j + 1 < columns && is_thin_start(j)) continue;
      keep(j);
    }
    if (static_cast<int>(kept_.size()) == columns) return 0;
    rebuild();
    return moved_;
  }

 private:
  double most_in(int j, const auto& of_patch) const {
    double most = 0;
    for (int i = 0; i < surface_.patches.rows(); ++i)
      most = std::max(most, of_patch(i, surface_.patches(i, j)));
    return most;
  }

  // At the start runs are cut off; the first span that stays begins where they end.
  bool is_thin_start(int j) {
    const double moves = most_in(j, [&](int, const RationalBezierPatch& patch) {
      return distance_to(patch, column_of(patch, true));
    });
    if (start_ + moves > thin_) return false;
    start_ += moves;
    moved_ = std::max(moved_, start_);
    return true;
  }

  // Whether the last column that stays may reach over this one, too: it ends with the border of
  // this one, and its points move along by what the stretched parameter does at its largest speed.
  bool reaches_over(int j) {
    const int before = kept_.back();
    const std::vector<double>& knots = surface_.v_knots;
    const double moves = most_in(j, [&](int i, const RationalBezierPatch& patch) {
      return distance_to(patch, column_of(surface_.patches(i, before), true));
    });
    const double stretched = knots[index(j + 1)] - knots[index(before + 1)];
    if (!(2 * moves + speed_ * stretched <= thin_)) return false;
    over_.back() = j;
    ends_.back() = knots[index(j + 1)];
    moved_ = std::max(moved_, moves + speed_ * stretched);
    return true;
  }

  void keep(int j) {
    const std::vector<double>&u = surface_.u_knots, &v = surface_.v_knots;
    speed_ = most_in(j, [&](int i, const RationalBezierPatch& patch) {
      const CellSide side_u{{u[index(i)], u[index(i + 1)]}, surface_.u_law, {0, 1}};
      const CellSide side_v{{v[index(j)], v[index(j + 1)]}, surface_.v_law, {0, 1}};
      return cell_jet(patch, side_u, side_v).first_v.size();
    });
    kept_.push_back(j);
    over_.push_back(j);
    ends_.push_back(v[index(j + 1)]);
  }

  void rebuild() {
    Grid<RationalBezierPatch> patches(surface_.patches.rows(), static_cast<int>(kept_.size()));
    double joined = 0;
    for (int i = 0; i < patches.rows(); ++i)
      for (int k = 0; k < patches.columns(); ++k) {
        patches(i, k) = surface_.patches(i, kept_[index(k)]);
        const int over = over_[index(k)];
        if (over > kept_[index(k)])
          joined =
              std::max(joined, end_with(patches(i, k), column_of(surface_.patches(i, over), true)));
      }
    moved_ += joined;
    const double first = surface_.v_knots[index(kept_.front())];
    surface_.patches = std::move(patches);
    surface_.v_knots = std::move(ends_);
    surface_.v_knots.insert(surface_.v_knots.begin(), first);
  }

  BezierSurface& surface_;
  double thin_, speed_ = 0, start_ = 0, moved_ = 0;
  std::vector<int> kept_, over_;  // and the last one that each reaches over
  std::vector<double> ends_;
};

void turn(BezierSurface& surface) {
  const auto turned = [](const auto& grid, const auto& value) {
    std::remove_cvref_t<decltype(grid)> result(grid.columns(), grid.rows());
    for (int i = 0; i < grid.rows(); ++i)
      for (int j = 0; j < grid.columns(); ++j) result(j, i) = value(grid(i, j));
    return result;
  };
  const auto same = [](const Vec4& p) { return p; };
  surface.patches = turned(surface.patches, [&](const RationalBezierPatch& patch) {
    return RationalBezierPatch{turned(patch.points, same)};
  });
  std::swap(surface.u_knots, surface.v_knots);
  std::swap(surface.u_law, surface.v_law);
  std::swap(surface.closed_u, surface.closed_v);
}

bool has_one_degree(const BezierSurface& surface) {
  const Grid<Vec4>& first = surface.patches(0, 0).points;
  return std::ranges::all_of(surface.patches.values(), [&](const RationalBezierPatch& patch) {
    return patch.points.rows() == first.rows() && patch.points.columns() == first.columns();
  });
}

bool has_short_span(const std::vector<double>& knots) {
  for (std::size_t k = 0; k + 1 < knots.size(); ++k)
    if (knots[k + 1] - knots[k] < kShort * (knots.back() - knots.front())) return true;
  return false;
}

}  // namespace

void drop_thin_spans(BezierSurface& surface, double thin) {
  if (!has_one_degree(surface)) return;
  if (surface.v_law == ParameterLaw::Linear && has_short_span(surface.v_knots))
    surface.error += Thinning(surface, thin).done();
  if (surface.u_law != ParameterLaw::Linear || !has_short_span(surface.u_knots)) return;
  turn(surface);
  surface.error += Thinning(surface, thin).done();
  turn(surface);
}

}  // namespace blossom
