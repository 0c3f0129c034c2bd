// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/nets/smooth_patches.h"

#include <utility>

#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>

#include "core/meshes/smooth_triangles.h"
#include "plugin/nets/net_shapes.h"
#include "plugin/nets/pieces.h"

namespace blossom::nets {
namespace {

constexpr int kPatchDegree = 4;

Net net_of(const BezierTriangle& patch, const std::string& file, std::size_t number) {
  RationalBezierTriangle value{patch.degree, {}};
  for (const Vec3& p : patch.points) value.points.push_back({p[0], p[1], p[2], 1});
  Net net;
  net.value = std::move(value);
  net.u = net.v = {0, 1};
  net.source.file = file;
  net.source.net = static_cast<int>(number);
  return net;
}

}  // namespace

SmoothPatches smooth_patches(std::span<const Vec3> points,
                             std::span<const std::array<int, 3>> triangles, double crease,
                             TargetForm form, const std::string& file, const Stop& stop) {
  const std::vector<CornerNormals> normals = corner_normals(points, triangles, crease, stop);
  const SmoothMesh smooth = smooth_mesh(points, triangles, normals, stop);
  SmoothPatches made;
  for (const BezierTriangle& patch : smooth.patches) {
    Net net = net_of(patch, file, made.nets.size() + 1);
    made.nets.push_back(form == TargetForm::Bezier ? collapsed_net(net) : std::move(net));
  }
  made.triangles = triangles.size();
  made.crease = crease;
  made.smooth_sides = smooth.smooth_sides;
  made.sharp_sides = smooth.sharp_sides;
  made.largest_angle = smooth.largest_angle;
  return made;
}

occt::Model model_of(const SmoothPatches& made, const Stop& stop) {
  TopoDS_Compound patches;
  const BRep_Builder builder;
  builder.MakeCompound(patches);
  for (const Net& net : made.nets) {
    ask(stop);
    builder.Add(patches, net_shape(net));
  }
  occt::Model model;
  model.add(patches, "patches");
  return model;
}

reports::Json smooth_patches_report(const std::string& file, const reports::Json& output,
                                    const SmoothPatches& made,
                                    const std::vector<std::string>& notes, double seconds) {
  return {{"schema", "blossom.mesh-patches/1"},
          {"file", file},
          {"output", output},
          {"triangles", made.triangles},
          {"patches", made.nets.size()},
          {"degree", kPatchDegree},
          {"crease", made.crease},
          {"smooth_sides", made.smooth_sides},
          {"sharp_sides", made.sharp_sides},
          {"largest_angle", made.largest_angle},
          {"notes", notes},
          {"seconds", seconds}};
}

}  // namespace blossom::nets
