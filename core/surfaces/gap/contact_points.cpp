// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/gap/contact_points.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/unbounded.h"
#include "core/cells/cell_pair.h"
#include "core/forms/evaluation.h"
#include "core/surfaces/gap/newton.h"

namespace blossom {
namespace {

constexpr int kSteps = 24;
constexpr double kSettled = 1e-13;    // a step below this is rounding; fraction of a patch
constexpr double kStalled = 1e-9;     // so is one below this that no longer shrinks,
constexpr double kSlow = 1e-5;        // and the last of many, near singular points
constexpr double kMeet = 1e-13;       // relative: surfaces this close meet
constexpr double kDifference = 1e-5;  // step of a difference quotient; fraction of a patch

// How far Newton may lead, in lengths of the way an arm has left: from the arm's chord, and to
// another meeting point than the given one.
constexpr double kArmBend = 0.5;
constexpr double kArmReach = 2;
constexpr double kMinGrowth = 1e-2;  // of the fastest: what is slower has no sure direction

using Row = std::array<double, 5>;  // four derivatives, then minus the value
using System = std::array<Row, 4>;

// Gaussian elimination with partial pivoting; false if singular.
bool solve(System& m) {
  for (std::size_t c = 0; c < 4; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c + 1; r < 4; ++r)
      if (std::abs(m[r][c]) > std::abs(m[pivot][c])) pivot = r;
    if (m[pivot][c] == 0) return false;
    if (pivot != c) std::swap(m[c], m[pivot]);
    const double inverse = 1 / m[c][c];
    for (std::size_t r = c + 1; r < 4; ++r) {
      const double factor = m[r][c] * inverse;
      for (std::size_t k = c + 1; k < 5; ++k) m[r][k] -= factor * m[c][k];
    }
  }
  for (std::size_t r = 4; r-- > 0;) {
    for (std::size_t k = r + 1; k < 4; ++k) m[r][4] -= m[r][k] * m[k][4];
    m[r][4] /= m[r][r];
  }
  return true;
}

// `good` tells whether a point whose steps no longer shrink is a solution.
template <class Equations, class Good>
std::optional<Point4> newton(const Point4& start, double reach, const Equations& equations,
                             const Good& good) {
  Point4 x = start;
  double last = kUnbounded;
  for (int step = 0; step < kSteps; ++step) {
    System m = equations(x);
    if (!solve(m)) return std::nullopt;
    double largest = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      x[i] += m[i][4];
      if (!(std::abs(x[i] - start[i]) <= reach)) return std::nullopt;
      largest = std::max(largest, std::abs(m[i][4]));
    }
    // The next step is this one times the ratio, or less where they shrink ever faster.
    const double ratio = step == 0 ? 1 : std::min(largest / last, 1.0);
    const bool settled = largest * ratio < kSettled;
    const bool stalled =
        (largest < kStalled && largest > 0.25 * last) || (largest < kSlow && step + 1 == kSteps);
    if (settled || (stalled && good(x))) return x;
    last = largest;
  }
  return std::nullopt;
}

constexpr auto kAlways = [](const Point4&) { return true; };

Row plane_row(const Point4& plane, const Point4& start, const Point4& x) {
  Row row{plane[0], plane[1], plane[2], plane[3], 0};
  for (std::size_t i = 0; i < 4; ++i) row[4] -= plane[i] * (x[i] - start[i]);
  return row;
}

// Row k of A - B = apart.
Row coincidence_row(const PatchJet& p, const PatchJet& q, int k, const Vec3& apart = {}) {
  return {p.u[k], p.v[k], -q.u[k], -q.v[k], q.point[k] - p.point[k] + apart[k]};
}

// (A - B) . B_s = 0 and (A - B) . B_t = 0.
Row foot_row(const PatchJet& p, const PatchJet& q, bool along_s) {
  const Vec3 f = p.point - q.point;
  const Vec3 &d = along_s ? q.u : q.v, &ds = along_s ? q.uu : q.uv, &dt = along_s ? q.uv : q.vv;
  return {dot(p.u, d), dot(p.v, d), dot(f, ds) - dot(q.u, d), dot(f, dt) - dot(q.v, d), -dot(f, d)};
}

