// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/arguments/vectors.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <sstream>
#include <utility>

#include "plugin/cli/arguments/values.h"
#include "plugin/cli/exit_code.h"

namespace blossom::cli {
namespace {

// Numbers between commas; nothing if one is none.
std::optional<std::vector<double>> finite_numbers(const std::string& text) {
  std::vector<double> numbers;
  std::size_t start = 0, comma = 0;
  while (comma != std::string::npos) {
    comma = text.find(',', start);
    const std::optional<double> number = finite_value(text.substr(start, comma - start));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    start = comma + 1;
  }
  return numbers;
}

std::vector<double> parse_numbers(const std::string& text, std::size_t count,
                                  const std::string& what, const std::string& wanted) {
  std::optional<std::vector<double>> numbers = finite_numbers(text);
  if (!numbers || numbers->size() != count)
    throw UsageError(what + ": '" + text + "' is not " + wanted);
  return std::move(*numbers);
}

}  // namespace

Vec3 parse_vector(const std::string& text, const std::string& what) {
  const std::vector<double> n = parse_numbers(text, 3, what, "three finite numbers x,y,z");
  return {n[0], n[1], n[2]};
}

occt::Plane parse_plane(const std::string& text, const std::string& what) {
  const std::vector<double> n =
      parse_numbers(text, 6, what, "six finite numbers x,y,z,nx,ny,nz, a point and a normal");
  const Vec3 normal{n[3], n[4], n[5]};
  const double largest = max_norm(normal);
  if (largest == 0) throw UsageError(what + ": the normal of '" + text + "' is zero");
  return {{n[0], n[1], n[2]}, unit(normal * (1 / largest))};
}

Vec3 without_roundings(const Vec3& v) {
  constexpr double kNothing = 1e-12;  // of the largest
  Vec3 shown = v;
  for (int k = 0; k < 3; ++k)
    if (std::abs(v[k]) <= kNothing * max_norm(v)) shown[k] = 0;
  return shown;
}

std::string vector_text(const Vec3& v) {
  std::ostringstream text;
  text.precision(12);
  text << "(" << v[0] << ", " << v[1] << ", " << v[2] << ")";
  return text.str();
}

}  // namespace blossom::cli
