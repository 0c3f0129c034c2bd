// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/balls/detail/ball_equations.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/errors.h"
#include "core/base/unbounded.h"
#include "core/blending/balls/limits.h"
#include "core/math/linear_solve.h"

namespace blossom {
namespace {

constexpr double kMinMinor = 1e-10;  // of F', columns relative to |S_u|: below, its rank is lost
constexpr double kSettled = 4 * 0x1p-52;  // a step, relative to a coordinate or its extent
constexpr double kAlmostSettled = 1e-9;   // then a step that is no smaller is rounding
constexpr int kMaxSteps = 25;
constexpr double kQuadratic = 1e-3;  // from steps that long Newton's method squares them
// A first step so short leaves its square times at most 1 / kQuadratic.
constexpr double kShortStep = 1e-9;
constexpr double kLostStep = 10;       // so long a one comes from a matrix without its rank
constexpr double kLongestStep = 0.25;  // of the extents, far from a solution
constexpr double kStray = 0.5;         // of the extents, beside a part while looking for a start

Vec3 normal_rate(const Vec3& rate, const Vec3& normal, double size) {
  return (rate - normal * dot(rate, normal)) * (1 / size);
}

constexpr double kNoNormal = 1e-14;  // sine of the angle between derivatives: its rounding

double triple(const Vec3& a, const Vec3& b, const Vec3& c) { return dot(cross(a, b), c); }

// F' without radii: its columns.
std::array<Vec3, 4> columns_of(const std::array<OffsetJet, 2>& jets) {
  return {jets[0].by_u, jets[0].by_v, -jets[1].by_u, -jets[1].by_v};
}

// The three rows of F', and the fourth.
SquareMatrix<4> matrix_of(const std::array<Vec3, 4>& columns, const Vec4& last) {
  SquareMatrix<4> m{};
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 3; ++i)
      m[static_cast<std::size_t>(i)][j] = columns[static_cast<std::size_t>(j)][i];
  m[3] = last;
  return m;
}

// The derivative of the distance of the centre, O_1, from a plane.
Vec4 plane_row(const Vec3& normal, const OffsetJet& o) {
  return {dot(normal, o.by_u), dot(normal, o.by_v), 0, 0};
}

double step_size(const Vec4& step, const Vec4& x, const Vec4& extents) {
  double size = 0;
  for (int k = 0; k < 4; ++k)
    size = std::max(size, std::abs(step[k]) / std::max(std::abs(x[k]), extents[k]));
  return size;
}

// Whether no step of Newton's method is left after two of these sizes: the one that would follow
// has K size^2, K = size / before^2. Before the first step there is none, and K is taken to be what
// it is at most where the method squares.
bool is_settled(double size, double before) {
  if (before == kUnbounded && size <= kShortStep) return true;
  if (size <= kSettled || (size < kAlmostSettled && size >= 0.5 * before)) return true;
  return before <= kQuadratic && size * size * size <= kSettled * before * before;
}

bool is_sound(const ChartRectangle& part, const BezierSurface& surface) {
  const auto inside = [](const Interval& range, const std::vector<double>& knots, bool closed) {
    const double slack = kRangeSlack * (knots.back() - knots.front());
    if (!(length(range) > 0)) return false;
    if (closed) return length(range) <= knots.back() - knots.front() + slack;
    return range.from >= knots.front() - slack && range.to <= knots.back() + slack;
  };
  return inside(part.u, surface.u_knots, surface.closed_u) &&
         inside(part.v, surface.v_knots, surface.closed_v);
}

// An edge E with the frame that `ball_track.h` has, and their derivatives by u.
std::optional<OffsetJet> pipe_jet(const BezierSurface& ruled, const ChartCell& cell, const Vec2& uv,
                                  double radius) {
  const PatchJet s = chart_jet(ruled, cell, {uv[0], 0}, 2);
  const double speed = norm(s.u);
  if (!(speed > 0)) return std::nullopt;
  const Vec3 t = s.u * (1 / speed), t_u = normal_rate(s.uu, t, speed);
  const double along = dot(s.v, t);
  const Vec3 w = s.v - along * t;
  if (!(norm(w) > kNoNormal * norm(s.v))) return std::nullopt;
  const Vec3 w_u = s.uv - (dot(s.uv, t) + dot(s.v, t_u)) * t - along * t_u;
  const Vec3 e1 = unit(w), e1_u = normal_rate(w_u, e1, norm(w));
  const Vec3 e2 = cross(t, e1), e2_u = cross(t_u, e1) + cross(t, e1_u);
  const double c = std::cos(uv[1]), d = std::sin(uv[1]);
  OffsetJet o{s.point, s.u, {}, c * e1 + d * e2, {}, {}, {}};
  o.offset = s.point + radius * o.normal;
  o.by_u = s.u + radius * (c * e1_u + d * e2_u);
  o.by_v = radius * (c * e2 - d * e1);
  o.determinant = dot(o.by_u, t) / speed;
  o.trace = 1 + o.determinant;
  o.sizes = {speed, radius};
  return o;
}

}  // namespace

