// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/fills/fill_data.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/QR>

namespace blossom {
namespace {

/// Parameter changes below this are rounding: they must not raise the degree.
constexpr double kNoChange = 1e-12;

using Factor = std::vector<double>;  // Bernstein coefficients of a function of s

Row derivative(const Row& row) {
  if (row.size() < 2) return {Vec4{}};
  Row result;
  const auto degree = static_cast<double>(row.size() - 1);
  for (std::size_t i = 1; i < row.size(); ++i) result.push_back(degree * (row[i] - row[i - 1]));
  return result;
}

Factor times(const Factor& a, const Factor& b) {
  Row row;
  for (const double x : b) row.push_back({x, 0, 0, 0});
  Factor result;
  for (const Vec4& p : product(a, row)) result.push_back(p[0]);
  return result;
}

Row scaled(double factor, Row row) {
  for (Vec4& p : row) p *= factor;
  return row;
}

/// The half of a row over [0, 1/2] or [1/2, 1].
Row half_of(Row row, int half) {
  Row part;
  for (std::size_t left = row.size(); left > 0; --left) {
    part.push_back(half == 0 ? row.front() : row[left - 1]);
    for (std::size_t i = 0; i + 1 < left; ++i) row[i] = 0.5 * (row[i] + row[i + 1]);
  }
  if (half == 1) std::reverse(part.begin(), part.end());
  return part;
}

/// A side's functions at one of its ends, and how they can be changed.
struct SideEnd {
  Vec4 value, normal;           ///< f_s, f_n
  Vec4 ss, sn, nn;              ///< second derivatives
  std::vector<Vec4> change;     ///< directions in which sn may be changed
  std::vector<Vec4> change_nn;  ///< likewise nn
};

/// a, b, r of a side: values at both ends, and what is added to the slopes there.
struct SideParameters {
  std::array<std::array<double, 3>, 2> values{}, slopes{};
  std::array<Vec4, 2> normals;                  ///< f_n at the ends, as the corners ask
  std::array<std::vector<double>, 2> added;     ///< along SideEnd::change
  std::array<std::vector<double>, 2> added_nn;  ///< along SideEnd::change_nn
};

/// The end of a row, or of its derivative there.
Vec4 end_of(const Row& row, int end) { return end == 0 ? row.front() : row.back(); }
Vec4 slope_of(const Row& row, int end) { return end_of(derivative(row), end); }

/// Columns that depend on the others up to this sine are taken as dependent: tangent planes that
/// agree within the tolerance of angles are one plane.
constexpr double kDependent = 1e-5;

/// Least-squares solution of least norm of matrix x = target, columns first scaled to unit length.
Eigen::VectorXd solved(Eigen::MatrixXd matrix, const Eigen::VectorXd& target) {
  Eigen::VectorXd scale = matrix.colwise().norm();
  for (double& length : scale) length = length > 0 ? 1 / length : 1;
  matrix *= scale.asDiagonal();
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  solver.setThreshold(kDependent);
  solver.compute(matrix);
  return scale.cwiseProduct(Eigen::VectorXd(solver.solve(target)));
}

Eigen::VectorXd stacked(const std::vector<Vec4>& vectors) {
  Eigen::VectorXd result(4 * static_cast<Eigen::Index>(vectors.size()));
  for (std::size_t i = 0; i < vectors.size(); ++i)
    for (int x = 0; x < 4; ++x) result(4 * static_cast<Eigen::Index>(i) + x) = vectors[i][x];
  return result;
}

/// The polygon's functions, corner by corner.
class FunctionMaker {
 public:
  FunctionMaker(const std::vector<FillSide>& sides, CornerDemand demand)
      : sides_(sides), demand_(demand), rational_(is_rational(sides)), parameters_(sides.size()) {
    const double theta = sector_angle(static_cast<int>(sides.size()));
    cosine_ = std::cos(theta);
    sine_ = std::sin(theta);
  }

  PolygonFunctions made() {
    PolygonFunctions result;
    for (std::size_t k = 0; k < sides_.size(); ++k) meet_tangents(k);
    if (demand_ == CornerDemand::Twists || demand_ == CornerDemand::SecondJets)
      for (std::size_t k = 0; k < sides_.size(); ++k)
        result.mismatch = std::max(result.mismatch, meet_seconds(k));
    for (std::size_t k = 0; k < sides_.size(); ++k) result.sides.push_back(functions(k));
    return result;
  }

