// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/border_rows.h"

#include <algorithm>
#include <cstddef>

#include "core/math/binomial.h"

namespace blossom {
namespace {

/// Places on a border that are one.
constexpr double kSameBreak = 1e-9;

bool runs_along_v(SurfaceSide side) {
  return side == SurfaceSide::UMin || side == SurfaceSide::UMax;
}

bool is_at_end(SurfaceSide side) { return side == SurfaceSide::UMax || side == SurfaceSide::VMax; }

/// One patch behind a border: its points counted inwards from the border, then along it.
struct PatchView {
  const RationalBezierPatch& patch;
  SurfaceSide side;

  int along() const { return runs_along_v(side) ? patch.degree_v() : patch.degree_u(); }
  int inwards() const { return runs_along_v(side) ? patch.degree_u() : patch.degree_v(); }
  const Vec4& operator()(int depth, int k) const {
    const int i = is_at_end(side) ? inwards() - depth : depth;
    return runs_along_v(side) ? patch.points(i, k) : patch.points(k, i);
  }
};

const RationalBezierPatch& patch_behind(const BezierSurface& surface, SurfaceSide side, int span) {
  const Grid<RationalBezierPatch>& all = surface.patches;
  if (runs_along_v(side)) return all(is_at_end(side) ? all.rows() - 1 : 0, span);
  return all(span, is_at_end(side) ? all.columns() - 1 : 0);
}

/// Scales each span so that the weights continue those of the span before.
void align_weights(std::vector<BorderRows>& spans) {
  double weight = 1;
  for (BorderRows& rows : spans) {
    const double factor = weight / rows[0].front()[3];
    for (Row& row : rows)
      for (Vec4& point : row) point *= factor;
    weight = rows[0].back()[3];
  }
}

/// The rows of a patch behind a border; a step of its parameter outwards is `depth` long.
BorderRows rows_of(const PatchView& net, int order, double depth) {
  const int m = net.inwards();
  BorderRows rows;
  double factor = 1;
  for (int k = 0; k <= order; ++k) {
    Row& row = rows.emplace_back();
    for (int i = 0; i <= net.along(); ++i) {
      Vec4 difference;
      for (int j = 0; j <= std::min(k, m); ++j)
        difference += (j % 2 == 0 ? 1 : -1) * binomial(k, j) * net(j, i);
      row.push_back(factor * difference);
    }
    factor *= (m - k) / depth;
  }
  return rows;
}

/// The part of a row over [0, t] and the part over [t, 1], by de Casteljau.
struct Halves {
  Row left;
  Row right;
};

Halves halves(Row row, double t) {
  Halves parts{{row.front()}, {row.back()}};
  for (std::size_t left = row.size() - 1; left > 0; --left) {
    for (std::size_t i = 0; i < left; ++i) row[i] = (1 - t) * row[i] + t * row[i + 1];
    parts.left.push_back(row.front());
    parts.right.push_back(row[left - 1]);
  }
  std::reverse(parts.right.begin(), parts.right.end());
  return parts;
}

Row part_of(const Row& row, const Interval& t) {
  Row part = row;
  if (t.to < 1) part = halves(part, t.to).left;
  if (t.from > 0) part = halves(part, t.from / t.to).right;
  return part;
}

int span_at(const Border& border, double x) {
  const auto after = std::upper_bound(border.breaks.begin(), border.breaks.end(), x);
  const auto span = after - border.breaks.begin() - 1;
  return static_cast<int>(
      std::clamp<std::ptrdiff_t>(span, 0, static_cast<std::ptrdiff_t>(border.breaks.size()) - 2));
}

double local_at(const Border& border, int span, double x, double snap) {
  const double low = border.breaks[static_cast<std::size_t>(span)];
  const double high = border.breaks[static_cast<std::size_t>(span) + 1];
  if (x <= low + snap) return 0;
  if (x >= high - snap) return 1;
  return local_parameter(border.law, {at(border.range, low), at(border.range, high)},
                         at(border.range, x));
}

struct HomogeneousJet {
  Vec4 value;
  Vec4 derivative;
};

HomogeneousJet homogeneous_jet(Row row, double t) {
  const auto degree = static_cast<double>(row.size() - 1);
  for (std::size_t left = row.size() - 1; left > 1; --left)
    for (std::size_t i = 0; i < left; ++i) row[i] = (1 - t) * row[i] + t * row[i + 1];
  if (row.size() == 1) return {row[0], {}};
  return {(1 - t) * row[0] + t * row[1], degree * (row[1] - row[0])};
}

Vec3 derivative_in_space(const Vec4& vector, const Vec4& value) {
  const Vec4 difference = vector - (vector[3] / value[3]) * value;
  return Vec3{difference[0], difference[1], difference[2]} * (1 / value[3]);
}

}  // namespace

Border border_of(const BezierSurface& surface, SurfaceSide side, int order) {
  const bool along_v = runs_along_v(side);
  const std::vector<double>& along = along_v ? surface.v_knots : surface.u_knots;
  const std::vector<double>& inwards = along_v ? surface.u_knots : surface.v_knots;
  const ParameterLaw inward_law = along_v ? surface.u_law : surface.v_law;
  const Interval behind = is_at_end(side) ? Interval{inwards[inwards.size() - 2], inwards.back()}
                                          : Interval{inwards[0], inwards[1]};

  Border border;
  border.name = to_string(side);
  border.error = surface.error;
  border.rational = surface.rational;
  border.range = {along.front(), along.back()};
  border.law = along_v ? surface.v_law : surface.u_law;
  border.depth = length(behind);
  border.closed = along_v ? surface.closed_v : surface.closed_u;
  for (const double knot : along)
    border.breaks.push_back((knot - along.front()) / length(border.range));

  const double depth = parameter_derivative(inward_law, behind, is_at_end(side) ? 1 : 0);
  for (int span = 0; span + 1 < static_cast<int>(along.size()); ++span)
    border.spans.push_back(
        rows_of(PatchView{patch_behind(surface, side, span), side}, order, depth));
  align_weights(border.spans);
  return border;
}

void reverse(Border& border) {
  std::reverse(border.breaks.begin(), border.breaks.end());
  for (double& x : border.breaks) x = 1 - x;
  std::reverse(border.spans.begin(), border.spans.end());
  for (BorderRows& rows : border.spans)
    for (Row& row : rows) std::reverse(row.begin(), row.end());
  align_weights(border.spans);
}

BorderPiece piece_of(const Border& border, const Interval& x, double snap) {
  const bool backward = x.from > x.to;
  const Interval rising = backward ? Interval{x.to, x.from} : x;
  const int span = span_at(border, at(rising, 0.5));
  Interval local{local_at(border, span, rising.from, snap),
                 local_at(border, span, rising.to, snap)};
  BorderPiece piece{.rows = {}, .span = span, .local = local};
  for (const Row& row : border.spans[static_cast<std::size_t>(span)]) {
    piece.rows.push_back(part_of(row, local));
    if (backward) std::reverse(piece.rows.back().begin(), piece.rows.back().end());
  }
  if (backward) piece.local = {local.to, local.from};
  return piece;
}

Border restarted(const Border& border, double start) {
  Border result = border;
  result.breaks = {0};
  result.spans.clear();
  std::vector<double> cuts{start};
  for (const double x : border.breaks)
    if (x > start + kSameBreak) cuts.push_back(x);
  for (const double x : border.breaks)
    if (x > kSameBreak && x < start - kSameBreak) cuts.push_back(1 + x);
  cuts.push_back(1 + start);
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    const double turns = cuts[i - 1] >= 1 ? 1 : 0;
    result.spans.push_back(
        piece_of(border, {cuts[i - 1] - turns, cuts[i] - turns}, kSameBreak).rows);
    result.breaks.push_back(i + 1 == cuts.size() ? 1 : cuts[i] - start);
  }
  align_weights(result.spans);
  return result;
}