// A's derivative in the direction `across` lies in B's tangent plane.
Row tangency_row(const PatchJet& p, const PatchJet& q, const Vec2& across) {
  const Vec3 n = cross(q.u, q.v);
  const Vec3 ns = cross(q.uu, q.v) + cross(q.u, q.uv), nt = cross(q.uv, q.v) + cross(q.u, q.vv);
  const Vec3 d = p.u * across[0] + p.v * across[1];
  return {dot(p.uu * across[0] + p.uv * across[1], n), dot(p.uv * across[0] + p.vv * across[1], n),
          dot(d, ns), dot(d, nt), -dot(d, n)};
}

// It vanishes. Its derivatives are central differences: their error only slows Newton's method.
Row bend_row(const RationalBezierPatch& a, const RationalBezierPatch& b, const Point4& x,
             const Vec2& across) {
  Row row;
  for (std::size_t i = 0; i < 4; ++i) {
    Point4 before = x, after = x;
    before[i] -= kDifference;
    after[i] += kDifference;
    row[i] = (bend_between(a, b, after, across) - bend_between(a, b, before, across)) /
             (2 * kDifference);
  }
  row[4] = -bend_between(a, b, x, across);
  return row;
}

std::array<Row, 3> line_rows(const RationalBezierPatch& a, const RationalBezierPatch& b,
                             const Point4& x, const TouchLine& line) {
  const PatchJet p = jet_at(a, x[0], x[1], 2), q = jet_at(b, x[2], x[3], 2);
  return {foot_row(p, q, true), foot_row(p, q, false),
          line.cross ? bend_row(a, b, x, line.across) : tangency_row(p, q, line.across)};
}

}  // namespace

double bend_between(const RationalBezierPatch& a, const RationalBezierPatch& b, const Point4& x,
                    const Vec2& across) {
  const PatchJet p = jet_at(a, x[0], x[1], 2), q = jet_at(b, x[2], x[3], 2);
  const auto second = [](const PatchJet& jet, double u, double v) {
    return jet.uu * (u * u) + jet.uv * (2 * u * v) + jet.vv * (v * v);
  };
  const Vec3 n = cross(q.u, q.v);
  const Vec3 d = p.u * across[0] + p.v * across[1];
  const double s = dot(cross(d, q.v), n) / dot(n, n), t = dot(cross(q.u, d), n) / dot(n, n);
  return dot(second(p, across[0], across[1]) - second(q, s, t), n);
}

std::optional<Point4> curve_point(const RationalBezierPatch& a, const RationalBezierPatch& b,
                                  const Point4& start, const Point4& plane, double reach,
                                  const Vec3& apart) {
  // Where the plane fixes one parameter there are three equations for the others.
  if (std::ranges::count(plane, 0.0) == 3 && apart == Vec3{}) {
    const auto fixed = std::ranges::find_if(plane, [](double x) { return x != 0; });
    Box4 box;
    for (std::size_t i = 0; i < 4; ++i) box[i] = {start[i] - 0.5 * reach, start[i] + 0.5 * reach};
    if (auto x = newton(a, b, start, static_cast<int>(fixed - plane.begin()), box)) return x;
  }
  const auto equations = [&](const Point4& x) {
    const PatchJet p = jet_at(a, x[0], x[1], 1), q = jet_at(b, x[2], x[3], 1);
    return System{coincidence_row(p, q, 0, apart), coincidence_row(p, q, 1, apart),
                  coincidence_row(p, q, 2, apart), plane_row(plane, start, x)};
  };
  // Near a node the steps shrink slowly, but the surfaces meet all the same.
  const auto meet = [&](const Point4& x) {
    const Vec3 p = point_at(a, x[0], x[1]), q = point_at(b, x[2], x[3]);
    return distance(p, q + apart) <= kMeet * (1 + max_norm(p));
  };
  return newton(start, reach, equations, meet);
}

