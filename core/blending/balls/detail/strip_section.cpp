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

// Weight and tangents' meeting point of the arc between two unit vectors.
Vec4 arc_middle(const CharacteristicCircle& circle, const Vec3& from, const Vec3& to) {
  const double cosine = dot(from, to);
  return weighted(circle.centre + (from + to) * (circle.radius / (1 + cosine)),
                  std::sqrt(0.5 * (1 + cosine)));
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
    case SectionKind::Circle: return halved ? 5 : 3;
    case SectionKind::Conic: return 3;
    case SectionKind::Curvature: return 6;
    case SectionKind::Chamfer: return 2;
  }
  return 0;
}

int SectionForm::degree() const { return halved ? 2 : rows() - 1; }

bool SectionForm::has_weight(int row) const {
  return (kind == SectionKind::Circle || kind == SectionKind::Conic) && row % 2 == 1;
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
  if (!form.halved) {
    rows[1] = arc_middle(circle, e1, e2);
    // The weight rho / (1 - rho) moves the shoulder to rho of the way to the tangents' meeting.
    if (form.kind == SectionKind::Conic)
      rows[1] = weighted(projected(rows[1]), form.rho / (1 - form.rho));
    return rows;
  }
  const Vec3 sum = e1 + e2;
  const Vec3 middle = norm(sum) > kOpposite ? unit(sum) : unit(cross(ball.centre_rate, e1));
  rows[1] = arc_middle(circle, e1, middle);
  rows[2] = weighted(circle.centre + circle.radius * middle, 1);
  rows[3] = arc_middle(circle, middle, e2);
  return rows;
}

Vec3 section_point(const std::array<Vec4, kMaxRows>& rows, const SectionForm& form, double v) {
  std::size_t from = 0;
  if (form.halved) {
    from = v < 0.5 ? 0 : 2;
    v = v < 0.5 ? 2 * v : 2 * v - 1;
  }
  std::array<Vec4, kMaxRows> p{};
  const auto degree = static_cast<std::size_t>(form.degree());
  std::copy_n(rows.begin() + static_cast<std::ptrdiff_t>(from), degree + 1, p.begin());
  for (std::size_t count = degree; count > 0; --count)
    for (std::size_t i = 0; i < count; ++i) p[i] = (1 - v) * p[i] + v * p[i + 1];
  return projected(p[0]);
}

}  // namespace blossom
