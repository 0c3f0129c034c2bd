// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/exchange/brep_words.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <string>

namespace blossom::occt {
namespace {

bool parts_words(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

}  // namespace

std::string_view BrepWords::word() {
  while (at_ < content_.size() && parts_words(content_[at_])) ++at_;
  const std::size_t start = at_;
  while (at_ < content_.size() && !parts_words(content_[at_])) ++at_;
  return content_.substr(start, at_ - start);
}

int BrepWords::count() {
  const int count = whole();
  if (binary_) ++at_;  // the end of the line
  return count;
}

void BrepWords::skip_text_word() {
  if (!binary_) word();
}

BrepWords::Number BrepWords::real() {
  if (binary_) return {at_, sizeof(double), bytes<double>()};
  const std::string text(word());
  return {at_ - text.size(), text.size(), std::strtod(text.c_str(), nullptr)};
}

template <class Value>
Value BrepWords::bytes() {
  Value value{};
  if (at_ + sizeof(Value) <= content_.size())
    std::memcpy(&value, content_.data() + at_, sizeof(Value));
  at_ += sizeof(Value);
  return value;
}

int BrepWords::whole() {
  const std::string_view text = word();
  at_ -= text.size();
  const bool plus = text.starts_with('+');
  int value = 0;
  const auto [end, fault] =
      std::from_chars(text.data() + (plus ? 1 : 0), text.data() + text.size(), value);
  lost_ = lost_ || fault != std::errc();
  at_ += static_cast<std::size_t>(end - text.data());
  return lost_ ? 0 : value;
}

void BrepWords::skip(std::size_t count, std::size_t size) {
  if (binary_)
    at_ += std::min(count * size, content_.size() - std::min(at_, content_.size()));
  else
    for (std::size_t i = 0; i < count && at_ < content_.size(); ++i) word();
}

std::size_t BrepWords::room(std::size_t size) const {
  const std::size_t rest = content_.size() - std::min(at_, content_.size());
  return binary_ ? rest / size : (rest + 1) / 2;  // a digit, and a blank before the next one
}

}  // namespace blossom::occt
