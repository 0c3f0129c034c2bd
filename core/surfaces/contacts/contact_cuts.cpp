// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/contacts/contact_cuts.h"

#include <algorithm>
#include <cmath>

#include "core/cells/surface_cells.h"
#include "core/surfaces/contacts/limits.h"
#include "core/surfaces/gap/contact_points.h"
#include "core/surfaces/pairs/pair_search_result.h"

namespace blossom {
namespace {

class Cutter {
 public:
  Cutter(const RationalBezierPatch& patch_a, const RationalBezierPatch& patch_b)
      : patch_a_(patch_a), patch_b_(patch_b) {}

  ValleyCell run(const ValleyCell& cell) const {
    ValleyCell result;
    std::vector<int> contact_at(cell.contacts.size(), kContactElsewhere);
    for (std::size_t i = 0; i < cell.contacts.size(); ++i) {
      const CellContact& contact = cell.contacts[i];
      const auto on_valley = [&](const Point4& start, const Point4& plane) {
        const Vec2 across{contact.path.back()[1] - contact.path.front()[1],
                          contact.path.front()[0] - contact.path.back()[0]};
        return touch_point(patch_a_, patch_b_, start, {across, contact.crosses}, plane, 0.5);
      };
      for (const auto& part : parts_inside(contact.path, on_valley)) {
        CellContact piece;
        piece.crosses = contact.crosses;
        piece.path = part.path;
        for (const Point4& x : piece.path)
          piece.gaps.push_back(std::abs(signed_gap(patch_a_, patch_b_, x)));
        piece.leaves = {part.cut[0] || contact.leaves[0], part.cut[1] || contact.leaves[1]};
        contact_at[i] = static_cast<int>(result.contacts.size());
        result.contacts.push_back(piece);
      }
    }
    const auto on_curve = [&](const Point4& start, const Point4& plane) {
      return curve_point(patch_a_, patch_b_, start, plane, 0.5);
    };
    for (const CellBranch& branch : cell.branches)
      for (const auto& part : parts_inside(branch.path, on_curve)) {
        CellBranch piece{part.path, {-1, -1}};
        for (std::size_t end = 0; end < 2; ++end)
          if (!part.cut[end] && branch.contact[end] >= 0)
            piece.contact[end] = contact_at[static_cast<std::size_t>(branch.contact[end])];
        result.branches.push_back(piece);
      }
    return result;
  }

 private:
  // By how much a point lies inside; negative outside.
  static double depth_inside(const Point4& x) { return std::min({x[2], 1 - x[2], x[3], 1 - x[3]}); }

  // Where a path crosses the patch's border between two of its points. One that runs along another
  // border is beside it by rounding, which is no crossing.
  template <class PointIn>
  std::optional<Point4> crossing(const Point4& in, const Point4& out,
                                 const PointIn& point_in) const {
    double first = 2;
    std::size_t axis = 2;
    double goal = 0;
    bool begun = true;  // beyond the border, but within kOnBorder of it, at `in` already
    for (const std::size_t k : {std::size_t{2}, std::size_t{3}})
      for (const double end : {0.0, 1.0}) {
        const double f = (end - in[k]) / (out[k] - in[k]);
        const bool beyond = end == 0 ? out[k] < -kOnBorder : out[k] > 1 + kOnBorder;
        if (beyond && (f < 0 ? begun && first > 1 : begun || f < first)) {
          begun = f < 0;
          first = std::max(f, 0.0);
          axis = k;
          goal = end;
        }
      }
    if (first > 1) return std::nullopt;
    Point4 start;
    for (std::size_t k = 0; k < 4; ++k) start[k] = in[k] + first * (out[k] - in[k]);
    start[axis] = goal;
    Point4 plane{};
    plane[axis] = 1;
    auto x = point_in(start, plane);
    if (!x) return std::nullopt;
    (*x)[axis] = goal;
    // A path that runs along this border comes to it anywhere, beyond others perhaps.
    return depth_inside(*x) < -kOnBorder ? std::nullopt : x;
  }

  // A path with a point in the patch between two points outside of it where the chord runs
  // through it, as it does near a corner.
  template <class PointIn>
  std::vector<Point4> with_inner_points(const std::vector<Point4>& path,
                                        const PointIn& point_in) const {
    std::vector<Point4> result;
    for (std::size_t i = 0; i < path.size(); ++i) {
      if (i > 0)
        if (const auto x = inner_point(path[i - 1], path[i], point_in)) result.push_back(*x);
      result.push_back(path[i]);
    }
    return result;
  }

  template <class PointIn>
  std::optional<Point4> inner_point(const Point4& p, const Point4& q,
                                    const PointIn& point_in) const {
    if (depth_inside(p) >= -kOnBorder || depth_inside(q) >= -kOnBorder) return std::nullopt;
    double from = 0, to = 1;  // of the chord, inside the patch
    for (const std::size_t k : {std::size_t{2}, std::size_t{3}}) {
      const double f = -p[k] / (q[k] - p[k]), g = (1 - p[k]) / (q[k] - p[k]);
      from = std::max(from, std::min(f, g));
      to = std::min(to, std::max(f, g));
    }
    if (!(from < to)) return std::nullopt;
    Point4 start, plane{};
    for (std::size_t k = 0; k < 4; ++k) start[k] = p[k] + 0.5 * (from + to) * (q[k] - p[k]);
    plane[std::abs(q[2] - p[2]) > std::abs(q[3] - p[3]) ? 2 : 3] = 1;
    const auto x = point_in(start, plane);
    return x && depth_inside(*x) > 0 ? x : std::nullopt;
  }

  struct PathPart {
    std::vector<Point4> path;
    std::array<bool, 2> cut{};
  };

  template <class PointIn>
  std::vector<PathPart> parts_inside(const std::vector<Point4>& whole,
                                     const PointIn& point_in) const {
    const std::vector<Point4> path = with_inner_points(whole, point_in);
    std::vector<PathPart> parts;
    bool open = false;
    for (std::size_t i = 0; i < path.size(); ++i) {
      const bool in = depth_inside(path[i]) >= -kOnBorder;
      if (in && !open) {
        parts.emplace_back();
        if (i > 0) {
          parts.back().cut[0] = true;
          if (const auto x = crossing(path[i], path[i - 1], point_in))
            parts.back().path.push_back(*x);
        }
      }
      if (in) parts.back().path.push_back(path[i]);
      if (!in && open) {
        parts.back().cut[1] = true;
        if (const auto x = crossing(path[i - 1], path[i], point_in))
          parts.back().path.push_back(*x);
      }
      open = in;
    }
    std::erase_if(parts, [](const PathPart& part) { return is_point(part.path); });
    return parts;
  }

  // What only ends on the border of the patch is in it with its end alone.
  static bool is_point(const std::vector<Point4>& path) {
    return std::all_of(path.begin(), path.end(), [&](const Point4& x) {
      for (std::size_t k = 0; k < 4; ++k)
        if (std::abs(x[k] - path[0][k]) > 4 * kOnBorder) return false;
      return true;
    });
  }

  const RationalBezierPatch& patch_a_;
  const RationalBezierPatch& patch_b_;
};

}  // namespace

ValleyCell part_inside(const RationalBezierPatch& patch_a, const RationalBezierPatch& patch_b,
                       const ValleyCell& cell) {
  return Cutter(patch_a, patch_b).run(cell);
}

}  // namespace blossom