 private:
  std::size_t before(std::size_t k) const { return (k + sides_.size() - 1) % sides_.size(); }
  void meet_tangents(std::size_t k);
  void set_normal(std::size_t side, int end, const Vec4& normal);
  double meet_seconds(std::size_t k);
  SideEnd end_at(std::size_t side, int end) const;
  SideFunctions functions(std::size_t side) const;
  /// All directions: what a missing neighbour leaves open.
  std::vector<Vec4> free_directions() const {
    std::vector<Vec4> units{Vec4{1, 0, 0, 0}, Vec4{0, 1, 0, 0}, Vec4{0, 0, 1, 0}};
    if (rational_) units.push_back({0, 0, 0, 1});
    return units;
  }
  Row normal_of(std::size_t side) const;
  Row second_of(std::size_t side) const;
  Factor factor(const SideParameters& of, std::size_t which) const;

  const std::vector<FillSide>& sides_;
  CornerDemand demand_;
  bool rational_;
  std::vector<SideParameters> parameters_;
  double cosine_ = 0, sine_ = 0;
};

/// Corner k begins side k and ends the one before:  e_before = cos e + sin n, and
/// e = cos e_before - sin n_before.
void FunctionMaker::meet_tangents(std::size_t k) {
  const Vec4 after = slope_of(sides_[k].edge, 0), ending = slope_of(sides_[before(k)].edge, 1);
  set_normal(k, 0, (1 / sine_) * (ending - cosine_ * after));
  set_normal(before(k), 1, (1 / sine_) * (cosine_ * ending - after));
}

void FunctionMaker::set_normal(std::size_t side, int end, const Vec4& normal) {
  SideParameters& of = parameters_[side];
  const auto at = static_cast<std::size_t>(end);
  of.normals[at] = normal;
  if (sides_[side].across.empty()) return;
  Eigen::MatrixXd frame(4, 3);
  frame << stacked({end_of(sides_[side].across, end)}), stacked({slope_of(sides_[side].edge, end)}),
      stacked({end_of(sides_[side].edge, end)});
  const Eigen::VectorXd solution = solved(frame, stacked({normal}));
  for (int i = 0; i < 3; ++i) of.values[at][static_cast<std::size_t>(i)] = solution(i);
}

SideEnd FunctionMaker::end_at(std::size_t side, int end) const {
  const FillSide& data = sides_[side];
  const SideParameters& of = parameters_[side];
  const auto& [a, b, r] = of.values[static_cast<std::size_t>(end)];
  SideEnd result;
  const Row first = derivative(data.edge);
  const Vec4 value = end_of(data.edge, end);
  result.value = end_of(first, end);
  result.normal = of.normals[static_cast<std::size_t>(end)];
  result.ss = slope_of(first, end);
  if (data.across.empty()) {
    result.sn = of.normals[1] - of.normals[0];
    result.change = result.change_nn = free_directions();
    return result;
  }
  const Vec4 across = end_of(data.across, end);
  const Vec4 mixed = slope_of(data.across, end);
  result.sn = a * mixed + b * result.ss + r * result.value +
              (of.values[1][0] - of.values[0][0]) * across +
              (of.values[1][1] - of.values[0][1]) * result.value +
              (of.values[1][2] - of.values[0][2]) * value;
  // Polynomials keep the weight 1, so r stays 0.
  result.change = {across, result.value};
  if (rational_) result.change.push_back(value);
  result.change_nn = data.bend.empty() ? free_directions() : result.change;
  if (!data.bend.empty())
    result.nn = a * a * end_of(data.bend, end) + 2 * a * b * mixed + b * b * result.ss +
                2 * r * (a * across + b * result.value);
  return result;
}

/// Adds to the slopes, and second derivatives, at corner k what makes the demand true there, by the
/// least norm. Returns what remains, relative.
///   twists:  F(e, e_before) = cos ss + sin sn   of this side,
///                             cos ss - sin sn   of the one before
///   jets:    ss, sn, nn of this side are those of the one before in its turned frame.
double FunctionMaker::meet_seconds(std::size_t k) {
  const SideEnd after = end_at(k, 0), ending = end_at(before(k), 1);
  const double c = cosine_, s = sine_;
  const bool jets = demand_ == CornerDemand::SecondJets;
  // Rows of three factors: of ss, sn, nn after the corner, and of those before it.
  std::vector<std::array<double, 6>> equations{{c, s, 0, -c, s, 0}};
  if (jets)
    equations = {{1, 0, 0, -c * c, 2 * c * s, -s * s},
                 {0, 1, 0, -c * s, s * s - c * c, c * s},
                 {0, 0, 1, -s * s, -2 * c * s, -c * c}};
  const std::size_t m[4] = {after.change.size(), jets ? after.change_nn.size() : 0,
                            ending.change.size(), jets ? ending.change_nn.size() : 0};
  const auto rows = static_cast<Eigen::Index>(4 * equations.size());
  Eigen::MatrixXd matrix =
      Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(m[0] + m[1] + m[2] + m[3]));
  std::vector<Vec4> wrong;
  for (std::size_t q = 0; q < equations.size(); ++q) {
    const auto& w = equations[q];
    wrong.push_back(w[0] * after.ss + w[1] * after.sn + w[2] * after.nn + w[3] * ending.ss +
                    w[4] * ending.sn + w[5] * ending.nn);
    Eigen::Index column = 0;
    const auto add = [&](const std::vector<Vec4>& change, std::size_t count, double weight) {
      for (std::size_t i = 0; i < count; ++i, ++column)
        matrix.block(static_cast<Eigen::Index>(4 * q), column, 4, 1) =
            weight * stacked({change[i]});
    };
    add(after.change, m[0], w[1]);
    add(after.change_nn, m[1], w[2]);
    add(ending.change, m[2], w[4]);
    add(ending.change_nn, m[3], w[5]);
  }
  const double size = stacked({after.value, after.normal, after.ss, after.sn, after.nn,
                               ending.value, ending.normal, ending.ss, ending.sn, ending.nn})
                          .norm();
  const Eigen::VectorXd target = -stacked(wrong);
  if (target.norm() <= kSameSeconds * size) return target.norm() / size;
  const Eigen::VectorXd solution = solved(matrix, target);
  Eigen::Index next = 0;
  const auto take = [&](std::vector<double>& into, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) into.push_back(solution(next++));
  };
  take(parameters_[k].added[0], m[0]);
  take(parameters_[k].added_nn[0], m[1]);
  take(parameters_[before(k)].added[1], m[2]);
  take(parameters_[before(k)].added_nn[1], m[3]);
  return (matrix * solution - target).norm() / size;
}

