// SPDX-License-Identifier: LGPL-2.1-or-later
// STEP text that Open CASCADE would misread is written as it reads it.

#include "adapters/occt/exchange/step/step_text.h"

#include <string>

#include <gtest/gtest.h>

namespace blossom::occt {
namespace {

std::string mended(const std::string& entity) {
  std::string text =
      "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n" + entity + "\nENDSEC;\nEND-ISO-10303-21;\n";
  ReadingReport report;
  mend_step_text(text, report);
  EXPECT_EQ(report.grade(), ReadingGrade::Whole);
  const std::size_t start = text.find('#');
  return text.substr(start, text.rfind("\nENDSEC") - start);
}

TEST(StepText, HasExponentsInCapitalsButNotInStrings) {
  EXPECT_EQ(mended("#1=CARTESIAN_POINT('M8x1e-3',(1.e-3,2.5e5,3.5e+2));"),
            "#1=CARTESIAN_POINT('M8x1e-3',(1.E-3,2.5E5,3.5E+2));");
}

TEST(StepText, HasPointsAndTheLetterEInNumbersWithExponents) {
  EXPECT_EQ(mended("#1=CARTESIAN_POINT('1e-05',(1e-05,-2E3, +1.5d0));"),
            "#1=CARTESIAN_POINT('1e-05',(1.E-05,-2.E3, +1.5E0));");
  const std::string others = "#1=A2E5(.E5.,B3D2,#12,1.E,3D(4));";
  EXPECT_EQ(mended(others), others);
}

TEST(StepText, HasLettersBeyondAsciiInItsOwnCodes) {
  EXPECT_EQ(mended("#1=PRODUCT('\xE6\x97\xA5 \xE9',$);"),
            "#1=PRODUCT('\\X2\\65E5\\X0\\ \\X\\E9',$);");
  EXPECT_EQ(mended("#1=PRODUCT('\xF0\x9F\x94\xA9',$);"), "#1=PRODUCT('\\X2\\D83DDD29\\X0\\',$);");
}

TEST(StepText, HasBlanksForControlCharacters) {
  EXPECT_EQ(mended("#1=PRODUCT('a\x1B[31m\x07',\n$);"), "#1=PRODUCT('a [31m ',\n$);");
}

TEST(StepText, HasBlanksForTabs) {
  EXPECT_EQ(mended("#1\t=\tA('a\tb',\n\t#2);"), "#1 = A('a b',\n #2);");
}

TEST(StepText, HasNoOrientedEdgeOfItself) {
  EXPECT_EQ(mended("#1=ORIENTED_EDGE('#1',*,*,#1,.F.);\n#02=ORIENTED_EDGE('',*,*,#3,.F.);\n"
                   "#3=ORIENTED_EDGE('',*,*,#2,.T.);"),
            "#1=ORIENTED_EDGE('#1',*,*,$ ,.F.);\n#02=ORIENTED_EDGE('',*,*,$ ,.F.);\n"
            "#3=ORIENTED_EDGE('',*,*,$ ,.T.);");
  const std::string others =
      "#1=ORIENTED_EDGE('',*,*,#2,.F.);\n#2=ORIENTED_EDGE('',*,*,#3,.F.);\n#3=EDGE_CURVE(#3);";
  EXPECT_EQ(mended(others), others);
}

TEST(StepText, StaysAsItIsOtherwise) {
  const std::string plain = "#1=PRODUCT('Cafe 2e4 \\X\\E9','e',$);\n#2=POINT((1.E-3));";
  EXPECT_EQ(mended(plain), plain);
}

TEST(StepText, HasKeywordsInCapitalsWhereverSmallOnesStand) {
  EXPECT_EQ(mended("#1=PRODUCT('a',$);\n#2=Cartesian_Point('b c',(1.));\n#3=(Named_Unit(*));"),
            "#1=PRODUCT('a',$);\n#2=CARTESIAN_POINT('b c',(1.));\n#3=(NAMED_UNIT(*));");
}

TEST(StepText, HasThePartsOfComplexEntitiesInTheOrderOfTheirNames) {
  EXPECT_EQ(mended("#1=(LENGTH_UNIT()NAMED_UNIT(#3)CONVERSION_BASED_UNIT('IN)',#2));"),
            "#1=(CONVERSION_BASED_UNIT('IN)',#2)LENGTH_UNIT()NAMED_UNIT(#3));");
  EXPECT_EQ(mended("#1=( B((1,2)) /* ( */\n A() );"), "#1=( A()B((1,2))           );");
  const std::string sorted = "#1=(BOUNDED_CURVE() B_SPLINE_CURVE(3) /* B( */ CURVE());";
  EXPECT_EQ(mended(sorted), sorted);
  const std::string no_entity = "#1=PRODUCT('=(B()A())',$);\n#2=(B(,A());";
  EXPECT_EQ(mended(no_entity), no_entity);
}

TEST(StepText, HasNumbersThatFitAnInteger) {
  EXPECT_EQ(mended("#2147483648=A('#9',#0012);\n#12=B(#2147483648);"), "#1=A('#9',#2);\n#2=B(#1);");
  const std::string fits = "#2147483647=A(#0012);";
  EXPECT_EQ(mended(fits), fits);
}

TEST(StepText, HasNoScopes) {
  EXPECT_EQ(mended("#9=A('&SCOPE');\n#1=&SCOPE #2=B(); #3=&SCOPE#4=C();ENDSCOPE D(#4); ENDSCOPE "
                   "/#2, #3/ E(#2,#3);"),
            "#9=A('&SCOPE');\n #2=B(); #4=C();#3=D(#4); #1= E(#2,#3);");
}

TEST(StepText, HasNoEmptyListsThatCrash) {
  EXPECT_EQ(
      mended("#1=SURFACE_CURVE('()',#2,( ),.PCURVE_S1.);\n#2=SEAM_CURVE('',#2,(),.CURVE_3D.);"),
      "#1=SURFACE_CURVE('()',#2,($ ),.PCURVE_S1.);\n#2=SEAM_CURVE('',#2,($),.CURVE_3D.);");
  EXPECT_EQ(mended("#1=(CURVE() RATIONAL_B_SPLINE_CURVE( () ));\n#2=DIRECTION('(()',());"),
            "#1=(CURVE() RATIONAL_B_SPLINE_CURVE( ($) ));\n#2=DIRECTION('(()',($));");
  const std::string others =
      "#3=(DIRECTION()LENGTH_UNIT());\n#1=PRODUCT('',(),$);\n#2=SURFACE_CURVE('',#1,(#3),.CURVE_3D."
      ");";
  EXPECT_EQ(mended(others), others);
}

TEST(StepText, HasEachNumberOnce) {
  EXPECT_EQ(mended("#1=A('#2=');\n#2=B( 1. );\n#02=B(1.);\n#3=C();"),
            "#1=A('#2=');\n#2=B( 1. );\n          \n#3=C();");
  std::string text =
      "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n#1=A();\n#2=B('x;');\n#1=C();\n#2=D();\n"
      "#2=E();\nENDSEC;\nEND-ISO-10303-21;\n";
  ReadingReport report;
  mend_step_text(text, report);
  EXPECT_EQ(text.substr(text.find('#'), 19), "#1=A();\n#2=B('x;');");
  EXPECT_EQ(text.find("=C()"), std::string::npos);
  ASSERT_EQ(report.losses.size(), 1u);
  EXPECT_EQ(report.losses[0].text(),
            "3 entity numbers (#1, #2, ...): several entities have it, and the first is taken");
  EXPECT_EQ(report.grade(), ReadingGrade::ShapesLost);
}

std::string whole(std::string text) {
  ReadingReport report;
  mend_step_text(text, report);
  EXPECT_EQ(report.grade(), ReadingGrade::Whole);
  return text;
}

TEST(StepText, HasSectionsWithoutBlanksAndLists) {
  EXPECT_EQ(whole("ISO-10303-21 ; HEADER /* x */ ;\nA('');\nENDSEC ;\nDATA('a',('b;'));\n#1=A();\n"
                  "ENDSEC\n;\nEND-ISO-10303-21 ;"),
            "ISO-10303-21;  HEADER;         \nA('');\nENDSEC; \nDATA;            \n#1=A();\n"
            "ENDSEC; \nEND-ISO-10303-21;\n");
}

TEST(StepText, TakesNoLongerWordForASection) {
  const std::string odd = "ISO-10303-21;\nHEADERS;\nENDSEC;\nDATABASE;\n#1=A();\nENDSEC;\n";
  EXPECT_EQ(whole(odd + "END-ISO-10303-21;"), odd + "END-ISO-10303-21;\n");
}

TEST(StepText, HasAHeaderAndTheEndOfItsLastSection) {
  EXPECT_EQ(whole("ISO-10303-21;\nDATA;\n#1=A();\nEND-ISO-10303-21;"),
            "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n#1=A();\nENDSEC;\nEND-ISO-10303-21;\n");
}

}  // namespace
}  // namespace blossom::occt
