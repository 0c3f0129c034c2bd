// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/surfaces/retry/finer_tolerance.h"

#include <gtest/gtest.h>

#include "core/results/result.h"

namespace blossom {
namespace {

Place place_of(PlaceKind kind, const Vec3& low, const Vec3& high, double gap_low) {
  Place place;
  place.kind = kind;
  place.box_low = low;
  place.box_high = high;
  place.gap_low = gap_low;
  return place;
}

// An open place round (1, 0, 0).
SurfaceIntersection open_at_one() {
  SurfaceIntersection found;
  found.status = Status::Stopped;
  found.places.push_back(place_of(PlaceKind::Open, {0.9, -0.1, -0.1}, {1.1, 0.1, 0.1}, 0));
  return found;
}

// A line along x at a height, with a sample at (1, 0, height).
SurfaceIntersection line_at(double height) {
  SurfaceIntersection finer;
  IntersectionCurve curve;
  curve.samples = {{{0, 0, height}, {}, {}}, {{1, 0, height}, {}, {}}, {{2, 0, height}, {}, {}}};
  finer.curves.push_back(curve);
  return finer;
}

TEST(FinerTolerance, SettlesAPlaceThatACurvePassesThrough) {
  EXPECT_TRUE(is_settled(open_at_one(), line_at(0), 1e-6, 1e-7));
  EXPECT_FALSE(is_settled(open_at_one(), line_at(1), 1e-6, 1e-7));
  EXPECT_FALSE(is_settled(open_at_one(), {}, 1e-6, 1e-7));
}

TEST(FinerTolerance, SettlesNothingWithoutAProof) {
  SurfaceIntersection finer = line_at(0);
  finer.status = Status::Tolerance;
  EXPECT_FALSE(is_settled(open_at_one(), finer, 1e-6, 1e-7));
}

TEST(FinerTolerance, KeepsNearMissesThatItWouldLose) {
  for (const double gap : {0.0, 5e-7}) {
    SurfaceIntersection found = open_at_one();
    found.places.push_back(place_of(PlaceKind::Touch, {5, 5, 5}, {6, 6, 6}, gap));
    EXPECT_EQ(is_settled(found, line_at(0), 1e-6, 1e-7), gap == 0);
  }
}

// What was read as a touch of surfaces apart is a loop less deep than the tolerance.
TEST(FinerTolerance, SettlesATouchThatHoldsACurve) {
  for (const double height : {0.0, 1.0}) {
    SurfaceIntersection found = open_at_one();
    found.places[0].kind = PlaceKind::Touch;
    found.places[0].gap_low = 5e-7;
    EXPECT_EQ(is_settled(found, line_at(height), 1e-6, 1e-7), height == 0);
  }
}

// A touch of surfaces apart beside a curve is not that curve, however near it is.
TEST(FinerTolerance, KeepsATouchBesideACurve) {
  for (const double height : {0.0, 1e-3}) {
    SurfaceIntersection found;
    found.status = Status::Tolerance;
    found.places.push_back(
        place_of(PlaceKind::Touch, {1 - 1e-5, -1e-5, -1e-5}, {1 + 1e-5, 1e-5, 1e-5}, 5e-7));
    EXPECT_EQ(is_settled(found, line_at(height), 1e-6, 1e-7), height == 0);
  }
}

TEST(FinerTolerance, KeepsOverlaps) {
  SurfaceIntersection found = open_at_one();
  found.overlaps.push_back({});
  EXPECT_FALSE(is_settled(found, line_at(0), 1e-6, 1e-7));
}

TEST(FinerTolerance, SaysThatItWasUsed) {
  const SurfaceIntersection answer = settled(line_at(0));
  EXPECT_EQ(answer.status, Status::Tolerance);
  EXPECT_EQ(answer.curves.size(), 1);
  EXPECT_EQ(answer.certificate.reasons.size(), 1);
}

}  // namespace
}  // namespace blossom
