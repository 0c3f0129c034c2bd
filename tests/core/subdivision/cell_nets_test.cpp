// SPDX-License-Identifier: LGPL-2.1-or-later
// Halvings of nets, one by one and in chains of twenty, against exact rationals.

#include "core/subdivision/cell_nets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/forms/algebra/conversion.h"
#include "core/forms/algebra/detail/conversion.h"
#include "core/math/detail/bernstein.h"
#include "core/math/matrix.h"
#include "tests/support/exact.h"
#include "tests/support/random.h"

namespace blossom {
namespace {

using testing::exact_gap;
using testing::pick;
using testing::Rational;
using testing::seeded;
using testing::uniform;

using Net = std::vector<double>;
using ExactPlane = Grid<Vec<Rational, 1>>;

Net random_net(testing::Random& random, const NetShape& shape) {
  Net net(static_cast<std::size_t>(shape.size()));
  for (double& value : net) value = uniform(random, -1, 1);
  return net;
}

struct Halves {
  Net low, high;
};

using Halving = void (*)(const NetShape&, const double*, double, double*, double*);

Halves halve(Halving halving, const NetShape& shape, const Net& net, double cut) {
  Halves halves{Net(net.size()), Net(net.size())};
  halving(shape, net.data(), cut, halves.low.data(), halves.high.data());
  return halves;
}

double& entry(const NetShape& shape, Net& net, int plane, int i, int j) {
  return net[static_cast<std::size_t>(plane * shape.plane_size() + i * shape.columns + j)];
}

Net transposed(const NetShape& shape, Net net) {
  const NetShape turned{shape.columns, shape.rows, shape.planes};
  Net result(net.size());
  for (int k = 0; k < shape.planes; ++k)
    for (int i = 0; i < shape.rows; ++i)
      for (int j = 0; j < shape.columns; ++j)
        entry(turned, result, k, j, i) = entry(shape, net, k, i, j);
  return result;
}

ExactPlane exact_plane(const NetShape& shape, Net net, int plane) {
  ExactPlane result(shape.rows, shape.columns);
  for (int i = 0; i < shape.rows; ++i)
    for (int j = 0; j < shape.columns; ++j)
      result(i, j)[0] = Rational(entry(shape, net, plane, i, j));
  return result;
}

// Where a chain of halvings has arrived, exactly.
struct Place {
  IntervalOf<Rational> u, v;

  void enter(bool along_u, bool low, double cut) {
    IntervalOf<Rational>& side = along_u ? u : v;
    const Rational at = side.from + (side.to - side.from) * Rational(cut);
    (low ? side.to : side.from) = at;
  }
};

// Coefficients after x = h y + m along u, by the binomial theorem.
ExactPlane substituted(const ExactPlane& plane, const Rational& h, const Rational& m) {
  ExactPlane result(plane.rows(), plane.columns());
  const auto h_power = detail::powers(h, plane.rows()), m_power = detail::powers(m, plane.rows());
  for (int k = 0; k < plane.rows(); ++k)
    for (int i = k; i < plane.rows(); ++i)
      for (int j = 0; j < plane.columns(); ++j)
        result(k, j)[0] += Rational(binomial(i, k)) * h_power[detail::index(k)] *
                           m_power[detail::index(i - k)] * plane(i, j)[0];
  return result;
}

ExactPlane turned(const ExactPlane& plane) {
  ExactPlane result(plane.columns(), plane.rows());
  for (int i = 0; i < plane.rows(); ++i)
    for (int j = 0; j < plane.columns(); ++j) result(j, i) = plane(i, j);
  return result;
}

// The shapes that have code of their own, and others; rows and columns swapped in some.
const NetShape kShapes[] = {{4, 4, 3}, {3, 3, 4}, {6, 6, 3}, {2, 2, 3},   {3, 2, 4},  {2, 3, 4},
                            {1, 1, 3}, {1, 5, 3}, {8, 3, 4}, {10, 10, 3}, {26, 4, 3}, {5, 26, 3}};

class CellNets : public ::testing::TestWithParam<int> {
 protected:
  NetShape shape() const { return kShapes[GetParam() % std::size(kShapes)]; }
  // In the middle for a third of the seeds: those halvings have code of their own. Cuts of large
  // nets have few digits, which keeps the rationals short.
  double cut(testing::Random& random) const {
    if (GetParam() % 3 == 0) return 0.5;
    return shape().size() > 300 ? pick(random, 20, 44) / 64.0 : uniform(random, 0.3, 0.7);
  }