std::optional<OffsetJet> offset_jet(const BezierSurface& surface, const ChartCell& cell,
                                    const Vec2& uv, int side, double radius) {
  const PatchJet s = chart_jet(surface, cell, uv, 2);
  const Vec3 across = cross(s.u, s.v);
  const double size = norm(across);
  if (!(size > kNoNormal * norm(s.u) * norm(s.v))) return std::nullopt;
  const Vec3 n = across * (1 / size);
  const Vec3 n_u = normal_rate(cross(s.uu, s.v) + cross(s.u, s.uv), n, size);
  const Vec3 n_v = normal_rate(cross(s.uv, s.v) + cross(s.u, s.vv), n, size);
  const double d = side * radius;
  OffsetJet o{s.point, s.u, s.v, side * n, s.point + d * n, s.u + d * n_u, s.v + d * n_v};
  o.determinant = triple(o.by_u, o.by_v, n) / size;
  o.trace = (triple(o.by_u, s.v, n) + triple(s.u, o.by_v, n)) / size;
  o.sizes = {norm(s.u), norm(s.v)};
  return o;
}

std::optional<OffsetJet> offset_jet(const BallSupport& support, const ChartCell& cell,
                                    const Vec2& uv, double radius) {
  if (support.is_edge) return pipe_jet(*support.surface, cell, uv, radius);
  return offset_jet(*support.surface, cell, uv, support.side, radius);
}

BallSystem::BallSystem(const std::array<BallSupport, 2>& supports, RadiusLaw law,
                       std::function<MovingPlane(double)> planes)
    : supports_(supports), law_(std::move(law)), planes_(std::move(planes)) {
  for (int k = 0; k < 2; ++k) {
    const ChartRectangle& part = supports_[static_cast<std::size_t>(k)].part;
    extents_[2 * k] = length(part.u);
    extents_[2 * k + 1] = length(part.v);
  }
}

std::optional<std::array<OffsetJet, 2>> BallSystem::jets(const Vec4& x, const BallCells& cells,
                                                         double radius) const {
  const auto one = [&](std::size_t k) {
    return offset_jet(supports_[k], cells[k], chart_of(x, static_cast<int>(k)), radius);
  };
  const auto a = one(0), b = one(1);
  if (!a || !b) return std::nullopt;
  return std::array{*a, *b};
}

std::optional<Vec4> BallSystem::rate(const Vec4& x, const BallCells& cells,
                                     double parameter) const {
  const auto o = jets(x, cells, law_.at(parameter).value);
  return o ? rate(*o, parameter) : std::nullopt;
}

std::optional<Vec4> BallSystem::rate(const std::array<OffsetJet, 2>& side, double parameter) const {
  const RadiusJet r = law_.at(parameter);
  std::array<Vec3, 4> columns = columns_of(side);
  if (planes_) {
    const MovingPlane plane = planes_(parameter);
    const Vec3 moved = -r.first * (side[0].normal - side[1].normal);
    const double last = dot(plane.point_rate - r.first * side[0].normal, plane.normal) -
                        dot(side[0].offset - plane.point, plane.normal_rate);
    Vec4 y{moved[0], moved[1], moved[2], last};
    if (!solve<4>(matrix_of(columns, plane_row(plane.normal, side[0])), y)) return std::nullopt;
    return y;
  }
  const std::array<double, 4> sizes{side[0].sizes[0], side[0].sizes[1], side[1].sizes[0],
                                    side[1].sizes[1]};
  for (std::size_t k = 0; k < 4; ++k) columns[k] *= 1 / sizes[k];
  const auto& c = columns;
  Vec4 kernel{triple(c[1], c[2], c[3]), -triple(c[0], c[2], c[3]), triple(c[0], c[1], c[3]),
              -triple(c[0], c[1], c[2])};
  if (!(max_norm(kernel) > kMinMinor)) return std::nullopt;
  for (int k = 0; k < 4; ++k) kernel[k] /= sizes[static_cast<std::size_t>(k)];
  const Vec3 first = side[0].u * kernel[0] + side[0].v * kernel[1],
             second = side[1].u * kernel[2] + side[1].v * kernel[3];
  const double speed = std::sqrt(0.5 * (dot(first, first) + dot(second, second)));
  if (!(speed > 0)) return std::nullopt;
  return kernel * (1 / speed);
}

