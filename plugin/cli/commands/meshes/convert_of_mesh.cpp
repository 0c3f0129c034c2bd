// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/meshes/convert_of_mesh.h"

#include <sstream>
#include <utility>

#include "plugin/cli/commands/meshes/meshed_input.h"
#include "plugin/cli/commands/query/query_parts.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/nets/net_input.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/meshes/mesh_fill.h"
#include "plugin/meshes/mesh_judge.h"
#include "plugin/nets/net_json.h"
#include "plugin/nets/smooth_patches.h"

namespace blossom::cli {
namespace {

int write_smooth(const std::string& input, const meshes::FileMesh& mesh,
                 const CommonOptions& common, const MeshInputConversion& conversion) {
  const Stopwatch watch;
  const nets::SmoothPatches made =
      nets::smooth_patches(mesh.points, mesh.triangles, conversion.crease,
                           *nets::target_form(conversion.to), input, stop_if_interrupted);
  stop_if_interrupted();
  if (nets::is_net_file(common.output))
    write_plain_json(nets::nets_json(made.nets), common.output);
  else
    write_model(nets::model_of(made, stop_if_interrupted), common.output);
  if (!common.json.empty())
    write_json(nets::smooth_patches_report(input, common.output, made, mesh.notes, watch.seconds()),
               common.json);
  std::ostringstream text;
  text << input << " to " << common.output << ": " << counted(made.triangles, "triangle") << ", "
       << made.nets.size() << " patches of degree 4\n  " << counted(made.smooth_sides, "side")
       << " smooth: normals of both patches within " << made.largest_angle
       << " rad where they were measured\n";
  if (made.sharp_sides > 0)
    text << "  " << counted(made.sharp_sides, "side") << " sharp, or at the end of a crease\n";
  print_summary(text.str() + meshes::notes_text(mesh), common.json);
  return kExitComplete;
}

int write_triangles(const std::string& input, const meshes::FileMesh& mesh,
                    const CommonOptions& common, bool as_text) {
  const meshes::WrittenMesh written =
      meshes::write_mesh_file(mesh, common.output, as_text, stop_if_interrupted);
  if (!common.json.empty())
    write_json({{"schema", "blossom.mesh-copy/1"},
                {"file", input},
                {"output", common.output},
                {"triangles", mesh.triangles.size()},
                {"points", mesh.points.size()},
                {"groups", mesh.groups.size()},
                {"rounding", written.rounding},
                {"lost", written.lost},
                {"notes", mesh.notes}},
               common.json);
  std::ostringstream text;
  text << input << " to " << common.output << ": " << counted(mesh.triangles.size(), "triangle")
       << ", " << counted(mesh.points.size(), "point");
  if (!mesh.groups.empty()) text << ", " << counted(mesh.groups.size(), "group");
  if (written.rounding > 0) text << ", points moved by " << written.rounding << " at most";
  for (const std::string& what : written.lost) text << ", without " << what;
  text << "\n";
  print_summary(text.str() + meshes::notes_text(mesh), common.json);
  return kExitComplete;
}

}  // namespace

int run_conversion_of_mesh(const std::string& input, const CommonOptions& common,
                           const MeshInputConversion& conversion) {
  const bool flat = meshes::is_written_mesh_file(common.output);
  if (flat && !conversion.to.empty())
    throw UsageError(common.output + ": is of flat triangles, --to is of surfaces");
  if (meshes::is_glb_file(common.output))
    throw UsageError(common.output + ": .glb is written of models, not of files of triangles");
  if (!flat && conversion.to != "bezier" && conversion.to != "triangles")
    throw UsageError(common.output + ": " + input +
                     " is of flat triangles; --to triangles makes curved ones of them, --to bezier "
                     "patches of four sides");
  meshes::FileMesh mesh = read_mesh_input(input);
  stop_if_interrupted();
  if (flat) return write_triangles(input, mesh, common, conversion.text);
  return write_smooth(input, meshes::with_points_joined(std::move(mesh)), common, conversion);
}

}  // namespace blossom::cli