/// a, b or r along a side: constant, linear, or cubic if the slopes were changed.
Factor FunctionMaker::factor(const SideParameters& of, std::size_t which) const {
  const double from = of.values[0][which], to = of.values[1][which];
  const auto slope = [&](std::size_t end) {
    return which < of.added[end].size() ? of.added[end][which] : 0.0;
  };
  if (std::max(std::abs(slope(0)), std::abs(slope(1))) > kNoChange)
    return {from, from + (to - from + slope(0)) / 3, to - (to - from + slope(1)) / 3, to};
  if (std::abs(to - from) > kNoChange) return {from, to};
  return {(from + to) / 2};
}

/// f_n; its ends are those that the corners ask for.
Row FunctionMaker::normal_of(std::size_t side) const {
  const FillSide& data = sides_[side];
  const SideParameters& of = parameters_[side];
  if (data.across.empty()) {
    const Vec4 rise = of.normals[1] - of.normals[0];
    std::array<Vec4, 2> slopes{rise, rise};
    for (std::size_t end = 0; end < 2; ++end)
      for (std::size_t x = 0; x < of.added[end].size(); ++x)
        slopes[end][static_cast<int>(x)] += of.added[end][x];
    return {of.normals[0], of.normals[0] + (1.0 / 3) * slopes[0],
            of.normals[1] - (1.0 / 3) * slopes[1], of.normals[1]};
  }
  Row normal =
      sum(product(factor(of, 0), data.across), product(factor(of, 1), derivative(data.edge)));
  const Factor r = factor(of, 2);
  if (std::any_of(r.begin(), r.end(), [](double x) { return std::abs(x) > kNoChange; }))
    normal = sum(normal, product(r, data.edge));
  const Vec4 wrong_0 = of.normals[0] - normal.front(), wrong_1 = of.normals[1] - normal.back();
  if (std::max(max_norm(wrong_0), max_norm(wrong_1)) > 0) normal = sum(normal, {wrong_0, wrong_1});
  return normal;
}

