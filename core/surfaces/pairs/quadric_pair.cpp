// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/pairs/quadric_pair.h"

#include <algorithm>

#include "core/surfaces/gap/contact_points.h"

namespace blossom {
namespace {

constexpr int kMaxPatches = 64;          // of a surface that is looked at as a whole
constexpr double kSmallPart = 1.0 / 16;  // of the surfaces' size: cells that coincide
constexpr double kMinPart = 1.0 / 256;   // likewise: cells at a border
constexpr double kFootReach = 0.5;       // of Newton's method for feet, fraction of a patch

// Of the tolerance: the rest is left for the rounding of slopes.
constexpr double kMaxSpread = 1 - 1e-6;

constexpr double kOnePoint = 1e-12;  // relative

// The surface ends nowhere: it is closed in one direction, and in the other one closed, too, or its
// borders are single points, as the poles of a sphere.
bool is_borderless(const BezierSurface& surface) {
  const auto& patches = surface.patches;
  const auto is_point = [&](const RationalBezierPatch& patch, bool across_u, bool upper) {
    const auto& net = patch.points;
    const int count = across_u ? net.columns() : net.rows();
    const auto at = [&](int k) {
      const Vec4& p =
          across_u ? net(upper ? net.rows() - 1 : 0, k) : net(k, upper ? net.columns() - 1 : 0);
      return projected(p);
    };
    for (int k = 1; k < count; ++k)
      if (distance(at(k), at(0)) > kOnePoint * (1 + norm(at(0)))) return false;
    return true;
  };
  const auto ends_in_points = [&](bool across_u) {
    const int last = (across_u ? patches.rows() : patches.columns()) - 1;
    for (int k = 0; k < (across_u ? patches.columns() : patches.rows()); ++k)
      for (const bool upper : {false, true}) {
        const int end = upper ? last : 0;
        if (!is_point(across_u ? patches(end, k) : patches(k, end), across_u, upper)) return false;
      }
    return true;
  };
  return (surface.closed_u && (surface.closed_v || ends_in_points(false))) ||
         (surface.closed_v && ends_in_points(true));
}

// True if the middle of one cell is a point of the other one.
bool holds_middle(const CellTree& outer_tree, const Cell& outer, const CellTree& inner_tree,
                  const Cell& inner) {
  const auto x = foot_point(
      inner_tree.patch(), outer_tree.patch(),
      {at(inner.u, 0.5), at(inner.v, 0.5), at(outer.u, 0.5), at(outer.v, 0.5)}, kFootReach);
  return x && (*x)[2] >= outer.u.from && (*x)[2] <= outer.u.to && (*x)[3] >= outer.v.from &&
         (*x)[3] <= outer.v.to;
}

}  // namespace

bool is_whole_quadric(SurfaceCells& surface, QuadricBands& bands) {
  if (surface.patches() > kMaxPatches || !is_borderless(surface.surface())) return false;
  const QuadricBand* band = bands.of(surface.tree(0));
  if (band == nullptr) return false;
  for (int patch = 1; patch < surface.patches(); ++patch)
    if (!band->holds_tightly(surface.tree(patch))) return false;
  return true;
}

QuadricPair::QuadricPair(const CellTree& a, const CellTree& b, QuadricBands& bands,
                         bool one_is_whole, double size)
    : tree_a_(a), tree_b_(b), band_a_(bands.of(a)), band_b_(bands.of(b)), size_(size) {
  const bool asked = &a != &b && band_b_ != nullptr;
  spread_ = asked ? band_b_->spread_over(a[0], a.shape()) : 0;
  const bool on_one = asked && spread_ <= kMaxSpread;
  is_one_ = on_one && one_is_whole;
  is_common_ = on_one && !one_is_whole;
}

bool QuadricPair::is_steep(const Cell& a, const Cell& b) const {
  return band_b_->is_steep_in(a, tree_a_.shape(), spread_) &&
         band_b_->is_steep_in(b, tree_b_.shape(), spread_);
}

bool QuadricPair::is_small(const Cell& a, const Cell& b) const {
  return std::max(a.extent, b.extent) <= kSmallPart * size_;
}

bool QuadricPair::coincide(const Cell& a, const Cell& b) const {
  return is_small(a, b) && is_steep(a, b);
}

bool QuadricPair::touch_all_over(const Cell& a, const Cell& b) const {
  if (band_a_ == nullptr || band_b_ == nullptr || !is_small(a, b)) return false;
  const double of_a = band_b_->spread_over(a, tree_a_.shape());
  const double of_b = band_a_->spread_over(b, tree_b_.shape());
  return std::max(of_a, of_b) <= kMaxSpread && band_b_->is_steep_in(a, tree_a_.shape(), of_a) &&
         band_b_->is_steep_in(b, tree_b_.shape(), of_a);
}

bool QuadricPair::cover_each_other(const Cell& a, const Cell& b) const {
  if (std::max(a.extent, b.extent) <= kMinPart * size_) return true;
  return holds_middle(tree_b_, b, tree_a_, a) || holds_middle(tree_a_, a, tree_b_, b);
}

bool QuadricPair::are_disjoint(const Cell& a, const Cell& b) const {
  return (band_b_ != nullptr && band_b_->misses(a, tree_a_.shape())) ||
         (band_a_ != nullptr && band_a_->misses(b, tree_b_.shape()));
}

}  // namespace blossom
