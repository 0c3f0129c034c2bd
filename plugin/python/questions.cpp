// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/python/questions.h"

#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "plugin/python/answers.h"
#include "plugin/python/json.h"
#include "plugin/reports/blends/blend_words.h"

namespace py = pybind11;
using py::arg;

namespace blossom::python {
namespace {

using Triple = std::array<double, 3>;

Vec3 vec(const Triple& triple) { return {triple[0], triple[1], triple[2]}; }

std::vector<occt::Plane> planes_of(const std::vector<std::pair<Triple, Triple>>& list) {
  std::vector<occt::Plane> planes;
  for (const auto& [point, normal] : list) planes.push_back(plane_of(vec(point), vec(normal)));
  return planes;
}

// A point, a normal, a name, and an offset of those that have no name of their own.
using PlaneWords = std::tuple<Triple, Triple, std::string, std::optional<double>>;

std::vector<reports::NamedPlane> named_planes(const std::vector<PlaneWords>& list) {
  std::vector<reports::NamedPlane> planes;
  for (const auto& [point, normal, name, offset] : list)
    planes.push_back({plane_of(vec(point), vec(normal)), name, !offset, offset});
  return planes;
}

// Samples are nearly all that there is of a report: as lists they keep Python's lock for long when
// they are made, and whenever garbage is looked for.
void drop_samples(reports::Json& json) {
  if (json.is_object() && json.contains("curves"))
    for (reports::Json& curve : json["curves"])
      for (const char* samples : {"points", "uv_a", "uv_b"})
        if (curve.is_object()) curve.erase(samples);
  for (reports::Json& each : json)
    if (each.is_structured()) drop_samples(each);
}

py::object python_report(const Answer& answer, bool samples) {
  reports::Json report;
  {
    const py::gil_scoped_release released;
    report = answer.report();
    if (!samples) drop_samples(report);
  }
  return to_python(report);
}

SharedModel shape_of_answer(const Answer& answer) {
  const py::gil_scoped_release released;
  return answer.model ? answer.model() : nullptr;
}

void add_answer_class(py::module_& module) {
  py::class_<Answer>(module, "Answer")
      .def("report", &python_report, arg("samples"))
      .def("model", &shape_of_answer)
      .def("records", [](const Answer& a) { return a.records ? a.records() : py::dict(); })
      .def(
          "draw",
          [](const Answer& a, const std::string& file, const Control& control) {
            a.draw(file, control);
          },
          arg("file"), arg("control"))
      .def_property_readonly("has_picture", [](const Answer& a) { return bool(a.picture); })
      .def(
          "show",
          [](const Answer& a, const std::string& file, const std::string& form,
             const std::string& view, const std::pair<int, int>& size, bool zebra,
             const Control& control) {
            return show(a, file, {form, view, size.first, size.second, zebra}, control);
          },
          arg("file"), arg("form"), arg("view"), arg("size"), arg("zebra"), arg("control"));
}

void add_meetings(py::module_& module) {
  module.def("intersect", &intersect, arg("a"), arg("b"), arg("control"));
  module.def("self_intersect", &self_intersect, arg("model"), arg("all_faces"), arg("control"));
  module.def("distance", &least_distance, arg("a"), arg("b"), arg("control"));
  module.def("does_intersect", &does_intersect, arg("a"), arg("b"), arg("control"));
  module.def("clash", &clash, arg("a"), arg("b"), arg("clearance"), arg("far"), arg("control"));
}

void add_places(py::module_& module) {
  module.def(
      "section",
      [](const SharedModel& model, const Triple& point, const Triple& normal,
         const Control& control) { return section(model, vec(point), vec(normal), control); },
      arg("model"), arg("point"), arg("normal"), arg("control"));
  module.def(
      "sections",
      [](const SharedModel& model, const std::vector<PlaneWords>& planes, const Control& control) {
        return sections(model, named_planes(planes), control);
      },
      arg("model"), arg("planes"), arg("control"));
  module.def(
      "ray",
      [](const SharedModel& model, const Triple& from, const Triple& direction, bool first,
         bool line, const Control& control) {
        return cast_ray(model, vec(from), vec(direction), first, line, control);
      },
      arg("model"), arg("origin"), arg("direction"), arg("first"), arg("line"), arg("control"));
  module.def(
      "nearest",
      [](const SharedModel& model, const Triple& at, bool all, const Control& control) {
        return nearest_point(model, vec(at), all, control);
      },
      arg("model"), arg("at"), arg("all"), arg("control"));
}

void add_facts(py::module_& module) {
  module.def("check", &check, arg("model"), arg("control"));
  module.def(
      "sew",
      [](const SharedModel& model, const Control& control) {
        interruptible(control, [&](const Watch& watch) {
          const LoadedModel::Turn turn = model->turn(watch);
          model->repaired_input(watch);
        });
      },
      arg("model"), arg("control"));
  module.def("info", &info, arg("model"), arg("edges"), arg("faces"), arg("control"));
  module.def(
      "continuity",
      [](const SharedModel& model, double gap, double angle, double curvature,
         const std::string& require, const Control& control) {
        return continuity(model, {.gap = gap, .angle = angle, .curvature = curvature}, require,
                          control);
      },
      arg("model"), arg("gap"), arg("angle"), arg("curvature"), arg("require"), arg("control"));
  module.def("watertight", &watertight, arg("model"), arg("control"));
  module.def("mass", &mass, arg("model"), arg("control"));
}

void add_cuts(py::module_& module) {
  using Planes = std::vector<std::pair<Triple, Triple>>;
  module.def(
      "trim",
      [](const SharedModel& part, const std::vector<SharedModel>& tools, const Planes& planes,
         const std::string& keep,
         const Control& control) { return trim(part, tools, planes_of(planes), keep, control); },
      arg("part"), arg("tools"), arg("planes"), arg("keep"), arg("control"));
  module.def(
      "solid",
      [](const std::string& operation, const SharedModel& part,
         const std::vector<SharedModel>& tools, const Planes& planes, const Control& control) {
        return combine_solids(operation, part, tools, planes_of(planes), control);
      },
      arg("operation"), arg("part"), arg("tools"), arg("planes"), arg("control"));
}

void add_strip(py::module_& module) {
  module.def(
      "strip",
      [](const SharedModel& a, const SharedModel& b, const std::string& edge_a,
         const std::string& edge_b, int order, double weight_a, double weight_b,
         const Control& control) {
        return strip_between(
            a, b,
            {.border_a = edge_a,
             .border_b = edge_b,
             .strip = {.order = order, .weight_a = weight_a, .weight_b = weight_b}},
            control);
      },
      arg("a"), arg("b"), arg("edge_a"), arg("edge_b"), arg("order"), arg("weight_a"),
      arg("weight_b"), arg("control"));
}

using FacePair = std::optional<std::pair<int, int>>;
using MaybeNumber = std::optional<double>;

/// Edges with radii, or laws as JSON.
using OwnRadii = std::vector<std::tuple<int, double, std::string>>;

occt::EdgeRadius radius_of(double radius, const std::string& law) {
  if (law.empty()) return {radius, {}};
  return {radius, reports::radius_law(law)};
}

void add_edge_blends(py::module_& module) {
  module.def(
      "fillet",
      [](const SharedModel& part, const std::vector<int>& edges, const std::string& kind,
         const FacePair& between, double radius, const std::string& law, const OwnRadii& own,
         const std::string& section, MaybeNumber setback, bool full_round, bool partial,
         const Control& control) {
        const occt::EdgeRadius common = radius_of(radius, law);
        occt::FilletOptions of{.radius = common.radius,
                               .law = common.law,
                               .section = reports::fillet_section(section),
                               .setback = setback,
                               .partial = partial};
        for (const auto& [edge, number, along] : own) of.own[edge] = radius_of(number, along);
        return blend_edges(part, {{edges.begin(), edges.end()}, kind, between}, of, full_round,
                           control);
      },
      arg("part"), arg("edges"), arg("kind"), arg("between"), arg("radius"), arg("law"), arg("own"),
      arg("section"), arg("setback"), arg("full_round"), arg("partial"), arg("control"));
  module.def(
      "chamfer",
      [](const SharedModel& part, const std::vector<int>& edges, const std::string& kind,
         const FacePair& between, double distance, MaybeNumber second, MaybeNumber angle,
         bool partial, const Control& control) {
        const occt::FilletOptions of{.chamfer = occt::ChamferSize{distance, second, angle},
                                     .partial = partial};
        return blend_edges(part, {{edges.begin(), edges.end()}, kind, between}, of, false, control);
      },
      arg("part"), arg("edges"), arg("kind"), arg("between"), arg("distance"), arg("second"),
      arg("angle"), arg("partial"), arg("control"));
}

FacetOptions facets_of(double deviation, double angle, double edge_length, double aspect) {
  return {.deviation = deviation, .angle = angle, .edge_length = edge_length, .aspect = aspect};
}

void add_meshes(py::module_& module) {
  module.def(
      "mesh",
      [](const SharedModel& model, double deviation, double angle, double edge_length,
         double aspect, const Control& control) {
        return mesh(model, facets_of(deviation, angle, edge_length, aspect), control);
      },
      arg("model"), arg("deviation"), arg("angle"), arg("edge_length"), arg("aspect"),
      arg("control"));
  module.def(
      "write_mesh",
      [](const SharedModel& model, double deviation, double angle, double edge_length,
         double aspect, const std::string& path, bool text, const Control& control) {
        write_mesh(model, facets_of(deviation, angle, edge_length, aspect), path, text, control);
      },
      arg("model"), arg("deviation"), arg("angle"), arg("edge_length"), arg("aspect"), arg("path"),
      arg("text"), arg("control"));
}

void add_forms(py::module_& module) {
  using NumberList = std::vector<double>;
  module.def(
      "subdivide",
      [](const SharedModel& model, const NumberList& interval, const NumberList& rectangle,
         const NumberList& triangle, const NumberList& q, int levels, const Control& control) {
        return subdivide(model, nets::cut_of({interval, rectangle, triangle, q}, levels), control);
      },
      arg("model"), arg("interval"), arg("rectangle"), arg("triangle"), arg("q"), arg("levels"),
      arg("control"));
  module.def(
      "subdivide_whole",
      [](const SharedModel& model, const NumberList& interval, const NumberList& rectangle,
         const Control& control) {
        const nets::Cut place = nets::cut_of({interval, rectangle, {}, {}}, 0);
        return subdivide_whole(model, {.interval = place.interval, .rectangle = place.rectangle},
                               control);
      },
      arg("model"), arg("interval"), arg("rectangle"), arg("control"));
  module.def("convert", &convert, arg("model"), arg("to"), arg("control"));
  module.def(
      "fill",
      [](const SharedModel& model, const std::vector<int>& edges,
         const std::vector<std::string>& continuity, const std::string& layout, double angle,
         bool sew, const Control& control) {
        return fill(model, {edges, continuity, layout, angle, sew}, control);
      },
      arg("model"), arg("edges"), arg("continuity"), arg("layout"), arg("angle"), arg("sew"),
      arg("control"));
}

}  // namespace

void add_questions(py::module_& module) {
  add_answer_class(module);
  add_meetings(module);
  add_places(module);
  add_facts(module);
  add_cuts(module);
  add_strip(module);
  add_edge_blends(module);
  add_meshes(module);
  add_forms(module);
}

}  // namespace blossom::python
