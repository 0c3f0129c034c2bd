// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/exchange/file_text.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>

#include "adapters/occt/base/errors.h"

namespace blossom::occt {
namespace {

namespace fs = std::filesystem;

/// Words that tell a format stand within so many bytes of the first that is no comment.
constexpr std::size_t kHead = 4096;

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

std::uintmax_t memory_of_machine() {
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
  return pages > 0 && size > 0
             ? static_cast<std::uintmax_t>(pages) * static_cast<std::uintmax_t>(size)
             : UINTMAX_MAX;
}

/// Opening a pipe would wait for a writer, and a device has no end.
std::uintmax_t size_of_regular(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found) throw BadModel("no such file");
  if (error) throw BadModel("cannot be opened: " + error.message());
  if (fs::is_directory(status)) throw BadModel("is a folder");
  if (!fs::is_regular_file(status)) throw BadModel("is no regular file");
  const std::uintmax_t size = fs::file_size(file, error);
  if (error) throw BadModel("cannot be opened: " + error.message());
  if (size > memory_of_machine()) throw BadModel("is larger than the memory of this machine");
  return size;
}

std::string bytes_of(const fs::path& file) {
  std::string bytes(size_of_regular(file), '\0');
  std::ifstream in(file, std::ios::binary);
  if (!in) throw BadModel(std::string("cannot be opened for reading: ") + std::strerror(errno));
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (in.bad()) throw BadModel("cannot be read to its end");
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return bytes;
}

bool starts_like(std::string_view text, std::string_view upper) {
  return text.size() >= upper.size() &&
         std::equal(upper.begin(), upper.end(), text.begin(), [](char a, char b) {
           return a == static_cast<char>(std::toupper(static_cast<unsigned char>(b)));
         });
}

/// The first line that has more than blanks.
std::string_view first_line(std::string_view text) {
  for (;;) {
    const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
    if (line.size() == text.size() || !std::ranges::all_of(line, is_blank)) return line;
    text.remove_prefix(line.size() + 1);
  }
}

/// A line of IGES has the letter of its section in column 73 and a number in the seven columns
/// behind it. The first section, S, may be missing; C comes before it in the compressed form.
bool is_iges(std::string_view text) {
  constexpr std::size_t kSectionColumn = 72;
  const std::string_view line = first_line(text);
  if (line.size() <= kSectionColumn) return false;
  if (std::string_view("SGC").find(line[kSectionColumn]) == std::string_view::npos) return false;
  return std::ranges::all_of(line.substr(kSectionColumn + 1, 7), [](char c) {
    return is_blank(c) || std::isdigit(static_cast<unsigned char>(c)) != 0;
  });
}

std::string all_of_no_format(const fs::path& file) {
  std::string ending = file.extension().string();
  try {
    switch (format_of(file)) {
      case Format::Step: return "is no STEP file";
      case Format::Iges: return "is no IGES file";
      case Format::Brep: return "is no BREP file";
      case Format::Glb: return "is of a format that is written only";
    }
  } catch (const BadModel&) {
    // An ending that says nothing, as the content does.
  }
  return "is no STEP, IGES or BREP file by its content, and the ending '" + ending +
         "' is not known";
}

}  // namespace

bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0 || c == '\0'; }

std::string_view after_preface(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  for (;;) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    if (!text.starts_with("/*")) return text;
    const std::size_t end = text.find("*/", 2);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 2);
  }
}

void mend_line_ends(std::string& text) {
  if (text.find('\n') != std::string::npos) return;
  std::ranges::replace(text, '\r', '\n');
}

bool is_binary_brep(std::string_view text) {
  return text.substr(0, 64).find("Open CASCADE Topology V") != std::string_view::npos;
}

std::optional<Format> format_of_content(std::string_view text) {
  if (starts_like(after_preface(text), "ISO-10303-21")) return Format::Step;
  if (text.substr(0, kHead).find("CASCADE Topology V") != std::string_view::npos)
    return Format::Brep;
  if (is_iges(text)) return Format::Iges;
  return std::nullopt;
}

FileText file_text(const std::filesystem::path& file) {
  auto [text, cut, name, others] = unpacked(bytes_of(file));
  narrow_letters(text);
  if (text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
  if (std::ranges::all_of(text, is_blank)) throw BadModel("is empty");
  const std::optional<Format> format = format_of_content(text);
  if (!format) throw BadModel(all_of_no_format(file));
  return {*format, std::move(text), cut, std::move(name), std::move(others)};
}

}  // namespace blossom::occt
