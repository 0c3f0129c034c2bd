// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/python/mesh_questions.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "adapters/occt/base/errors.h"
#include "core/base/errors.h"
#include "core/base/work_limit.h"
#include "core/math/index.h"
#include "plugin/meshes/mesh_curves.h"
#include "plugin/meshes/mesh_distance.h"
#include "plugin/meshes/mesh_fill.h"
#include "plugin/meshes/mesh_info.h"
#include "plugin/meshes/mesh_judge.h"
#include "plugin/meshes/mesh_parts.h"
#include "plugin/nets/smooth_patches.h"
#include "plugin/pictures/results/mesh_answers.h"
#include "plugin/pictures/results/meshes.h"
#include "plugin/python/answers.h"
#include "plugin/python/arrays.h"
#include "plugin/reports/models/measured_input.h"

namespace py = pybind11;
using py::arg;
using namespace py::literals;

namespace blossom::python {
namespace {

// Of the size of a model: how near its triangles are where it meets a mesh.
constexpr double kMeetingDeviation = 1e-4;

// Never changed, so that it needs no turn.
struct NamedMesh {
  std::string name;
  meshes::FileMesh mesh;
};
using SharedMesh = std::shared_ptr<const NamedMesh>;

using MeshRows = py::array_t<double, py::array::c_style | py::array::forcecast>;
using MeshCorners = py::array_t<std::int32_t, py::array::c_style | py::array::forcecast>;
using MeshGroups =
    std::vector<std::tuple<std::string, std::size_t, std::optional<meshes::MeshColour>, int>>;
using MeshTriple = std::array<double, 3>;

SharedMesh mesh_of_arrays(const std::string& name, const MeshRows& points,
                          const MeshCorners& triangles, const MeshGroups& groups) {
  auto made = std::make_shared<NamedMesh>();
  made->name = name;
  const auto p = points.unchecked<2>();
  for (py::ssize_t i = 0; i < p.shape(0); ++i) {
    made->mesh.points.push_back({p(i, 0), p(i, 1), p(i, 2)});
    if (!std::isfinite(p(i, 0) + p(i, 1) + p(i, 2)))
      throw InvalidInput("vertices: row " + std::to_string(i) + " is not finite");
  }
  const auto t = triangles.unchecked<2>();
  for (py::ssize_t i = 0; i < t.shape(0); ++i) {
    for (py::ssize_t k = 0; k < 3; ++k)
      if (t(i, k) < 0 || t(i, k) >= p.shape(0))
        throw InvalidInput("triangles: row " + std::to_string(i) +
                           " names a vertex that is not there");
    made->mesh.triangles.push_back({t(i, 0), t(i, 1), t(i, 2)});
  }
  for (const auto& [group, first, colour, part] : groups)
    made->mesh.groups.push_back({group, first, colour, part});
  if (made->mesh.triangles.empty()) throw InvalidInput("triangles: there is none");
  return made;
}

SharedMesh read_mesh(const std::string& path, const Control& control) {
  return interruptible(control, [&](const Watch&) -> SharedMesh {
    return std::make_shared<const NamedMesh>(NamedMesh{path, meshes::read_mesh_file(path)});
  });
}

MeshGroups groups_of(const NamedMesh& mesh) {
  MeshGroups groups;
  for (const meshes::MeshGroup& group : mesh.mesh.groups)
    groups.push_back({group.name, group.first, group.colour, group.part});
  return groups;
}

py::array corners_array(const NamedMesh& mesh) {
  const auto& triangles = mesh.mesh.triangles;
  py::array_t<std::int32_t> made({static_cast<py::ssize_t>(triangles.size()), py::ssize_t{3}});
  std::int32_t* to = made.mutable_data();
  for (const std::array<int, 3>& triangle : triangles) to = std::copy_n(triangle.begin(), 3, to);
  return read_only(std::move(made));
}

template <class Value>
Value with_cgal(std::optional<Value> value) {
  if (!value) throw occt::Failure("questions of meshes need CGAL, which this module lacks");
  return std::move(*value);
}

// Either as triangles; a model's belong to the turn of the question.
using MeshOrModel = std::variant<SharedMesh, SharedModel>;

meshes::MeshSource source_of(const MeshOrModel& of, const Watch& watch) {
  if (const auto* mesh = std::get_if<SharedMesh>(&of)) return {(*mesh)->name, (*mesh)->mesh};
  LoadedModel& model = *std::get<SharedModel>(of);
  model.faces(watch);
  const reports::Input& input = model.repaired_input(watch);
  return {input.name, reports::chosen_shape(input), input.numbers};
}

LoadedModel::Turn turn_of(const MeshOrModel& of, const Watch& watch) {
  const auto* model = std::get_if<SharedModel>(&of);
  return model ? (*model)->turn(watch) : LoadedModel::Turn();
}

// What has a file of its own to tell of.
std::vector<SharedModel> models_of(const MeshOrModel& of) {
  const auto* const model = std::get_if<SharedModel>(&of);
  return model ? std::vector<SharedModel>{*model} : std::vector<SharedModel>{};
}

Answer facts(const SharedMesh& mesh, const Control& control) {
  return interruptible(control, [&](const Watch& watch) {
    const MeshFacts found = meshes::facts_of(mesh->mesh, [&watch] { watch.stop(); });
    Answer answer = made_answer(meshes::mesh_info_report(mesh->name, mesh->mesh, found), nullptr);
    answer.picture = [mesh, text = meshes::enclosed_text(found)](const Watch& looking) {
      return pictures::mesh_picture(mesh->name, mesh->mesh, text, [&looking] { looking.stop(); });
    };
    return answer;
  });
}

Answer judged(const SharedMesh& mesh, const Control& control) {
  return interruptible(control, [&](const Watch& watch) {
    const meshes::JudgedMesh found =
        with_cgal(meshes::judged_mesh(mesh->mesh, [&watch] { watch.stop(); }));
    Answer answer = made_answer(meshes::mesh_check_report(mesh->name, mesh->mesh, found), nullptr);
    answer.picture = [mesh, found](const Watch& looking) {
      return pictures::mesh_check_picture(mesh->name, mesh->mesh, found,
                                          [&looking] { looking.stop(); });
    };
    return answer;
  });
}

py::list curve_arrays(const meshes::MeshCurves& found) {
  py::list curves;
  for (const meshes::MeshPolyline& curve : found.curves)
    curves.append(points_array(std::span<const Vec3>(curve.points)));
  return curves;
}

py::dict curve_records(const std::vector<meshes::MeshCurves>& found) {
  py::list curves, points;
  for (const meshes::MeshCurves& one : found) {
    curves.append(curve_arrays(one));
    points.append(points_array(std::span<const Vec3>(one.points)));
  }
  return py::dict("curves"_a = curves, "points"_a = points);
}

// With the polylines as wires, one compound for each.
Answer answer_of_curves(reports::Json report, std::vector<meshes::MeshCurves> found,
                        const char* name) {
  SharedModel wires;
  occt::Model made;
  bool any = false;
  for (const meshes::MeshCurves& one : found) {
    if (one.curves.empty() && one.points.empty()) continue;
    made.add(occt::compound_of(meshes::section_of(one)), name);
    any = true;
  }
  if (any) wires = std::make_shared<LoadedModel>(name, std::move(made), reports::Repairing::None);
  Answer answer = made_answer(std::move(report), wires);
  answer.records = [found = std::move(found)] { return curve_records(found); };
  return answer;
}

Answer met(const SharedMesh& a, const MeshOrModel& b, const Control& control) {
  return interruptible(control, [&](const Watch& watch) {
    const LoadedModel::Turn turn = turn_of(b, watch);
    const IntersectionOptions left = watch.engine();
    const WorkLimit limit(left);
    meshes::MeshSource second = source_of(b, watch);
    if (!second.refine(kMeetingDeviation * second.size(),
                       [&limit] { return limit.reached() == nullptr; })) {
      watch.stop();
      throw occt::Failure(second.name() + ": the time limit was reached while it was meshed");
    }
    meshes::MeshPair pair{a->name, second.name(), 0, second.distance()};
    const double start = watch.seconds();
    pair.found =
        with_cgal(meshes::curves_of_meshes(a->mesh, second.mesh(), [&watch] { watch.stop(); }));
    pair.seconds = watch.seconds() - start;
    Answer answer = answer_of_curves(with_reading(meshes::mesh_pair_report(pair), models_of(b)),
                                     {pair.found}, "intersection");
    answer.picture = [a, pair,
                      other = std::make_shared<const meshes::MeshSource>(std::move(second))](
                         const Watch& looking) {
      const meshes::MeshSource first(a->name, a->mesh);
      return pictures::mesh_pair_picture(pair, {&first, other.get()},
                                         [&looking] { looking.stop(); });
    };
    return answer;
  });
}

using MeshPlaneWords = std::tuple<MeshTriple, MeshTriple, std::string, std::optional<double>>;

Answer cut_mesh(const SharedMesh& mesh, const std::vector<MeshPlaneWords>& planes,
                const Control& control) {
  return interruptible(control, [&](const Watch& watch) {
    std::vector<meshes::PlaneOfMesh> cuts;
    std::vector<meshes::MeshCurves> found;
    bool touching = false;
    for (const auto& [point, normal, name, offset] : planes) {
      meshes::PlaneOfMesh& one = cuts.emplace_back(meshes::PlaneOfMesh{
          name, plane_of({point[0], point[1], point[2]}, {normal[0], normal[1], normal[2]}),
          offset});
      one.found =
          with_cgal(meshes::curves_in_plane(mesh->mesh, one.plane, [&watch] { watch.stop(); }));
      touching = touching || one.found.touching;
      found.push_back(one.found);
    }
    Answer answer = answer_of_curves(
        meshes::mesh_sections_report(mesh->name, touching ? Status::Tolerance : Status::Complete,
                                     cuts, watch.seconds()),
        std::move(found), "section");
    answer.picture = [mesh, cuts](const Watch& looking) {
      return pictures::mesh_sections_picture(mesh->name, mesh->mesh, cuts,
                                             [&looking] { looking.stop(); });
    };
    return answer;
  });
}

Answer farthest(const SharedMesh& a, const MeshOrModel& b, double tolerance,
                std::optional<double> within, const Control& control) {
  return interruptible(control, [&](const Watch& watch) {
    const LoadedModel::Turn turn = turn_of(b, watch);
    const IntersectionOptions left = watch.engine();
    const WorkLimit limit(left);
    meshes::MeshSource first = source_of(a, watch), second = source_of(b, watch);
    const auto goes_on = [&] {
      watch.stop();
      return limit.reached() == nullptr;
    };
    const meshes::MeshDistance found =
        meshes::distance_of(first, second, tolerance, goes_on, within);
    return made_answer(with_reading(meshes::mesh_distance_report(found), models_of(b)), nullptr);
  });
}

std::pair<SharedMesh, Answer> filled_mesh(const SharedMesh& mesh, const Control& control) {
  return interruptible(control, [&](const Watch& watch) {
    meshes::FilledMesh made = meshes::with_holes_filled(mesh->mesh, [&watch] { watch.stop(); });
    Answer answer = made_answer(meshes::mesh_fill_report(mesh->name, made), nullptr);
    return std::pair<SharedMesh, Answer>(
        std::make_shared<const NamedMesh>(NamedMesh{mesh->name, std::move(made.mesh)}),
        std::move(answer));
  });
}

Answer curved(const SharedMesh& of, const std::string& to, double crease, const Control& control) {
  return interruptible(control, [&](const Watch& watch) {
    const nets::Stop stop = [&watch] { watch.stop(); };
    const double start = watch.seconds();
    const meshes::FileMesh mesh = meshes::with_points_joined(of->mesh);
    nets::SmoothPatches made = nets::smooth_patches(mesh.points, mesh.triangles, crease,
                                                    nets::target_form(to).value(), of->name, stop);
    reports::Json report =
        nets::smooth_patches_report(of->name, nullptr, made, mesh.notes, watch.seconds() - start);
    Answer answer = made_answer(std::move(report), nullptr);
    const auto kept = std::make_shared<const nets::SmoothPatches>(std::move(made));
    answer.model = [kept] {
      return std::make_shared<LoadedModel>("conversion", nets::model_of(*kept, {}),
                                           reports::Repairing::None);
    };
    answer.records = [kept] { return net_records(kept->nets); };
    return answer;
  });
}

// As pybind11 holds it.
using Own = std::shared_ptr<NamedMesh>;

Own own(const SharedMesh& mesh) { return std::const_pointer_cast<NamedMesh>(mesh); }

void add_mesh_class(py::module_& module) {
  py::class_<NamedMesh, std::shared_ptr<NamedMesh>>(module, "Triangles")
      .def_property_readonly("name", [](const NamedMesh& of) { return of.name; })
      .def_property_readonly(
          "vertices",
          [](const NamedMesh& of) { return points_array(std::span<const Vec3>(of.mesh.points)); })
      .def_property_readonly("triangles", &corners_array)
      .def_property_readonly("groups", &groups_of)
      .def_property_readonly("notes", [](const NamedMesh& of) { return of.mesh.notes; });
}

void add_made_meshes(py::module_& module) {
  module.def(
      "mesh_part",
      [](const Own& mesh, const std::vector<int>& numbers, const std::vector<std::string>& names,
         const std::string& name) {
        return std::make_shared<NamedMesh>(
            NamedMesh{name, meshes::chosen_groups(mesh->mesh, numbers, names, mesh->name)});
      },
      arg("mesh"), arg("numbers"), arg("names"), arg("name"));
  module.def(
      "read_mesh",
      [](const std::string& path, const Control& control) { return own(read_mesh(path, control)); },
      arg("path"), arg("control"));
  module.def(
      "mesh_of_arrays",
      [](const std::string& name, const MeshRows& vertices, const MeshCorners& triangles,
         const MeshGroups& groups) {
        return own(mesh_of_arrays(name, vertices, triangles, groups));
      },
      arg("name"), arg("vertices"), arg("triangles"), arg("groups"));
  module.def(
      "fill_mesh",
      [](const Own& mesh, const Control& control) {
        auto [made, answer] = filled_mesh(mesh, control);
        return py::make_tuple(own(made), std::move(answer));
      },
      arg("mesh"), arg("control"));
}

}  // namespace

void add_mesh_questions(py::module_& module) {
  add_mesh_class(module);
  add_made_meshes(module);
  module.def(
      "info_mesh", [](const Own& mesh, const Control& control) { return facts(mesh, control); },
      arg("mesh"), arg("control"));
  module.def(
      "curve_mesh",
      [](const Own& mesh, const std::string& to, double crease, const Control& control) {
        return curved(mesh, to, crease, control);
      },
      arg("mesh"), arg("to"), arg("crease"), arg("control"));
  module.def(
      "check_mesh", [](const Own& mesh, const Control& control) { return judged(mesh, control); },
      arg("mesh"), arg("control"));
  module.def(
      "intersect_mesh",
      [](const Own& a, const std::variant<Own, SharedModel>& b, const Control& control) {
        if (const auto* mesh = std::get_if<Own>(&b)) return met(a, SharedMesh(*mesh), control);
        return met(a, std::get<SharedModel>(b), control);
      },
      arg("a"), arg("b"), arg("control"));
  module.def(
      "section_mesh",
      [](const Own& mesh, const std::vector<MeshPlaneWords>& planes, const Control& control) {
        return cut_mesh(mesh, planes, control);
      },
      arg("mesh"), arg("planes"), arg("control"));
  module.def(
      "mesh_distance",
      [](const Own& a, const std::variant<Own, SharedModel>& b, double tolerance,
         std::optional<double> within, const Control& control) {
        if (const auto* mesh = std::get_if<Own>(&b))
          return farthest(a, SharedMesh(*mesh), tolerance, within, control);
        return farthest(a, std::get<SharedModel>(b), tolerance, within, control);
      },
      arg("a"), arg("b"), arg("tolerance"), arg("within"), arg("control"));
  module.def(
      "write_triangles",
      [](const Own& mesh, const std::string& path, bool text, const Control& control) {
        write_triangles(mesh->mesh, path, text, control);
      },
      arg("mesh"), arg("path"), arg("text"), arg("control"));
}

}  // namespace blossom::python
