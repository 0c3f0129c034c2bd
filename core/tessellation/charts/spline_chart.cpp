// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tessellation/charts/spline_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/not_zero.h"
#include "core/forms/evaluation.h"
#include "core/math/index.h"
#include "core/math/matrix.h"
#include "core/math/spans.h"
#include "core/subdivision/patch_subdivision.h"
#include "core/subdivision/subdivision_matrix.h"
#include "core/tessellation/charts/cell_jets.h"
#include "core/tessellation/charts/joined_jet.h"
#include "core/tessellation/charts/quadratic_rest.h"
#include "core/tessellation/charts/thin_spans.h"

namespace blossom {
namespace {

constexpr int kMaxParts = 8;         // of a span, where it has few facets
constexpr int kMaxFineParts = 1000;  // of a span
constexpr double kMuchChange = 0.3;  // of the size of second derivatives, within a cell
constexpr double kMuchTurn = 0.3;    // likewise of first ones
// Of the size of second derivatives: what cells may add to the bounds of the facets in them. A
// choice: as many facets go along a direction as the root of the bound, so these are 2.5 % more.
constexpr double kBoundSlack = 0.05;
constexpr double kFacetsInCell = 4;   // along a direction: cells are not made smaller for that
constexpr int kMaxPatches = 6;        // of which the parts under a facet are asked
constexpr double kMinPart = 0x1p-30;  // of a span: facets are not narrower
constexpr double kNoBend = 0.2;       // of the wanted distance: it need not be known better
constexpr double kThin = 0.01;        // of the wanted distance: spans that move no more are none

int cell_at(const std::vector<double>& ends, double parameter) {
  return static_cast<int>(span_of(ends, parameter));
}

// Of a range in the cell k.
double width_in(const std::vector<double>& ends, int k, double low, double high) {
  return std::min(high, ends[index(k + 1)]) - std::max(low, ends[index(k)]);
}

std::pair<Vec2, Vec2> rectangle_of(const std::array<Vec2, 3>& corners) {
  Vec2 low = corners[0], high = low;
  for (const Vec2& corner : corners)
    for (int k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], corner[k]);
      high[k] = std::max(high[k], corner[k]);
    }
  return {low, high};
}

std::vector<double> even_cuts(int parts) {
  std::vector<double> cuts;
  for (int k = 0; k <= parts; ++k) cuts.push_back(static_cast<double>(k) / parts);
  return cuts;
}

// The patches as polynomials of the surface's own parameters; none if one is rational.
Grid<BezierPatch> polynomials_of(const BezierSurface& surface) {
  if (surface.u_law != ParameterLaw::Linear || surface.v_law != ParameterLaw::Linear) return {};
  Grid<BezierPatch> polynomials(surface.patches.rows(), surface.patches.columns());
  for (int i = 0; i < polynomials.rows(); ++i)
    for (int j = 0; j < polynomials.columns(); ++j) {
      const Grid<Vec4>& net = surface.patches(i, j).points;
      polynomials(i, j).points = Grid<Vec3>(net.rows(), net.columns());
      for (int k = 0; k < net.rows(); ++k)
        for (int l = 0; l < net.columns(); ++l) {
          if (net(k, l)[3] != net(0, 0)[3]) return {};
          polynomials(i, j).points(k, l) = projected(net(k, l));
        }
    }
  return polynomials;
}

// The parts of spans that a range covers; not told if they are more than kMaxPatches.
struct SpanParts {
  int first = 0, count = 0;
  std::array<CellSide, kMaxPatches> sides;

  SpanParts(const std::vector<double>& knots, ParameterLaw law, double low, double high)
      : first(cell_at(knots, low)) {
    count = std::max(first, cell_at(knots, std::nextafter(high, low))) - first + 1;
    for (int k = 0; k < count && count <= kMaxPatches; ++k) {
      const Interval span{knots[index(first + k)], knots[index(first + k + 1)]};
      // A part that is a point has no derivatives.
      const double least = kMinPart * length(span);
      const double from = std::clamp(low, span.from, span.to - least);
      const double to = std::clamp(high, from + least, span.to);
      sides[index(k)] = {
          span, law, {local_parameter(law, span, from), local_parameter(law, span, to)}};
    }
  }
};

// What cuts all patches of a row, or of a column.
struct SpanCut {
  Grid<double> matrix;

  const Grid<double>& of(int degree, const Interval& part) {
    if (matrix.rows() != degree + 1) matrix = subdivision_matrix(degree, part);
    return matrix;
  }
};

