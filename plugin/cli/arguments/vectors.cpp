// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/arguments/vectors.h"

#include <cstddef>
#include <optional>
#include <utility>

#include "plugin/cli/exit_code.h"

namespace blossom::cli {
namespace {

std::vector<double> parse_numbers(const std::string& text, std::size_t count,
                                  const std::string& what, const std::string& wanted) {
  std::optional<std::vector<double>> numbers = reports::finite_numbers(text);
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

}  // namespace blossom::cli
