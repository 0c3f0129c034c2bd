// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/meshes/meshed_input.h"

#include <vector>

#include "adapters/occt/base/errors.h"
#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/nets/net_input.h"
#include "plugin/cli/process/supervision.h"
#include "plugin/meshes/mesh_parts.h"

namespace blossom::cli {
namespace {

constexpr int kMaxGroups = 1'000'000;  // that an input names one by one

}  // namespace

bool is_mesh_input(const std::string& input) {
  return meshes::is_mesh_file(parse_input(input).file);
}

meshes::FileMesh read_mesh_input(const std::string& input) {
  const InputName name = parse_input(input);
  refuse_special(name.file);
  enter(Phase::Reading, name.file.string());
  meshes::FileMesh mesh = meshes::read_mesh_file(name.file);
  enter(Phase::Working, "working on " + name.file.string());
  if (name.is_whole()) return mesh;
  std::vector<int> numbers;
  for (const auto& [first, last] : name.faces)
    for (int k = first; k <= last && numbers.size() < kMaxGroups; ++k) numbers.push_back(k);
  return meshes::chosen_groups(mesh, numbers, name.words, name.file.string());
}

meshes::MeshSource mesh_source_of(const std::string& input) {
  if (is_mesh_input(input)) return {input, read_mesh_input(input)};
  Input model = read_input(input);
  drop_other_faces(model);
  return {input, model.model.shape(), model.numbers};
}

}  // namespace blossom::cli
