// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/nets/pieces.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/base/tolerances.h"
#include "core/blossom/curve_blossom.h"
#include "core/blossom/patch_blossom.h"
#include "core/blossom/triangle_conversion.h"
#include "core/forms/algebra/conversion.h"
#include "core/subdivision/curve_subdivision.h"
#include "core/subdivision/patch_subdivision.h"
#include "core/subdivision/triangle_subdivision.h"

namespace blossom::nets {
namespace {

Net with_value(const Net& net, NetValue value) {
  Net result = net;
  result.value = std::move(value);
  return result;
}

bool is_span(const Net& net) { return net.source.face > 0 || net.source.edge > 0; }

// Rounding leaves the weights of polynomial forms a little beside 1; others have to stay positive.
void settle_weights(const Net& net, std::span<Vec4> points) {
  for (Vec4& p : points) {
    if (!net.rational) p[3] = 1;
    if (!(p[3] > 0)) throw occt::BadModel("a weight of the piece is not positive");
  }
}

// The parameter of a span, from 0 to 1, at the source's parameter.
double local(ParameterLaw law, const Interval& span, double x) {
  if (x == span.from) return 0;
  return x == span.to ? 1 : local_parameter(law, span, x);
}
Interval local(ParameterLaw law, const Interval& span, const Interval& part) {
  return {local(law, span, part.from), local(law, span, part.to)};
}
// The part of a span inside of a wanted interval; empty if there is none.
std::optional<Interval> clipped(const Net& net, const Interval& span, const Interval& wanted) {
  if (!is_span(net)) return wanted;
  const Interval part{std::clamp(wanted.from, span.from, span.to),
                      std::clamp(wanted.to, span.from, span.to)};
  if (part.from == part.to) return std::nullopt;
  return part;
}

std::vector<double> equal_cuts(int levels) {
  const int count = 1 << levels;
  std::vector<double> cuts;
  for (int k = 0; k <= count; ++k) cuts.push_back(static_cast<double>(k) / count);
  return cuts;
}

// Where the cuts of a part of a span lie in the source's parameters.
std::vector<double> places_of(const std::vector<double>& cuts, ParameterLaw law,
                              const Interval& span, const Interval& part) {
  const Interval inner = local(law, span, part);
  std::vector<double> places;
  for (const double t : cuts) places.push_back(parameter_at(law, span, at(inner, t)));
  places.front() = part.from;
  places.back() = part.to;
  return places;
}

// ---- curves

// The Bezier points on an interval.
RationalBezierCurve curve_on(const Net& net, const Interval& part) {
  RationalBezierCurve made;
  if (const auto* monomial = std::get_if<RationalMonomialCurve>(&net.value)) {
    made = bezier_points(*monomial, part);
  } else {
    const auto* q = std::get_if<QCurve>(&net.value);
    made = sub_curve(q ? bezier_form(*q) : std::get<RationalBezierCurve>(net.value),
                     local(net.u_law, net.u, part));
  }
  settle_weights(net, made.points);
  return made;
}

Net curve_piece(const Net& net, NetValue value, const Interval& place) {
  Net piece = with_value(net, std::move(value));
  piece.u = place;
  return piece;
}

std::vector<Net> q_curve_pieces(const Net& net, const Interval& part, const Cut& cut) {
  const auto* given = std::get_if<QCurve>(&net.value);
  const bool same = given && given->q == *cut.q && part == given->interval;
  const QCurve curve = same ? *given : q_bezier_form(curve_on(net, part), part, *cut.q);
  std::vector<Net> result;
  for (QCurve& piece : midpoint_pieces(curve, cut.levels)) {
    if (!net.rational) settle_weights(net, piece.points);
    const Interval place = piece.interval;
    result.push_back(curve_piece(net, std::move(piece), place));
  }
  return result;
}

std::vector<Net> curve_pieces(const Net& net, const Cut& cut) {
  if (cut.rectangle || cut.triangle)
    throw InvalidInput("it is a curve; pieces of it take an interval");
  const auto part = clipped(net, net.u, cut.interval.value_or(net.u));
  if (!part) return {};
  if (cut.q) return q_curve_pieces(net, *part, cut);

  const std::vector<double> cuts = equal_cuts(cut.levels);
  const std::vector<double> at_u = places_of(cuts, net.u_law, net.u, *part);
  std::vector<RationalBezierCurve> cells = subdivide(curve_on(net, *part), cuts);
  std::vector<Net> result;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    settle_weights(net, cells[k].points);
    result.push_back(curve_piece(net, std::move(cells[k]), {at_u[k], at_u[k + 1]}));
  }
  return result;
}

// ---- patches

RationalBezierPatch patch_on(const Net& net, const Interval& u, const Interval& v) {
  RationalBezierPatch made;
  if (const auto* monomial = std::get_if<RationalMonomialPatch>(&net.value)) {
    made = bezier_points(*monomial, u, v);
  } else {
    const auto* q = std::get_if<QPatch>(&net.value);
    made = sub_patch(q ? bezier_form(*q) : std::get<RationalBezierPatch>(net.value),
                     local(net.u_law, net.u, u), local(net.v_law, net.v, v));
  }
  settle_weights(net, made.points.values());
  return made;
}

Net patch_piece(const Net& net, NetValue value, const Interval& u, const Interval& v) {
  Net piece = with_value(net, std::move(value));
  piece.u = u;
  piece.v = v;
  return piece;
}

void add_quadrants(const Net& net, QPatch patch, int levels, const Stop& stop,
                   std::vector<Net>& result) {
  ask(stop);
  if (levels == 0) {
    if (!net.rational) settle_weights(net, patch.points.values());
    const Interval u = patch.u, v = patch.v;
    return result.push_back(patch_piece(net, std::move(patch), u, v));
  }
  const Grid<QPatch> quadrants = subdivide(patch, at(patch.u, 0.5), at(patch.v, 0.5));
  for (const QPatch& quadrant : quadrants.values())
    add_quadrants(net, quadrant, levels - 1, stop, result);
}

std::vector<Net> q_patch_pieces(const Net& net, const Interval& u, const Interval& v,
                                const Cut& cut) {
  const auto* given = std::get_if<QPatch>(&net.value);
  const bool same =
      given && given->q == *cut.q && given->r == *cut.q && u == given->u && v == given->v;
  std::vector<Net> result;
  add_quadrants(net, same ? *given : q_bezier_form(patch_on(net, u, v), u, v, *cut.q, *cut.q),
                cut.levels, cut.stop, result);
  return result;
}

std::vector<Net> rectangle_pieces(const Net& net, const Cut& cut) {
  const auto rectangle = cut.rectangle.value_or(std::array{net.u, net.v});
  const auto u = clipped(net, net.u, rectangle[0]), v = clipped(net, net.v, rectangle[1]);
  if (!u || !v) return {};
  if (cut.q) return q_patch_pieces(net, *u, *v, cut);

  const std::vector<double> cuts = equal_cuts(cut.levels);
  const std::vector<double> at_u = places_of(cuts, net.u_law, net.u, *u),
                            at_v = places_of(cuts, net.v_law, net.v, *v);
  std::vector<Net> result;
  Grid<RationalBezierPatch> cells = subdivide(patch_on(net, *u, *v), cuts, cuts);
  for (int i = 0; i < cells.rows(); ++i)
    for (int j = 0; j < cells.columns(); ++j) {
      settle_weights(net, cells(i, j).points.values());
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      result.push_back(
          patch_piece(net, std::move(cells(i, j)), {at_u[a], at_u[a + 1]}, {at_v[b], at_v[b + 1]}));
    }
  return result;
}

// ---- triangles

using Polygon = std::vector<Vec2>;

// The part of a convex polygon where coordinate k is on the inner side of a bound.
Polygon half_of(const Polygon& polygon, int k, double bound, bool below) {
  const auto inside = [&](const Vec2& p) { return below ? p[k] <= bound : p[k] >= bound; };
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[(i + 1) % polygon.size()];
    if (inside(a)) result.push_back(a);
    if (inside(a) == inside(b)) continue;
    Vec2 crossing = a + (b - a) * ((bound - a[k]) / (b[k] - a[k]));
    crossing[k] = bound;
    if (crossing != a && crossing != b) result.push_back(crossing);
  }
  return result;
}

