// SPDX-License-Identifier: LGPL-2.1-or-later
// Damaged and odd IGES files.

#include <string>

#include <gtest/gtest.h>

#include "adapters/occt/shapes.h"
#include "tests/adapters/occt/exchange/read_files.h"
#include "tests/adapters/occt/exchange/shapes_files.h"

namespace blossom::occt {
namespace {

using testing::faces_of;
using testing::Folder;
using testing::loss;
using testing::sample;

TEST(ReadingIges, TakesAByteOrderMark) {
  const Folder folder;
  testing::write_content(folder / "marked.iges", "\xef\xbb\xbf" + sample(".iges"));
  EXPECT_EQ(faces_of(folder / "marked.iges"), 18);
}

TEST(ReadingIges, CountsTheLinesOfEachSection) {
  const Folder folder;
  std::string text = sample(".iges");
  const std::size_t line = text.find("P0000020\n");
  ASSERT_NE(line, std::string::npos);
  text.erase(line - 72, 81);
  testing::write_content(folder / "hole.iges", text);
  EXPECT_EQ(loss(folder / "hole.iges").substr(0, 19), "lines of section P:");
  EXPECT_EQ(read_model(folder / "hole.iges").reading().grade(), ReadingGrade::ShapesLost);
}

TEST(ReadingIges, TakesAFileWhoseGlobalSectionIsCountedWrong) {
  const Folder folder;
  const std::string text = sample(".iges");
  const std::size_t count = text.find('G', text.rfind("\nS") + 1);
  testing::write_content(folder / "odd.iges", std::string(text).replace(count + 7, 1, "9"));
  EXPECT_EQ(faces_of(folder / "odd.iges"), 18);
  EXPECT_EQ(read_model(folder / "odd.iges").reading().grade(), ReadingGrade::AttributesLost);
}

TEST(ReadingIges, LeavesOutAFaceOfNoKnownType) {
  const Folder folder;
  std::string text = sample(".iges");
  const std::size_t face = text.find("\n     510");
  ASSERT_NE(face, std::string::npos);
  testing::write_content(folder / "type.iges", text.replace(face + 1, 8, "     999"));
  EXPECT_EQ(faces_of(folder / "type.iges"), 18);  // one is its plane, to which nobody refers now
  EXPECT_EQ(read_model(folder / "type.iges").reading().grade(), ReadingGrade::ShapesLost);
}

}  // namespace
}  // namespace blossom::occt
