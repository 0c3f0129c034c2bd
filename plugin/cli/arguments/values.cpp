// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/arguments/values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <exception>
#include <functional>
#include <numbers>
#include <optional>
#include <utility>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

namespace blossom::cli {
namespace {

std::optional<long> whole_value(const std::string& text) {
  long value = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  if (read.ec != std::errc{} || read.ptr != end) return std::nullopt;
  return value;
}

// Without a description, so that the help text keeps to the option's type name.
CLI::Validator taking(const std::string& what, std::function<bool(const std::string&)> accepts) {
  return {[what, accepts = std::move(accepts)](const std::string& text) {
            return accepts(text) ? std::string() : "takes " + what + ", not '" + text + "'";
          },
          ""};
}

}  // namespace

CLI::Validator positive_number() {
  return taking("a positive number", [](const std::string& text) {
    const std::optional<double> value = finite_value(text);
    return value && *value > 0;
  });
}

CLI::Validator number_not_negative() {
  return taking("a number that is not negative", [](const std::string& text) {
    const std::optional<double> value = finite_value(text);
    return value && *value >= 0;
  });
}

CLI::Validator finite_number() {
  return taking("finite numbers",
                [](const std::string& text) { return finite_value(text).has_value(); });
}

CLI::Validator whole_number(long from, long to) {
  return taking("a whole number from " + std::to_string(from) + " to " + std::to_string(to),
                [from, to](const std::string& text) {
                  const std::optional<long> value = whole_value(text);
                  return value && *value >= from && *value <= to;
                });
}

CLI::Option* add_angle(CLI::App& command, const std::string& name, double& radians,
                       const std::string& what) {
  constexpr double kDegree = std::numbers::pi / 180;
  const auto take = [&radians](const double& degrees) { radians = degrees * kDegree; };
  return command.add_option_function<double>(name, take, what + "; degrees")
      ->check(taking("degrees, more than 0 and at most 180",
                     [](const std::string& text) {
                       const std::optional<double> value = finite_value(text);
                       return value && *value > 0 && *value <= 180;
                     }))
      ->default_str(number_text(rounded(radians / kDegree)))
      ->type_name("DEG");
}

void limit_to(CLI::Option& option, const std::vector<std::string>& words) {
  std::string braced;
  for (const std::string& word : words) braced += (braced.empty() ? "{" : ",") + word;
  option.type_name(braced + "}")->check(taking(listed(words), [words](const std::string& text) {
    return std::ranges::find(words, text) != words.end();
  }));
}

}  // namespace blossom::cli
