// SPDX-License-Identifier: LGPL-2.1-or-later
// STEP text that Open CASCADE would misread is written as it reads it.

#include "adapters/occt/exchange/step/step_text.h"

#include <string>

#include <gtest/gtest.h>

namespace blossom::occt {
namespace {

std::string mended(const std::string& entity) {
  std::string text = "ISO-10303-21;\nDATA;\n" + entity + "\nENDSEC;\nEND-ISO-10303-21;\n";
  ReadingReport report;
  mend_step_text(text, report);
  EXPECT_EQ(report.grade(), ReadingGrade::Whole);
  const std::size_t start = text.find('#');
  return text.substr(start, text.find("\nENDSEC") - start);
}

TEST(StepText, HasExponentsInCapitalsButNotInStrings) {
  EXPECT_EQ(mended("#1=CARTESIAN_POINT('M8x1e-3',(1.e-3,2.5e5,3.5e+2));"),
            "#1=CARTESIAN_POINT('M8x1e-3',(1.E-3,2.5E5,3.5E+2));");
}

TEST(StepText, HasLettersBeyondAsciiInItsOwnCodes) {
  EXPECT_EQ(mended("#1=PRODUCT('\xE6\x97\xA5 \xE9',$);"),
            "#1=PRODUCT('\\X2\\65E5\\X0\\ \\X\\E9',$);");
  EXPECT_EQ(mended("#1=PRODUCT('\xF0\x9F\x94\xA9',$);"), "#1=PRODUCT('\\X2\\D83DDD29\\X0\\',$);");
}

TEST(StepText, HasBlanksForControlCharacters) {
  EXPECT_EQ(mended("#1=PRODUCT('a\x1B[31m\x07',\n$);"), "#1=PRODUCT('a [31m ',\n$);");
}

TEST(StepText, StaysAsItIsOtherwise) {
  const std::string plain = "#1=PRODUCT('Cafe 2e4 \\X\\E9','e',$);\n#2=POINT((1.E-3));";
  EXPECT_EQ(mended(plain), plain);
}

}  // namespace
}  // namespace blossom::occt