std::optional<Point4> fold_point(const RationalBezierPatch& a, const RationalBezierPatch& b,
                                 const Point4& start, const Vec2& across, double reach) {
  return newton(
      start, reach,
      [&](const Point4& x) {
        const PatchJet p = jet_at(a, x[0], x[1], 2), q = jet_at(b, x[2], x[3], 2);
        return System{coincidence_row(p, q, 0), coincidence_row(p, q, 1), coincidence_row(p, q, 2),
                      tangency_row(p, q, across)};
      },
      kAlways);
}

std::optional<Point4> touch_point(const RationalBezierPatch& a, const RationalBezierPatch& b,
                                  const Point4& start, const TouchLine& line, const Point4& plane,
                                  double reach) {
  return newton(
      start, reach,
      [&](const Point4& x) {
        const auto rows = line_rows(a, b, x, line);
        return System{rows[0], rows[1], rows[2], plane_row(plane, start, x)};
      },
      kAlways);
}

std::optional<Point4> foot_point(const RationalBezierPatch& a, const RationalBezierPatch& b,
                                 const Point4& start, double reach) {
  return newton(
      start, reach,
      [&](const Point4& x) {
        const PatchJet p = jet_at(a, x[0], x[1], 1), q = jet_at(b, x[2], x[3], 2);
        return System{foot_row(p, q, true), foot_row(p, q, false), Row{1, 0, 0, 0, 0},
                      Row{0, 1, 0, 0, 0}};
      },
      kAlways);
}

std::optional<Point4> point_on_iso_line(const RationalBezierPatch& a, const RationalBezierPatch& b,
                                        const Point4& start, int k, double reach) {
  if (k < 2) return foot_point(a, b, start, reach);
  const auto foot = foot_point(b, a, {start[2], start[3], start[0], start[1]}, reach);
  if (!foot) return std::nullopt;
  return Point4{(*foot)[2], (*foot)[3], start[2], start[3]};
}

Point4 moved_into(const RationalBezierPatch& a, const RationalBezierPatch& b, const Point4& x,
                  double reach) {
  const auto clamped = [](Point4 p) {
    for (double& t : p) t = std::clamp(t, 0.0, 1.0);
    return p;
  };
  const Point4 p = clamped(x);
  const bool moved_a = p[0] != x[0] || p[1] != x[1], moved_b = p[2] != x[2] || p[3] != x[3];
  if (moved_a == moved_b) return p;
  return clamped(point_on_iso_line(a, b, p, moved_a ? 0 : 2, reach).value_or(p));
}

Point4 touch_tangent(const RationalBezierPatch& a, const RationalBezierPatch& b, const Point4& x,
                     const TouchLine& line) {
  const auto rows = line_rows(a, b, x, line);
  Point4 tangent{};
  for (int k = 0; k < 4; ++k) {
    const auto kept = kept_columns(k);
    std::array<Vec3, 3> c;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        c[i][static_cast<int>(j)] = rows[j][static_cast<std::size_t>(kept[i])];
    const double minor = dot(c[0], cross(c[1], c[2]));
    tangent[static_cast<std::size_t>(k)] = k % 2 == 0 ? minor : -minor;
  }
  return tangent;
}

std::optional<Point4> collinear_normal_point(const RationalBezierPatch& a,
                                             const RationalBezierPatch& b, const Point4& start,
                                             double reach) {
  return newton(
      start, reach,
      [&](const Point4& x) {
        const PatchJet p = jet_at(a, x[0], x[1], 2), q = jet_at(b, x[2], x[3], 2);
        return System{foot_row(p, q, true), foot_row(p, q, false), tangency_row(p, q, {1, 0}),
                      tangency_row(p, q, {0, 1})};
      },
      kAlways);
}

namespace {

Point4 between(const Point4& p, const Point4& q, double t) {
  Point4 x;
  for (std::size_t k = 0; k < 4; ++k) x[k] = (1 - t) * p[k] + t * q[k];
  return x;
}

Point4 difference(const Point4& p, const Point4& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2], p[3] - q[3]};
}

