// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/meshes/convert_of_mesh.h"

#include <sstream>
#include <utility>
#include <vector>

#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>

#include "adapters/occt/shapes.h"
#include "core/meshes/smooth_triangles.h"
#include "plugin/cli/commands/meshes/meshed_input.h"
#include "plugin/cli/commands/query/query_parts.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/nets/net_input.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/meshes/mesh_fill.h"
#include "plugin/meshes/mesh_judge.h"
#include "plugin/nets/net_json.h"
#include "plugin/nets/net_shapes.h"
#include "plugin/nets/pieces.h"

namespace blossom::cli {
namespace {

// Three patches of degree 4 for each triangle.
std::vector<Net> nets_of(const SmoothMesh& smooth, const std::string& file) {
  std::vector<Net> nets;
  for (const BezierTriangle& patch : smooth.patches) {
    RationalBezierTriangle value{patch.degree, {}};
    for (const Vec3& p : patch.points) value.points.push_back({p[0], p[1], p[2], 1});
    Net& net = nets.emplace_back();
    net.value = std::move(value);
    net.u = net.v = {0, 1};
    net.source.file = file;
    net.source.net = static_cast<int>(nets.size());
  }
  return nets;
}

// As four-sided patches one side of each is a point.
void write_patches(std::vector<Net> made, const MeshInputConversion& conversion,
                   const std::string& file) {
  if (conversion.to == "bezier")
    for (Net& net : made) net = nets::collapsed_net(net);
  if (nets::is_net_file(file)) return write_plain_json(nets::nets_json(made), file);
  TopoDS_Compound patches;
  const BRep_Builder builder;
  builder.MakeCompound(patches);
  for (const Net& net : made) {
    stop_if_interrupted();
    builder.Add(patches, nets::net_shape(net));
  }
  occt::Model model;
  model.add(patches, "patches");
  write_model(model, file);
}

int write_smooth(const std::string& input, const meshes::FileMesh& mesh,
                 const CommonOptions& common, const MeshInputConversion& conversion) {
  const Stopwatch watch;
  const std::vector<CornerNormals> normals =
      corner_normals(mesh.points, mesh.triangles, conversion.crease, stop_if_interrupted);
  const SmoothMesh smooth = smooth_mesh(mesh.points, mesh.triangles, normals, stop_if_interrupted);
  stop_if_interrupted();
  write_patches(nets_of(smooth, input), conversion, common.output);
  if (!common.json.empty())
    write_json({{"schema", "blossom.mesh-patches/1"},
                {"file", input},
                {"output", common.output},
                {"triangles", mesh.triangles.size()},
                {"patches", smooth.patches.size()},
                {"degree", 4},
                {"crease", conversion.crease},
                {"smooth_sides", smooth.smooth_sides},
                {"sharp_sides", smooth.sharp_sides},
                {"largest_angle", smooth.largest_angle},
                {"notes", mesh.notes},
                {"seconds", watch.seconds()}},
               common.json);
  std::ostringstream text;
  text << input << " to " << common.output << ": " << counted(mesh.triangles.size(), "triangle")
       << ", " << smooth.patches.size() << " patches of degree 4\n  "
       << counted(smooth.smooth_sides, "side") << " smooth: normals of both patches within "
       << smooth.largest_angle << " rad where they were measured\n";
  if (smooth.sharp_sides > 0)
    text << "  " << counted(smooth.sharp_sides, "side") << " sharp, or at the end of a crease\n";
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