  // Halves a net twenty times, at random along u and v, and goes on with either half.
  Place halved_twenty_times(testing::Random& random, Net& net, Halving halve_u,
                            Halving halve_v) const {
    Place place;
    for (int depth = 0; depth < 20; ++depth) {
      const bool along_u = pick(random, 0, 1) == 0, low = pick(random, 0, 1) == 0;
      const double at = cut(random);
      Halves halves = halve(along_u ? halve_u : halve_v, shape(), net, at);
      net = low ? halves.low : halves.high;
      place.enter(along_u, low, at);
    }
    return place;
  }
};

TEST(CellNet, HalvesOfTheSaddleAreKnownByHand) {
  const NetShape shape{2, 2, 3};
  const Net saddle{0, 0, 1, 1, 0, 1, 0, 1, 0, 0, 0, 1};  // x = u, y = v, z = u v

  const Halves along_u = halve(halve_bezier_u, shape, saddle, 0.25);
  const Halves along_v = halve(halve_bezier_v, shape, saddle, 0.25);

  EXPECT_EQ(along_u.low, (Net{0, 0, 0.25, 0.25, 0, 1, 0, 1, 0, 0, 0, 0.25}));
  EXPECT_EQ(along_u.high, (Net{0.25, 0.25, 1, 1, 0, 1, 0, 1, 0, 0.25, 0, 1}));
  EXPECT_EQ(along_v.low, (Net{0, 0, 1, 1, 0, 0.25, 0, 0.25, 0, 0, 0, 0.25}));
}

TEST(CellNet, MonomialHalvesOfAParabolaAreKnownByHand) {
  const NetShape shape{3, 1, 1};
  const Net square{0, 0, 1};  // x^2 on [-1, 1]

  const Halves middle = halve(halve_monomial_u, shape, square, 0.5);
  const Halves off = halve(halve_monomial_u, shape, square, 0.75);

  EXPECT_EQ(middle.low, (Net{0.25, -0.5, 0.25}));     // ((y - 1) / 2)^2
  EXPECT_EQ(middle.high, (Net{0.25, 0.5, 0.25}));     // ((y + 1) / 2)^2
  EXPECT_EQ(off.low, (Net{0.0625, -0.375, 0.5625}));  // (3/4 y - 1/4)^2
  EXPECT_EQ(off.high, (Net{0.5625, 0.375, 0.0625}));  // (1/4 y + 3/4)^2
}

TEST(CellNet, ConversionOfAParabolaIsKnownByHand) {
  const NetShape shape{3, 1, 1};
  Net net(3), coefficients(3);

  bezier_from_monomial(shape, Net{0, 0, 1}.data(), net.data());
  monomial_from_bezier(shape, net.data(), coefficients.data());

  EXPECT_EQ(net, (Net{1, -1, 1}));
  EXPECT_EQ(coefficients, (Net{0, 0, 1}));
}

TEST_P(CellNets, HalvingAlongVIsHalvingAlongUOfTheTransposedNetBitForBit) {
  auto random = seeded(GetParam());
  const NetShape turned_shape{shape().columns, shape().rows, shape().planes};
  const Net net = random_net(random, shape());
  const double at = cut(random);
  for (const auto& [along_u, along_v] : {std::pair{&halve_bezier_u, &halve_bezier_v},
                                         std::pair{&halve_monomial_u, &halve_monomial_v}}) {
    const Halves direct = halve(*along_v, shape(), net, at);
    const Halves other = halve(*along_u, turned_shape, transposed(shape(), net), at);
    EXPECT_EQ(direct.low, transposed(turned_shape, other.low));
    EXPECT_EQ(direct.high, transposed(turned_shape, other.high));
  }
}

TEST_P(CellNets, HalvesShareTheirBorderBitForBit) {
  auto random = seeded(GetParam());
  Net net = random_net(random, shape());
  Halves halves = halve(halve_bezier_u, shape(), net, cut(random));
  for (int k = 0; k < shape().planes; ++k)
    for (int j = 0; j < shape().columns; ++j) {
      EXPECT_EQ(entry(shape(), halves.low, k, shape().rows - 1, j),
                entry(shape(), halves.high, k, 0, j));
      EXPECT_EQ(entry(shape(), halves.low, k, 0, j), entry(shape(), net, k, 0, j));
    }
}

TEST_P(CellNets, ReversedNetsHaveReversedHalvesInTheMiddleBitForBit) {
  auto random = seeded(GetParam());
  Net net = random_net(random, shape()), reversed = net;
  for (int k = 0; k < shape().planes; ++k)
    for (int i = 0; i < shape().rows; ++i)
      for (int j = 0; j < shape().columns; ++j)
        entry(shape(), reversed, k, shape().rows - 1 - i, j) = entry(shape(), net, k, i, j);

  Halves halves = halve(halve_bezier_u, shape(), net, 0.5);
  Halves other = halve(halve_bezier_u, shape(), reversed, 0.5);

  for (int k = 0; k < shape().planes; ++k)
    for (int i = 0; i < shape().rows; ++i)
      for (int j = 0; j < shape().columns; ++j)
        EXPECT_EQ(entry(shape(), halves.low, k, i, j),
                  entry(shape(), other.high, k, shape().rows - 1 - i, j));
}

TEST_P(CellNets, TwentyHalvingsOfABezierNetStayWithinTheStatedError) {
  auto random = seeded(GetParam());
  const Net start = random_net(random, shape());
  Net net = start;
  const Place place = halved_twenty_times(random, net, halve_bezier_u, halve_bezier_v);
  const double bound = halving_error(std::max(shape().rows, shape().columns) - 1, 20);
  const auto along_u = detail::subdivision_matrix(shape().rows - 1, place.u);
  const auto along_v = detail::subdivision_matrix(shape().columns - 1, place.v);

  double largest = 0;
  const ExactPlane expected =
      product_transposed(product(along_u, exact_plane(shape(), start, 0)), along_v);
  for (int i = 0; i < shape().rows; ++i)
    for (int j = 0; j < shape().columns; ++j)
      largest = std::max(largest, exact_gap(entry(shape(), net, 0, i, j), expected(i, j)[0]));

  RecordProperty("error_over_bound", std::to_string(largest / bound));
  EXPECT_LE(largest, bound);
}

TEST_P(CellNets, TwentyHalvingsOfCoefficientsStayWithinTheStatedError) {
  auto random = seeded(GetParam());
  const Net start = random_net(random, shape());
  Net coefficients = start;
  const Place place = halved_twenty_times(random, coefficients, halve_monomial_u, halve_monomial_v);
  // A cell [a, b] of [0, 1] is x = (b - a) y + (a + b - 1).
  const ExactPlane plane = exact_plane(shape(), start, 0);
  const ExactPlane along_u =
      substituted(plane, place.u.to - place.u.from, place.u.from + place.u.to - 1);
  const ExactPlane expected = turned(
      substituted(turned(along_u), place.v.to - place.v.from, place.v.from + place.v.to - 1));
  double size = 0, error = 0;
  for (int i = 0; i < shape().rows; ++i)
    for (int j = 0; j < shape().columns; ++j) {
      size += std::abs(plane(i, j)[0].convert_to<double>());
      error += exact_gap(entry(shape(), coefficients, 0, i, j), expected(i, j)[0]);
    }
  const int degree = std::max(shape().rows, shape().columns) - 1;
  const double bound = monomial_halving_error(degree, 20) * size;

  RecordProperty("error_over_bound", std::to_string(error / bound));
  EXPECT_LE(error, bound);
}

TEST_P(CellNets, ConversionsAreWithinTheStatedErrors) {
  auto random = seeded(GetParam());
  const int n = shape().rows - 1, m = shape().columns - 1;
  const Net start = random_net(random, shape());
  Net net(start.size()), coefficients(start.size());
  bezier_from_monomial(shape(), start.data(), net.data());
  monomial_from_bezier(shape(), start.data(), coefficients.data());

  const ExactPlane plane = exact_plane(shape(), start, 0);
  const IntervalOf<Rational> whole{Rational(-1), Rational(1)};
  const ExactPlane expected_net = product_transposed(
      product(detail::monomial_matrix(n, whole), plane), detail::monomial_matrix(m, whole));
  const ExactPlane expected_coefficients = detail::monomial_net(plane, Origin::Middle);
  double size = 0, net_error = 0, coefficient_error = 0;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= m; ++j) {
      size += std::abs(plane(i, j)[0].convert_to<double>());
      net_error =
          std::max(net_error, exact_gap(entry(shape(), net, 0, i, j), expected_net(i, j)[0]));
      coefficient_error +=
          exact_gap(entry(shape(), coefficients, 0, i, j), expected_coefficients(i, j)[0]);
    }