double doubled_area(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// The triangles that make up the part of a triangle over the span.
std::vector<TriangleCorners> clipped(const Net& net, const TriangleCorners& corners) {
  if (!is_span(net)) return {corners};
  Polygon polygon(corners.begin(), corners.end());
  for (const auto& [k, span] : {std::pair{0, net.u}, std::pair{1, net.v}})
    polygon = half_of(half_of(polygon, k, span.from, false), k, span.to, true);
  std::vector<TriangleCorners> result;
  for (std::size_t i = 2; i < polygon.size(); ++i)
    if (doubled_area(polygon[0], polygon[i - 1], polygon[i]) != 0)
      result.push_back({polygon[0], polygon[i - 1], polygon[i]});
  return result;
}

// Every triangle into four by the middles of its sides.
std::vector<TriangleCorners> quartered(std::vector<TriangleCorners> triangles, int levels) {
  for (int level = 0; level < levels; ++level) {
    std::vector<TriangleCorners> next;
    for (const auto& [a, b, c] : triangles) {
      const Vec2 ab = (a + b) * 0.5, bc = (b + c) * 0.5, ca = (c + a) * 0.5;
      next.insert(next.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {bc, ca, ab}});
    }
    triangles = std::move(next);
  }
  return triangles;
}

// The parameters in which the net's value is given: those of the patch from 0 to 1, or the
// barycentric coordinates of the triangle.
Vec2 local_point(const Net& net, const Vec2& p) {
  if (!is_triangle(net)) return {local(net.u_law, net.u, p[0]), local(net.v_law, net.v, p[1])};
  const auto& [a, b, c] = net.corners;
  const double whole = doubled_area(a, b, c);
  if (whole == 0) throw occt::BadModel("its corners lie on one line");
  return {doubled_area(p, b, c) / whole, doubled_area(a, p, c) / whole};
}

