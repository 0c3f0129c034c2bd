// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/forms/quadric.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/forms/evaluation.h"

namespace blossom {
namespace {

constexpr int kHighest = 2;             // degree in each direction
constexpr int kSamples = 2 * kHighest;  // so that q(S), of twice the degree, vanishes with them
constexpr std::size_t kTerms = 10;
constexpr double kNoPivot = 1e-11;  // relative to the first one: a row of zeros
constexpr double kPivot = 1e-7;     // likewise, not of zeros
constexpr double kFlat = 1e-11;     // of a patch's diagonal: in a plane
constexpr double kWide = 1e-3;      // of its square: the corners span a plane well

using Row = std::array<double, kTerms>;

constexpr std::array<std::array<std::size_t, 2>, kTerms> kPlaces{
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}, {0, 3}, {1, 3}, {2, 3}, {3, 3}}};

// The kernel of rows by elimination with complete pivoting, if it has dimension one.
std::optional<Row> kernel_of(std::vector<Row> rows) {
  std::array<std::size_t, kTerms> column;
  for (std::size_t j = 0; j < kTerms; ++j) column[j] = j;
  double first = 0;
  for (std::size_t step = 0; step + 1 < kTerms; ++step) {
    std::size_t best_row = step, best = step;
    for (std::size_t i = step; i < rows.size(); ++i)
      for (std::size_t j = step; j < kTerms; ++j)
        if (std::abs(rows[i][column[j]]) > std::abs(rows[best_row][column[best]])) {
          best_row = i;
          best = j;
        }
    std::swap(rows[step], rows[best_row]);
    std::swap(column[step], column[best]);
    const double pivot = rows[step][column[step]];
    first = std::max(first, std::abs(pivot));
    if (!(std::abs(pivot) > kPivot * first)) return std::nullopt;
    for (std::size_t i = step + 1; i < rows.size(); ++i) {
      const double factor = rows[i][column[step]] / pivot;
      for (std::size_t j = step; j < kTerms; ++j)
        rows[i][column[j]] -= factor * rows[step][column[j]];
    }
  }
  for (std::size_t i = kTerms - 1; i < rows.size(); ++i)
    if (std::abs(rows[i][column[kTerms - 1]]) > kNoPivot * first) return std::nullopt;
  Row kernel{};
  kernel[column[kTerms - 1]] = 1;
  for (std::size_t i = kTerms - 1; i-- > 0;) {
    double sum = 0;
    for (std::size_t j = i + 1; j < kTerms; ++j) sum += rows[i][column[j]] * kernel[column[j]];
    kernel[column[i]] = -sum / rows[i][column[i]];
  }
  return kernel;
}

// Whether the control points, and so the patch, are in a plane but for a part of their size far
// below what a pivot needs: on many quadrics. Only told where the corners say which plane.
bool is_flat(const RationalBezierPatch& patch) {
  const auto& net = patch.points;
  const auto point = [](const Vec4& p) { return Vec3{p[0], p[1], p[2]} * (1 / p[3]); };
  const int last_row = net.rows() - 1, last_column = net.columns() - 1;
  const Vec3 origin = point(net(0, 0));
  const Vec3 diagonal = point(net(last_row, last_column)) - origin;
  const Vec3 normal = cross(diagonal, point(net(last_row, 0)) - point(net(0, last_column)));
  const double length = norm(normal), size = norm(diagonal);
  if (!(length > kWide * size * size)) return false;
  return std::ranges::all_of(net.values(), [&](const Vec4& p) {
    return p[3] > 0 && std::abs(dot(normal, point(p) - origin)) <= kFlat * size * length;
  });
}

}  // namespace

double Quadric::value(const Vec4& x) const {
  double sum = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      sum += matrix[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] * x[i] * x[j];
  return sum;
}

Vec3 Quadric::gradient(const Vec3& x) const {
  Vec3 result;
  for (int k = 0; k < 3; ++k) {
    const auto& row = matrix[static_cast<std::size_t>(k)];
    result[k] = 2 * (row[0] * x[0] + row[1] * x[1] + row[2] * x[2] + row[3]);
  }
  return result;
}

bool may_lie_on_quadric(const RationalBezierPatch& patch) {
  return std::max(patch.degree_u(), patch.degree_v()) <= kHighest;
}

std::optional<Quadric> quadric_of(const RationalBezierPatch& patch) {
  if (!may_lie_on_quadric(patch) || is_flat(patch)) return std::nullopt;
  std::vector<Vec3> points;
  for (int i = 0; i <= kSamples; ++i)
    for (int j = 0; j <= kSamples; ++j)
      points.push_back(point_at(patch, i / double{kSamples}, j / double{kSamples}));
  const Vec3 middle = points[points.size() / 2];
  double size = 0;
  for (const Vec3& p : points) size = std::max(size, norm(p - middle));
  if (!(size > 0)) return std::nullopt;
  std::vector<Row> rows;
  for (const Vec3& p : points) {
    const Vec3 x = (p - middle) * (1 / size);
    const Vec4 h{x[0], x[1], x[2], 1};
    Row& row = rows.emplace_back();
    for (std::size_t k = 0; k < kTerms; ++k)
      row[k] = h[static_cast<int>(kPlaces[k][0])] * h[static_cast<int>(kPlaces[k][1])];
  }
  const auto kernel = kernel_of(std::move(rows));
  if (!kernel) return std::nullopt;
  // In the patch's own coordinates: x = (p - middle) / size, that is (p - w middle) / (w size).
  Quadric local;
  for (std::size_t k = 0; k < kTerms; ++k) {
    const auto [i, j] = kPlaces[k];
    local.matrix[i][j] += 0.5 * (*kernel)[k];
    local.matrix[j][i] += 0.5 * (*kernel)[k];
  }
  const double slope = norm(local.gradient({})) / size;
  if (!(slope > 0)) return std::nullopt;
  Quadric result;
  std::array<std::array<double, 4>, 4> to{};  // rows of the map to local coordinates
  for (std::size_t k = 0; k < 3; ++k) {
    to[k][k] = 1 / size;
    to[k][3] = -middle[static_cast<int>(k)] / size;
  }
  to[3][3] = 1;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t l = 0; l < 4; ++l)
          result.matrix[i][j] += to[k][i] * local.matrix[k][l] * to[l][j] / slope;
  return result;
}

}  // namespace blossom
