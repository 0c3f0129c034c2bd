// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/blending/fills/fill_operator.h"

#include <algorithm>
#include <complex>
#include <map>
#include <mutex>
#include <string>
#include <tuple>

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include "core/base/errors.h"

namespace blossom {
namespace {

using Complex = std::complex<double>;
using Matrix = Eigen::MatrixXcd;
using Index = Eigen::Index;

/// Polynomials up to this total degree are reproduced.
constexpr int kReproduced = 3;

/// Pivots below this part of the largest one belong to redundant conditions: rounding leaves at
/// most 1e-15 of them. The smallest of the others is 3e-5 at G1 and 1e-7 at G2, and 7e-9 in the
/// ring at G2, over 3 to 12 sides; measured for the star up to degree 13, the ring up to 11, and
/// the deep ring up to 9 with at most 6 sides.
constexpr double kRedundant = 1e-10;

/// Weight of a second-order condition that fails against the thin-plate energy: conditions first.
constexpr double kNearSecond = 1e6;

// Each kind of operand makes the compiler write products and decompositions of its own: here all of
// them take whole matrices.
Matrix product(const Matrix& a, const Matrix& b) { return a * b; }
Matrix adjoint(const Matrix& a) { return a.adjoint(); }

using Decomposition = Eigen::CompleteOrthogonalDecomposition<Matrix>;

/// The solution of least norm.
Matrix solved(const Decomposition& decomposition, const Matrix& right) {
  return decomposition.solve(right);
}

/// The Bernstein points of a function times a bilinear one.
Grid<Complex> times_bilinear(const Grid<Complex>& f, const std::array<Complex, 4>& corners) {
  const int n = f.rows();
  Grid<Complex> product(n + 1, n + 1);
  const auto part = [n](int at, bool high) { return (high ? at : n - at) / double(n); };
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      for (int corner = 0; corner < 4; ++corner) {
        const bool high_i = corner == 1 || corner == 2, high_j = corner >= 2;
        const int k = i - high_i, l = j - high_j;
        if (k < 0 || l < 0 || k >= n || l >= n) continue;
        product(i, j) +=
            part(i, high_i) * part(j, high_j) * corners[static_cast<std::size_t>(corner)] * f(k, l);
      }
  return product;
}

/// The function z^a conj(z)^b on a quad of sector 0, of bidegree `degree`.
Grid<Complex> power(const PolygonLayout& layout, int quad, int a, int b, int degree) {
  std::array<Complex, 4> z, conjugate;
  const auto places = corners_from(layout, {quad, 0, 0});
  for (std::size_t i = 0; i < 4; ++i) {
    z[i] = {places[i][0], places[i][1]};
    conjugate[i] = std::conj(z[i]);
  }
  Grid<Complex> f(1, 1, 1.0);
  for (int k = 0; k < degree; ++k)
    f = times_bilinear(f, k < a ? z : k < a + b ? conjugate : std::array<Complex, 4>{1, 1, 1, 1});
  return f;
}

/// Makes the systems of all frequencies and joins their solutions.
class OperatorMaker {
 public:
  OperatorMaker(const PolygonLayout& layout, const FillPoints& points, const FillData& data,
                FillGoal goal, const std::vector<FillRow>& rows)
      : layout_(layout), points_(points), data_(data), goal_(goal), rows_(rows) {
    for (int quad = 0; quad < points.quads; ++quad)
      energies_.push_back(thin_plate(layout, quad, points.degree));
  }

  Grid<double> weights() const;

 private:
  Complex turn(int frequency, int sector) const {
    return std::polar(1.0, frequency * sector * sector_angle(layout_.sides));
  }
  /// The centre is the same in all sectors: it has no part in other frequencies.
  int unknowns(int frequency) const { return points_.inner() - (frequency == 0 ? 0 : 1); }

  Matrix conditions(int frequency, bool second_order) const;
  Matrix energy(int frequency) const;
  Matrix powers(int frequency) const;
  Matrix data_of(const Matrix& powers, int frequency) const;
  Matrix least_energy(int frequency) const;
  Matrix mode(int frequency) const;

