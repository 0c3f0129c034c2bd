// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/meshes/part_crossings.h"

#include <algorithm>
#include <utility>

#include "plugin/reports/models/parts.h"

namespace blossom::meshes {
namespace {

constexpr int kNotMeant = -1;  // of faces that are not asked about

}  // namespace

std::vector<int> parts_of_faces(const reports::Input& input) {
  std::vector<int> parts(static_cast<std::size_t>(input.model.face_count()), kNotMeant);
  for (const int number : input.numbers) parts[static_cast<std::size_t>(number) - 1] = 0;
  int count = 0;
  for (const reports::NamedPart& part : reports::named_parts(input)) {
    ++count;
    for (const int number : reports::faces_of(part).numbers)
      parts[static_cast<std::size_t>(number) - 1] = count;
  }
  return parts;
}

std::optional<JudgedParts> judged_parts(const FileMesh& mesh, const std::vector<int>& number_of,
                                        const std::vector<int>& parts,
                                        const std::function<void()>& stop) {
  Crossings crossings;
  const auto part_of = [&](int number) { return parts[static_cast<std::size_t>(number) - 1]; };
  const auto found = judged_mesh(mesh, stop, [&](int a, int b) {
    const int i = number_of[static_cast<std::size_t>(a)],
              j = number_of[static_cast<std::size_t>(b)];
    if (part_of(i) == kNotMeant && part_of(j) == kNotMeant) return;
    const std::array<int, 2> pair{std::min(i, j), std::max(i, j)};
    crossings.faces.insert(pair);
    if (part_of(i) != part_of(j)) {
      ++crossings.between;
    } else {
      ++crossings.inside;
      crossings.faces_inside.insert(pair);
      for (const int number : std::set<int>{i, j}) ++crossings.of_face[number];
    }
  });
  if (!found) return {};
  return JudgedParts{*found, std::move(crossings)};
}

}  // namespace blossom::meshes
