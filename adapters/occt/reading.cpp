// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/reading.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <system_error>

namespace blossom::occt {
namespace {

constexpr double kLeastAllowance = 1.5;  // processor seconds; small files that are odd take 1.2

constexpr std::size_t kNamed = 5;  // the reader of a report wants a place to look at, not all

void add_first(const std::vector<std::string>& news, std::vector<std::string>& to) {
  for (const std::string& name : news)
    if (to.size() < kNamed && std::ranges::find(to, name) == to.end()) to.push_back(name);
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

int count_of(const std::vector<Loss>& losses, bool of_shape) {
  int count = 0;
  for (const Loss& loss : losses)
    if (loss.of_shape == of_shape) count += loss.count;
  return count;
}

}  // namespace

double reading_allowance(double bytes) { return std::max(kLeastAllowance, 1.5e-5 * bytes); }

double reading_allowance(const std::filesystem::path& file) {
  std::error_code error;
  const auto bytes = static_cast<double>(std::filesystem::file_size(file, error));
  const std::string ending = file.extension().string();
  const bool packed =
      ending.ends_with('z') || ending.ends_with('Z') || ending == ".zip" || ending == ".ZIP";
  return error ? kLeastAllowance : reading_allowance(packed ? 10 * bytes : bytes);
}

const char* to_string(ReadingGrade grade) {
  switch (grade) {
    case ReadingGrade::Whole: return "whole";
    case ReadingGrade::AttributesLost: return "attributes lost";
    case ReadingGrade::ShapesLost: break;
  }
  return "shapes lost";
}

std::string Loss::text() const {
  // Words are counted as words, names of a format as what they are.
  const bool word = std::islower(static_cast<unsigned char>(what.front())) != 0;
  std::string text = what;
  if (count > 1) text = std::to_string(count) + " " + what + (word ? "s" : " entities");
  std::string places = listed(which);
  if (count > static_cast<int>(which.size()) && !which.empty()) places += ", ...";
  if (!belongs_to.empty()) places += (places.empty() ? "of " : " of ") + listed(belongs_to);
  if (!places.empty()) text += " (" + places + ")";
  return text + ": " + cause;
}

ReadingGrade ReadingReport::grade() const {
  if (losses.empty()) return ReadingGrade::Whole;
  return count_of(losses, true) > 0 ? ReadingGrade::ShapesLost : ReadingGrade::AttributesLost;
}

void ReadingReport::add(const Loss& loss) {
  const auto same = std::ranges::find_if(losses, [&](const Loss& known) {
    return known.what == loss.what && known.cause == loss.cause && known.of_shape == loss.of_shape;
  });
  if (same == losses.end()) {
    losses.push_back(loss);
    return;
  }
  same->count += loss.count;
  add_first(loss.which, same->which);
  add_first(loss.belongs_to, same->belongs_to);
}

std::string ReadingReport::summary() const {
  if (losses.empty()) return {};
  const int shapes = count_of(losses, true), others = count_of(losses, false);
  const bool of_shape = shapes > 0;
  const auto first =
      std::ranges::find_if(losses, [&](const Loss& loss) { return loss.of_shape == of_shape; });
  std::string text = of_shape ? "SHAPES ARE MISSING OR WRONG in " + std::to_string(shapes) +
                                    (shapes == 1 ? " place: " : " places: ")
                              : "read without " + std::to_string(others) +
                                    (others == 1 ? " attribute: " : " attributes: ");
  return text + first->text();
}

}  // namespace blossom::occt
