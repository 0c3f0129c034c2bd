// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/exchange/step/step_sections.h"

#include <cstddef>
#include <string>
#include <string_view>

#include "adapters/occt/exchange/file_text.h"
#include "adapters/occt/exchange/step/step_scan.h"

namespace blossom::occt {
namespace {

constexpr std::string_view kEndOfSection = "ENDSEC";

/// Makes "WORD;" of the statement at a place, and blanks of the rest of it.
/// returns   the place behind it; the end of the text if it has no end
std::size_t make_statement(std::string& text, std::size_t place, std::string_view word) {
  const std::size_t end = semicolon_from(text, place);
  if (end == kNowhere) return text.size();
  std::string statement(word);
  statement += ';';
  statement.resize(end + 1 - place, ' ');
  if (text.compare(place, statement.size(), statement) != 0)
    text.replace(place, statement.size(), statement);
  return end + 1;
}

/// Whether a statement may begin at a place: behind the end of another one, or a comment.
bool may_begin(std::string_view text, std::size_t place) {
  while (place > 0 && is_blank(text[place - 1])) --place;
  return place == 0 || text[place - 1] == ';' || text[place - 1] == '/';
}

/// Whether a section begins at a place with that word, which may have a list: "DATA('a',('b'))".
bool begins_with(std::string_view text, std::size_t place, std::string_view word) {
  if (!has_word(text, place, word)) return false;
  const std::size_t behind = behind_blanks(text, place + word.size());
  return behind < text.size() && (text[behind] == ';' || text[behind] == '(');
}

/// "HEADER;" behind the first statement, or a header if there is none.
void mend_beginning(std::string& text) {
  const std::size_t begin = behind_blanks(text, 0);
  if (!begins_with(text, begin, "ISO-10303-21")) return;
  const std::size_t behind = make_statement(text, begin, "ISO-10303-21");
  const std::size_t next = behind_blanks(text, behind);
  if (begins_with(text, next, "HEADER"))
    make_statement(text, next, "HEADER");
  else if (begins_with(text, next, "DATA"))
    text.insert(next, "HEADER;\nENDSEC;\n");
}

/// The next end of a section, from a place on.
std::size_t section_end(std::string_view text, std::size_t place) {
  for (place = text.find(kEndOfSection, place); place != kNowhere;
       place = text.find(kEndOfSection, place + 1)) {
    const std::size_t behind = behind_blanks(text, place + kEndOfSection.size());
    if (may_begin(text, place) && behind < text.size() && text[behind] == ';') return place;
  }
  return kNowhere;
}

}  // namespace

void mend_step_sections(std::string& text) {
  mend_beginning(text);
  std::size_t behind = 0;
  for (std::size_t end = section_end(text, 0); end != kNowhere; end = section_end(text, behind)) {
    behind = make_statement(text, end, kEndOfSection);
    if (const std::size_t next = behind_blanks(text, behind); begins_with(text, next, "DATA"))
      behind = make_statement(text, next, "DATA");
  }
  const std::size_t end = text.rfind("END-ISO-10303-21");
  if (end != kNowhere && text.find('=', behind) < end) text.insert(end, "ENDSEC;\n");
}

}  // namespace blossom::occt