std::optional<Vec4> BallSystem::solved(Vec4 x, const BallCells& cells, double parameter,
                                       const ChartPlane& plane) const {
  const double radius = law_.at(parameter).value;
  MovingPlane driven;
  if (planes_) driven = planes_(parameter);
  double before = kUnbounded;
  for (int step = 0; step < kMaxSteps; ++step) {
    const auto o = jets(x, cells, radius);
    if (!o) return std::nullopt;
    const std::array<OffsetJet, 2>& side = *o;
    const Vec3 f = side[0].offset - side[1].offset;
    const double last = planes_ ? dot(side[0].offset - driven.point, driven.normal)
                                : dot(plane.row, x) - plane.value;
    const Vec4 row = planes_ ? plane_row(driven.normal, side[0]) : plane.row;
    Vec4 dx{f[0], f[1], f[2], last};
    if (!solve<4>(matrix_of(columns_of(side), row), dx)) return std::nullopt;
    const double size = step_size(dx, x, extents_);
    if (!(size < kLostStep)) return std::nullopt;
    x -= dx;
    if (is_settled(size, before)) return x;
    before = size;
  }
  return std::nullopt;
}

// The shortest solution of F' x = f, relative to the extents.
bool BallSystem::shortest_step(std::array<Vec3, 4> columns, Vec3 f, Vec4& step) const {
  for (std::size_t k = 0; k < 4; ++k) columns[k] *= extents_[static_cast<int>(k)];
  SquareMatrix<3> squares{};
  for (std::size_t i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (const Vec3& c : columns) squares[i][j] += c[static_cast<int>(i)] * c[j];
  if (!solve<3>(squares, f)) return false;
  for (std::size_t k = 0; k < 4; ++k) step[static_cast<int>(k)] = dot(columns[k], f);
  return true;
}

std::optional<Vec4> BallSystem::nearest(Vec4 x) const {
  const double radius = law_.at(0).value;
  double before = kUnbounded;
  for (int step = 0; step < 2 * kMaxSteps; ++step) {
    const BallCells cells{cell_at(*supports_[0].surface, chart_of(x, 0)),
                          cell_at(*supports_[1].surface, chart_of(x, 1))};
    const auto o = jets(x, cells, radius);
    if (!o) return std::nullopt;
    Vec4 dx;
    if (!shortest_step(columns_of(*o), (*o)[0].offset - (*o)[1].offset, dx)) return std::nullopt;
    const double size = max_norm(dx);
    if (!std::isfinite(size)) return std::nullopt;
    if (size > kLongestStep) dx *= kLongestStep / size;
    for (int k = 0; k < 4; ++k) x[k] -= dx[k] * extents_[k];
    for (std::size_t k = 0; k < 2; ++k) {
      const Vec2 uv = chart_of(x, static_cast<int>(k));
      const ChartRectangle& part = supports_[k].part;
      const auto away = [](double t, const Interval& range) {
        return std::max(range.from - t, t - range.to) / length(range);
      };
      if (std::max(away(uv[0], part.u), away(uv[1], part.v)) > kStray) return std::nullopt;
    }
    if (size <= kSettled || (size < kAlmostSettled && size >= 0.5 * before)) return x;
    before = size;
  }
  return std::nullopt;
}

BallPoint BallSystem::ball(const Vec4& x, const Vec4& x_rate, const std::array<OffsetJet, 2>& side,
                           double parameter) const {
  const RadiusJet r = law_.at(parameter);
  BallPoint ball;
  ball.parameter = parameter;
  ball.radius = r.value;
  ball.radius_rate = r.first;
  for (int k = 0; k < 2; ++k) {
    const OffsetJet& jet = side[static_cast<std::size_t>(k)];
    BallContact& contact = ball.contacts[static_cast<std::size_t>(k)];
    contact.chart = chart_of(x, k);
    contact.chart_rate = chart_of(x_rate, k);
    contact.point = jet.point;
    contact.rate = jet.u * contact.chart_rate[0] + jet.v * contact.chart_rate[1];
    contact.normal = jet.normal;
    contact.determinant = jet.determinant;
    contact.trace = jet.trace;
    ball.centre += 0.5 * jet.offset;
    ball.centre_rate += 0.5 * (jet.by_u * contact.chart_rate[0] + jet.by_v * contact.chart_rate[1] +
                               r.first * jet.normal);
  }
  return ball;
}

void validate(const BallSupport& support, const char* name) {
  const auto refuse = [&](const char* cause) {
    throw InvalidInput(std::string("support ") + name + ": " + cause);
  };
  if (support.surface == nullptr) refuse("it has no surface");
  validate(*support.surface, name);
  if (support.side != 1 && support.side != -1) refuse("its side is neither 1 nor -1");
  if (!is_sound(support.part, *support.surface)) refuse("its part is empty or leaves the surface");
}

void validate_radius(double radius) {
  if (!(radius > 0) || !std::isfinite(radius))
    throw InvalidInput("the radius has to be positive and finite, got " + std::to_string(radius));
}

}  // namespace blossom
