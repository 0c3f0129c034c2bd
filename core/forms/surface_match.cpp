// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/surface_match.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/unbounded.h"
#include "core/forms/evaluation.h"

namespace blossom {
namespace {

constexpr double kSameParameter = 0x1p-46;  // of the largest parameter: rounding of a few steps
constexpr double kRounding = 0x1p-49;       // of a coordinate: projecting, subtracting, summing

// How places in the grid of one surface correspond to places in that of another.
struct Turn {
  bool exchanged = false;
  bool reversed_u = false;  // of the first surface
  bool reversed_v = false;
};

// The place in a grid of `b` that belongs to (i, j) of an m x n grid of `a`.
struct GridPlace {
  int row, column;
};
GridPlace turned(const Turn& turn, int i, int j, int m, int n) {
  const int row = turn.reversed_u ? m - 1 - i : i;
  const int column = turn.reversed_v ? n - 1 - j : j;
  return turn.exchanged ? GridPlace{column, row} : GridPlace{row, column};
}

template <class T>
bool have_same_shape(const Turn& turn, const Grid<T>& a, const Grid<T>& b) {
  return turn.exchanged ? a.rows() == b.columns() && a.columns() == b.rows()
                        : a.rows() == b.rows() && a.columns() == b.columns();
}

struct Line {
  double slope, offset;
};

// The affine map that takes the knots of one direction to those of another.
std::optional<Line> line_between(const std::vector<double>& from, const std::vector<double>& to,
                                 bool reversed) {
  if (from.size() != to.size()) return {};
  const double first = reversed ? to.back() : to.front();
  const double last = reversed ? to.front() : to.back();
  const double slope = (last - first) / (from.back() - from.front());
  const Line line{slope, first - slope * from.front()};
  const double largest = std::max(std::abs(first), std::abs(last)) +
                         std::abs(slope) * std::max(std::abs(from.front()), std::abs(from.back()));
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double wanted = reversed ? to[to.size() - 1 - i] : to[i];
    if (std::abs(line.slope * from[i] + line.offset - wanted) > kSameParameter * largest) return {};
  }
  return line;
}

std::optional<ChartMap> map_between(const BezierSurface& a, const BezierSurface& b,
                                    const Turn& turn) {
  const bool laws_agree = turn.exchanged ? a.u_law == b.v_law && a.v_law == b.u_law
                                         : a.u_law == b.u_law && a.v_law == b.v_law;
  if (!laws_agree) return {};
  const auto of_u =
      line_between(a.u_knots, turn.exchanged ? b.v_knots : b.u_knots, turn.reversed_u);
  const auto of_v =
      line_between(a.v_knots, turn.exchanged ? b.u_knots : b.v_knots, turn.reversed_v);
  if (!of_u || !of_v) return {};
  ChartMap map{turn.exchanged, {of_u->slope, of_v->slope}, {of_u->offset, of_v->offset}};
  if (turn.exchanged) map = {true, {of_v->slope, of_u->slope}, {of_v->offset, of_u->offset}};
  return map;
}

// What the control points of two surfaces differ by.
struct Difference {
  double points = 0;
  double least_ratio = kInfinity;  // of weights
  double most_ratio = 0;
  double coordinate = 0;  // the largest one
  bool same_bits = true;

  void add(const Vec4& p, const Vec4& q) {
    const Vec3 x = projected(p), y = projected(q);
    points = std::max(points, distance(x, y));
    least_ratio = std::min(least_ratio, q[3] / p[3]);
    most_ratio = std::max(most_ratio, q[3] / p[3]);
    for (int k = 0; k < 3; ++k) coordinate = std::max(coordinate, std::abs(x[k]));
    same_bits = same_bits && p == q;
  }

  double bound() const {
    if (same_bits) return 0;
    const double weights = most_ratio / least_ratio - 1;
    const double size = 2 * std::sqrt(3.0) * coordinate;  // bounds the diagonal
    return points + weights * size + kRounding * coordinate;
  }
};

bool add(const RationalBezierPatch& p, const RationalBezierPatch& q, const Turn& turn,
         double within, Difference& sum) {
  if (!have_same_shape(turn, p.points, q.points)) return false;
  const int m = p.points.rows(), n = p.points.columns();
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const GridPlace at = turned(turn, i, j, m, n);
      sum.add(p.points(i, j), q.points(at.row, at.column));
      if (sum.points > within) return false;
    }
  return true;
}

std::optional<double> gap_between(const BezierSurface& a, const BezierSurface& b, const Turn& turn,
                                  double within) {
  if (!have_same_shape(turn, a.patches, b.patches)) return {};
  Difference difference;
  const int m = a.patches.rows(), n = a.patches.columns();
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const GridPlace at = turned(turn, i, j, m, n);
      if (!add(a.patches(i, j), b.patches(at.row, at.column), turn, within, difference)) return {};
    }
  if (!(difference.bound() <= within)) return {};
  return difference.bound() + a.error + b.error;
}

}  // namespace

std::optional<SurfaceMatch> match(const BezierSurface& a, const BezierSurface& b, double within) {
  for (const bool exchanged : {false, true})
    for (const bool reversed_u : {false, true})
      for (const bool reversed_v : {false, true}) {
        const Turn turn{exchanged, reversed_u, reversed_v};
        const std::optional<double> gap = gap_between(a, b, turn, within);
        if (!gap) continue;
        if (const auto map = map_between(a, b, turn)) return SurfaceMatch{*map, *gap};
      }
  return {};
}

}  // namespace blossom
