// SPDX-License-Identifier: LGPL-2.1-or-later
// Models as triangles, in arrays and in files.

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>

#include <pybind11/stl.h>
#include <BRepBuilderAPI_Copy.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/tessellation/triangulated_faces.h"
#include "core/base/work_limit.h"
#include "plugin/meshes/shape_mesh.h"
#include "plugin/pictures/results/meshes.h"
#include "plugin/python/answers.h"
#include "plugin/python/arrays.h"
#include "plugin/reports/models/measured_input.h"
#include "plugin/reports/models/repairs.h"

namespace py = pybind11;
using namespace py::literals;

namespace blossom::python {
namespace {

py::array triangles_array(const std::vector<std::array<int, 3>>& triangles) {
  py::array_t<std::int32_t> made({static_cast<py::ssize_t>(triangles.size()), py::ssize_t{3}});
  std::int32_t* to = made.mutable_data();
  for (const std::array<int, 3>& triangle : triangles) to = std::copy_n(triangle.begin(), 3, to);
  return read_only(std::move(made));
}

py::dict mesh_records(const meshes::ShapeMesh& made, const std::vector<int>& numbers) {
  std::vector<std::int32_t> faces;
  for (const int place : made.face_of) faces.push_back(numbers[static_cast<std::size_t>(place)]);
  py::list groups;
  for (const meshes::MeshGroup& group : made.mesh.groups)
    groups.append(py::make_tuple(group.name, group.first, group.colour, group.part));
  return py::dict("vertices"_a = points_array(std::span<const Vec3>(made.mesh.points)),
                  "triangles"_a = triangles_array(made.mesh.triangles),
                  "faces"_a = numbers_array(faces), "groups"_a = groups);
}

meshes::ShapeMesh meshed(const std::string& name, const TopoDS_Shape& shape,
                         const meshes::MeshedFaces& faces, const Watch& watch) {
  const IntersectionOptions left = watch.engine();
  const WorkLimit limit(left);
  meshes::ShapeMesh made = meshes::mesh_of(
      name, shape, faces, [&limit] { return limit.reached() == nullptr; },
      [&watch] { watch.stop(); });
  watch.stop();
  if (made.made.facets.stopped)
    throw occt::Failure(name + ": the time limit was reached while it was meshed");
  return made;
}

meshes::ShapeMesh meshed(LoadedModel& model, const FacetOptions& options, const Watch& watch) {
  model.faces(watch);
  const reports::Input& input = model.repaired_input(watch);
  const std::vector<meshes::MeshGroup> groups = meshes::face_groups(input);
  const std::vector<int> parts = meshes::parts_of_faces(input);
  return meshed(input.name, reports::chosen_shape(input), {input.numbers, groups, parts, options},
                watch);
}

// The chosen faces with names, colours and places, on shapes of their own: those of a caller get
// no triangles.
occt::Model own_copy(LoadedModel& model, const Watch& watch) {
  model.faces(watch);
  const reports::Input& input = model.repaired_input(watch);
  occt::Model copy = input.model.copy();
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(BRepBuilderAPI_Copy(copy.shape(), Standard_False).Shape(), TopAbs_FACE, faces);
  std::map<int, std::vector<TopoDS_Face>> pieces;
  for (int number = 1; number <= faces.Extent(); ++number) pieces[number];
  for (const int number : input.numbers) pieces[number] = {TopoDS::Face(faces(number))};
  copy.replace_faces(pieces);
  return copy;
}

void write_glb(LoadedModel& model, const FacetOptions& options, const std::string& file,
               const Watch& watch) {
  const occt::Model copy = own_copy(model, watch);
  std::vector<int> numbers(static_cast<std::size_t>(copy.face_count()));
  std::iota(numbers.begin(), numbers.end(), 1);
  const std::vector<meshes::MeshGroup> groups(numbers.size());  // it has those of the model
  const std::vector<int> all = meshes::parts_of_faces(model.input());
  std::vector<int> parts;  // of the faces that are copied
  for (const int number : model.input().numbers)
    parts.push_back(all[static_cast<std::size_t>(number) - 1]);
  const meshes::ShapeMesh made =
      meshed(model.name(), copy.shape(), {numbers, groups, parts, options}, watch);
  occt::put_on_faces(made.made, copy.shape());
  occt::write_model(copy, file, [&watch] { watch.stop(); });
}

}  // namespace

Answer mesh(const SharedModel& model, const FacetOptions& options, const Control& control) {
  return interruptible(control, [&](const Watch& watch) {
    const LoadedModel::Turn turn = model->turn(watch);
    const auto made = std::make_shared<const meshes::ShapeMesh>(meshed(*model, options, watch));
    const reports::Input& input = model->input();
    reports::Json report = reports::mesh_report(input.name, "", made->answer);
    report["output"] = nullptr;
    report["repairs"] = reports::Json::array({reports::repairs_json(input)});
    Answer answer = made_answer(with_reading(std::move(report), {model}), nullptr);
    answer.records = [made, numbers = input.numbers] { return mesh_records(*made, numbers); };
    answer.picture = [made, name = input.name](const Watch& looking) {
      return pictures::mesh_picture(name, made->mesh,
                                    reports::counted(made->mesh.triangles.size(), "triangle"),
                                    [&looking] { looking.stop(); });
    };
    return answer;
  });
}

void write_mesh(const SharedModel& model, const FacetOptions& options, const std::string& file,
                bool text, const Control& control) {
  interruptible(control, [&](const Watch& watch) {
    const LoadedModel::Turn turn = model->turn(watch);
    if (meshes::is_glb_file(file)) return write_glb(*model, options, file, watch);
    meshes::write_mesh_file(meshed(*model, options, watch).mesh, file, text,
                            [&watch] { watch.stop(); });
  });
}

void write_triangles(const meshes::FileMesh& mesh, const std::string& file, bool text,
                     const Control& control) {
  interruptible(control, [&](const Watch& watch) {
    meshes::write_mesh_file(mesh, file, text, [&watch] { watch.stop(); });
  });
}

}  // namespace blossom::python
