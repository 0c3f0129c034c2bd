// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/plane/pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/errors.h"

namespace blossom {
namespace {

PlanarBezier line(const Vec2& from, const Vec2& to) {
  return {{{from[0], from[1], 1}, {to[0], to[1], 1}}};
}

PlanarPath arc(const Vec2& centre, double radius, double from, double to) {
  PlanarPath path;
  const int count = static_cast<int>(std::ceil(std::abs(to - from) / 1.6));
  for (int k = 0; k < count; ++k) {
    const double a = from + (to - from) * k / count, b = from + (to - from) * (k + 1) / count;
    const double w = std::cos(0.5 * (b - a)), m = 0.5 * (a + b);
    const auto point = [&](double angle, double r, double weight) {
      return Vec3{weight * (centre[0] + r * std::cos(angle)),
                  weight * (centre[1] + r * std::sin(angle)), weight};
    };
    path.push_back({{point(a, radius, 1), point(m, radius / w, w), point(b, radius, 1)}});
  }
  return path;
}

// The square [0, 4]^2 with vertices 0..3, and one more on each side where asked.
class Square {
 public:
  std::vector<ChartArc> arcs;

  // `splits` are the places on each side, from its start, where vertices 4, 5, ... lie.
  explicit Square(const std::vector<std::vector<double>>& splits = {{}, {}, {}, {}}) {
    const Vec2 corners[] = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    int next = 4;
    for (std::size_t side = 0; side < 4; ++side) {
      const Vec2 from = corners[side], to = corners[(side + 1) % 4];
      int vertex = static_cast<int>(side);
      Vec2 at_vertex = from;
      for (const double place : splits[side]) {
        const Vec2 there = from + (place / 4) * (to - from);
        add_border(vertex, next, at_vertex, there);
        vertex = next++;
        at_vertex = there;
      }
      add_border(vertex, static_cast<int>((side + 1) % 4), at_vertex, to);
    }
  }

  int cut(int from, int to, PlanarPath path) {
    arcs.push_back({from, to, std::move(path), false});
    return static_cast<int>(arcs.size()) - 1;
  }

  std::vector<double> areas() const {
    std::vector<double> sizes;
    for (const ChartPiece& piece : pieces(arcs).pieces) {
      double size = signed_area(arcs, piece.outer);
      for (const Cycle& hole : piece.holes) size += signed_area(arcs, hole);
      sizes.push_back(size);
    }
    std::sort(sizes.begin(), sizes.end());
    return sizes;
  }

