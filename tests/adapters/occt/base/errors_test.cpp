// SPDX-License-Identifier: LGPL-2.1-or-later
// Failures of Open CASCADE as exceptions with words.

#include "adapters/occt/base/errors.h"

#include <ios>
#include <new>
#include <string>

#include <gtest/gtest.h>
#include <Standard_ConstructionError.hxx>
#include <Standard_NoSuchObject.hxx>
#include <Standard_OutOfMemory.hxx>
#include <Standard_OutOfRange.hxx>

namespace blossom::occt {
namespace {

TEST(Guarded, ReturnsWhatTheWorkReturns) {
  EXPECT_EQ(guarded("adding", [] { return 2 + 2; }), 4);
}

TEST(Guarded, SaysWhatWasBeingDoneAndWhatTheExceptionMeans) {
  try {
    guarded("reading part.step", [] { throw Standard_OutOfRange("index 7 of 5"); });
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_STREQ(
        failure.what(),
        "reading part.step: a number points outside of the list that it counts (index 7 of "
        "5)");
  }
}

TEST(Guarded, LetsOurOwnErrorsPass) {
  EXPECT_THROW(guarded("reading", [] { throw BadModel("a.step: is empty"); }), BadModel);
}

template <class Exception>
std::string words_of(const Exception& exception) {
  try {
    throw exception;
  } catch (...) {
    return current_failure_text();
  }
}

TEST(CurrentFailureText, HasNoNamesOfOpenCascadeInIt) {
  EXPECT_EQ(words_of(Standard_OutOfRange("NCollection_IndexedMap::FindKey")),
            "a number points outside of the list that it counts");
  EXPECT_EQ(words_of(Standard_NoSuchObject()), "something is referred to that is not there");
  EXPECT_EQ(words_of(Standard_ConstructionError("Geom_BSplineCurve")),
            "its numbers make no such geometry");
  EXPECT_EQ(words_of(Standard_Failure("Open CASCADE says this")),
            "Open CASCADE fails (Open CASCADE says this)");
  EXPECT_EQ(words_of(std::ios_base::failure("x")).find("basic_ios"), std::string::npos);
  EXPECT_EQ(current_failure_text(), "no failure");
}

TEST(CurrentFailureText, IsNoWordsForWantOfMemory) {
  EXPECT_THROW(words_of(std::bad_alloc()), std::bad_alloc);
  EXPECT_THROW(words_of(Standard_OutOfMemory()), std::bad_alloc);
  EXPECT_THROW(guarded("reading", [] { throw Standard_OutOfMemory(); }), std::bad_alloc);
}

}  // namespace
}  // namespace blossom::occt
