// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/balls/detail/strip_section.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/errors.h"
#include "core/blending/balls/chart_cell.h"
#include "core/blossom/composition.h"
#include "core/forms/evaluation.h"

namespace blossom {
namespace {

constexpr double kOpposite = 1e-12;  // |e_1 + e_2| below: the arc's middle is across the spine

Vec4 weighted(const Vec3& x, double w) { return {w * x[0], w * x[1], w * x[2], w}; }

// Weight and tangents' meeting point of the arc.
Vec4 arc_middle(const CharacteristicCircle& circle) {
  const auto& [from, to] = circle.to_contact;
  const double cosine = dot(from, to);
  return weighted(circle.centre + (from + to) * (circle.radius / (1 + cosine)),
                  std::sqrt(0.5 * (1 + cosine)));
}

// The arc of angle 4 a as c^2 / |c|^2 in the complex plane, where c has the control points 1,
// w e^(i a) and e^(2 i a). It is one polynomial span with positive weights also at 180 degrees, and
// w makes its speed at the ends that in the middle.
//
// middle   unit vector from the centre to the arc's middle
std::array<Vec4, 5> wide_arc(const CharacteristicCircle& circle, const Vec3& middle) {
  const Vec3& x = circle.to_contact[0];
  const double cosine = dot(x, middle);
  const Vec3 y = unit(middle - x * cosine);
  const double a = 0.5 * std::atan2(norm(cross(x, middle)), cosine);
  const double w = 0.5 * (std::sqrt(std::cos(a) * std::cos(a) + 8) - std::cos(a));
  const double inner = (1 + 2 * w * w) / 3;  // of c^2 the absolute control points are 1, w, this
  const auto row = [&](double turn, double size, double weight) {
    const Vec3 off = x * std::cos(turn) + y * std::sin(turn);
    const Vec3 point = circle.centre * weight + off * (circle.radius * size);
    return Vec4{point[0], point[1], point[2], weight};
  };
  const double near = w * std::cos(a), half = (std::cos(2 * a) + 2 * w * w) / 3;  // of |c|^2
  return {row(0, 1, 1), row(a, w, near), row(2 * a, inner, half), row(3 * a, w, near),
          row(4 * a, 1, 1)};
}

// How a support bends across the contact, positive towards the ball: the curvature of its normal
// section in a direction, and the derivative of that by the section's length.
struct SupportBend {
  double curvature = 0;
  double rate = 0;
};

// The third derivative along the line of local parameters from a point in a direction of them. It
// is taken over half a patch, where polynomials keep their size.
Vec3 third_derivative(const RationalBezierPatch& patch, const Vec2& from, const Vec2& way) {
  const double length = 0.5 / std::max(std::abs(way[0]), std::abs(way[1]));
  const RationalBezierCurve curve = on_segment(patch, from, from + length * way);
  const int n = curve.degree();
  const std::vector<Vec4>& p = curve.points;
  const Vec4 h1 = n * (p[1] - p[0]), h2 = (n * (n - 1.0)) * (p[2] - 2 * p[1] + p[0]);
  Vec4 h3{};
  if (n > 2) h3 = (n * (n - 1.0) * (n - 2.0)) * (p[3] - 3 * p[2] + 3 * p[1] - p[0]);
  // X / w and its derivatives, by the quotient rule.
  const double over = 1 / p[0][3];
  const Vec4 x0 = over * p[0], x1 = over * (h1 - h1[3] * x0);
  const Vec4 x2 = over * (h2 - (2 * h1[3]) * x1 - h2[3] * x0);
  const Vec4 x3 = over * (h3 - (3 * h1[3]) * x2 - (3 * h2[3]) * x1 - h3[3] * x0);
  return Vec3{x3[0], x3[1], x3[2]} * (1 / (length * length * length));
}

// With C(s) = S(x + a s + b s^2 / 2 + c s^3 / 6), S_x a the direction and b such that C'' is
// normal:
//
//   n.C'' = n.S_xx(a, a),   n.C''' = n.S_xxx(a, a, a) + 3 n.S_xx(a, b),   as n.S_x c = 0
SupportBend bend_across(const BallSupport& support, const BallContact& contact,
                        const Vec3& direction, bool with_rate) {
  const BezierSurface& surface = *support.surface;
  const ChartCell cell = cell_at(surface, contact.chart);
  const RationalBezierPatch& patch = surface.patches(cell.span[0], cell.span[1]);
  const Vec2 at{local_parameter(surface.u_law, range_of(surface, cell, 0), contact.chart[0]),
                local_parameter(surface.v_law, range_of(surface, cell, 1), contact.chart[1])};
  const PatchJet s = jet_at(patch, at[0], at[1], 2);
  const double uu = dot(s.u, s.u), uv = dot(s.u, s.v), vv = dot(s.v, s.v), det = uu * vv - uv * uv;
  const auto in_chart = [&](const Vec3& way) {
    const double u = dot(s.u, way), v = dot(s.v, way);
    return Vec2{(u * vv - v * uv) / det, (v * uu - u * uv) / det};
  };
  const auto second = [&](const Vec2& a, const Vec2& b) {
    return s.uu * (a[0] * b[0]) + s.uv * (a[0] * b[1] + a[1] * b[0]) + s.vv * (a[1] * b[1]);
  };
  const Vec3& n = contact.normal;
  const Vec2 a = in_chart(direction);
  const Vec3 along = second(a, a);
  SupportBend bend{dot(along, n), 0};
  if (with_rate)
    bend.rate = dot(third_derivative(patch, at, a), n) + 3 * dot(second(a, in_chart(-along)), n);
  return bend;
}

// A curve of degree 5 or 7 with the circle's ends and tangents, their length that of the arc, and
// the surfaces' curvatures; at degree 7 also the rates at which these change. By the length of a
// curve of curvature k, C'' = k n and C''' = k' n - k^2 t.
void add_curvature_rows(const BallTrack& track, const BallPoint& ball,
                        const CharacteristicCircle& circle, const SectionForm& form,
                        std::array<Vec4, kMaxRows>& rows) {
  const Vec3 &e1 = circle.to_contact[0], &e2 = circle.to_contact[1];
  const double cosine = std::clamp(dot(e1, e2), -1.0, 1.0),
               length = circle.radius * std::acos(cosine);
  const int n = form.degree();
  const bool with_rate = form.kind == SectionKind::CurvatureRate;
  for (std::size_t k = 0; k < 2; ++k) {
    const BallContact& contact = ball.contacts[k];
    const Vec3 inwards = k == 0 ? unit(e2 - e1 * cosine) : unit(e1 - e2 * cosine);
    const SupportBend bend = bend_across(track.supports()[k], contact, inwards, with_rate);
    const Vec3 first = inwards * (length / n);
    const Vec3 second = contact.normal * (bend.curvature * length * length / (n * (n - 1)));
    const auto row = [&](std::size_t i) -> Vec4& {
      return rows[k == 0 ? i : static_cast<std::size_t>(n) - i];
    };
    row(0) = weighted(contact.point, 1);
    row(1) = weighted(contact.point + first, 1);
    row(2) = weighted(contact.point + 2 * first + second, 1);
    if (!with_rate) continue;
    const Vec3 rate = contact.normal * bend.rate - inwards * (bend.curvature * bend.curvature);
    const Vec3 third = rate * (length * length * length / (n * (n - 1) * (n - 2)));
    row(3) = weighted(contact.point + 3 * first + 3 * second + third, 1);
  }
}

}  // namespace

CharacteristicCircle characteristic_circle(const BallPoint& ball) {
  CharacteristicCircle circle{ball.centre, ball.radius, {}};
  if (ball.radius_rate != 0) {
    const double speed = dot(ball.centre_rate, ball.centre_rate);
    const double ratio = ball.radius_rate * ball.radius_rate / speed;
    if (!(ratio < 1))
      throw InvalidInput("the balls have no envelope at parameter " +
                         std::to_string(ball.parameter) +
                         ": the radius grows as fast as the centre moves");
    circle.centre -= ball.centre_rate * (ball.radius * ball.radius_rate / speed);
    circle.radius *= std::sqrt(1 - ratio);
  }
  for (std::size_t k = 0; k < 2; ++k)
    circle.to_contact[k] = unit(ball.contacts[k].point - circle.centre);
  return circle;
}

int SectionForm::rows() const {
  switch (kind) {
    case SectionKind::Circle: return wide ? 5 : 3;
    case SectionKind::Conic: return 3;
    case SectionKind::Curvature: return 6;
    case SectionKind::CurvatureRate: return 8;
    case SectionKind::Chamfer: return 2;
  }
  return 0;
}

int SectionForm::degree() const { return rows() - 1; }

bool SectionForm::has_weight(int row) const {
  return (kind == SectionKind::Circle || kind == SectionKind::Conic) && row > 0 && row < degree();
}

std::array<Vec4, kMaxRows> section_rows(const BallTrack& track, const BallPoint& ball,
                                        const SectionForm& form) {
  const CharacteristicCircle circle = characteristic_circle(ball);
  const Vec3 &e1 = circle.to_contact[0], &e2 = circle.to_contact[1];
  std::array<Vec4, kMaxRows> rows{};
  if (takes_curvature(form.kind)) {
    add_curvature_rows(track, ball, circle, form, rows);
    return rows;
  }
  const auto last = static_cast<std::size_t>(form.rows()) - 1;
  rows[0] = weighted(ball.contacts[0].point, 1);
  rows[last] = weighted(ball.contacts[1].point, 1);
  if (form.kind == SectionKind::Chamfer) return rows;
  if (form.wide) {
    const Vec3 sum = e1 + e2;
    const std::array<Vec4, 5> arc =
        wide_arc(circle, norm(sum) > kOpposite ? unit(sum) : unit(cross(ball.centre_rate, e1)));
    std::copy_n(arc.begin() + 1, 3, rows.begin() + 1);
    return rows;
  }
  rows[1] = arc_middle(circle);
  // The weight rho / (1 - rho) moves the shoulder to rho of the way to the tangents' meeting.
  if (form.kind == SectionKind::Conic)
    rows[1] = weighted(projected(rows[1]), form.rho / (1 - form.rho));
  return rows;
}

Vec3 section_point(const std::array<Vec4, kMaxRows>& rows, const SectionForm& form, double v) {
  std::array<Vec4, kMaxRows> p = rows;
  for (auto count = static_cast<std::size_t>(form.degree()); count > 0; --count)
    for (std::size_t i = 0; i < count; ++i) p[i] = (1 - v) * p[i] + v * p[i + 1];
  return projected(p[0]);
}

}  // namespace blossom