std::vector<PlacedNet> placed_nets(const Grid<BezierPatch>& patches, const SpanParts& in_u,
                                   const SpanParts& in_v) {
  const auto place = [](const CellSide& side) {
    return Interval{at(side.span, side.part.from), at(side.span, side.part.to)};
  };
  std::array<SpanCut, kMaxPatches> cuts_u, cuts_v;
  std::vector<PlacedNet> nets;
  nets.reserve(index(in_u.count * in_v.count));
  for (int i = 0; i < in_u.count; ++i)
    for (int j = 0; j < in_v.count; ++j) {
      const CellSide &side_u = in_u.sides[index(i)], &side_v = in_v.sides[index(j)];
      const BezierPatch& patch = patches(in_u.first + i, in_v.first + j);
      const Grid<double>& cut_u = cuts_u[index(i)].of(patch.degree_u(), side_u.part);
      const Grid<double>& cut_v = cuts_v[index(j)].of(patch.degree_v(), side_v.part);
      nets.push_back({{product_transposed(product(cut_u, patch.points), cut_v)},
                      place(side_u),
                      place(side_v)});
    }
  return nets;
}

struct Parts {
  int u = 1, v = 1;
};

int limited(double parts, double least, double most) {
  return static_cast<int>(std::clamp(std::ceil(parts), least, most));
}

// Of a patch in both directions. Along a direction there are no more than facets, over which cells
// are joined. Where there are many facets cells are small enough to bound most of them: asking each
// for its own rectangle costs as much as a cell.
Parts wanted_parts(const CellJet& whole, double h_u, double h_v, double fine) {
  const JetEnclosure& jet = whole.jet;
  const auto sum = [&](double uu, double uv, double vv) {
    return h_u * h_u * uu + 2 * h_u * h_v * uv + h_v * h_v * vv;
  };
  const double change = sum(norm(jet.uu.radius), norm(jet.uv.radius), norm(jet.vv.radius));
  const double size = sum(norm(jet.uu.centre), norm(jet.uv.centre), norm(jet.vv.centre));
  if (change + size <= 8 * kNoBend * fine) return {};
  const double turn =
      std::max(norm(whole.first_u.radius) / std::max(norm(whole.first_u.centre), kNotZero),
               norm(whole.first_v.radius) / std::max(norm(whole.first_v.centre), kNotZero));
  const double parts =
      std::max(change / std::max(kMuchChange * size, 8 * kNoBend * fine), turn / kMuchTurn);
  const auto finer = [&](double bend) {
    const double facets = std::sqrt(bend / (8 * fine));
    const int least = limited(std::min(parts, facets), 1, kMaxParts);
    return limited(
        std::min(change / (kBoundSlack * std::max(size, kNotZero)), facets / kFacetsInCell), least,
        kMaxFineParts);
  };
  const double twist = h_u * h_v * jet.uv.size();
  return {finer(h_u * h_u * jet.uu.size() + twist), finer(h_v * h_v * jet.vv.size() + twist)};
}

// By the surface's own parameters, by which the local ones have the derivatives u and v. Their
// second derivatives move along the surface alone.
CurvatureSample curvature_of(const PatchJet& jet, double u, double v) {
  const Vec3 n = unit(cross(jet.u, jet.v));
  return {std::abs(dot(n, jet.uu)) * u * u, std::abs(dot(n, jet.uv)) * u * v,
          std::abs(dot(n, jet.vv)) * v * v, norm(jet.u) * u, norm(jet.v) * v};
}

}  // namespace

SplineChart::SplineChart(const BezierSurface& surface, double fine) : surface_(surface) {
  validate(surface, "to be meshed");
  drop_thin_spans(surface_, kThin * fine);
  polynomials_ = polynomials_of(surface_);
  enclose(choose_cells(fine));
  find_jumps();
}

Vec2 SplineChart::clamped(const Vec2& uv) const {
  return {std::clamp(uv[0], surface_.u_knots.front(), surface_.u_knots.back()),
          std::clamp(uv[1], surface_.v_knots.front(), surface_.v_knots.back())};
}

PointNormal SplineChart::frame_at(const Vec2& uv) const {
  const Vec2 at = clamped(uv);
  const double u = at[0], v = at[1];
  const int i = cell_at(surface_.u_knots, u), j = cell_at(surface_.v_knots, v);
  const Interval span_u{surface_.u_knots[index(i)], surface_.u_knots[index(i + 1)]};
  const Interval span_v{surface_.v_knots[index(j)], surface_.v_knots[index(j + 1)]};
  const PatchJet jet = jet_at(surface_.patches(i, j), local_parameter(surface_.u_law, span_u, u),
                              local_parameter(surface_.v_law, span_v, v), 1);
  return {jet.point, unit(cross(jet.u, jet.v))};
}

