// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/meshes/fill_of_mesh.h"

#include <numeric>
#include <utility>
#include <vector>

#include "plugin/cli/commands/meshes/mesh_picture.h"
#include "plugin/cli/commands/meshes/meshed_input.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/picture/files.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/meshes/mesh_fill.h"
#include "plugin/meshes/mesh_parts.h"

namespace blossom::cli {
namespace {

// What fills the holes is its last group.
Picture fill_picture(const std::string& input, const meshes::FilledMesh& filled) {
  const meshes::FileMesh& mesh = filled.mesh;
  Picture picture;
  picture.title = short_name(input);
  picture.subtitle = counted(filled.holes.size(), "hole") + " filled";
  const std::size_t first = filled.holes.empty() ? mesh.triangles.size() : mesh.groups.back().first;
  std::vector<std::size_t> old(first), filling(mesh.triangles.size() - first);
  std::iota(old.begin(), old.end(), std::size_t{0});
  std::iota(filling.begin(), filling.end(), first);
  picture.groups = mesh_faces(meshes::chosen_triangles(mesh, old), picture.title, kFirstColour, 1);
  for (PictureFaces& group :
       mesh_faces(meshes::chosen_triangles(mesh, filling), "fill", kTouchColour, 1))
    picture.groups.push_back(std::move(group));
  picture.layers = faulty_side_layers(mesh);
  return picture;
}

}  // namespace

int run_fill_of_mesh(const std::string& input, const CommonOptions& common) {
  check_files(common, {input}, Outputs::ModelsNetsAndTriangles);
  if (!common.output.empty() && !meshes::is_written_mesh_file(common.output))
    throw UsageError(common.output + ": a mesh is written as .stl, .ply, .obj, .off or .3mf");
  meshes::FileMesh mesh = read_mesh_input(input);
  stop_if_interrupted();
  const meshes::FilledMesh filled = meshes::with_holes_filled(std::move(mesh), stop_if_interrupted);
  const std::vector<PictureFile> pictures =
      picture_files(common, [&] { return fill_picture(input, filled); });
  stop_if_interrupted();
  write_pictures(pictures);
  if (!common.output.empty())
    meshes::write_mesh_file(filled.mesh, common.output, false, stop_if_interrupted);
  if (!common.json.empty()) write_json(meshes::mesh_fill_report(input, filled), common.json);
  print_summary(meshes::mesh_fill_text(input, filled), common.json);
  return filled.whole() ? kExitComplete : kExitTolerance;
}

}  // namespace blossom::cli
