// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/tracing/sites.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/parallel.h"
#include "core/bounds/patch_boxes.h"
#include "core/surfaces/search/pair_search.h"
#include "tests/core/tracing/surface_pairs.h"

namespace blossom {
namespace {

class SmoothRuns : public ::testing::TestWithParam<testing::SurfacePair> {
 protected:
  template <class Check>
  void each_chain(const Check& check) {
    constexpr double kCut = 0.4865;
    const Vec3 origin;
    SurfaceCells a(GetParam().a, origin, CellForm::Auto, kCut);
    SurfaceCells b(GetParam().b, origin, CellForm::Auto, kCut);
    std::vector<StartPair> pairs;
    for (const auto& [i, j] : meeting_patches(PatchBoxes(GetParam().a), PatchBoxes(GetParam().b)))
      pairs.push_back({i, 0, j, 0});
    const PairSearchResult found = search_pairs(a, b, pairs, 1, KnownCurves({}, {}), {});
    std::vector<CriticalCluster> clusters;
    const std::vector<Chain> chains = chains_of(found, a, b, {}, clusters);
    ASSERT_FALSE(chains.empty());
    for (const Chain& chain : chains) check(ChainTracer(found, a, b, origin, chain));
  }
};

// The probes see a piece at two places; its error elsewhere is not much larger.
TEST_P(SmoothRuns, HavePiecesAsGoodAsWanted) {
  for (const double wanted : {1e-6, 1e-9})
    each_chain([&](const ChainTracer& tracer) {
      for (const SmoothRun& run : smooth_runs(tracer, GetParam().a, GetParam().b, {wanted}, 0.125))
        for (std::size_t i = 0; i < run.pieces.size(); ++i)
          for (int k = 1; k < 20; ++k) {
            const Vec7 x = value_at(run.pieces[i].points, k / 20.0);
            const double sine = std::min(run.sites[i].point.sine, run.sites[i + 1].point.sine);
            EXPECT_LE(relative_gap(gaps_at(GetParam().a, GetParam().b, x), {wanted}, sine), 0.4);
          }
    });
}

TEST_P(SmoothRuns, FollowEachOther) {
  each_chain([&](const ChainTracer& tracer) {
    const auto runs = smooth_runs(tracer, GetParam().a, GetParam().b, {1e-7}, 0.125);
    EXPECT_EQ(runs.front().sites.front().station, 0);
    EXPECT_EQ(runs.back().sites.back().station, tracer.stations().back());
    double reached = 0;
    for (const SmoothRun& run : runs) {
      ASSERT_EQ(run.sites.size(), run.pieces.size() + 1);
      ASSERT_EQ(run.errors.size(), run.pieces.size());
      for (std::size_t i = 0; i < run.pieces.size(); ++i) {
        EXPECT_EQ(run.pieces[i].place.from, reached);
        EXPECT_GT(run.pieces[i].place.to, reached);
        reached = run.pieces[i].place.to;
        EXPECT_EQ(run.sites[i].point.point, space(run.pieces[i].points.front()));
        EXPECT_EQ(run.sites[i + 1].point.point, space(run.pieces[i].points.back()));
      }
    }
  });
}

TEST_P(SmoothRuns, AreTheSameForAnyNumberOfThreads) {
  each_chain([&](const ChainTracer& tracer) {
    std::vector<SmoothRun> by_one, by_four;
    const auto runs = [&] {
      return smooth_runs(tracer, GetParam().a, GetParam().b, {1e-9}, 0.125);
    };
    with_threads(1, [&] { by_one = runs(); });
    with_threads(4, [&] { by_four = runs(); });
    ASSERT_EQ(by_one.size(), by_four.size());
    for (std::size_t k = 0; k < by_one.size(); ++k) {
      EXPECT_EQ(by_one[k].multiplicity, by_four[k].multiplicity);
      EXPECT_EQ(by_one[k].errors, by_four[k].errors);
      ASSERT_EQ(by_one[k].pieces.size(), by_four[k].pieces.size());
      for (std::size_t i = 0; i < by_one[k].pieces.size(); ++i)
        EXPECT_EQ(by_one[k].pieces[i].points, by_four[k].pieces[i].points);
    }
  });
}

// Along a branch across a line of contact the sine of the surfaces' angle grows with the square of
// the distance: near the line derivatives are rounding, and have to come from farther away.
TEST(SmoothRunsAcrossContact, TakeFewPieces) {
  const testing::Cubic x = testing::linear(-0.5, 1, 0), y = testing::linear(-0.5, 0, 1);
  const testing::CubicPair pair =
      testing::cubic_pair(0.01 * (x * x * y), 20 * testing::base_cubic());
  constexpr double kCut = 0.4865, kLength = 0.003, kWanted = 1e-6;
  const Vec3 origin;
  SurfaceCells a(pair.a, origin, CellForm::Auto, kCut), b(pair.b, origin, CellForm::Auto, kCut);
  PairSearchResult found;
  FoundArc arc{0, 0, {}, {}, {-1, -1}};
  arc.arc.from = {0.5, 0.5, 0.5, 0.5};
  arc.arc.direction = {1, 0, std::cos(0.4) / 1.6, -std::sin(0.4) / 1.6};
  for (std::size_t i = 0; i < 4; ++i) {
    arc.arc.to[i] = arc.arc.from[i] + kLength * arc.arc.direction[i];
    arc.box[i] = {0, 1};
  }
  found.arcs.push_back(arc);
  Chain chain;
  chain.links.push_back({0, true});
  const ChainTracer tracer(found, a, b, origin, chain);

  const auto runs = smooth_runs(tracer, pair.a, pair.b, {kWanted}, 0.125);

  ASSERT_EQ(runs.size(), 1u);
  EXPECT_LE(runs[0].pieces.size(), 8u);
  for (const double error : runs[0].errors) EXPECT_LE(error, 0.125);
}

INSTANTIATE_TEST_SUITE_P(Pairs, SmoothRuns, ::testing::ValuesIn(testing::surface_pairs()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace blossom
