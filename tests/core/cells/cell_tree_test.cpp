// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/cells/cell_tree.h"

#include <gtest/gtest.h>

#include <random>

#include "core/cells/cell_pair.h"
#include "core/forms/evaluation.h"

namespace blossom {
namespace {

constexpr double kRounding = 1e-13;

class RandomPatches : public ::testing::TestWithParam<int> {
 protected:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  // A patch over the unit square with random heights; rational when the seed is odd.
  RationalBezierPatch patch(double lift = 0) {
    const int n = 1 + GetParam() % 5, m = 1 + GetParam() / 5 % 4;
    RationalBezierPatch p{Grid<Vec4>(n + 1, m + 1)};
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= m; ++j) {
        const double w = rational() ? uniform(0.2, 3) : 1;
        p.points(i, j) = {w * (i / double(n) + uniform(-0.1, 0.1)),
                          w * (j / double(m) + uniform(-0.1, 0.1)), w * (uniform(-1, 1) + lift), w};
      }
    return p;
  }
  bool rational() const { return GetParam() % 2 == 1; }

  // A cell some halvings down a random path.
  int descend(CellTree& tree, int halvings) {
    int cell = 0;
    for (int i = 0; i < halvings; ++i) cell = tree.split(cell) + int(random_() % 2);
    return cell;
  }

  std::mt19937_64 random_{static_cast<unsigned>(GetParam())};
};

TEST_P(RandomPatches, CellsContainTheirPartOfThePatch) {
  const RationalBezierPatch p = patch();
  const Vec3 origin{0.5, 0.25, 0.125};
  for (const CellForm form : {CellForm::Bezier, CellForm::Monomial}) {
    CellTree tree(p, rational(), origin, form, 0.4865);
    for (int trial = 0; trial < 20; ++trial) {
      const Cell& cell = tree[descend(tree, trial)];
      for (int sample = 0; sample < 20; ++sample) {
        const double u = at(cell.u, uniform(0, 1)), v = at(cell.v, uniform(0, 1));
        const PatchJet jet = jet_at(p, u, v, 1);
        const Vec3 x = jet.point - origin;
        const Vec3 du = jet.u * length(cell.u), dv = jet.v * length(cell.v);
        const double height = dot(cell.plane.normal, x);
        EXPECT_GE(height, cell.plane.low - kRounding);
        EXPECT_LE(height, cell.plane.high + kRounding);
        for (int k = 0; k < 3; ++k) {
          EXPECT_GE(x[k], cell.low[k] - kRounding);
          EXPECT_LE(x[k], cell.high[k] + kRounding);
          EXPECT_LE(std::abs(du[k] - cell.du.middle[k]), cell.du.radius[k] + kRounding);
          EXPECT_LE(std::abs(dv[k] - cell.dv.middle[k]), cell.dv.radius[k] + kRounding);
        }
      }
    }
  }
}

TEST_P(RandomPatches, BoundsShrinkWithTheCell) {
  CellTree tree(patch(), rational(), {}, CellForm::Auto, 0.4865);
  const Cell whole = tree[0];
  const Cell small = tree[descend(tree, 16)];

  EXPECT_LT(small.extent, 0.1 * whole.extent);
  EXPECT_LT(small.plane.high - small.plane.low, 0.02 * whole.extent);
  // A derivative by the cell's own parameter shrinks with it; its spread shrinks faster.
  EXPECT_LT(norm(small.du.radius) + norm(small.dv.radius),
            0.05 * (norm(whole.du.radius) + norm(whole.dv.radius)) + 1e-9);
}

TEST_P(RandomPatches, SeparatedCellsHaveNoPointInCommon) {
  const RationalBezierPatch p = patch(), q = patch(0.3);
  CellTree a(p, rational(), {}, CellForm::Auto, 0.4865);
  CellTree b(q, rational(), {}, CellForm::Auto, 0.4865);
  int met = 0;
  for (int trial = 0; trial < 200; ++trial) {
    // A common point by construction: q is moved so that it passes through a point of p.
    const int i = descend(a, trial % 12), j = descend(b, trial % 12);
    const Cell &ca = a[i], &cb = b[j];
    const Vec3 x = jet_at(p, at(ca.u, uniform(0, 1)), at(ca.v, uniform(0, 1)), 1).point;
    const Vec3 y = jet_at(q, at(cb.u, uniform(0, 1)), at(cb.v, uniform(0, 1)), 1).point;
    CellTree moved(q, rational(), y - x, CellForm::Auto, 0.4865);
    int same = 0;
    while (moved[same].u != cb.u || moved[same].v != cb.v) {
      const int child = moved.split(same);
      const auto holds = [](const Interval& outer, const Interval& inner) {
        return outer.from <= inner.from && inner.to <= outer.to;
      };
      same = holds(moved[child].u, cb.u) && holds(moved[child].v, cb.v) ? child : child + 1;
    }
    met += !separated(ca, moved[same], a.shape().plane_size(), b.shape().plane_size());
  }
  EXPECT_EQ(met, 200);
}

// The certified column is looked for in four minors at once.
TEST_P(RandomPatches, TheCertifiedColumnIsThatOfARegularMinor) {
  CellTree a(patch(), rational(), {}, CellForm::Auto, 0.4865);
  CellTree b(patch(0.3), rational(), {}, CellForm::Auto, 0.4865);
  int certified = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const int i = descend(a, trial % 12), j = descend(b, trial % 12);
    const JacobianBounds bounds(a[i], b[j]);
    const int column = bounds.certified_column();
    if (column >= 0) {
      EXPECT_TRUE(bounds.minor(column).regular);
    } else {
      for (int k = 0; k < 4; ++k) EXPECT_FALSE(bounds.minor(k).regular) << k;
    }
    if (bounds.minor(bounds.best_column()).regular) {
      EXPECT_EQ(column, bounds.best_column());
    }
    certified += column >= 0;
  }
  EXPECT_GT(certified, 0);
}

