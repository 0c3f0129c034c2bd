// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/base/work_limit.h"

#include <gtest/gtest.h>

#include <functional>
#include <type_traits>

namespace blossom {
namespace {

struct Wishes {
  double time_limit = 0;
  std::function<bool()> cancelled;
};

TEST(WorkLimit, TakesNothingThatWouldBeGoneWhenItIsAsked) {
  EXPECT_TRUE((std::is_constructible_v<WorkLimit, const Wishes&>));
  EXPECT_FALSE((std::is_constructible_v<WorkLimit, Wishes>));
  EXPECT_TRUE((std::is_constructible_v<WorkLimit, double, const std::function<bool()>&>));
  EXPECT_FALSE((std::is_constructible_v<WorkLimit, double, std::function<bool()>>));
  EXPECT_FALSE((std::is_constructible_v<WorkLimit, double, bool (*)()>));
}

TEST(WorkLimit, IsReachedWhenTheUserSaysSo) {
  bool is_wanted = false;
  const std::function<bool()> cancelled = [&] { return is_wanted; };
  const WorkLimit limit(0, cancelled);
  EXPECT_EQ(limit.reached(), nullptr);
  is_wanted = true;
  EXPECT_STREQ(limit.reached(), WorkLimit::kCancelled);
}

}  // namespace
}  // namespace blossom