Grid<CellJet> SplineChart::choose_cells(double fine) {
  const Grid<RationalBezierPatch>& patches = surface_.patches;
  Grid<CellJet> wholes(patches.rows(), patches.columns());
  u_parts_.assign(index(patches.rows()), 1);
  v_parts_.assign(index(patches.columns()), 1);
  for (int i = 0; i < patches.rows(); ++i)
    for (int j = 0; j < patches.columns(); ++j) {
      const Interval u{surface_.u_knots[index(i)], surface_.u_knots[index(i + 1)]};
      const Interval v{surface_.v_knots[index(j)], surface_.v_knots[index(j + 1)]};
      const CellJet& whole = wholes(i, j) =
          cell_jet(patches(i, j), {u, surface_.u_law, {0, 1}}, {v, surface_.v_law, {0, 1}});
      const Parts parts = wanted_parts(whole, length(u), length(v), fine);
      const bool bends_u = whole.jet.uu.size() + whole.jet.uv.size() > 0;
      const bool bends_v = whole.jet.vv.size() + whole.jet.uv.size() > 0;
      if (bends_u) u_parts_[index(i)] = std::max(u_parts_[index(i)], parts.u);
      if (bends_v) v_parts_[index(j)] = std::max(v_parts_[index(j)], parts.v);
    }
  const auto ends = [](const std::vector<double>& knots, ParameterLaw law,
                       const std::vector<int>& parts) {
    std::vector<double> result{knots.front()};
    for (std::size_t i = 0; i < parts.size(); ++i) {
      for (int k = 1; k < parts[i]; ++k)
        result.push_back(
            parameter_at(law, {knots[i], knots[i + 1]}, static_cast<double>(k) / parts[i]));
      result.push_back(knots[i + 1]);
    }
    return result;
  };
  u_ = ends(surface_.u_knots, surface_.u_law, u_parts_);
  v_ = ends(surface_.v_knots, surface_.v_law, v_parts_);
  return wholes;
}

// Fits have many more patches than facets where the deviation is large: most are one cell, and
// known.
void SplineChart::enclose(const Grid<CellJet>& wholes) {
  const int rows = static_cast<int>(u_.size()) - 1, columns = static_cast<int>(v_.size()) - 1;
  jets_ = Grid<JetEnclosure>(rows, columns);
  curvatures_ = Grid<CurvatureSample>(rows, columns);
  int first_row = 0;
  for (int i = 0; i < surface_.patches.rows(); first_row += u_parts_[index(i)], ++i) {
    const Interval u{surface_.u_knots[index(i)], surface_.u_knots[index(i + 1)]};
    const std::vector<double> u_cuts = even_cuts(u_parts_[index(i)]);
    int first_column = 0;
    for (int j = 0; j < surface_.patches.columns(); first_column += v_parts_[index(j)], ++j) {
      const Interval v{surface_.v_knots[index(j)], surface_.v_knots[index(j + 1)]};
      const std::vector<double> v_cuts = even_cuts(v_parts_[index(j)]);
      const RationalBezierPatch& patch = surface_.patches(i, j);
      const int parts_u = u_parts_[index(i)], parts_v = v_parts_[index(j)];
      const bool is_one = parts_u == 1 && parts_v == 1;
      Grid<RationalBezierPatch> cells;
      if (!is_one) cells = subdivide(patch, u_cuts, v_cuts);
      for (int k = 0; k < parts_u; ++k)
        for (int l = 0; l < parts_v; ++l) {
          const Interval part_u{u_cuts[index(k)], u_cuts[index(k + 1)]};
          const Interval part_v{v_cuts[index(l)], v_cuts[index(l + 1)]};
          const CellSide side_u{u, surface_.u_law, part_u}, side_v{v, surface_.v_law, part_v};
          jets_(first_row + k, first_column + l) =
              is_one ? wholes(i, j).jet : cell_jet(std::move(cells(k, l)), side_u, side_v).jet;
          const double s = at(part_u, 0.5), t = at(part_v, 0.5);
          curvatures_(first_row + k, first_column + l) =
              curvature_of(jet_at(patch, s, t, 2), 1 / parameter_derivative(surface_.u_law, u, s),
                           1 / parameter_derivative(surface_.v_law, v, t));
        }
    }
  }
}

