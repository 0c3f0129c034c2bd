// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/cells/pair_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "core/surfaces/gap/newton.h"
#include "core/surfaces/pairs/arc_stretches.h"
#include "core/surfaces/pairs/border_roots.h"
#include "tests/support/cubic_family.h"
#include "tests/support/quadric_patches.h"

namespace blossom {
namespace {

using testing::cubic_pair;
using testing::CubicPair;

constexpr double kCut = 0.4865;

struct PatchesRow {
  RationalBezierPatch a, b;
  bool rational;
};

class PairModels : public ::testing::TestWithParam<int> {
 protected:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  static PatchesRow patches() {
    if (GetParam() % 2 == 0)
      return {testing::sphere_octant({0, 0, 0}, 2), testing::sphere_octant({0.3, -0.2, 0.5}, 2),
              true};
    const CubicPair pair = cubic_pair(testing::loop(0.43, 0.57, 0.2));
    return {pair.a.patches(0, 0), pair.b.patches(0, 0), false};
  }

  int descend(CellTree& tree, int halvings) {
    int cell = 0;
    for (int i = 0; i < halvings; ++i) cell = tree.split(cell) + int(random_() % 2);
    return cell;
  }

  // A cell of each patch.
  struct RandomCells {
    explicit RandomCells(PairModels& of)
        : a(of.descend(tree_a, GetParam() % 9)), b(of.descend(tree_b, GetParam() % 7)) {}

    PatchesRow row = patches();
    CellTree tree_a{row.a, row.rational, {}, CellForm::Bezier, kCut};
    CellTree tree_b{row.b, row.rational, {}, CellForm::Bezier, kCut};
    int a, b;
    PairModel model{tree_a, tree_a[a], tree_b, tree_b[b]};
  };

  // The cell that holds a point, after so many halvings.
  static int cell_at(CellTree& tree, double u, double v, int halvings) {
    int cell = 0;
    const auto has = [](const Interval& x, double t) { return x.from <= t && t <= x.to; };
    for (int i = 0; i < halvings; ++i) {
      const int child = tree.split(cell);
      cell = has(tree[child].u, u) && has(tree[child].v, v) ? child : child + 1;
    }
    return cell;
  }

  PairPart random_part() {
    PairPart part;
    for (std::size_t i = 0; i < 4; ++i) {
      part.radius[i] = 0.5 * std::pow(10, uniform(-4, 0));
      part.middle[i] = uniform(-0.5 + part.radius[i], 0.5 - part.radius[i]);
    }
    return part;
  }

  std::array<double, 4> place_in(const PairPart& part) {
    std::array<double, 4> z;
    for (std::size_t i = 0; i < 4; ++i) z[i] = part.middle[i] + part.radius[i] * uniform(-1, 1);
    return z;
  }

