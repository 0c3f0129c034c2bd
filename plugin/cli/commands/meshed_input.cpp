// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/meshed_input.h"

#include <cstddef>
#include <vector>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/tessellation.h"
#include "core/bounds/box_tree.h"
#include "plugin/cli/nets/net_input.h"

namespace blossom::cli {
namespace {

constexpr double kAnyDeviation = 1e6;  // model units: triangles for the size alone

}  // namespace

bool is_mesh_input(const std::string& input) {
  return meshes::is_mesh_file(parse_input(input).file);
}

MeshedInput::MeshedInput(const std::string& name) : name_(name) {
  if (is_mesh_input(name)) {
    mesh_ = meshes::read_mesh_file(parse_input(name).file);
    return;
  }
  model_ = std::make_unique<Input>(read_input(name));
  drop_other_faces(*model_);
  mesh_model(kAnyDeviation, FacetOptions{}.angle, {});
}

double MeshedInput::size() const {
  Box box;
  for (const Vec3& p : mesh_.points) box = joined(box, {p, p});
  return diagonal(box);
}

bool MeshedInput::refine(double deviation, const std::function<bool()>& ask) {
  return !model_ || mesh_model(deviation, 0, ask);
}

bool MeshedInput::mesh_model(double deviation, double angle, const std::function<bool()>& ask) {
  FacetOptions options;
  options.deviation = deviation;
  options.angle = angle;
  const occt::ShapeTessellation made = occt::tessellation(model_->model.shape(), options, ask);
  if (made.facets.stopped) return false;
  for (std::size_t f = 0; f < made.facets.faces.size(); ++f)
    if (!made.facets.faces[f].obstacle.empty())
      throw occt::BadModel(name_ + ": face " + std::to_string(model_->numbers[f]) +
                           " cannot be meshed: " + made.facets.faces[f].obstacle);
  mesh_ = {made.facets.points, occt::triangles_of(made)};
  distance_ = made.facets.distance;
  return true;
}

}  // namespace blossom::cli
