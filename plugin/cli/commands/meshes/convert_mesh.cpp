// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/commands/meshes/convert_mesh.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

#include <Bnd_Box.hxx>

#include "adapters/occt/convert/hulls.h"
#include "adapters/occt/tessellation/triangulated_faces.h"
#include "core/base/work_limit.h"
#include "plugin/cli/arguments/inputs.h"
#include "plugin/cli/arguments/values.h"
#include "plugin/cli/exit_code.h"
#include "plugin/cli/nets/net_input.h"
#include "plugin/cli/output/output.h"
#include "plugin/cli/process/interruption.h"
#include "plugin/cli/process/progress.h"
#include "plugin/cli/process/supervision.h"
#include "plugin/meshes/part_crossings.h"
#include "plugin/meshes/shape_mesh.h"
#include "plugin/reports/models/mesh.h"
#include "plugin/reports/models/repairs.h"

namespace blossom::cli {
namespace {

meshes::ShapeMesh meshed(const Input& input, const std::vector<meshes::MeshGroup>& groups,
                         const std::vector<int>& parts, const FacetOptions& options) {
  Progress progress("meshing");
  const std::function<bool()> cancelled = interrupted;
  const WorkLimit limit(seconds_left(), cancelled);
  const auto ask = [&] {
    progress.tick();
    return limit.reached() == nullptr;
  };
  return meshes::mesh_of(input.name, input.model.shape(), {input.numbers, groups, parts, options},
                         ask, stop_if_interrupted);
}

// What the file's rounding leaves of the deviation; where that is little, half of it all the same.
double deviation_of_triangles(const TopoDS_Shape& shape, const MeshConversion& conversion,
                              const std::string& file) {
  const Bnd_Box box = occt::bounds_of(shape);
  if (box.IsVoid() || conversion.deviation == 0) return conversion.deviation;
  double largest = 0;
  for (const gp_Pnt& corner : {box.CornerMin(), box.CornerMax()})
    for (int k = 1; k <= 3; ++k) largest = std::max(largest, std::abs(corner.Coord(k)));
  const double moved = meshes::writing_bound(file, conversion.text, largest);
  return std::max(conversion.deviation - moved, 0.5 * conversion.deviation);
}

std::string summary(const std::string& input, const std::string& output,
                    const reports::MeshAnswer& answer) {
  std::ostringstream text;
  text << input << " to " << output << ": " << counted(answer.triangles, "triangle") << ", "
       << counted(answer.points, "point") << ", within " << answer.distance
       << " of the faces, proven\n"
       << reports::mesh_notes(answer);
  return text.str();
}

}  // namespace

void add_mesh_options(CLI::App& command, MeshConversion& options) {
  command
      .add_option("--deviation", options.deviation,
                  "of triangles: how far they may be from the faces, mm; else a "
                  "thousandth of the model's size")
      ->check(positive_number())
      ->type_name("D");
  add_angle(command, "--angle", options.facets.angle,
            "of triangles: how far normals may turn along a side, about");
  command
      .add_option("--edge-length", options.facets.edge_length,
                  "of triangles: how long sides may be, about; mm")
      ->check(positive_number())
      ->type_name("L");
  command
      .add_option("--aspect", options.facets.aspect,
                  "of triangles: how much longer than wide they may be where faces bend, about; "
                  "16 when not given")
      ->check(CLI::Range(1.0, 1e6))
      ->type_name("X");
  command.add_flag("--text", options.text, "of triangles: .stl and .ply as text");
}

bool is_of_triangles(const std::string& file) {
  return meshes::is_written_mesh_file(file) || meshes::is_glb_file(file);
}

int run_mesh_conversion(const std::string& name, const CommonOptions& common,
                        const MeshConversion& conversion) {
  Input input = read_input(name);
  const Json repairs = Json::array({reports::repairs_json(input)});
  const std::vector<meshes::MeshGroup> groups = meshes::face_groups(input);
  const std::string others = other_parts_text(input, OtherParts::LeftOut);
  const std::vector<int> parts = meshes::parts_of_faces(input);
  drop_other_faces(input);
  stop_if_interrupted();
  FacetOptions options = conversion.facets;
  options.deviation = deviation_of_triangles(input.model.shape(), conversion, common.output);
  meshes::ShapeMesh made = meshed(input, groups, parts, options);
  if (conversion.deviation > 0) made.answer.options.deviation = conversion.deviation;
  stop_if_interrupted();
  if (made.made.facets.stopped) {
    report_unwritten(common.output, "the time limit was reached while it was meshed");
    return kExitStopped;
  }
  reports::MeshAnswer& answer = made.answer;
  if (meshes::is_glb_file(common.output)) {
    occt::put_on_faces(made.made, input.model.shape());
    write_model(input.model, common.output);
  } else {
    made.made = {};  // the triangles once more, with parameters and normals
    const meshes::WrittenMesh written =
        meshes::write_mesh_file(made.mesh, common.output, conversion.text, stop_if_interrupted);
    answer.rounding = written.rounding;
    answer.lost = written.lost;
    answer.distance += written.rounding;
  }
  if (!common.json.empty()) {
    Json report = reports::mesh_report(name, common.output, answer);
    report["repairs"] = repairs;
    write_json(report, common.json);
  }
  print_summary(summary(input.name, common.output, answer) + others, common.json);
  return answer.refused.empty() ? kExitComplete : kExitTolerance;
}

}  // namespace blossom::cli
