// SPDX-License-Identifier: LGPL-2.1-or-later
// Copies of models stand alone.

#include <optional>

#include <gtest/gtest.h>
#include <BRepPrimAPI_MakeBox.hxx>

#include "adapters/occt/shapes.h"

namespace blossom::occt {
namespace {

TEST(Copies, CanBeCopiedWhenTheirOriginalIsGone) {
  std::optional<Model> first(std::in_place);
  first->add(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), "part", {0.25, 0.5, 0.75});
  const Model second = first->copy();
  first.reset();

  const Model third = second.copy();

  EXPECT_EQ(third.face_count(), 6);
  EXPECT_EQ(third.part_name(1), "part");
}

}  // namespace
}  // namespace blossom::occt
