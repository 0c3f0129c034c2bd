// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/blending/fillet_refusal.h"

#include <cmath>
#include <regex>
#include <sstream>

namespace blossom::occt {

namespace {

// Of a place's largest coordinate: what of the others is left of rounding, and told as 0. Some
// operations on coordinates of 2^-53.
constexpr double kRounding = 0x1p-48;

}  // namespace

const char* to_string(FilletFault fault) {
  switch (fault) {
    case FilletFault::Edge: return "edge";
    case FilletFault::Nothing: return "nothing to round";
    case FilletFault::NoBall: return "no ball";
    case FilletFault::Pinch: return "pinch";
    case FilletFault::LeavesFace: return "leaves face";
    case FilletFault::EdgeConsumed: return "edge consumed";
    case FilletFault::End: return "end";
    case FilletFault::Corner: return "corner";
    case FilletFault::Setback: return "setback";
    case FilletFault::Interference: return "interference";
    case FilletFault::Result: break;
  }
  return "result";
}

double told_below(double size) {
  const int exponent = 5 - static_cast<int>(std::floor(std::log10(size)));
  const auto cut_off = [&](double number) {  // by a power of ten that has no rounding, if it may
    return exponent < 0 ? number * std::pow(10, -exponent) : number / std::pow(10, exponent);
  };
  const double number =
      std::floor(exponent < 0 ? size / std::pow(10, -exponent) : size * std::pow(10, exponent));
  return cut_off(number) > size ? cut_off(number - 1) : cut_off(number);
}

std::optional<double> FilletRefusal::told_largest() const {
  return largest ? std::optional(told_below(*largest)) : std::nullopt;
}

std::string told_place(const Vec3& place) {
  const double none = kRounding * max_norm(place);
  std::ostringstream text;
  for (int i = 0; i < 3; ++i)
    text << (i == 0 ? "(" : ", ") << (std::abs(place[i]) <= none ? 0 : place[i]);
  text << ")";
  return text.str();
}

std::string FilletRefusal::text() const {
  std::ostringstream text;
  if (edge > 0) text << "edge " << edge << ": ";
  text << cause;
  if (point) text << ", at " << told_place(*point);
  text << tried;
  if (largest)
    text << "; the largest " << (of_chamfer ? "distance" : "radius") << " that works is "
         << (at_least ? "at least " : "") << *told_largest();
  return text.str();
}

std::string renumbered(const std::string& text, const std::function<std::string(int)>& edge,
                       const std::function<std::string(int)>& face) {
  static const std::regex numbered("\\b(edge|face) ([0-9]{1,9})\\b");
  std::string made;
  auto rest = text.cbegin();
  for (std::sregex_iterator it(text.begin(), text.end(), numbered), end; it != end; ++it) {
    made.append(rest, (*it)[0].first);
    const int number = std::stoi((*it)[2]);
    made += (*it)[1] == "edge" ? edge(number) : face(number);
    rest = (*it)[0].second;
  }
  return made.append(rest, text.cend());
}

}  // namespace blossom::occt
