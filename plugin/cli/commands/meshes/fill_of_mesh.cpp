// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/meshes/fill_of_mesh.h"

#include <utility>

#include "plugin/cli/commands/meshes/meshed_input.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/picture/files.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/meshes/mesh_fill.h"
#include "plugin/pictures/results/mesh_answers.h"

namespace blossom::cli {
int run_fill_of_mesh(const std::string& input, const CommonOptions& common) {
  check_files(common, {input}, Outputs::ModelsNetsAndTriangles);
  if (!common.output.empty() && !meshes::is_written_mesh_file(common.output))
    throw UsageError(common.output + ": a mesh is written as .stl, .ply, .obj, .off or .3mf");
  meshes::FileMesh mesh = read_mesh_input(input);
  stop_if_interrupted();
  const meshes::FilledMesh filled = meshes::with_holes_filled(std::move(mesh), stop_if_interrupted);
  const std::vector<PictureFile> pictures = picture_files(
      common, [&] { return pictures::mesh_fill_picture(input, filled, stop_if_interrupted); });
  stop_if_interrupted();
  write_pictures(pictures);
  if (!common.output.empty())
    meshes::write_mesh_file(filled.mesh, common.output, false, stop_if_interrupted);
  if (!common.json.empty()) write_json(meshes::mesh_fill_report(input, filled), common.json);
  print_summary(meshes::mesh_fill_text(input, filled), common.json);
  return filled.whole() ? kExitComplete : kExitTolerance;
}

}  // namespace blossom::cli
