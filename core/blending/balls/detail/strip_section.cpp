// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/balls/detail/strip_section.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/errors.h"
#include "core/blending/balls/chart_cell.h"

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

// The curvature of a support across the contact in a unit direction of its tangent plane, positive
// towards the ball.
double normal_curvature(const BallSupport& support, const BallContact& contact,
                        const Vec3& direction) {
  const BezierSurface& surface = *support.surface;
  const PatchJet s = chart_jet(surface, cell_at(surface, contact.chart), contact.chart, 2);
  const double uu = dot(s.u, s.u), uv = dot(s.u, s.v), vv = dot(s.v, s.v);
  const double u = dot(s.u, direction), v = dot(s.v, direction), det = uu * vv - uv * uv;
  const double a = (u * vv - v * uv) / det, b = (v * uu - u * uv) / det;
  return dot(s.uu * (a * a) + s.uv * (2 * a * b) + s.vv * (b * b), contact.normal);
}

// Quintic with the circle's ends and tangents, their length that of the arc, and second derivatives
// with the surfaces' curvatures.
void add_curvature_rows(const BallTrack& track, const BallPoint& ball,
                        const CharacteristicCircle& circle, std::array<Vec4, kMaxRows>& rows) {
  const Vec3 &e1 = circle.to_contact[0], &e2 = circle.to_contact[1];
  const double cosine = std::clamp(dot(e1, e2), -1.0, 1.0),
               length = circle.radius * std::acos(cosine);
  for (std::size_t k = 0; k < 2; ++k) {
    const BallContact& contact = ball.contacts[k];
    const Vec3 inwards = k == 0 ? unit(e2 - e1 * cosine) : unit(e1 - e2 * cosine);
    const double bend = normal_curvature(track.supports()[k], contact, inwards);
    const Vec3 second = contact.normal * (bend * length * length);
    const Vec3 next = contact.point + inwards * (length / 5);
    const Vec3 third = 2 * next - contact.point + second * (1.0 / 20);
    rows[k == 0 ? 0 : 5] = weighted(contact.point, 1);
    rows[k == 0 ? 1 : 4] = weighted(next, 1);
    rows[k == 0 ? 2 : 3] = weighted(third, 1);
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
  if (form.kind == SectionKind::Curvature) {
    add_curvature_rows(track, ball, circle, rows);
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