RationalBezierTriangle triangle_on(const Net& net, const RationalBezierPatch* patch,
                                   const TriangleCorners& corners) {
  const TriangleCorners inner = {local_point(net, corners[0]), local_point(net, corners[1]),
                                 local_point(net, corners[2])};
  RationalBezierTriangle made =
      patch ? sub_triangle(*patch, inner)
            : sub_triangle(std::get<RationalBezierTriangle>(net.value), inner);
  settle_weights(net, made.points);
  return made;
}

// Those of a patch are cut from its Bezier form, which is made once.
std::vector<Net> triangles_on(const Net& net, const std::vector<TriangleCorners>& triangles,
                              const Stop& stop) {
  RationalBezierPatch patch;
  if (!is_triangle(net) && !triangles.empty()) patch = patch_on(net, net.u, net.v);
  std::vector<Net> result;
  for (const TriangleCorners& corners : triangles) {
    ask(stop);
    result.push_back(
        with_value(net, triangle_on(net, is_triangle(net) ? nullptr : &patch, corners)));
    result.back().corners = corners;
  }
  return result;
}

std::vector<Net> triangle_pieces(const Net& net, const Cut& cut) {
  if (cut.q) throw InvalidInput("(q1,q2)-forms are of curves and patches, not of triangles");
  if (is_triangle(net) && !cut.triangle && cut.levels == 0) return {net};
  const TriangleCorners& place = cut.triangle ? *cut.triangle : net.corners;
  return triangles_on(net, quartered(clipped(net, place), cut.levels), cut.stop);
}

std::vector<Net> surface_pieces(const Net& net, const Cut& cut) {
  if (cut.interval) throw InvalidInput("it is a surface; an interval goes with curves");
  if (cut.triangle) return triangle_pieces(net, cut);
  if (!is_triangle(net)) return rectangle_pieces(net, cut);
  if (cut.rectangle) throw InvalidInput("it is a triangle; pieces of it take a triangle");
  return triangle_pieces(net, cut);
}

// The same triangle with the corners in the order b, c, a.
RationalBezierTriangle rotated(const RationalBezierTriangle& triangle) {
  RationalBezierTriangle result = triangle;
  for (int nu = 0; nu <= triangle.degree; ++nu)
    for (int mu = 0; mu <= triangle.degree - nu; ++mu)
      result(nu, mu) = triangle(triangle.degree - nu - mu, nu);
  return result;
}

