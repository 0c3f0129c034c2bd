// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/fills/fill_conditions.h"

#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "core/math/binomial.h"
#include "core/math/functions/quadrature.h"

namespace blossom {
namespace {

/// Identity of a control point up to turns: role of its vertex; both roles of its edge, how many
/// sectors lie between them, and the place on it; or its place inside of a quad.
using PointKey = std::tuple<int, int, int, int, int>;

struct NamedPoint {
  PointKey key;
  int sector = 0;
};

NamedPoint vertex_name(const LayoutVertex& v) { return {{0, v.role, 0, 0, 0}, v.sector}; }

/// Point `at` of 0..degree on the edge from v to w, whose roles differ in every layout.
NamedPoint edge_name(LayoutVertex v, LayoutVertex w, int at, int degree, int centre) {
  if (v.role > w.role) {
    std::swap(v, w);
    at = degree - at;
  }
  const int between = w.role == centre ? 0 : w.sector - v.sector;
  return {{1, v.role, w.role, between, at}, v.sector};
}

NamedPoint name_of(const PolygonLayout& layout, int quad, int i, int j, int degree) {
  const auto& c = layout.quads[static_cast<std::size_t>(quad)].corners;
  const bool low_i = i == 0, high_i = i == degree, low_j = j == 0, high_j = j == degree;
  if ((low_i || high_i) && (low_j || high_j))
    return vertex_name(c[low_j ? (low_i ? 0 : 1) : (low_i ? 3 : 2)]);
  if (low_j) return edge_name(c[0], c[1], i, degree, layout.centre);
  if (high_i) return edge_name(c[1], c[2], j, degree, layout.centre);
  if (high_j) return edge_name(c[3], c[2], i, degree, layout.centre);
  if (low_i) return edge_name(c[0], c[3], j, degree, layout.centre);
  return {{2, quad, i, j, 0}, 0};
}

/// Place (i, j) of a point that is given by an edge of the quad.
std::array<int, 2> place_from(int edge, int along, int inwards, int degree) {
  switch (edge) {
    case 0: return {along, inwards};
    case 1: return {degree - inwards, along};
    case 2: return {degree - along, degree - inwards};
    default: return {inwards, degree - along};
  }
}

/// Patch derivatives at a place of an edge as linear forms in control points: by the parameter
/// along the edge and by the one into the quad.
class EdgeForms {
 public:
  /// t        parameter along the common direction
  /// reverse  whether the quad's own edge runs against that direction
  EdgeForms(const FillPoints& points, const QuadEdge& edge, double t, bool reverse)
      : points_(points), edge_(edge), sign_(reverse ? -1 : 1) {
    jet_ = bernstein_jet(points.degree, reverse ? 1 - t : t);
  }
  void along(FillRow& row, double factor) const { add(row, sign_ * factor, jet_.first, {1}); }
  void along_twice(FillRow& row, double factor) const { add(row, factor, jet_.second, {1}); }
  void across(FillRow& row, double factor) const {
    add(row, factor * points_.degree, jet_.value, {-1, 1});
  }
  void mixed(FillRow& row, double factor) const {
    add(row, sign_ * factor * points_.degree, jet_.first, {-1, 1});
  }
  void across_twice(FillRow& row, double factor) const {
    add(row, factor * points_.degree * (points_.degree - 1), jet_.value, {1, -2, 1});
  }

 private:
  void add(FillRow& row, double factor, const std::vector<double>& basis,
           const std::vector<double>& differences) const {
    if (factor == 0) return;
    for (std::size_t j = 0; j < differences.size(); ++j)
      for (std::size_t i = 0; i < basis.size(); ++i)
        row.terms.push_back({points_.at(edge_, static_cast<int>(i), static_cast<int>(j)),
                             factor * differences[j] * basis[i]});
  }