Row FunctionMaker::second_of(std::size_t side) const {
  const FillSide& data = sides_[side];
  const SideParameters& of = parameters_[side];
  if (data.across.empty() || data.bend.empty()) {
    Row second(2);
    for (std::size_t end = 0; end < 2; ++end)
      for (std::size_t x = 0; x < of.added_nn[end].size(); ++x)
        second[end][static_cast<int>(x)] = of.added_nn[end][x];
    return second;
  }
  const Factor a = factor(of, 0), b = factor(of, 1), r = factor(of, 2);
  const Row first = derivative(data.edge);
  Row second = sum(product(times(a, a), data.bend),
                   scaled(2, product(times(a, b), derivative(data.across))));
  second = sum(second, product(times(b, b), derivative(first)));
  if (std::any_of(r.begin(), r.end(), [](double x) { return std::abs(x) > kNoChange; }))
    second = sum(second, scaled(2, product(r, sum(product(a, data.across), product(b, first)))));
  const std::array<const Row*, 3> along{&data.across, &first, &data.edge};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto at = [&](std::size_t end) {
      return i < of.added_nn[end].size() ? of.added_nn[end][i] : 0.0;
    };
    const Factor change{at(0), at(1)};
    if (std::max(std::abs(change[0]), std::abs(change[1])) > kNoChange)
      second = sum(second, product(change, *along[i]));
  }
  return second;
}

SideFunctions FunctionMaker::functions(std::size_t side) const {
  SideFunctions result{sides_[side].edge, normal_of(side), {}};
  if (demand_ == CornerDemand::SecondJets || demand_ == CornerDemand::None)
    result.second = second_of(side);
  return result;
}

}  // namespace

Row sum(const Row& a, const Row& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  const int degree = static_cast<int>(std::max(a.size(), b.size())) - 1;
  Row result = raised(a, degree);
  const Row other = raised(b, degree);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] += other[i];
  return result;
}

int SideFunctions::degree() const {
  const auto of = [](const Row& row) { return static_cast<int>(row.size()) - 1; };
  const int first = std::max(of(value), of(normal) + 1);
  return second.empty() ? first : std::max(first, of(second) + 2);
}

PolygonFunctions polygon_functions(const std::vector<FillSide>& sides, CornerDemand demand) {
  return FunctionMaker(sides, demand).made();
}

/// d beta across a half of a side is A e + B n there; A and B are linear along it.
///   Q_y = A f_s + B f_n,  Q_yy = A^2 f_ss + 2 A B f_sn + B^2 f_nn.
std::vector<Vec4> operator_data(const std::vector<SideFunctions>& sides, const FillOperator& made) {
  const FillData& at = made.data();
  const int d = at.degree;
  std::vector<Vec4> data(sides.size() * static_cast<std::size_t>(at.count()));
  const PolygonLayout& layout = made.layout();
  const Vec2 e = place_of(layout, {0, 1}) - place_of(layout, {0, 0});
  const Vec2 n{e[1], -e[0]};
  for (std::size_t half = 0; half < 2; ++half) {
    const auto corners = corners_from(layout, layout.borders[half]);
    const Vec2 start = corners[3] - corners[0], end = corners[2] - corners[1];
    const Factor a{dot(start, e) / dot(e, e), dot(end, e) / dot(e, e)};
    const Factor b{dot(start, n) / dot(e, e), dot(end, n) / dot(e, e)};
    for (std::size_t k = 0; k < sides.size(); ++k) {
      const auto put = [&](int place, const Row& row, double factor, int count) {
        const Row full = raised(row, d);
        for (int i = 0; i < count; ++i)
          data[k * static_cast<std::size_t>(at.count()) + static_cast<std::size_t>(place + i)] =
              factor * full[static_cast<std::size_t>(i)];
      };
      const int h = static_cast<int>(half);
      const auto part = [h](const Row& row) { return half_of(row, h); };
      const Row first = derivative(sides[k].value);
      put(h * d, part(sides[k].value), 1, d);
      put(at.at(1, h, 0), sum(product(a, part(first)), product(b, part(sides[k].normal))), 1.0 / d,
          d + 1);
      if (at.order < 2) continue;
      const Row mixed = product(times(a, b), part(derivative(sides[k].normal)));
      put(at.at(2, h, 0),
          sum(sum(product(times(a, a), part(derivative(first))), scaled(2, mixed)),
              product(times(b, b), part(sides[k].second))),
          1.0 / (d * (d - 1)), d + 1);
    }
  }
  return data;
}

}  // namespace blossom