// Whether the side from a to b is a point.
bool is_point_ab(const RationalBezierTriangle& triangle) {
  const Vec4& first = triangle(0, triangle.degree);
  for (int nu = 1; nu <= triangle.degree; ++nu) {
    const Vec4& p = triangle(nu, triangle.degree - nu);
    if (max_norm(p * first[3] - first * p[3]) > Tolerances{}.point * p[3] * first[3]) return false;
  }
  return true;
}

// ---- other forms

double middle(double from, double to, double centre) { return from + (to - from) * centre; }

RationalMonomialPatch monomial_of(const RationalBezierPatch& patch, const Net& net) {
  RationalMonomialPatch made = monomial_form(patch);
  made.centre_u = middle(net.u.from, net.u.to, made.centre_u);
  made.centre_v = middle(net.v.from, net.v.to, made.centre_v);
  made.scale_u *= length(net.u);
  made.scale_v *= length(net.v);
  return made;
}

RationalMonomialCurve monomial_of(const RationalBezierCurve& curve, const Net& net) {
  RationalMonomialCurve made = monomial_form(curve);
  made.centre = middle(net.u.from, net.u.to, made.centre);
  made.scale *= length(net.u);
  return made;
}

}  // namespace

Cut cut_of(const CutNumbers& numbers, int levels) {
  const auto& [i, r, t, q] = numbers;
  Cut cut;
  cut.levels = levels;
  if (!i.empty()) cut.interval = Interval{i[0], i[1]};
  if (!r.empty()) cut.rectangle = {Interval{r[0], r[1]}, Interval{r[2], r[3]}};
  if (!t.empty()) cut.triangle = {Vec2{t[0], t[1]}, Vec2{t[2], t[3]}, Vec2{t[4], t[5]}};
  if (!q.empty()) cut.q = QParameters{q[0], q[1]};
  return cut;
}

double piece_count(const Net& net, const Cut& cut) {
  const double directions = is_curve(net) ? 1 : 2;
  const double triangles = cut.triangle && is_span(net) ? 5 : 1;  // a heptagon's at most
  return triangles * std::exp2(directions * cut.levels);
}

std::vector<Net> pieces(const Net& net, const Cut& cut) {
  ask(cut.stop);
  return named(net.source,
               [&] { return is_curve(net) ? curve_pieces(net, cut) : surface_pieces(net, cut); });
}

Net bezier_net(const Net& net) {
  if (is_triangle(net)) return net;
  return named(net.source, [&]() -> Net {
    if (is_curve(net)) return with_value(net, curve_on(net, net.u));
    return with_value(net, patch_on(net, net.u, net.v));
  });
}

Net monomial_net(const Net& net) {
  return named(net.source, [&]() -> Net {
    if (is_curve(net)) return with_value(net, monomial_of(curve_on(net, net.u), net));
    if (is_triangle(net)) {
      Net made = with_value(net, monomial_form(std::get<RationalBezierTriangle>(net.value)));
      made.u = made.v = {0, 1};
      return made;
    }
    return with_value(net, monomial_of(patch_on(net, net.u, net.v), net));
  });
}

std::vector<Net> triangle_nets(const Net& net) {
  if (is_curve(net))
    throw occt::BadModel(text_of(net.source) + ": a curve cannot become triangles");
  if (is_triangle(net)) return {net};
  const auto& [u0, u1] = net.u;
  const auto& [v0, v1] = net.v;
  const std::vector<TriangleCorners> halves = {{Vec2{u0, v0}, Vec2{u1, v0}, Vec2{u0, v1}},
                                               {Vec2{u1, v1}, Vec2{u0, v1}, Vec2{u1, v0}}};
  return named(net.source, [&] { return triangles_on(net, halves, {}); });
}

Net collapsed_net(const Net& net) {
  return named(net.source, [&] {
    RationalBezierTriangle triangle = std::get<RationalBezierTriangle>(net.value);
    // Collapsed sides beside each other would make a face that does not survive a STEP file.
    for (int k = 0; k < 2 && !is_point_ab(triangle); ++k) triangle = rotated(triangle);
    if (!is_point_ab(triangle)) triangle = rotated(triangle);
    RationalBezierPatch patch = collapsed_patch(triangle);
    settle_weights(net, patch.points.values());
    return with_value(net, std::move(patch));
  });
}

}  // namespace blossom::nets