  std::mt19937_64 random_{static_cast<unsigned>(GetParam())};
};

bool holds(const VectorBounds& bounds, const Vec3& x) {
  for (int k = 0; k < 3; ++k)
    if (std::abs(x[k] - bounds.middle[k]) > bounds.radius[k]) return false;
  return true;
}

TEST_P(PairModels, BoundTheDerivativesInAPart) {
  const RandomCells cells(*this);
  const PairModel& model = cells.model;
  const PairPart part = random_part();

  const JacobianBounds bounds = model.jacobian(model.jet(place_in(part)), part);

  for (int sample = 0; sample < 50; ++sample) {
    const PairJet jet = model.jet(place_in(part));
    for (int k = 0; k < 4; ++k)
      EXPECT_TRUE(holds(bounds.column(k), jet.columns[static_cast<std::size_t>(k)])) << k;
  }
}

// The means by the trapezoidal rule, whose error grows with the square of its steps.
TEST_P(PairModels, BoundTheMeanDerivativesOnTheWayToAPart) {
  const RandomCells cells(*this);
  const PairModel& model = cells.model;
  const PairPart part = random_part();
  const auto start = place_in(part);

  const JacobianBounds bounds = model.mean_jacobian(model.jet(start), part);

  constexpr int kSteps = 64;
  for (int sample = 0; sample < 20; ++sample) {
    const auto stop = place_in(part);
    std::array<Vec3, 4> mean{};
    for (int step = 0; step <= kSteps; ++step) {
      std::array<double, 4> z;
      for (std::size_t k = 0; k < 4; ++k) z[k] = start[k] + (stop[k] - start[k]) * step / kSteps;
      const double weight = (step % kSteps == 0 ? 0.5 : 1.0) / kSteps;
      const PairJet jet = model.jet(z);
      for (std::size_t k = 0; k < 4; ++k) mean[k] += weight * jet.columns[k];
    }
    for (int k = 0; k < 4; ++k) {
      VectorBounds wide = bounds.column(k);
      wide.radius += 1e-3 * wide.radius;
      EXPECT_TRUE(holds(wide, mean[static_cast<std::size_t>(k)])) << k;
    }
  }
}

// F with a shift that puts a root at a place chosen beforehand: narrowing has to keep it.
TEST_P(PairModels, KeepRootsWhenAPartIsNarrowed) {
  const PatchesRow row = patches();
  CellTree tree_a(row.a, row.rational, {}, CellForm::Bezier, kCut);
  CellTree tree_b(row.b, row.rational, {}, CellForm::Bezier, kCut);
  const int i = descend(tree_a, 4 + GetParam() % 5), j = descend(tree_b, 4 + GetParam() % 5);
  const PairModel model(tree_a, tree_a[i], tree_b, tree_b[j]);
  int narrowed = 0;
  for (int draw = 0; draw < 40; ++draw) {
    PairPart part = random_part();
    const auto root = place_in(part);
    const PairJet jet = model.jet(part.middle);
    const Vec3 shift = model.gap(root).value;
    const JacobianBounds bounds =
        draw % 2 == 0 ? model.jacobian(jet, part) : model.mean_jacobian(jet, part);
    const int along = bounds.best_column();
    const Minor minor = bounds.minor(along);
    if (!minor.regular) continue;
    const PairPart before = part;

    ASSERT_TRUE(narrow(part, minor, along, bounds.column(along), jet.place,
                       {jet.gap - shift, 2 * model.rounding()}));

    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_LE(std::abs(root[k] - part.middle[k]), part.radius[k] + 1e-13);
      narrowed += part.radius[k] < 0.9 * before.radius[k];
    }
  }
  EXPECT_GT(narrowed, 0);
}

TEST_P(PairModels, TellWhereNoRootIs) {
  const PatchesRow row = patches();
  CellTree tree_a(row.a, row.rational, {}, CellForm::Bezier, kCut);
  CellTree tree_b(row.b, row.rational, {}, CellForm::Bezier, kCut);
  int told = 0;
  for (int draw = 0; draw < 10; ++draw) {
    const int i = descend(tree_a, 10), j = descend(tree_b, 10);
    const PairModel model(tree_a, tree_a[i], tree_b, tree_b[j]);
    PairPart part = random_part();
    const PairJet jet = model.jet(part.middle);
    const JacobianBounds bounds = model.jacobian(jet, part);
    const int along = bounds.best_column();
    const Minor minor = bounds.minor(along);
    if (!minor.regular) continue;
    ++told;
    // Farther away than all columns reach together.
    Vec3 far{};
    for (int k = 0; k < 4; ++k)
      far = far + absolute(bounds.column(k).middle) + bounds.column(k).radius;

    EXPECT_FALSE(
        narrow(part, minor, along, bounds.column(along), jet.place, {1e3 * far, model.rounding()}));
  }
  EXPECT_GT(told, 0);
}

RationalBezierPatch moved(RationalBezierPatch patch, const Vec3& by) {
  for (Vec4& p : patch.points.values())
    for (int k = 0; k < 3; ++k) p[k] += p[3] * by[k];
  return patch;
}

// b is moved so that it meets a at a place chosen beforehand, near to the origin and far from it.
TEST_P(PairModels, AreNotApartWhereTheyMeet) {
  const Vec3 far = GetParam() % 3 == 0 ? Vec3{1e4, -2e4, 3e4} : Vec3{};
  const PatchesRow row = patches();
  const RationalBezierPatch a = moved(row.a, far), b = moved(row.b, far);
  CellTree tree_a(a, row.rational, {}, CellForm::Bezier, kCut);
  CellTree tree_b(b, row.rational, {}, CellForm::Bezier, kCut);
  for (int draw = 0; draw < 40; ++draw) {
    const int i = descend(tree_a, draw % 12), j = descend(tree_b, draw % 11);
    const PairModel model(tree_a, tree_a[i], tree_b, tree_b[j]);
    const auto root = place_in(PairPart{});
    CellTree tree(moved(b, model.gap(root).value), row.rational, {}, CellForm::Bezier, kCut);
    const int there = cell_at(tree, at(tree_b[j].u, 0.5), at(tree_b[j].v, 0.5), tree_b[j].depth);
    EXPECT_FALSE(PairModel(tree_a, tree_a[i], tree, tree[there]).are_disjoint(0));
  }
}

// One surface above the other: cells whose boxes and planes leave it open.
TEST(PairModel, TellsApartWhatBendsAlike) {
  const CubicPair pair = cubic_pair(testing::linear(0.01, 0.002, -0.001));
  CellTree tree_a(pair.a.patches(0, 0), false, {}, CellForm::Bezier, kCut);
  CellTree tree_b(pair.b.patches(0, 0), false, {}, CellForm::Bezier, kCut);
  const int points = tree_a.shape().plane_size();
  int open = 0, told = 0;
  const auto leaves = [](CellTree& tree, int halvings) {
    std::vector<int> cells{0};
    for (int i = 0; i < halvings; ++i) {
      std::vector<int> halves;
      for (const int cell : cells) {
        const int child = tree.split(cell);
        halves.insert(halves.end(), {child, child + 1});
      }
      cells = halves;
    }
    return cells;
  };
  const std::vector<int> cells_a = leaves(tree_a, 6), cells_b = leaves(tree_b, 6);
  for (const int i : cells_a)
    for (const int j : cells_b) {
      if (separated(tree_a[i], tree_b[j], points, points)) continue;
      ++open;
      told += PairModel(tree_a, tree_a[i], tree_b, tree_b[j]).are_disjoint(1e-7);
    }
  EXPECT_GT(open, 50);
  EXPECT_GT(told, open / 2);
}

// Points of the arc found by Newton's method lie in each stretch that has their parameter, however
// often it is narrowed.
TEST_P(PairModels, KeepTheArcInItsStretches) {
  const PatchesRow row = patches();
  CellTree tree_a(row.a, row.rational, {}, CellForm::Bezier, kCut);
  CellTree tree_b(row.b, row.rational, {}, CellForm::Bezier, kCut);
  int held = 0;
  for (int draw = 0; draw < 60; ++draw) {
    const Point4 start{uniform(0, 1), uniform(0, 1), uniform(0, 1), uniform(0, 1)};
    const auto root = newton(row.a, row.b, start, draw % 4, Box4{{{0, 1}, {0, 1}, {0, 1}, {0, 1}}});
    if (!root || !std::ranges::all_of(*root, [](double x) { return 0 <= x && x <= 1; })) continue;
    const int i = cell_at(tree_a, (*root)[0], (*root)[1], 8);
    const int j = cell_at(tree_b, (*root)[2], (*root)[3], 8);
    const Cell a = tree_a[i], b = tree_b[j];
    const JacobianBounds bounds(a, b);
    const int along = bounds.certified_column();
    if (along < 0) continue;
    const PairModel model(tree_a, a, tree_b, b);
    ArcStretches arc(model, along);
    const Box4 box = box_of(a, b);
    const auto off = [&](const PairPart& part, std::size_t k) {
      const double z = ((*root)[k] - at(box[k], 0.5)) / length(box[k]);
      return std::abs(z - part.middle[k]) - part.radius[k];
    };
    for (std::size_t number = 1; number < ArcStretches::kCount; ++number) {
      arc.stretch(number);
      arc.narrow_again(number);
      const ArcStretch& s = arc.stretch(number);
      if (s.empty || off(s.part, static_cast<std::size_t>(along)) > 0) continue;
      for (std::size_t k = 0; k < 4; ++k) EXPECT_LE(off(s.part, k), 1e-10);
      ++held;
    }
    EXPECT_FALSE(arc.stretch(1).empty);
  }
  EXPECT_GT(held, 0);
}

INSTANTIATE_TEST_SUITE_P(Draws, PairModels, ::testing::Range(0, 30));

}  // namespace
}  // namespace blossom