// Arcs of one circle go on smoothly.
void SplineChart::find_jumps() {
  const Grid<RationalBezierPatch>& patches = surface_.patches;
  jumps_u_.assign(surface_.u_knots.size(), Vec3{});
  jumps_v_.assign(surface_.v_knots.size(), Vec3{});
  const auto side = [](const std::vector<double>& knots, ParameterLaw law, int i) {
    return CellSide{{knots[index(i)], knots[index(i + 1)]}, law, {0, 1}};
  };
  const auto raise = [](Vec3& most, const Vec3& jump) {
    for (int k = 0; k < 3; ++k) most[k] = std::max(most[k], jump[k]);
  };
  for (int i = 0; i < patches.rows(); ++i)
    for (int j = 0; j < patches.columns(); ++j) {
      const CellSide u = side(surface_.u_knots, surface_.u_law, i);
      const CellSide v = side(surface_.v_knots, surface_.v_law, j);
      if (i > 0 && u.law == ParameterLaw::Linear)
        raise(jumps_u_[index(i)],
              largest_jump_u(patches(i - 1, j), side(surface_.u_knots, u.law, i - 1), patches(i, j),
                             u));
      if (j > 0 && v.law == ParameterLaw::Linear)
        raise(jumps_v_[index(j)],
              largest_jump_v(patches(i, j - 1), side(surface_.v_knots, v.law, j - 1), patches(i, j),
                             v));
    }
}

JetEnclosure SplineChart::jet_of_cells(const Vec2& low, const Vec2& high) const {
  const int i0 = cell_at(u_, low[0]), j0 = cell_at(v_, low[1]);
  const int i1 = std::max(i0, cell_at(u_, std::nextafter(high[0], low[0])));
  const int j1 = std::max(j0, cell_at(v_, std::nextafter(high[1], low[1])));
  if (i0 == i1 && j0 == j1) return jets_(i0, j0);
  return joined_jet(
      i1 - i0 + 1, j1 - j0 + 1,
      [&](int i, int j) -> const JetEnclosure& { return jets_(i0 + i, j0 + j); },
      [&](int i) { return width_in(u_, i0 + i, low[0], high[0]); },
      [&](int j) { return width_in(v_, j0 + j, low[1], high[1]); });
}

// Over the rectangle round the corners, and no more.
// Of a polynomial surface the cells' second derivatives do: they only say by how much a height
// changes where the facet's points are moved within the surface.
std::optional<double> SplineChart::own_distance(const JetEnclosure& of_cells,
                                                const std::array<Vec2, 3>& corners,
                                                const Vec3& normal) const {
  const auto [low, high] = rectangle_of(corners);
  const std::vector<double>&u = surface_.u_knots, &v = surface_.v_knots;
  const SpanParts in_u(u, surface_.u_law, low[0], high[0]);
  const SpanParts in_v(v, surface_.v_law, low[1], high[1]);
  if (in_u.count * in_v.count > kMaxPatches) return {};
  if (polynomials_.rows() > 0)
    return blossom::facet_distance(of_cells, normal, corners,
                                   quadratic_rest(placed_nets(polynomials_, in_u, in_v)));
  std::vector<JetEnclosure> jets;
  for (int i = 0; i < in_u.count; ++i)
    for (int j = 0; j < in_v.count; ++j) {
      const CellSide &side_u = in_u.sides[index(i)], &side_v = in_v.sides[index(j)];
      const RationalBezierPatch& patch = surface_.patches(in_u.first + i, in_v.first + j);
      jets.push_back(cell_jet(sub_patch(patch, side_u.part, side_v.part), side_u, side_v).jet);
    }
  JetEnclosure jet = joined_jet(
      in_u.count, in_v.count,
      [&](int i, int j) -> const JetEnclosure& { return jets[index(i * in_v.count + j)]; },
      [&](int i) { return width_in(u, in_u.first + i, low[0], high[0]); },
      [&](int j) { return width_in(v, in_v.first + j, low[1], high[1]); });
  add_jumps(low, high, jet);
  return blossom::facet_distance(jet, normal, corners);
}

void SplineChart::add_jumps(const Vec2& low, const Vec2& high, JetEnclosure& jet) const {
  const auto add = [](const std::vector<double>& knots, const std::vector<Vec3>& jumps, double from,
                      double to, Vec3& sum) {
    auto knot = std::upper_bound(knots.begin(), knots.end(), from);
    for (; knot != knots.end() && *knot < to; ++knot)
      sum += jumps[static_cast<std::size_t>(knot - knots.begin())];
  };
  add(surface_.u_knots, jumps_u_, low[0], high[0], jet.jump_u);
  add(surface_.v_knots, jumps_v_, low[1], high[1], jet.jump_v);
}

JetEnclosure SplineChart::jet_over(const std::array<Vec2, 3>& corners) const {
  const auto [low, high] = rectangle_of(corners);
  JetEnclosure jet = jet_of_cells(low, high);
  add_jumps(low, high, jet);
  return jet;
}

double SplineChart::facet_distance(std::array<Vec2, 3> corners, const Vec3& normal,
                                   double wanted) const {
  for (Vec2& corner : corners) corner = clamped(corner);
  const JetEnclosure of_cells = jet_over(corners);
  const double known = blossom::facet_distance(of_cells, normal, corners);
  if (known <= wanted) return known;
  return std::min(known, own_distance(of_cells, corners, normal).value_or(known));
}

}  // namespace blossom