 private:
  void add_border(int from, int to, const Vec2& start, const Vec2& end) {
    arcs.push_back({from, to, {line(start, end)}, true});
  }
};

void expect_areas(const Square& square, const std::vector<double>& wanted) {
  const std::vector<double> found = square.areas();
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(found[i], wanted[i], 1e-13);
}

using std::numbers::pi;

TEST(Pieces, WithoutCutsAreTheFaceItself) { expect_areas(Square(), {16}); }

TEST(Pieces, OfAStraightCutHaveHandComputedAreas) {
  Square square({{1}, {}, {3}, {}});  // vertex 4 = (1, 0), vertex 5 = (1, 4)
  square.cut(4, 5, {line({1, 0}, {1, 4})});
  expect_areas(square, {4, 12});
}

TEST(Pieces, OfAClosedCutAreADiscAndAFaceWithAHole) {
  Square square;
  square.cut(4, 4, arc({2, 2}, 1, 0, 2 * pi));
  expect_areas(square, {pi, 16 - pi});
  const ChartPieces found = pieces(square.arcs);
  EXPECT_TRUE(found.consistent);
  EXPECT_EQ(found.pieces[0].holes.size() + found.pieces[1].holes.size(), 1u);
}

TEST(Pieces, OfNestedClosedCutsAreRings) {
  Square square;
  square.cut(4, 4, arc({2, 2}, 1, 0, 2 * pi));
  square.cut(5, 5, arc({2, 2}, 0.5, 2 * pi, 0));
  expect_areas(square, {pi / 4, 0.75 * pi, 16 - pi});
}

TEST(Pieces, OfTwoCrossingCutsAreFour) {
  Square square({{1}, {3}, {3}, {1}});  // (1, 0), (4, 3), (1, 4), (0, 3); they cross in (1, 3)
  square.cut(4, 8, {line({1, 0}, {1, 3})});
  square.cut(8, 6, {line({1, 3}, {1, 4})});
  square.cut(7, 8, {line({0, 3}, {1, 3})});
  square.cut(8, 5, {line({1, 3}, {4, 3})});
  expect_areas(square, {1, 3, 3, 9});
}

TEST(Pieces, CutThatEndsInsideIsLeftOutAndListed) {
  Square square({{1}, {}, {}, {}});
  const int dangling = square.cut(4, 5, {line({1, 0}, {1, 2})});
  expect_areas(square, {16});
  EXPECT_EQ(pieces(square.arcs).dangling, std::vector<int>{dangling});
}

TEST(Pieces, CutThatDividesNothingIsInThePieceRoundIt) {
  Square square({{1, 3}, {}, {1}, {}});  // vertices (1, 0), (3, 0), and (3, 4)
  square.cut(5, 6, {line({3, 0}, {3, 4})});
  const int from_rim = square.cut(4, 7, {line({1, 0}, {1, 2})});
  square.cut(8, 8, arc({1.5, 3}, 0.5, 0, 2 * pi));
  const int in_loop = square.cut(9, 10, {line({1.4, 3}, {1.6, 3})});
  const std::vector<ChartPiece> made = pieces(square.arcs).pieces;
  EXPECT_EQ(made.size(), 3u);
  for (const ChartPiece& piece : made) {
    const double size = signed_area(square.arcs, piece.outer);
    if (size > 5)
      EXPECT_EQ(piece.inner, std::vector<int>{from_rim});  // 3 x 4
    else if (size < 1)
      EXPECT_EQ(piece.inner, std::vector<int>{in_loop});
    else
      EXPECT_TRUE(piece.inner.empty());
  }
}

TEST(Pieces, StemOfAClosedCutIsLeftOutButTheLoopDivides) {
  Square square({{2}, {}, {}, {}});  // vertex 4 = (2, 0)
  const int stem = square.cut(4, 5, {line({2, 0}, {2, 1})});
  square.cut(5, 5, arc({2, 2}, 1, -pi / 2, 1.5 * pi));
  expect_areas(square, {pi, 16 - pi});
  EXPECT_EQ(pieces(square.arcs).dangling, std::vector<int>{stem});
}

TEST(Pieces, HoleStaysWithThePieceThatHoldsIt) {
  Square square({{1}, {}, {3}, {}});
  square.arcs.push_back({6, 6, arc({2.5, 2}, 0.5, 2 * pi, 0), true});  // clockwise: a hole
  square.cut(4, 5, {line({1, 0}, {1, 4})});
  expect_areas(square, {4, 12 - pi / 4});
}

TEST(Pieces, OneCutFromTheRimToAHoleDividesNothingAndTwoDo) {
  Square square({{2}, {}, {2}, {}});  // (2, 0), (2, 4)
  square.arcs.push_back({6, 7, arc({2, 2}, 1, 1.5 * pi, 0.5 * pi), true});
  square.arcs.push_back({7, 6, arc({2, 2}, 1, 0.5 * pi, -0.5 * pi), true});
  Square once = square;
  once.cut(4, 6, {line({2, 0}, {2, 1})});
  expect_areas(once, {16 - pi});
  square.cut(4, 6, {line({2, 0}, {2, 1})});
  square.cut(7, 5, {line({2, 3}, {2, 4})});
  expect_areas(square, {8 - pi / 2, 8 - pi / 2});
}

TEST(Pieces, ArmsWithOneDirectionAreOrderedByCurvature) {
  // Two parabolas leave (0, 0) along the bottom side; the one with the shorter leg bends faster.
  Square square;
  square.arcs = {{0, 1, {line({0, 0}, {4, 0})}, true},
                 {1, 2, {line({4, 0}, {4, 4})}, true},
                 {2, 0, {line({4, 4}, {0, 0})}, true}};
  square.cut(0, 2, {{{{0, 0, 1}, {4, 0, 1}, {4, 4, 1}}}});
  square.cut(0, 2, {{{{0, 0, 1}, {2, 0, 1}, {4, 4, 1}}}});
  // Between chord and parabola lies 2/3 of the control triangle: of 8 and of 4.
  expect_areas(square, {8 - 16.0 / 3, 8.0 / 3, 8.0 / 3});
}

// It leaves the corner by a fourth power, and bends the other way there by what a fit is off.
TEST(Pieces, WhereACutGoesCountsMoreThanHowItsFitBendsAtTheVertex) {
  constexpr double kTolerance = 1e-7, kOff = 1e-6;
  Square square({{}, {2}, {}, {}});
  square.cut(0, 4,
             {{{{0, 0, 1}, {0.8, 0, 1}, {1.6, -kOff, 1}, {2.4, 0, 1}, {3.2, 0, 1}, {4, 2, 1}}}});
  EXPECT_EQ(pieces(square.arcs, kTolerance).pieces.size(), 2u);
}

// As over a span of a surface that has the width of rounding: it leaves the square at first.
TEST(Pieces, FirstStepsAsShortAsRoundingDoNotTellWhereACutGoes) {
  Square square({{2}, {2}, {}, {}});
  const Vec2 out{2 - 1e-8, -1e-7};
  const double more = 9e-8;  // of the larger piece
  square.cut(4, 5, {line({2, 0}, out), line(out, {4, 2})});
  expect_areas(square, {2 - more, 14 + more});
  square.arcs.pop_back();
  square.cut(5, 4, {line({4, 2}, out), line(out, {2, 0})});
  expect_areas(square, {2 - more, 14 + more});
}

TEST(Pieces, CutThatTouchesTheRimInAVertexDividesThere) {
  Square square({{2}, {}, {}, {}});
  square.cut(4, 4, arc({2, 1}, 1, -pi / 2, 1.5 * pi));
  expect_areas(square, {pi, 16 - pi});
}

// It leaves the square and comes back 2e-4 farther on, by less than the tolerance.
TEST(Pieces, CutThatTouchesTheRimMayCrossItWithinTolerance) {
  constexpr double kTilt = 1e-4, kTolerance = 1e-7;
  Square square({{2}, {}, {}, {}});
  square.cut(4, 4, arc({2, 1}, 1, kTilt - pi / 2, kTilt + 1.5 * pi));
  EXPECT_EQ(pieces(square.arcs, kTolerance).pieces.size(), 2);
  EXPECT_EQ(pieces(square.arcs, kTilt * kTilt / 4).pieces.size(), 1);
}

// A contact of the fourth order that leaves the square by 1e-9 over a length of 0.028, at the right
// end of which its vertex is: neither direction nor curvature there tells on which side it goes on.
TEST(Pieces, CutThatTouchesTheRimToTheFourthOrderDividesThere) {
  constexpr double kTolerance = 1e-7, kFactor = 0.1, kHalf = 0.01;
  const double x = 2 + std::numbers::sqrt2 * kHalf, rise = kFactor * (16 - 8 * kHalf * kHalf);
  // The polar form of kFactor * (t^4 - 2 kHalf^2 t^2) with t = x - 2.
  const auto pole = [&](double from, double to, int index) {
    const double p = from - 2, q = to - 2, m = index;
    const double pairs =
        (4 - m) * (3 - m) / 2 * p * p + (4 - m) * m * p * q + m * (m - 1) / 2 * q * q;
    const double y = std::pow(p, 4 - m) * std::pow(q, m) - kHalf * kHalf * pairs / 3;
    return Vec3{from + m / 4 * (to - from), kFactor * y, 1};
  };
  const auto quartic = [&](double from, double to) {
    PlanarBezier curve;
    for (int i = 0; i <= 4; ++i) curve.points.push_back(pole(from, to, i));
    return PlanarPath{curve};
  };
  Square square({{x}, {rise}, {}, {4 - rise}});
  square.cut(6, 4, quartic(0, x));
  square.cut(4, 5, quartic(x, 4));
  const ChartPieces found = pieces(square.arcs, kTolerance);
  EXPECT_EQ(found.pieces.size(), 3u);
  EXPECT_TRUE(found.dangling.empty());
}

// By direction and curvature it would cross the rim 0.004 farther on; by its third derivative it
// does not.
TEST(Pieces, CutThatOnlySeemsToCrossTheRimBesideAVertexStaysInside) {
  Square square({{2}, {}, {}, {}});
  const double turn = 2e-5, bend = -0.005, rise = 0.5;
  const double s = 1, y1 = turn * s / 3, y2 = 2 * turn * s / 3 + bend * s * s / 3;
  const double y3 = turn * s + bend * s * s + rise * s * s * s;
  square.cut(4, 4,
             {{{{2, 0, 1}, {2 + s / 3, y1, 1}, {2 + 2 * s / 3, y2, 1}, {2 + s, y3, 1}}},
              line({2 + s, y3}, {2, 1}),
              line({2, 1}, {2, 0})});
  EXPECT_EQ(pieces(square.arcs, 1e-7).pieces.size(), 2);
}

// What begins beside a vertex is ordered by where it begins, straight or bent alike.
TEST(Pieces, CutBesideTheRimFromAVertexThatCoversBothDividesThere) {
  constexpr double kBeside = 1e-3;
  Square left({{}, {}, {4 - kBeside}, {}});
  left.cut(0, 4, {line({kBeside, 0}, {kBeside, 4})});
  expect_areas(left, {4 * kBeside, 16 - 4 * kBeside});
  Square right({{}, {}, {kBeside}, {}});
  right.cut(4, 1, {line({4 - kBeside, 4}, {4 - kBeside, 0})});
  expect_areas(right, {4 * kBeside, 16 - 4 * kBeside});
  Square bent({{}, {}, {4 - kBeside}, {}});  // between its ends by 1e-8 of them
  bent.cut(0, 4,
           {line({kBeside, 0}, {kBeside * (1 + 1e-8), 1}),
            line({kBeside * (1 + 1e-8), 1}, {kBeside, 4})});
  expect_areas(bent, {kBeside * (4 + 2e-8), 16 - kBeside * (4 + 2e-8)});
}

// At less than the angle to which the ends of fitted curves are known.
TEST(Pieces, StraightCutAtATinyAngleToTheRimDividesThere) {
  for (const double rise : {2e-7, 1e-8}) {
    Square low({{}, {rise}, {}, {}});
    low.cut(0, 4, {line({0, 0}, {4, rise})});
    expect_areas(low, {2 * rise, 16 - 2 * rise});
    Square back({{}, {}, {}, {4 - rise}});
    back.cut(4, 1, {line({0, rise}, {4, 0})});
    expect_areas(back, {2 * rise, 16 - 2 * rise});
  }
}

// It begins beside a vertex that covers both and comes to the rim again in the next vertex.
TEST(Pieces, CutThatComesDownToTheRimFromBesideAVertexDividesThere) {
  constexpr double kBeside = 1e-5, kTolerance = 1e-7;
  Square square({{2}, {}, {}, {}});
  square.cut(0, 4, {line({0, kBeside}, {2, 0})});
  EXPECT_EQ(pieces(square.arcs, kTolerance).pieces.size(), 2u);
  EXPECT_TRUE(pieces(square.arcs, kTolerance).dangling.empty());
}

TEST(Pieces, LoopsThatTouchInAVertexAreHolesOfTheirOwn) {
  Square square({{2}, {}, {}, {}});  // vertex 4 = (2, 0)
  square.cut(4, 4, arc({2, 0.5}, 0.5, -pi / 2, 1.5 * pi));
  square.cut(5, 5, arc({1, 2}, 0.5, 0, 2 * pi));  // from (1.5, 2)
  square.cut(5, 5, arc({2, 2}, 0.5, pi, 3 * pi));
  expect_areas(square, {pi / 4, pi / 4, pi / 4, 16 - 0.75 * pi});
  for (const ChartPiece& piece : pieces(square.arcs).pieces) {
    const bool around = signed_area(square.arcs, piece.outer) > 1;
    EXPECT_EQ(piece.outer.size(), around ? 5U : 1U);
    EXPECT_EQ(piece.holes.size(), around ? 3U : 0U);
  }
}

// The piece beside a loop that touches the rim is smaller than what the loop goes round, and its
// outer loop is round all of that.
TEST(Pieces, HoleInALoopThatTouchesTheRimIsNotInThePieceBesideIt) {
  constexpr double kRadius = 1.9, kHole = 0.3;
  Square square({{2}, {}, {}, {}});  // vertex 4 = (2, 0)
  square.cut(4, 4, arc({2, kRadius}, kRadius, -pi / 2, 1.5 * pi));
  square.cut(5, 5, arc({2, kRadius}, kHole, 0, 2 * pi));
  const double loop = pi * kRadius * kRadius, hole = pi * kHole * kHole;
  expect_areas(square, {hole, 16 - loop, loop - hole});
}

TEST(Pieces, SayWhenAHoleLiesOutsideOfTheFace) {
  Square square;
  square.arcs.push_back({4, 4, arc({9, 2}, 0.5, 2 * pi, 0), true});
  EXPECT_FALSE(pieces(square.arcs).consistent);
}

TEST(Pieces, RejectAnArcWithoutAPath) {
  EXPECT_THROW(pieces(std::vector<ChartArc>{{0, 1, {}, true}}), InvalidInput);
}

TEST(Loops, RayThroughAnEndOfTwoArcsIsCountedOnce) {
  const Vec2 point{-1, 1};
  const PlanarPath up{line({0, 0}, {1, 1})}, on{line({1, 1}, {0, 2})};
  EXPECT_EQ(ray_crossings(up, point) + ray_crossings(on, point), 1);
}

TEST(Loops, AreaOfACircleIsExact) {
  EXPECT_NEAR(area_along(arc({3, 1}, 2, 0, 2 * pi), {5, 1}), 4 * pi, 1e-12);
}

}  // namespace
}  // namespace blossom