SpaceJet jet_at(const Row& row, double t) {
  const HomogeneousJet jet = homogeneous_jet(row, t);
  const Vec4& p = jet.value;
  return {projected(p), derivative_in_space(jet.derivative, p)};
}

Vec3 across_at(const Row& edge, const Row& across, double t) {
  return derivative_in_space(homogeneous_jet(across, t).value, homogeneous_jet(edge, t).value);
}

Vec3 point_at(const Border& border, double x) {
  const int span = span_at(border, x);
  return jet_at(border.spans[static_cast<std::size_t>(span)][0], local_at(border, span, x, 0))
      .point;
}

Row product(const std::vector<double>& factor, const Row& row) {
  const int n = static_cast<int>(factor.size()) - 1;
  const int m = static_cast<int>(row.size()) - 1;
  Row result(factor.size() + row.size() - 1);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= m; ++j) {
      const double share = binomial(n, i) * binomial(m, j) / binomial(n + m, i + j);
      result[static_cast<std::size_t>(i + j)] +=
          (share * factor[static_cast<std::size_t>(i)]) * row[static_cast<std::size_t>(j)];
    }
  return result;
}

Row raised(const Row& row, int degree) {
  const auto missing = static_cast<std::size_t>(degree + 1) - row.size();
  if (missing == 0) return row;
  return product(std::vector<double>(missing + 1, 1.0), row);
}

}  // namespace blossom
