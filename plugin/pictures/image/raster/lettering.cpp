// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/pictures/image/raster/lettering.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace blossom::pictures {
namespace {

// One glyph a character from ' ' to '~'. Strokes are separated by blanks; a stroke is a row of
// points of two digits, x and y upwards. The base line is y = 2, capitals reach 8, small letters 6,
// descenders 0. A stroke after '~' is rounded. Nothing is a blank.
constexpr std::array<std::string_view, 95> kGlyphs = {
    "", "0804 0202", "0806 1816", "1218 3238 0444 0646", "~473818070615354443321203 2921",
    "~0817281607 ~2332433423 0248", "~42071828370403122244", "0806", "~18060412", "~08161402",
    "1814 0527 0725", "2327 0545", "1201", "0535", "1212", "0138",
    // digits
    "~183847433212030718", "062822 0242", "~071838474602 0242", "~0718384746352515 ~15354443321203",
    "32380444", "480805 ~05354443321203", "~3817050312324344351504", "084812",
    "~183847463515060718 ~153544433212030415", "~1233454738180706153546",
    // : ; < = > ? @
    "0202 0505", "1515 1201", "370533", "0444 0646", "073503", "~07183847462524 2222",
    "~4332120307183847443436161434",
    // capitals
    "022842 1434", "0208 ~083847463505 ~053544433202", "~4738180703123243", "0208 ~082847432202",
    "48080242 0535", "480802 0535", "~4738180703123243 434525", "0802 4842 0545", "0802",
    "~3833221203", "0802 4804 1542", "080242", "0208254842", "02084248", "~183847433212030718",
    "0208 ~083847463505", "~183847433212030718 2442", "0208 ~083847463505 2542",
    "~473818070615354443321203", "0848 2822", "~080312324348", "082248", "0812263248", "0842 0248",
    "082548 2522", "08480242",
    // [ \ ] ^ _ `
    "18080111", "0831", "08181101", "061826", "0141", "0817",
    // small letters
    "3632 ~3526160503122233", "0802 ~0516263533221203", "~3526160503122233",
    "3832 ~3526160503122233", "0434 ~343526160503122233", "~28181712 0626",
    "~3631201001 ~3526160503122233", "0802 ~0516263532", "0602 0808", "~161100 1818",
    "0802 0336 1432", "0802", "0602 ~05162522 ~25364542", "0602 ~0516263532", "~162635332212030516",
    "0600 ~0516263533221203", "3630 ~3526160503122233", "0602 ~041626", "~35261605142433221203",
    "~181322 0626", "~0603122233 3632", "062246", "0612253246", "0632 0236", "0622 4610",
    "06360232",
    // { | } ~
    "~28181605141121", "0801", "~08181625141101", "~05163445"};
constexpr std::string_view kUnknown = "0208383202";

constexpr double kCapital = 6;    // height of capitals, in units of the glyphs
constexpr double kBase = 2;       // y of the base line
constexpr double kBetween = 1.7;  // from one letter to the next
constexpr double kBlank = 2.4;    // width of a blank

// Chaikin's corner cutting, twice: a quadratic B-spline to the eye. Ends stay, unless it is closed.
std::vector<Vec2> rounded(std::vector<Vec2> points) {
  for (int round = 0; round < 2; ++round) {
    const bool closed = points.front() == points.back();
    std::vector<Vec2> next;
    if (!closed) next.push_back(points.front());
    for (std::size_t i = 1; i < points.size(); ++i) {
      next.push_back(0.75 * points[i - 1] + 0.25 * points[i]);
      next.push_back(0.25 * points[i - 1] + 0.75 * points[i]);
    }
    next.push_back(closed ? next.front() : points.back());
    points = std::move(next);
  }
  return points;
}

std::vector<std::vector<Vec2>> strokes_of(std::string_view glyph) {
  std::vector<std::vector<Vec2>> strokes;
  while (!glyph.empty()) {
    const std::size_t end = std::min(glyph.find(' '), glyph.size());
    std::string_view stroke = glyph.substr(0, end);
    glyph.remove_prefix(std::min(end + 1, glyph.size()));
    const bool round = stroke.starts_with('~');
    if (round) stroke.remove_prefix(1);
    std::vector<Vec2> points;
    for (std::size_t i = 0; i + 1 < stroke.size(); i += 2)
      points.push_back({double(stroke[i] - '0'), double(stroke[i + 1] - '0')});
    strokes.push_back(round ? rounded(points) : points);
  }
  return strokes;
}

// Beyond ASCII: the units' exponents, and degrees.
std::string_view glyph_beyond(std::string_view character) {
  if (character == "\u00B2") return "~0718282704 0424";
  if (character == "\u00B3") return "082816 ~162625140504";
  if (character == "\u00B0") return "~0718271607";
  return kUnknown;
}

// A glyph for every code point; bytes that go on with one have none of their own.
std::vector<std::string_view> glyphs_of(const std::string& text) {
  std::vector<std::string_view> glyphs;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i + 1;
    while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) ++end;
    const char c = text[i];
    glyphs.push_back(c >= ' ' && c <= '~'
                         ? kGlyphs[static_cast<std::size_t>(c - ' ')]
                         : glyph_beyond(std::string_view(text).substr(i, end - i)));
    i = end;
  }
  return glyphs;
}

}  // namespace

Lettering lettering_of(const std::string& text, double height) {
  const double unit = height / kCapital;
  Lettering made;
  double x = 0;
  for (const std::string_view glyph : glyphs_of(text)) {
    double right = glyph.empty() ? kBlank : 0;
    for (const std::vector<Vec2>& stroke : strokes_of(glyph)) {
      made.strokes.emplace_back();
      for (const Vec2& point : stroke) {
        right = std::max(right, point[0]);
        made.strokes.back().push_back({unit * (x + point[0]), unit * (kBase - point[1])});
      }
    }
    x += right + (glyph.empty() ? 0 : kBetween);
  }
  made.width = unit * std::max(0.0, x - kBetween);
  return made;
}

std::string fitting(const std::string& text, double height, double width) {
  if (lettering_of(text, height).width <= width) return text;
  std::string part = text;
  while (!part.empty() && lettering_of(part + "...", height).width > width) {
    while (part.size() > 1 && (static_cast<unsigned char>(part.back()) & 0xC0) == 0x80)
      part.pop_back();  // all of a character
    part.pop_back();
  }
  return part + "...";
}

}  // namespace blossom::pictures
