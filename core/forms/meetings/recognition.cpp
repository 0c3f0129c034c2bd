// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/meetings/recognition.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>

#include "core/base/unbounded.h"
#include "core/forms/algebra/products.h"
#include "core/forms/evaluation.h"

namespace blossom {
namespace {

constexpr int kSamples = 5;          // in each direction
constexpr double kNoNormal = 1e-12;  // of the product of both derivatives: a singular point
constexpr double kConstant = 1e-12;  // what differs by no more among unit normals is one
constexpr double kOneWay = 0.5;      // length of the mean of unit normals that are nearly one
// Of the largest eigenvalue of sums of squares, which are known to 1e-16 of it: one that counts as
// nothing, and the next one, which has to be more than that. Samples decide whether it was right.
constexpr double kKernel = 1e-14;
constexpr double kOtherwise = 1e-10;
// Of the numbers of a bound: placing a net round a centre, and lengths of axes, a few roundings
// each.
constexpr double kPlacing = 16 * kUnitRoundoff;

struct Sample {
  Vec3 point, normal;
};
using Samples = std::vector<Sample>;

// Points of all of a surface with their normals, in lengths of `size` round `middle`.
struct Sampling {
  Vec3 middle;
  double size = 0;
  Samples samples;
};

std::optional<Sample> sample_at(const BezierSurface& surface, double u, double v) {
  const auto& patches = surface.patches;
  const int i = std::min(static_cast<int>(u * patches.rows()), patches.rows() - 1);
  const int j = std::min(static_cast<int>(v * patches.columns()), patches.columns() - 1);
  const PatchJet jet = jet_at(patches(i, j), u * patches.rows() - i, v * patches.columns() - j, 1);
  const Vec3 normal = cross(jet.u, jet.v);
  const double length = norm(normal);
  if (!(length > kNoNormal * norm(jet.u) * norm(jet.v))) return {};
  return Sample{jet.point, normal * (1 / length)};
}

std::optional<Sampling> sampled(const BezierSurface& surface) {
  Sampling found;
  for (int i = 0; i < kSamples; ++i)
    for (int j = 0; j < kSamples; ++j) {
      const auto sample = sample_at(surface, (i + 0.5) / kSamples, (j + 0.5) / kSamples);
      if (!sample) return {};
      found.samples.push_back(*sample);
      found.middle += sample->point * (1.0 / (kSamples * kSamples));
    }
  for (const Sample& at : found.samples)
    found.size = std::max(found.size, distance(at.point, found.middle));
  if (!(found.size > 0)) return {};
  for (Sample& at : found.samples) at.point = (at.point - found.middle) * (1 / found.size);
  return found;
}

Sample mean_of(const Samples& all) {
  Sample mean;
  for (const Sample& at : all) {
    mean.point += at.point * (1.0 / static_cast<double>(all.size()));
    mean.normal += at.normal * (1.0 / static_cast<double>(all.size()));
  }
  return mean;
}

// The one point of all lines (point, normal), and how far points are from it: p - r n = centre by
// least squares.
struct Centre {
  Vec3 point;
  double radius = 0;  // 0: the normals are one
};
Centre centre_of(const Samples& all) {
  const Sample mean = mean_of(all);
  double mixed = 0, square = 0;
  for (const Sample& at : all) {
    const Vec3 turn = at.normal - mean.normal;
    mixed += dot(at.point - mean.point, turn);
    square += dot(turn, turn);
  }
  const double radius = square > kConstant * kConstant ? mixed / square : 0;
  return {mean.point - radius * mean.normal, std::abs(radius)};
}

Eigen::Vector3d eigen(const Vec3& v) { return {v[0], v[1], v[2]}; }

template <class Vector>
Vec3 from_eigen(const Vector& v, Eigen::Index first = 0) {
  return {v[first], v[first + 1], v[first + 2]};
}

// The direction that all vectors are perpendicular to; nothing if there is none, or several.
template <int Dim>
std::optional<Eigen::Matrix<double, Dim, 1>> kernel_of(
    const Eigen::Matrix<double, Dim, Dim>& squares) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, Dim, Dim>> solver(squares);
  const auto& values = solver.eigenvalues();  // increasing
  if (values[0] > kKernel * values[Dim - 1] || !(values[1] > kOtherwise * values[Dim - 1]))
    return {};
  return Eigen::Matrix<double, Dim, 1>(solver.eigenvectors().col(0));
}

std::optional<Elementary> plane_of(const Samples& all) {
  const Sample mean = mean_of(all);
  if (!(norm(mean.normal) > kOneWay)) return {};
  return Elementary{ElementaryKind::Plane, mean.point, unit(mean.normal)};
}

std::optional<Elementary> cylinder_of(const Samples& all) {
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (const Sample& at : all) squares += eigen(at.normal) * eigen(at.normal).transpose();
  const auto kernel = kernel_of<3>(squares);
  if (!kernel) return {};
  const Vec3 axis = unit(from_eigen(*kernel));
  Samples flat;
  for (const Sample& at : all) flat.push_back({across(at.point, axis), across(at.normal, axis)});
  const Centre centre = centre_of(flat);
  return Elementary{ElementaryKind::Cylinder, centre.point, axis, centre.radius};
}

std::optional<Elementary> cone_of(const Samples& all) {
  const Sample mean = mean_of(all);
  Eigen::Matrix3d turns = Eigen::Matrix3d::Zero(), planes = Eigen::Matrix3d::Zero();
  Eigen::Vector3d heights = Eigen::Vector3d::Zero();
  for (const Sample& at : all) {
    const Eigen::Vector3d n = eigen(at.normal), turn = eigen(at.normal - mean.normal);
    turns += turn * turn.transpose();
    planes += n * n.transpose();
    heights += n * dot(at.normal, at.point);
  }
  const auto kernel = kernel_of<3>(turns);
  if (!kernel) return {};
  const Vec3 axis = unit(from_eigen(*kernel));
  const double sine = std::abs(dot(mean.normal, axis));
  if (!(sine > kConstant && sine < 1 - kConstant)) return {};
  Elementary cone{ElementaryKind::Cone, from_eigen(Eigen::Vector3d(planes.ldlt().solve(heights))),
                  axis};
  cone.angle = std::asin(sine);
  return cone;
}

std::optional<Elementary> sphere_of(const Samples& all) {
  const Centre centre = centre_of(all);
  return Elementary{ElementaryKind::Sphere, centre.point, {0, 0, 1}, centre.radius};
}

std::optional<Elementary> torus_of(const Samples& all) {
  using Six = Eigen::Matrix<double, 6, 1>;
  Eigen::Matrix<double, 6, 6> squares = Eigen::Matrix<double, 6, 6>::Zero();
  for (const Sample& at : all) {
    Six row;
    row << eigen(cross(at.point, at.normal)), eigen(at.normal);
    squares += row * row.transpose();
  }
  const auto kernel = kernel_of<6>(squares);
  if (!kernel) return {};
  const Vec3 a = from_eigen(*kernel), moment = from_eigen(*kernel, 3);
  if (!(norm(a) > kConstant)) return {};
  const Vec3 axis = unit(a), foot = cross(a, moment) * (1 / dot(a, a));
  Samples meridian;  // in the half plane of (distance from the axis, height along it)
  for (const Sample& at : all) {
    const Vec3 out = across(at.point - foot, axis);
    const double radius = norm(out);
    if (!(radius > kConstant)) return {};
    meridian.push_back({{radius, dot(at.point - foot, axis), 0},
                        {dot(at.normal, out) / radius, dot(at.normal, axis), 0}});
  }
  const Centre ring = centre_of(meridian);
  Elementary torus{ElementaryKind::Torus, foot + ring.point[1] * axis, axis, ring.point[0]};
  torus.minor = ring.radius;
  if (!(torus.minor > 0 && torus.radius > torus.minor)) return {};
  return torus;
}

// The elementary surface that all samples lie on, within so many of their units.
std::optional<Elementary> through(const Samples& all, double within) {
  for (const auto& made : {plane_of, cylinder_of, cone_of, sphere_of, torus_of}) {
    const auto found = made(all);
    if (found && std::ranges::all_of(all, [&](const Sample& at) {
          return std::abs(height_over(*found, at.point).value) <= within;
        }))
      return found;
  }
  return {};
}

// A patch in a frame whose origin is the elementary surface's centre and whose z is its axis.
RationalBezierPatch placed(const RationalBezierPatch& patch, const Elementary& about) {
  const Vec3 x = any_across(about.axis), y = cross(about.axis, x);
  RationalBezierPatch local = patch;
  for (Vec4& p : local.points.values()) {
    const Vec3 from = head(p) - p[3] * about.centre;
    p = {dot(from, x), dot(from, y), dot(from, about.axis), p[3]};
  }
  return local;
}

RationalBezierPatch scaled(RationalBezierPatch patch, const Vec4& by) {
  for (Vec4& p : patch.points.values())
    for (int k = 0; k < 4; ++k) p[k] *= by[k];
  return patch;
}

double largest(const RationalBezierPatch& patch) {
  double found = 0;
  for (const Vec4& p : patch.points.values()) found = std::max(found, max_norm(p));
  return found;
}

// A polynomial of a placed patch, and a bound on the rounding of its coefficients.
struct Polynomial {
  BezierFunction2 form;
  double error = 0;
};

double largest(const Polynomial& f) {
  double found = 0;
  for (const double value : f.form.points.values()) found = std::max(found, std::abs(value));
  return found;
}

// f . g, of the patch with its coordinates by factors.
Polynomial square_of(const RationalBezierPatch& local, const Vec4& by_f, const Vec4& by_g) {
  const RationalBezierPatch f = scaled(local, by_f), g = scaled(local, by_g);
  const double error = 4 * (product_error(local.degree_u(), local.degree_v()) + kPlacing);
  return {dot_product(f, g), error * largest(f) * largest(g)};
}

Polynomial product_of(const Polynomial& f, const Polynomial& g) {
  const double rounding = product_error(f.form.degree_u(), f.form.degree_v());
  const double of_f = largest(f), of_g = largest(g);
  return {product(f.form, g.form), of_f * g.error + of_g * f.error + rounding * of_f * of_g};
}

Polynomial weight_square(const RationalBezierPatch& local) {
  return square_of(local, {0, 0, 0, 1}, {0, 0, 0, 1});
}

// A bound on |f| / w, of polynomials of one degree: both are the same means of coefficients.
double largest_quotient(const Polynomial& f, const Polynomial& w) {
  double found = 0;
  for (int i = 0; i < f.form.points.rows(); ++i)
    for (int j = 0; j < f.form.points.columns(); ++j) {
      const double weight = w.form.points(i, j) - w.error;
      if (!(weight > 0)) return kInfinity;
      found = std::max(found, (std::abs(f.form.points(i, j)) + f.error) / weight);
    }
  return found;
}

double plane_gap(const RationalBezierPatch& local) {
  double gap = 0;
  for (const Vec4& p : local.points.values()) gap = std::max(gap, std::abs(p[2] / p[3]));
  return gap;
}

// With d the distance, |F| = |x^2 + y^2 (+ z^2) - r^2| >= d r.
double round_gap(const RationalBezierPatch& local, double z, double radius) {
  const Polynomial f = square_of(local, {1, 1, z, radius}, {1, 1, z, -radius});
  return largest_quotient(f, weight_square(local)) / radius;
}

// The least |z| of a net on one side of z = 0; else 0.
double least_height(const RationalBezierPatch& local) {
  double low = kInfinity, high = -kInfinity;
  for (const Vec4& p : local.points.values()) {
    low = std::min(low, p[2] / p[3]);
    high = std::max(high, p[2] / p[3]);
  }
  return std::max({low, -high, 0.0});
}

// |F| = |c^2 (x^2 + y^2) - s^2 z^2| >= d s |z|, with cosine and sine of the angle.
double gap_beside_apex(const RationalBezierPatch& local, double angle) {
  const double c = std::cos(angle), s = std::sin(angle), height = least_height(local);
  if (!(height > 0)) return kInfinity;
  const Polynomial f = square_of(local, {c, c, s, 0}, {c, c, -s, 0});
  return largest_quotient(f, weight_square(local)) / (s * height);
}

struct Border {
  RationalBezierPatch points;  // of degree 0 in one direction
  double radius = 0;           // of its net round the origin
};

// The border of a patch at the start or end of u or v.
Border border_of(const RationalBezierPatch& patch, bool of_u, bool at_end) {
  const Grid<Vec4>& net = patch.points;
  const int count = of_u ? net.columns() : net.rows();
  const int other = at_end ? (of_u ? net.rows() : net.columns()) - 1 : 0;
  Border border{{of_u ? Grid<Vec4>(1, count) : Grid<Vec4>(count, 1)}};
  for (int i = 0; i < count; ++i) {
    const Vec4& p = of_u ? net(other, i) : net(i, other);
    (of_u ? border.points.points(0, i) : border.points.points(i, 0)) = p;
    border.radius = std::max(border.radius, norm(projected(p)));
  }
  return border;
}

// Straight from its apex a patch is nowhere farther from the cone than the border at the other end
// or the one at the apex, since a half cone grown from its apex is itself.
double cone_gap(const RationalBezierPatch& local, double angle) {
  double gap = gap_beside_apex(local, angle);
  for (const bool of_u : {false, true}) {
    if ((of_u ? local.degree_u() : local.degree_v()) != 1) continue;
    for (const bool at_end : {false, true}) {
      const double far = gap_beside_apex(border_of(local, of_u, !at_end).points, angle);
      gap = std::min(gap, std::max(far, border_of(local, of_u, at_end).radius));
    }
  }
  return gap;
}

// F = (x^2 + y^2 + z^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + y^2) is the product of d (d + 2 r), for d the
// height over the torus, and of what is at least R^2 - r^2.
double torus_gap(const RationalBezierPatch& local, double ring, double minor) {
  if (4 * std::max(local.degree_u(), local.degree_v()) > kMaxProductDegree) return kInfinity;
  const double inner = (ring - minor) * (ring + minor), k = std::sqrt(inner);
  const Polynomial all = square_of(local, {1, 1, 1, k}, {1, 1, 1, k});
  const Polynomial across =
      square_of(local, {1, 1, 0, 0}, {4 * ring * ring, 4 * ring * ring, 0, 0});
  const Polynomial weights = weight_square(local);
  Polynomial f = product_of(all, all);
  const Polynomial taken = product_of(across, weights);
  f.error += taken.error + kUnitRoundoff * (largest(f) + largest(taken));
  for (int i = 0; i < f.form.points.rows(); ++i)
    for (int j = 0; j < f.form.points.columns(); ++j)
      f.form.points(i, j) -= taken.form.points(i, j);
  return largest_quotient(f, product_of(weights, weights)) / (minor * inner);
}

double gap_of(const RationalBezierPatch& local, const Elementary& from) {
  switch (from.kind) {
    case ElementaryKind::Plane: return plane_gap(local);
    case ElementaryKind::Cylinder: return round_gap(local, 0, from.radius);
    case ElementaryKind::Cone: return cone_gap(local, from.angle);
    case ElementaryKind::Sphere: return round_gap(local, 1, from.radius);
    case ElementaryKind::Torus: break;
  }
  return torus_gap(local, from.radius, from.minor);
}

double largest_coordinate(const BezierSurface& surface) {
  double found = 0;
  for (const RationalBezierPatch& patch : surface.patches.values())
    for (const Vec4& p : patch.points.values()) found = std::max(found, max_norm(projected(p)));
  return found;
}

Elementary in_space(Elementary local, const Sampling& of) {
  local.centre = of.middle + of.size * local.centre;
  local.radius *= of.size;
  local.minor *= of.size;
  return local;
}

}  // namespace

std::optional<RecognisedSurface> recognised(const BezierSurface& surface, double within) {
  const auto sampling = sampled(surface);
  if (!sampling) return {};
  const auto local = through(sampling->samples, within / sampling->size);
  if (!local) return {};
  RecognisedSurface found{in_space(*local, *sampling)};

  for (const RationalBezierPatch& patch : surface.patches.values()) {
    found.gap = std::max(found.gap, gap_of(placed(patch, found.elementary), found.elementary));
    if (!(found.gap <= within)) return {};
  }
  const double coordinate =
      std::max(largest_coordinate(surface), max_norm(found.elementary.centre));
  found.gap += surface.error + kPlacing * coordinate;
  if (!(found.gap <= within)) return {};
  return found;
}

}  // namespace blossom