  const PolygonLayout& layout_;
  const FillPoints& points_;
  const FillData& data_;
  FillGoal goal_;
  const std::vector<FillRow>& rows_;
  std::vector<Grid<double>> energies_;
};

/// Columns: the sector's data, then the unknowns; the conditions are (A, -B) of it.
Matrix OperatorMaker::conditions(int frequency, bool second_order) const {
  std::vector<const FillRow*> chosen;
  for (const FillRow& row : rows_)
    if (row.second_order == second_order) chosen.push_back(&row);
  const int data = data_.count();
  Matrix matrix = Matrix::Zero(static_cast<Index>(chosen.size()), data + unknowns(frequency));
  for (std::size_t r = 0; r < chosen.size(); ++r) {
    const auto row = static_cast<Index>(r);
    for (const FillTerm& term : chosen[r]->terms) {
      const bool border = term.point.number < points_.border;
      const Index column = border ? term.point.number : data + term.point.number - points_.border;
      if (column < matrix.cols())
        matrix(row, column) += term.factor * turn(frequency, term.point.sector);
    }
    if (chosen[r]->datum >= 0) matrix(row, chosen[r]->datum) -= 1;
  }
  return matrix;
}

/// The energy by all points of a sector, border first.
Matrix OperatorMaker::energy(int frequency) const {
  const int count = points_.border + unknowns(frequency);
  Matrix sum = Matrix::Zero(count, count);
  const auto place = static_cast<std::size_t>((points_.degree + 1) * (points_.degree + 1));
  for (std::size_t quad = 0; quad < energies_.size(); ++quad)
    for (std::size_t i = 0; i < place; ++i)
      for (std::size_t j = 0; j < place; ++j) {
        const FillPoint& a = points_.points[quad * place + i];
        const FillPoint& b = points_.points[quad * place + j];
        if (a.number >= count || b.number >= count) continue;
        sum(a.number, b.number) += energies_[quad](static_cast<int>(i), static_cast<int>(j)) *
                                   turn(frequency, b.sector - a.sector);
      }
  return sum;
}

/// The polynomials of this frequency at all points of sector 0, border first; one in each column.
Matrix OperatorMaker::powers(int frequency) const {
  std::vector<std::array<int, 2>> exponents;
  for (int a = 0; a <= kReproduced; ++a)
    for (int b = 0; a + b <= kReproduced; ++b)
      if ((a - b - frequency) % layout_.sides == 0 && a + b <= points_.degree)
        exponents.push_back({a, b});
  Matrix values(points_.count, static_cast<Index>(exponents.size()));
  const auto place = static_cast<std::size_t>((points_.degree + 1) * (points_.degree + 1));
  for (std::size_t e = 0; e < exponents.size(); ++e)
    for (int quad = 0; quad < points_.quads; ++quad) {
      const auto f = power(layout_, quad, exponents[e][0], exponents[e][1], points_.degree);
      for (std::size_t k = 0; k < place; ++k) {
        const FillPoint& point = points_.points[static_cast<std::size_t>(quad) * place + k];
        values(point.number, static_cast<Index>(e)) =
            f.values()[k] * turn(frequency, -point.sector);
      }
    }
  return values;
}

Matrix OperatorMaker::data_of(const Matrix& powers, int frequency) const {
  Matrix data = Matrix::Zero(data_.count(), powers.cols());
  data.topRows(points_.border) = powers.topRows(points_.border);
  for (const FillRow& row : rows_)
    if (row.datum >= 0)
      for (const FillTerm& term : row.terms)
        data.row(row.datum) +=
            (term.factor * turn(frequency, term.point.sector)) * powers.row(term.point.number);
  return data;
}

/// The unknowns of least energy that meet the conditions, by the data.
Matrix OperatorMaker::least_energy(int frequency) const {
  const int data = data_.count(), count = unknowns(frequency);
  const bool soft = goal_ == FillGoal::FirstNearSecond;
  Matrix hard = conditions(frequency, false);
  const Matrix second = conditions(frequency, true);
  if (!soft && second.rows() > 0) {
    const Matrix first = hard;
    hard.resize(first.rows() + second.rows(), first.cols());
    hard << first, second;
  }
  const Matrix whole = energy(frequency);
  Matrix quadratic = whole.bottomRightCorner(count, count);
  Matrix linear = Matrix::Zero(count, data);
  linear.leftCols(points_.border) = whole.bottomLeftCorner(count, points_.border);
  if (soft) {
    const Matrix a = second.rightCols(count), turned = adjoint(a);
    quadratic += kNearSecond * product(turned, a);
    linear += kNearSecond * product(turned, second.leftCols(data));
  }
  Decomposition solver;
  solver.setThreshold(kRedundant);
  solver.compute(Matrix(hard.rightCols(count)));
  Matrix solution = -solved(solver, hard.leftCols(data));
  const Index kernel_size = count - solver.rank();
  if (kernel_size == 0) return solution;
  // A P = Q [T 0; 0 0] Z, so the kernel is spanned by the last columns of P Z^H.
  const Matrix turned = adjoint(solver.matrixZ());
  const Matrix kernel = solver.colsPermutation() * Matrix(turned.rightCols(kernel_size));
  const Matrix across = adjoint(kernel);
  const Matrix inside = product(product(across, quadratic), kernel);
  const Matrix slope = product(quadratic, solution) + linear;
  const Matrix step = inside.ldlt().solve(product(across, slope));
  solution -= product(kernel, step);
  return solution;
}

Matrix OperatorMaker::mode(int frequency) const {
  const Matrix least = least_energy(frequency);
  const Matrix cubics = powers(frequency);
  if (cubics.cols() == 0) return least;
  const Matrix data = data_of(cubics, frequency);
  const Matrix fit = solved(Decomposition(data), Matrix::Identity(data.rows(), data.rows()));
  const Matrix inner = cubics.middleRows(points_.border, unknowns(frequency));
  return product(inner, fit) + least - product(least, product(data, fit));
}

Grid<double> OperatorMaker::weights() const {
  const int n = layout_.sides, data = data_.count();
  Grid<double> joined(points_.inner(), n * data);
  for (int frequency = 0; 2 * frequency <= n; ++frequency) {
    const bool alone = frequency == 0 || 2 * frequency == n;  // else with its conjugate
    const Matrix part = mode(frequency) * ((alone ? 1.0 : 2.0) / n);
    for (int sector = 0; sector < n; ++sector) {
      const Complex factor = turn(frequency, sector);
      for (Index i = 0; i < part.rows(); ++i)
        for (Index j = 0; j < data; ++j)
          joined(static_cast<int>(i), sector * data + static_cast<int>(j)) +=
              (part(i, j) * factor).real();
    }
  }
  return joined;
}

FillContinuity continuity_of(FillGoal goal) {
  return goal == FillGoal::First ? FillContinuity::G1 : FillContinuity::G2;
}

struct CachedOperator {
  std::once_flag made;
  std::shared_ptr<const FillOperator> value;
};

}  // namespace

FillOperator::FillOperator(FillLayout layout, int sides, int degree, FillGoal goal)
    : layout_(polygon_layout(layout, sides)),
      goal_(goal),
      data_{.degree = degree, .order = goal == FillGoal::First ? 1 : 2} {
  if (degree < 2 || degree > kMaxFillDegree)
    throw InvalidInput("FillOperator: a degree within 2.." + std::to_string(kMaxFillDegree) +
                       " is wanted, got " + std::to_string(degree));
  points_ = fill_points(layout_, degree);
  rows_ = fill_conditions(layout_, points_, continuity_of(goal));
  weights_ = OperatorMaker(layout_, points_, data_, goal, rows_).weights();
}

std::vector<Vec4> FillOperator::control_points(std::span<const Vec4> data) const {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const int n = layout_.sides, count = data_.count();
  RowMajor stacked(n * count, 4 * n);
  for (int sector = 0; sector < n; ++sector)
    for (int behind = 0; behind < n; ++behind)
      for (int k = 0; k < count; ++k)
        for (int x = 0; x < 4; ++x)
          stacked(behind * count + k, 4 * sector + x) =
              data[static_cast<std::size_t>((sector - behind + n) % n * count + k)][x];
  const Eigen::Map<const RowMajor> weights(weights_.values().data(), weights_.rows(),
                                           weights_.columns());
  const RowMajor inner = weights * stacked;
  std::vector<Vec4> result;
  for (int sector = 0; sector < n; ++sector) {
    for (int k = 0; k < points_.border; ++k)
      result.push_back(data[static_cast<std::size_t>(sector * count + k)]);
    for (int k = 0; k < points_.inner(); ++k) {
      // One centre for all: the sums of the others may differ in their last bits.
      const int owner = k + 1 == points_.inner() ? 0 : 4 * sector;
      result.push_back(
          {inner(k, owner), inner(k, owner + 1), inner(k, owner + 2), inner(k, owner + 3)});
    }
  }
  return result;
}

double FillOperator::residual(std::span<const Vec4> control_points,
                              std::span<const Vec4> data) const {
  const int n = layout_.sides;
  double largest = 0;
  for (int sector = 0; sector < n; ++sector)
    for (const FillRow& row : rows_) {
      if (row.second_order && goal_ == FillGoal::FirstNearSecond) continue;
      Vec4 sum;
      for (const FillTerm& term : row.terms)
        sum += term.factor *
               control_points[static_cast<std::size_t>(
                   (sector + term.point.sector + n) % n * points_.count + term.point.number)];
      if (row.datum >= 0) sum -= data[static_cast<std::size_t>(sector * data_.count() + row.datum)];
      largest = std::max(largest, max_norm(sum));
    }
  return largest;
}

std::shared_ptr<const FillOperator> fill_operator(FillLayout layout, int sides, int degree,
                                                  FillGoal goal) {
  static std::mutex guard;
  static std::map<std::tuple<FillLayout, int, int, FillGoal>, CachedOperator> known;
  CachedOperator* entry = nullptr;
  {
    const std::lock_guard lock(guard);
    entry = &known[{layout, sides, degree, goal}];
  }
  std::call_once(entry->made, [&] {
    entry->value = std::make_shared<const FillOperator>(layout, sides, degree, goal);
  });
  return entry->value;
}

}  // namespace blossom