  EXPECT_LE(net_error, bezier_from_monomial_error(n, m) * size);
  EXPECT_LE(coefficient_error, monomial_from_bezier_error(n, m));
}

TEST_P(CellNets, HalvingInEitherFormGivesTheSameCells) {
  auto random = seeded(GetParam());
  const int n = shape().rows - 1, m = shape().columns - 1;
  const Net coefficients = random_net(random, shape());
  Net net(coefficients.size()), halved(coefficients.size());
  bezier_from_monomial(shape(), coefficients.data(), net.data());
  const double at = cut(random);

  const Net in_bezier = halve(halve_bezier_u, shape(), net, at).high;
  const Net in_monomial = halve(halve_monomial_u, shape(), coefficients, at).high;
  bezier_from_monomial(shape(), in_monomial.data(), halved.data());

  const int degree = std::max(n, m);
  const double bound = (monomial_halving_error(degree, 1) + halving_error(degree, 1) +
                        2 * bezier_from_monomial_error(n, m)) *
                       (n + 1) * (m + 1);
  for (std::size_t k = 0; k < halved.size(); ++k) EXPECT_NEAR(halved[k], in_bezier[k], bound);
}

TEST_P(CellNets, PlanesDoNotMix) {
  auto random = seeded(GetParam());
  Net net = random_net(random, shape());
  const Halves all = halve(halve_bezier_v, shape(), net, 0.4);
  const NetShape one{shape().rows, shape().columns, 1};
  for (int k = 0; k < shape().planes; ++k) {
    const auto begin = net.begin() + k * shape().plane_size();
    const Halves single = halve(halve_bezier_v, one, Net(begin, begin + shape().plane_size()), 0.4);
    EXPECT_TRUE(std::equal(single.low.begin(), single.low.end(),
                           all.low.begin() + k * shape().plane_size()));
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, CellNets, ::testing::Range(0, 36));

}  // namespace
}  // namespace blossom
