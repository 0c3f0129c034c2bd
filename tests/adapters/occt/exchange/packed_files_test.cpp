// SPDX-License-Identifier: LGPL-2.1-or-later
// Packed models: gzip and zip give what the plain file gives.

#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <zlib.h>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/shapes.h"
#include "tests/adapters/occt/exchange/shapes_files.h"

namespace blossom::occt {
namespace {

using testing::Folder;

/// windows   of zlib: 31 for gzip, -15 for the raw stream of a zip archive
std::string deflated(const std::string& text, int windows) {
  z_stream stream{};
  EXPECT_EQ(deflateInit2(&stream, 9, Z_DEFLATED, windows, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::string packed(deflateBound(&stream, text.size()) + 64, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  packed.resize(packed.size() - stream.avail_out);
  deflateEnd(&stream);
  return packed;
}

std::string number(std::size_t value, int size) {
  std::string bytes;
  for (int i = 0; i < size; ++i, value >>= 8U) bytes += static_cast<char>(value & 0xffU);
  return bytes;
}

/// An archive of a text file "readme.txt", stored, and of packed models in a folder, the first of
/// which is "parts/machine.stp", others "parts/other1.stp" and so on.
std::string archive(const std::string& model, int others = 0) {
  std::string bytes, directory;
  int count = 0;
  const auto add = [&](const std::string& name, const std::string& text, bool packed) {
    const std::string content = packed ? deflated(text, -15) : text;
    const std::string sizes =
        number(
            crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size())),
            4) +
        number(content.size(), 4) + number(text.size(), 4) + number(name.size(), 2) + number(0, 2);
    const std::string head =
        number(20, 2) + number(0, 2) + number(packed ? 8 : 0, 2) + number(0, 4);
    directory += "PK\x01\x02" + number(20, 2) + head + sizes + number(0, 2) + number(0, 2) +
                 number(0, 2) + number(0, 4) + number(bytes.size(), 4) + name;
    bytes += "PK\x03\x04" + head + sizes + name + content;
    ++count;
  };
  add("readme.txt", "A model.", false);
  add("parts/machine.stp", model, true);
  for (int i = 1; i <= others; ++i) add("parts/other" + std::to_string(i) + ".stp", model, true);
  const std::size_t start = bytes.size();
  const std::string counts = number(static_cast<std::size_t>(count), 2);
  return bytes + directory + "PK\x05\x06" + number(0, 4) + counts + counts +
         number(directory.size(), 4) + number(start, 4) + number(0, 2);
}

class PackedFiles : public ::testing::Test {
 protected:
  PackedFiles() {
    testing::write_machine(folder_ / "machine.step");
    text_ = testing::content(folder_ / "machine.step");
  }
  Model read(const std::string& name, const std::string& bytes) const {
    testing::write_content(folder_ / name, bytes);
    return read_model(folder_ / name);
  }

  Folder folder_;
  std::string text_;
};

TEST_F(PackedFiles, AreReadFromGzipWithAnyEnding) {
  const std::string packed = deflated(text_, 31);
  for (const char* name : {"machine.stp.gz", "machine.stpZ", "machine.stpz", "machine.step"}) {
    const Model model = read(name, packed);
    EXPECT_EQ(model.face_count(), 18) << name;
    EXPECT_EQ(model.part_name(1), "Base plate") << name;
    EXPECT_EQ(model.reading().grade(), ReadingGrade::Whole) << name;
  }
}

TEST_F(PackedFiles, AreReadFromZipBehindOtherFiles) {
  for (const char* name : {"machine.zip", "machine.stpZ"}) {
    const Model model = read(name, archive(text_));
    EXPECT_EQ(model.face_count(), 18) << name;
    EXPECT_EQ(model.part_name(1), "Base plate") << name;
  }
}

TEST_F(PackedFiles, NameTheModelsOfAnArchiveThatAreNotRead) {
  const Model model = read("machine.zip", archive(text_, 2));
  EXPECT_EQ(model.face_count(), 18);
  EXPECT_EQ(model.reading().grade(), ReadingGrade::ShapesLost);
  const std::string said = model.reading().summary();
  EXPECT_NE(said.find("other1.stp"), std::string::npos) << said;
  EXPECT_NE(said.find("machine.stp"), std::string::npos) << said;
  EXPECT_EQ(read("machine.zip", archive(text_)).reading().grade(), ReadingGrade::Whole);
}

TEST_F(PackedFiles, GiveWhatIsWholeWhenTheyAreCutOff) {
  const std::string packed = deflated(text_, 31);
  const Model model = read("machine.stpz", packed.substr(0, packed.size() * 19 / 20));
  EXPECT_GT(model.face_count(), 0);
  EXPECT_EQ(model.reading().grade(), ReadingGrade::ShapesLost);
}

TEST_F(PackedFiles, AreRefusedInWordsWhenNothingIsWhole) {
  EXPECT_THROW(read("a.zip", archive(text_).substr(0, 200)), BadModel);
  EXPECT_THROW(read("a.zip", archive("no model")), BadModel);
  EXPECT_THROW(read("a.stpz", deflated(text_, 31).substr(0, 40)), BadModel);
  EXPECT_THROW(read("a.stpz", deflated("no model", 31)), BadModel);
}

}  // namespace
}  // namespace blossom::occt
