// SPDX-License-Identifier: LGPL-2.1-or-later
// Failures of Open CASCADE as exceptions with words.

#include "adapters/occt/errors.h"

#include <gtest/gtest.h>
#include <Standard_OutOfRange.hxx>

namespace blossom::occt {
namespace {

TEST(Guarded, ReturnsWhatTheWorkReturns) {
  EXPECT_EQ(guarded("adding", [] { return 2 + 2; }), 4);
}

TEST(Guarded, SaysWhatWasBeingDoneAndWhatOpenCascadeSaid) {
  try {
    guarded("reading part.step", [] { throw Standard_OutOfRange("index 7"); });
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_STREQ(failure.what(), "reading part.step: Standard_OutOfRange: index 7");
  }
}

TEST(Guarded, LetsOurOwnErrorsPass) {
  EXPECT_THROW(guarded("reading", [] { throw BadModel("a.step: is empty"); }), BadModel);
}

TEST(CurrentFailureText, NamesTheTypeAloneWhenThereIsNoMessage) {
  try {
    throw Standard_OutOfRange();
  } catch (const Standard_Failure&) {
    EXPECT_EQ(current_failure_text(), "Standard_OutOfRange");
  }
  EXPECT_EQ(current_failure_text(), "no failure");
}

}  // namespace
}  // namespace blossom::occt