double largest(const Point4& x) {
  return std::max({std::abs(x[0]), std::abs(x[1]), std::abs(x[2]), std::abs(x[3])});
}

// How fast a branch, directed by its surfaces' normals, moves along a direction of the parameters,
// against the fastest possible; with the other sign on the other side of a fold.
double growth(const RationalBezierPatch& a, const RationalBezierPatch& b, const Point4& x,
              const Point4& direction) {
  const PatchJet p = jet_at(a, x[0], x[1], 1), q = jet_at(b, x[2], x[3], 1);
  const Vec3 s = -q.u, t = -q.v, n = cross(s, t), m = cross(p.u, p.v);
  const double fastest =
      norm(n) * (std::abs(direction[0]) * norm(p.v) + std::abs(direction[1]) * norm(p.u)) +
      norm(m) * (std::abs(direction[2]) * norm(t) + std::abs(direction[3]) * norm(s));
  return (direction[0] * dot(p.v, n) - direction[1] * dot(p.u, n) + direction[2] * dot(m, t) -
          direction[3] * dot(m, s)) /
         fastest;
}

// Where the branch turns round: its tangent runs across the mean direction of the arms.
std::optional<Point4> turning_point(const RationalBezierPatch& a, const RationalBezierPatch& b,
                                    const std::array<ContactArm, 2>& arms, const Point4& centre) {
  Vec2 along{};
  for (const ContactArm& arm : arms)
    along += unit(Vec2{arm.end[0] - centre[0], arm.end[1] - centre[1]});
  if (!(norm(along) > 0)) return std::nullopt;
  const Point4 middle = between(arms[0].end, arms[1].end, 0.5);
  return fold_point(a, b, middle, {-along[1], along[0]},
                    kArmReach * largest(difference(middle, centre)));
}

// Where the branch crosses the plane that bisects the ends of the arms.
std::optional<Point4> middle_point(const RationalBezierPatch& a, const RationalBezierPatch& b,
                                   const std::array<ContactArm, 2>& arms) {
  const Point4 apart = difference(arms[1].end, arms[0].end);
  return curve_point(a, b, between(arms[0].end, arms[1].end, 0.5), apart,
                     kArmReach * largest(apart));
}

}  // namespace

bool leads_to(const RationalBezierPatch& a, const RationalBezierPatch& b, const ContactArm& arm,
              const Point4& goal) {
  const Point4 direction = difference(goal, arm.start);
  const double reach = kArmBend * largest(difference(goal, arm.end));
  double last = 0;
  for (const double t : {0.25, 0.5, 0.75, 0.9, 0.98}) {
    const auto x = curve_point(a, b, between(arm.end, goal, t), direction, reach);
    if (!x) return false;
    const double next = growth(a, b, *x, direction);
    if (std::abs(next) < kMinGrowth) continue;  // the surfaces touch, its sign is noise
    if (last * next < 0) return false;
    last = next;
  }
  return true;
}

Point4 meeting_point(const RationalBezierPatch& a, const RationalBezierPatch& b,
                     const std::array<ContactArm, 2>& arms, const Point4& centre) {
  for (const auto& x :
       {std::optional(centre), turning_point(a, b, arms, centre), middle_point(a, b, arms)}) {
    const auto inside = [](double t) { return t >= 0 && t <= 1; };
    if (x && std::all_of(x->begin(), x->end(), inside) && leads_to(a, b, arms[0], *x) &&
        leads_to(a, b, arms[1], *x))
      return *x;
  }
  return centre;
}

double signed_gap(const RationalBezierPatch& a, const RationalBezierPatch& b, const Point4& x) {
  const PatchJet p = jet_at(a, x[0], x[1], 1), q = jet_at(b, x[2], x[3], 1);
  return dot(p.point - q.point, unit(cross(q.u, q.v)));
}

}  // namespace blossom
