// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/exchange/step_text.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string_view>

#include "adapters/occt/exchange/file_text.h"

namespace blossom::occt {
namespace {

constexpr std::string_view kFileEnd = "END-ISO-10303-21";
constexpr std::size_t kNone = std::string::npos;

char upper(char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); }
bool equals(std::string_view text, std::size_t place, std::string_view word) {
  return text.size() - place >= word.size() &&
         std::equal(word.begin(), word.end(), text.begin() + static_cast<std::ptrdiff_t>(place),
                    [](char a, char b) { return a == upper(b); });
}

/// The last place of a word in capitals, in either case.
std::size_t last_place(std::string_view text, std::string_view word) {
  for (std::size_t i = text.size() + 1 - std::min(text.size() + 1, word.size()); i-- > 0;)
    if (upper(text[i]) == word.front() && equals(text, i, word)) return i;
  return kNone;
}

/// Whether the first entity, "#1 = point(...)", is in small letters.
bool has_small_keywords(std::string_view text) {
  const std::size_t sign = text.find('=', std::min(text.find('#'), text.size()));
  if (sign == kNone) return false;
  const std::size_t letter = text.find_first_not_of(" \t\r\n(", sign + 1);
  return letter != kNone && std::islower(static_cast<unsigned char>(text[letter])) != 0;
}

/// Capitals outside of strings and comments.
void capitalize(std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::size_t end = kNone;
    if (text[i] == '\'' || text[i] == '"')
      end = text.find(text[i], i + 1);
    else if (text.compare(i, 2, "/*") == 0)
      end = text.find("*/", i + 2);
    if (end != kNone)
      i = end;
    else
      text[i] = upper(text[i]);
  }
}

/// The place behind the last entity that is there to its end, ")" and ";".
std::size_t end_of_entities(std::string_view text) {
  for (std::size_t i = text.rfind(';'); i != kNone && i > 0; i = text.rfind(';', i - 1)) {
    std::size_t before = i - 1;
    while (before > 0 && is_blank(text[before])) --before;
    if (text[before] == ')') return i + 1;
  }
  return 0;
}

void close(std::string& text, ReadingReport& report) {
  const std::size_t last = end_of_entities(text);
  const bool data_ends =
      equals(text, std::min(text.find_first_not_of(" \t\r\n", last), text.size()), "ENDSEC");
  text.resize(last);
  text += "\nENDSEC;\nEND-ISO-10303-21;\n";
  if (data_ends)
    report.add({"the file's last line", "END-ISO-10303-21 is missing"});
  else
    report.add({"the rest of the file", "it is cut off", true});
}

}  // namespace

void mend_step_text(std::string& text, ReadingReport& report) {
  text.erase(0, text.size() - after_preface(text).size());
  const std::size_t end = last_place(text, kFileEnd);
  if (end == kNone)
    close(text, report);
  else
    text.replace(end, text.size() - end, "END-ISO-10303-21;\n");
  if (has_small_keywords(text)) capitalize(text);
}

}  // namespace blossom::occt