TEST(CertifiedColumn, OfColumnsThatAreZeroIsNone) {
  const VectorBounds zero{}, x{{1, 0, 0}, {0.01, 0.01, 0.01}}, y{{0, 1, 0}, {0.01, 0.01, 0.01}},
      z{{0, 0, 1}, {0.01, 0.01, 0.01}};
  EXPECT_EQ(JacobianBounds(std::array{zero, zero, x, y}).certified_column(), -1);
  EXPECT_EQ(JacobianBounds(std::array{zero, x, y, z}).certified_column(), 0);
  EXPECT_EQ(JacobianBounds(std::array{x, y, zero, z}).certified_column(), 2);
}

TEST_P(RandomPatches, ARegularMinorIsRegularAllOverThePair) {
  CellTree a(patch(), rational(), {}, CellForm::Auto, 0.4865);
  CellTree b(patch(0.3), rational(), {}, CellForm::Auto, 0.4865);
  int regular = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Cell ca = a[descend(a, 8)], cb = b[descend(b, 8)];
    const JacobianBounds bounds(ca, cb);
    const int left_out = bounds.best_column();
    if (!bounds.minor(left_out).regular) continue;
    ++regular;
    const auto kept = kept_columns(left_out);
    double least = 1e300, most = -1e300;
    for (int sample = 0; sample < 50; ++sample) {
      const PatchJet p = jet_at(a.patch(), at(ca.u, uniform(0, 1)), at(ca.v, uniform(0, 1)), 1);
      const PatchJet q = jet_at(b.patch(), at(cb.u, uniform(0, 1)), at(cb.v, uniform(0, 1)), 1);
      const std::array<Vec3, 4> columns{p.u, p.v, -q.u, -q.v};
      const double d = dot(columns[std::size_t(kept[0])],
                           cross(columns[std::size_t(kept[1])], columns[std::size_t(kept[2])]));
      least = std::min(least, d);
      most = std::max(most, d);
    }
    EXPECT_GT(least * most, 0);
  }
  EXPECT_GT(regular, 10);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomPatches, ::testing::Range(0, 20));

}  // namespace
}  // namespace blossom
