// SPDX-License-Identifier: LGPL-2.1-or-later
// Structures as bytes for the same program in another process. For this folder only.
//
// A structure has a function `each_member(way, value)` in this namespace that calls way(member) for
// each of its members.

#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <ios>
#include <string>
#include <utility>
#include <vector>

#include "adapters/occt/reading.h"

namespace blossom::occt {

template <class Way, class Value>
void each_member(Way& way, Value& value) {
  way(value);
}

template <class Way>
void each_member(Way& way, Loss& loss) {
  way(loss.what), way(loss.cause), way(loss.of_shape), way(loss.count);
  way(loss.which), way(loss.belongs_to);
}

template <class Way>
void each_member(Way& way, ReadingReport& report) {
  way(report.losses), way(report.notes);
}

/// Appends members to bytes.
class ValuesOut {
 public:
  void operator()(const std::int64_t& number) {
    bytes.append(reinterpret_cast<const char*>(&number), sizeof(number));
  }
  void operator()(const int& number) { (*this)(std::int64_t{number}); }
  void operator()(const bool& is) { (*this)(std::int64_t{is}); }
  void operator()(const std::string& text) {
    (*this)(static_cast<std::int64_t>(text.size()));
    bytes += text;
  }
  template <class Each>
  void operator()(const std::vector<Each>& all);

  std::string bytes;
};

/// Takes them from there, in the same order.
class ValuesIn {
 public:
  explicit ValuesIn(const std::string& bytes) : bytes_(bytes) {}

  bool is_at_end() const { return at_ == bytes_.size(); }

  void operator()(std::int64_t& number) {
    std::memcpy(&number, take(sizeof(number)), sizeof(number));
  }
  void operator()(int& number) { number = static_cast<int>(next()); }
  void operator()(bool& is) { is = next() != 0; }
  void operator()(std::string& text) {
    const std::size_t size = count();
    text.assign(take(size), size);
  }
  template <class Each>
  void operator()(std::vector<Each>& all);

 private:
  const char* take(std::size_t size) {
    if (size > bytes_.size() - at_) throw std::ios_base::failure("values are cut off");
    at_ += size;
    return bytes_.data() + at_ - size;
  }
  std::int64_t next() {
    std::int64_t number = 0;
    (*this)(number);
    return number;
  }
  // Nothing takes less than a byte.
  std::size_t count() {
    const std::int64_t number = next();
    if (number < 0 || static_cast<std::uint64_t>(number) > bytes_.size())
      throw std::ios_base::failure("a count of values is damaged");
    return static_cast<std::size_t>(number);
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
};

template <class Each>
void ValuesOut::operator()(const std::vector<Each>& all) {
  (*this)(static_cast<std::int64_t>(all.size()));
  for (Each each : all) each_member(*this, each);
}

template <class Each>
void ValuesIn::operator()(std::vector<Each>& all) {
  all.assign(count(), {});
  for (Each& each : all) each_member(*this, each);
}

template <class Value>
std::string value_bytes(Value value) {
  ValuesOut out;
  each_member(out, value);
  return std::move(out.bytes);
}

/// throws   std::ios_base::failure if these are not what `value_bytes` made
template <class Value>
Value value_of(const std::string& bytes) {
  ValuesIn in(bytes);
  Value value;
  each_member(in, value);
  if (!in.is_at_end()) throw std::ios_base::failure("there are too many values");
  return value;
}

}  // namespace blossom::occt