  const FillPoints& points_;
  QuadEdge edge_;
  double sign_;
  BernsteinJet jet_;
};

/// The frames of both quads at the place t of an edge.
struct EdgeFrame {
  Vec2 e, A, B, twist;  ///< twist = d^2 beta_a / de dA
};

EdgeFrame frame_at(const PolygonLayout& layout, const SharedQuadEdge& edge, double t) {
  const auto a = corners_from(layout, edge.a), b = corners_from(layout, edge.b);
  return {.e = a[1] - a[0],
          .A = (1 - t) * (a[3] - a[0]) + t * (a[2] - a[1]),
          .B = t * (b[3] - b[0]) + (1 - t) * (b[2] - b[1]),
          .twist = a[2] - a[1] - a[3] + a[0]};
}

/// Both rows are scaled so that the control point of b farthest from the edge has a factor of
/// Bernstein's size.
FillRow first_order_row(const FillPoints& points, const SharedQuadEdge& edge, const EdgeFrame& at,
                        double t) {
  FillRow row;
  const double scale = 1 / (cross(at.e, at.A) * points.degree);
  const EdgeForms a(points, edge.a, t, false), b(points, edge.b, t, true);
  a.along(row, scale * cross(at.A, at.B));
  a.across(row, scale * cross(at.B, at.e));
  b.across(row, 1.0 / points.degree);
  return row;
}

FillRow second_order_row(const FillPoints& points, const SharedQuadEdge& edge, const EdgeFrame& at,
                         double t) {
  FillRow row;
  row.second_order = true;
  const double area = cross(at.e, at.A);
  const double p = cross(at.B, at.A) / area, q = cross(at.e, at.B) / area;
  const double p1 = cross(at.twist, at.A) / area, q1 = cross(at.e, at.twist) / area;
  const double scale = 1.0 / (points.degree * (points.degree - 1));
  const EdgeForms a(points, edge.a, t, false), b(points, edge.b, t, true);
  b.across_twice(row, scale);
  a.along_twice(row, -scale * p * p);
  a.mixed(row, -scale * 2 * p * q);
  a.along(row, scale * 2 * p * q * p1);
  a.across(row, scale * 2 * p * q * q1);
  a.across_twice(row, -scale * q * q);
  return row;
}

double node(int k, int count) {
  return (1 - std::cos((2 * k + 1) * std::numbers::pi / (2 * count))) / 2;
}

void add_inner_rows(std::vector<FillRow>& rows, const PolygonLayout& layout,
                    const FillPoints& points, FillContinuity continuity) {
  for (const SharedQuadEdge& edge : layout.shared) {
    const int first = points.degree + 3, second = points.degree + 5;
    for (int k = 0; k < first; ++k) {
      const double t = node(k, first);
      rows.push_back(first_order_row(points, edge, frame_at(layout, edge, t), t));
    }
    if (continuity != FillContinuity::G2) continue;
    for (int k = 0; k < second; ++k) {
      const double t = node(k, second);
      rows.push_back(second_order_row(points, edge, frame_at(layout, edge, t), t));
    }
  }
}

void add_border_rows(std::vector<FillRow>& rows, const PolygonLayout& layout,
                     const FillPoints& points, int order) {
  const FillData data{points.degree, order};
  for (int half = 0; half < 2; ++half) {
    const QuadEdge& edge = layout.borders[static_cast<std::size_t>(half)];
    for (int i = 0; i <= points.degree; ++i) {
      const FillPoint p0 = points.at(edge, i, 0), p1 = points.at(edge, i, 1);
      rows.push_back({{{p0, -1}, {p1, 1}}, data.at(1, half, i), false});
      if (order < 2) continue;
      const FillPoint p2 = points.at(edge, i, 2);
      rows.push_back({{{p0, 1}, {p1, -2}, {p2, 1}}, data.at(2, half, i), true});
    }
  }
}

/// Second derivatives of f at (x, y) of a quad as linear forms in its control points:
///   D^2 Q = J^T D^2 f J + [[0, 1], [1, 0]] (f_x, f_y) . twist,   (f_x, f_y) = J^-T (Q_x, Q_y).
struct SecondForms {
  std::vector<double> xx, xy, yy;
  double area = 0;  ///< det J
};

SecondForms second_forms(const std::array<Vec2, 4>& c, const BernsteinJet& u, const BernsteinJet& v,
                         double x, double y) {
  const Vec2 bx = (1 - y) * (c[1] - c[0]) + y * (c[2] - c[3]);
  const Vec2 by = (1 - x) * (c[3] - c[0]) + x * (c[2] - c[1]);
  const Vec2 twist = c[2] - c[1] - c[3] + c[0];
  SecondForms forms;
  forms.area = cross(bx, by);
  // The plane's unit vectors are g bx + h by.
  const Vec2 g = Vec2{by[1], -by[0]} * (1 / forms.area), h = Vec2{-bx[1], bx[0]} * (1 / forms.area);
  const double tx = dot(g, twist), ty = dot(h, twist);
  for (std::size_t i = 0; i < u.value.size(); ++i)
    for (std::size_t j = 0; j < v.value.size(); ++j) {
      const double quu = u.second[i] * v.value[j], qvv = u.value[i] * v.second[j];
      const double quv =
          u.first[i] * v.first[j] - tx * u.first[i] * v.value[j] - ty * u.value[i] * v.first[j];
      const auto entry = [&](int r, int s) {
        return g[r] * g[s] * quu + (g[r] * h[s] + h[r] * g[s]) * quv + h[r] * h[s] * qvv;
      };
      forms.xx.push_back(entry(0, 0));
      forms.xy.push_back(entry(0, 1));
      forms.yy.push_back(entry(1, 1));
    }
  return forms;
}

struct WeightedNode {
  double x, weight;
};

std::vector<WeightedNode> kronrod_nodes() {
  std::vector<WeightedNode> nodes;
  for (std::size_t i = 0; i < quadrature::kNodes.size(); ++i)
    for (const double sign : {-1.0, 1.0})
      if (sign > 0 || quadrature::kNodes[i] != 0)
        nodes.push_back({0.5 + 0.5 * sign * quadrature::kNodes[i], 0.5 * quadrature::kWeights[i]});
  return nodes;
}

}  // namespace

const char* to_string(FillContinuity continuity) {
  switch (continuity) {
    case FillContinuity::G0: return "G0";
    case FillContinuity::G1: return "G1";
    case FillContinuity::G2: break;
  }
  return "G2";
}

FillPoint FillPoints::at(const QuadEdge& edge, int along, int inwards) const {
  const auto [i, j] = place_from(edge.edge, along, inwards, degree);
  FillPoint point = at(edge.quad, i, j);
  if (point.number != centre()) point.sector += edge.sector;
  return point;
}

FillPoints fill_points(const PolygonLayout& layout, int degree) {
  FillPoints result;
  result.degree = degree;
  result.quads = static_cast<int>(layout.quads.size());
  result.border = 2 * degree;
  std::map<PointKey, FillPoint> known;  // the number, and the sector in which the key has it
  const auto number_of = [&](const NamedPoint& named, int turn) {
    const auto [entry, fresh] =
        known.try_emplace(named.key, FillPoint{result.count, named.sector + turn});
    if (fresh) ++result.count;
    return FillPoint{entry->second.number, named.sector + turn - entry->second.sector};
  };
  for (int half = 0; half < 2; ++half)
    for (int k = 0; k < degree; ++k) {
      const QuadEdge& edge = layout.borders[static_cast<std::size_t>(half)];
      const auto [i, j] = place_from(edge.edge, k, 0, degree);
      number_of(name_of(layout, edge.quad, i, j, degree), edge.sector);
    }
  const NamedPoint centre = vertex_name({layout.centre, 0});
  std::vector<std::size_t> at_centre;
  for (int quad = 0; quad < result.quads; ++quad)
    for (int i = 0; i <= degree; ++i)
      for (int j = 0; j <= degree; ++j) {
        const NamedPoint named = name_of(layout, quad, i, j, degree);
        if (named.key == centre.key) at_centre.push_back(result.points.size());
        result.points.push_back(named.key == centre.key ? FillPoint{} : number_of(named, 0));
      }
  for (const std::size_t place : at_centre) result.points[place].number = result.count;
  ++result.count;
  return result;
}

std::vector<FillRow> fill_conditions(const PolygonLayout& layout, const FillPoints& points,
                                     FillContinuity continuity) {
  std::vector<FillRow> rows;
  add_inner_rows(rows, layout, points, continuity);
  add_border_rows(rows, layout, points, continuity == FillContinuity::G2 ? 2 : 1);
  return rows;
}

Grid<double> thin_plate(const PolygonLayout& layout, int quad, int degree) {
  const auto corners = corners_from(layout, {quad, 0, 0});
  const int count = (degree + 1) * (degree + 1);
  Grid<double> form(count, count);
  const std::vector<WeightedNode> nodes = kronrod_nodes();
  for (const WeightedNode& x : nodes)
    for (const WeightedNode& y : nodes) {
      const SecondForms f =
          second_forms(corners, bernstein_jet(degree, x.x), bernstein_jet(degree, y.x), x.x, y.x);
      const double weight = x.weight * y.weight * f.area;
      for (int i = 0; i < count; ++i)
        for (int j = 0; j <= i; ++j) {
          const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
          form(i, j) += weight * (f.xx[a] * f.xx[b] + 2 * f.xy[a] * f.xy[b] + f.yy[a] * f.yy[b]);
        }
    }
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < i; ++j) form(j, i) = form(i, j);
  return form;
}

BernsteinJet bernstein_jet(int degree, double t) {
  const auto values = [t](int n) {
    std::vector<double> result(static_cast<std::size_t>(n) + 1);
    for (int i = 0; i <= n; ++i)
      result[static_cast<std::size_t>(i)] =
          binomial(n, i) * std::pow(t, i) * std::pow(1 - t, n - i);
    return result;
  };
  // B'_i = n (b_(i-1) - b_i) with b of degree n - 1, and once more.
  const auto lifted = [](const std::vector<double>& lower) {
    const double n = static_cast<double>(lower.size());
    std::vector<double> result(lower.size() + 1);
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] = n * ((i > 0 ? lower[i - 1] : 0) - (i < lower.size() ? lower[i] : 0));
    return result;
  };
  return {values(degree), lifted(values(degree - 1)), lifted(lifted(values(degree - 2)))};
}

}  // namespace blossom
