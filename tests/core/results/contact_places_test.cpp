// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/results/contact_places.h"

#include <gtest/gtest.h>

namespace blossom {
namespace {

TEST(ContactPlaces, HoldTheirPointsWithTheirParameters) {
  const Place place = place_of({{{1, 2, 3}, {0.1, 0.2}, {0.3, 0.4}}, {{2, 0, 3}, {0.5, 0}, {0, 1}}},
                               PlaceKind::Tangential, 0.25, 0.5);
  EXPECT_EQ(place.kind, PlaceKind::Tangential);
  EXPECT_EQ(place.box_low, (Vec3{0.5, -0.5, 2.5}));
  EXPECT_EQ(place.box_high, (Vec3{2.5, 2.5, 3.5}));
  EXPECT_EQ(place.gap_low, 0);
  EXPECT_EQ(place.gap_high, 0.25);
  EXPECT_EQ(place.parameters[0], (Interval{0.1, 0.5}));
  EXPECT_EQ(place.parameters[1], (Interval{0, 0.2}));
  EXPECT_EQ(place.parameters[2], (Interval{0, 0.3}));
  EXPECT_EQ(place.parameters[3], (Interval{0.4, 1}));
}

// To the far corner of the contact's box; overlaps and curves of contact say nothing about a point.
TEST(ContactPlaces, ReachAsFarAsTheContactThatHoldsThePoint) {
  SurfaceIntersection found;
  found.places = {place_of({{{0, 0, 0}, {}, {}}, {{3, 4, 0}, {}, {}}}, PlaceKind::Node, 0, 0),
                  place_of({{{0, 0, 0}, {}, {}}, {{9, 9, 9}, {}, {}}}, PlaceKind::Overlap, 0, 0)};
  EXPECT_EQ(contact_reach(found, {0, 0, 0}), 5);
  EXPECT_EQ(contact_reach(found, {3, 0, 0}), 4);
  EXPECT_EQ(contact_reach(found, {9, 9, 9}), 0);
}

}  // namespace
}  // namespace blossom
