// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/adapters/occt/exchange/read_files.h"

#include <gtest/gtest.h>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/shapes.h"
#include "tests/adapters/occt/exchange/shapes_files.h"

namespace blossom::testing {

std::string refusal(const std::filesystem::path& file) {
  const std::string name = file.string() + ": ";
  try {
    occt::read_model(file);
  } catch (const occt::BadModel& error) {
    const std::string text = error.what();
    return text.starts_with(name) ? text.substr(name.size()) : "without the name: " + text;
  }
  return "accepted";
}

std::string loss(const std::filesystem::path& file) {
  const occt::Model model = occt::read_model(file);
  return model.reading().losses.empty() ? "nothing is lost" : model.reading().losses.front().text();
}

int faces_of(const std::filesystem::path& file) { return occt::read_model(file).face_count(); }

std::string sample(const std::string& ending) {
  const Folder folder;
  write_machine(folder / "machine.step");
  occt::write_model(occt::read_model(folder / "machine.step"), folder / ("sample" + ending));
  return content(folder / ("sample" + ending));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return text.replace(place, from.size(), to);
}

std::string wide(const std::string& text, std::size_t bytes, bool least_first, bool mark) {
  std::string made;
  const auto put = [&](unsigned code) {
    for (std::size_t i = 0; i < bytes; ++i)
      made += static_cast<char>(code >> 8 * (least_first ? i : bytes - 1 - i) & 0xFFU);
  };
  if (mark) put(0xFEFF);
  for (const char c : text) put(static_cast<unsigned char>(c));
  return made;
}

}  // namespace blossom::testing
