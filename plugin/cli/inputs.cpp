// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/inputs.h"

#include <charconv>
#include <set>
#include <system_error>

#include "adapters/occt/errors.h"
#include "adapters/occt/soundness.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output.h"
#include "plugin/cli/reading.h"

namespace blossom::cli {
namespace {

// Face numbers of one entry, "3" or "5-9".
std::pair<int, int> face_range(const std::string& entry, const std::string& input) {
  const auto bad = [&]() {
    return UsageError("input '" + input + "': '" + entry +
                      "' is no face number and no range such as 5-9");
  };
  const char* const end = entry.data() + entry.size();
  int first = 0;
  auto read = std::from_chars(entry.data(), end, first);
  if (read.ec != std::errc{} || first < 1) throw bad();
  int last = first;
  if (read.ptr != end) {
    if (*read.ptr != '-') throw bad();
    read = std::from_chars(read.ptr + 1, end, last);
    if (read.ec != std::errc{} || read.ptr != end || last < first) throw bad();
  }
  return {first, last};
}

bool exists(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::exists(file, ignored);
}

}  // namespace

InputName parse_input(const std::string& text) {
  const std::size_t mark = text.rfind('#');
  if (mark == std::string::npos || exists(text)) return {text, {}};

  InputName name{text.substr(0, mark), {}};
  std::size_t begin = mark + 1;
  while (true) {
    const std::size_t comma = text.find(',', begin);
    name.faces.push_back(face_range(text.substr(begin, comma - begin), text));
    if (comma == std::string::npos) return name;
    begin = comma + 1;
  }
}

Input read_input(const std::string& text, Faces need) {
  const InputName name = parse_input(text);
  Input input{text, read_told(name.file), {}, {}, {}};
  input.shape = input.model.shape();
  const int count = input.model.face_count();
  if (count == 0 && need == Faces::Required)
    throw occt::BadModel(name.file.string() + ": there is no face in it");

  std::set<int> wanted;
  for (const auto& [first, last] : name.faces) {
    if (last > count)
      throw occt::BadModel(name.file.string() + ": there is no face " +
                           std::to_string(first > count ? first : last) + " in it, it has " +
                           counted(static_cast<std::size_t>(count), "face"));
    for (int number = first; number <= last; ++number) wanted.insert(number);
  }
  if (name.faces.empty())
    for (int number = 1; number <= count; ++number) wanted.insert(number);

  for (const int number : wanted) {
    input.numbers.push_back(number);
    input.faces.push_back(input.model.face(number));
  }
  return input;
}

void refuse_open_wires(const Input& input) {
  for (std::size_t i = 0; i < input.faces.size(); ++i)
    if (occt::has_open_wire(input.faces[i]))
      throw occt::BadModel(input.name + ": a wire of face " + std::to_string(input.numbers[i]) +
                           " is open and encloses nothing; `blossom check` lists what is wrong");
}

void share_model(const Input& a, Input& b) {
  std::error_code ignored;
  if (!std::filesystem::equivalent(a.model.file(), b.model.file(), ignored)) return;
  for (std::size_t i = 0; i < b.faces.size(); ++i) b.faces[i] = a.model.face(b.numbers[i]);
  b.shape = a.shape;
}

}  // namespace blossom::cli
