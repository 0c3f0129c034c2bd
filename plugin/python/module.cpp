// SPDX-License-Identifier: LGPL-2.1-or-later
// The compiled part of the Python package `blossom`. Its callers are the package's own modules,
// which check what users pass; no message of the binding library is meant to be seen.

#include <exception>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <Standard_Version.hxx>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/exchange/brep_bytes.h"
#include "core/base/errors.h"
#include "plugin/python/answers.h"
#include "plugin/python/control.h"
#include "plugin/python/json.h"
#include "plugin/python/loaded_model.h"
#include "plugin/python/nets.h"
#include "plugin/python/swig_bridge.h"
#include "plugin/reports/info.h"
#include "plugin/reports/reading.h"
#include "plugin/reports/repairs.h"

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

Control control_of(double tolerance, const std::string& form, double time_limit,
                   std::optional<long> budget, int threads, std::shared_ptr<Cancel> cancel,
                   py::object progress) {
  static const std::map<std::string, CellForm> forms = {
      {"auto", CellForm::Auto}, {"bezier", CellForm::Bezier}, {"monomial", CellForm::Monomial}};
  Control control;
  control.engine.tolerances.point = tolerance;
  control.engine.form = forms.at(form);
  control.engine.time_limit = time_limit;
  if (budget) control.engine.budget = *budget;
  control.engine.threads = threads;
  control.cancel = std::move(cancel);
  control.progress = std::move(progress);
  return control;
}

SharedModel read_file(const std::string& path, bool strict, const Control& control) {
  return interruptible(control, [&](const Watch& watch) {
    occt::ReadOptions options;
    options.step = [&watch](const char*) { watch.stop(); };
    occt::Model model = occt::read_model(path, options);
    if (strict && model.reading().grade() == occt::ReadingGrade::ShapesLost)
      throw occt::BadModel(path + ": is refused as strict: " + model.reading().summary());
    return std::make_shared<LoadedModel>(path, std::move(model), Repair::WhenUsed);
  });
}

SharedModel read_bytes(const py::bytes& bytes, const std::string& name) {
  const std::string_view view = bytes;
  const py::gil_scoped_release released;
  return std::make_shared<LoadedModel>(name, occt::shape_from_bytes(view, name));
}

SharedModel from_swig(const py::handle& object, const std::string& name) {
  const std::optional<TopoDS_Shape> shape = shape_from_swig(object);
  if (!shape) return nullptr;
  if (shape->IsNull()) throw InvalidInput(name + ": the shape is null");
  return std::make_shared<LoadedModel>(name, *shape);
}

py::bytes brep_bytes(LoadedModel& model) {
  std::string text;
  {
    const py::gil_scoped_release released;
    text = occt::brep_text(model.shape());
  }
  return py::bytes(text);
}

void write_file(LoadedModel& model, const std::string& path, const Control& control) {
  interruptible(control, [&](const Watch& watch) {
    const LoadedModel::Turn turn = model.turn(watch);
    const std::function<void()> stop = [&watch] { watch.stop(); };
    if (!model.is_part()) return occt::write_model(model.repaired_input(watch).model, path, stop);
    occt::Model part;
    part.add(model.shape(), model.name());
    occt::write_model(part, path, stop);
  });
}

py::dict counts_of(const LoadedModel& model) {
  py::dict counts;
  for (const reports::ShapeCount& each : reports::shape_counts(model.whole_shape()))
    counts[each.many] = each.count;
  return counts;
}

py::object reading_of(const LoadedModel& model) {
  const occt::Model* const file = model.file();
  if (file == nullptr) return py::none();
  return to_python(reports::reading_json(file->file(), file->reading()));
}

/// Bad input is a ValueError, everything else blossom.Error; Open CASCADE's failures too, which
/// Python would otherwise call an unknown exception.
void add_errors(py::module_& module) {
  static py::exception<occt::Failure> error(module, "Error", PyExc_RuntimeError);
  static py::exception<CancelledWork> cancelled(module, "Cancelled", error.ptr());
  py::register_exception_translator([](std::exception_ptr current) {
    try {
      if (current) std::rethrow_exception(current);
    } catch (const occt::BadModel& bad) {
      PyErr_SetString(PyExc_ValueError, bad.what());
    } catch (const occt::Failure& failure) {
      error(failure.what());
    } catch (const CancelledWork& work) {
      cancelled(work.what());
    } catch (const Standard_Failure&) {
      error(occt::current_failure_text().c_str());
    }
  });
}

void add_control(py::module_& module) {
  py::class_<Cancel, std::shared_ptr<Cancel>>(module, "Cancel",
                                              "Ends work that got it as `cancel`, from any thread.")
      .def(py::init<>())
      .def("cancel", [](Cancel& c) { c.asked = true; })
      .def_property_readonly("cancelled", [](const Cancel& c) { return c.asked.load(); });
  py::class_<Control>(module, "Control")
      .def(py::init(&control_of), arg("tolerance"), arg("form"), arg("time_limit"), arg("budget"),
           arg("threads"), arg("cancel"), arg("progress"));
}

void add_model(py::module_& module) {
  py::class_<LoadedModel, SharedModel>(module, "Model")
      .def_property_readonly("name", &LoadedModel::name)
      .def_property_readonly("face_count", &LoadedModel::face_count)
      .def_property_readonly("counts", &counts_of)
      .def_property_readonly(
          "file",
          [](const LoadedModel& m) { return m.file() ? m.file()->file().string() : std::string(); })
      .def_property_readonly(
          "file_unit",
          [](const LoadedModel& m) { return m.file() ? m.file()->file_unit() : std::string(); })
      .def_property_readonly("reading", &reading_of)
      .def("numbers", [](LoadedModel& m) { return m.input().numbers; })
      .def("face_names", [](LoadedModel& m) { return m.input().model.face_names(); })
      .def("part_paths", [](LoadedModel& m) { return m.input().model.part_paths(); })
      .def("repairs", [](LoadedModel& m) { return to_python(reports::repairs_json(m.input())); })
      .def("part", &LoadedModel::part, arg("numbers"), arg("name"))
      .def("brep", &brep_bytes)
      .def("swig", [](LoadedModel& m) { return swig_from_shape(m.shape()); })
      .def("write", &write_file, arg("path"), arg("control"));
  module.def("read_file", &read_file, arg("path"), arg("strict"), arg("control"));
  module.def("read_bytes", &read_bytes, arg("brep"), arg("name"));
  module.def("from_swig", &from_swig, arg("shape"), arg("name"));
}

KnotVector knots_of(int degree, std::vector<double> knots, std::vector<int> multiplicities) {
  return {degree, std::move(knots), std::move(multiplicities)};
}

void add_nets(py::module_& module) {
  py::class_<KnotVector>(module, "KnotVector")
      .def(py::init(&knots_of), arg("degree"), arg("knots"), arg("multiplicities"));
  const auto made = [](const TopoDS_Shape& shape, const std::string& name) {
    return std::make_shared<LoadedModel>(name, shape);
  };
  module.def(
      "net_face",
      [made](const Net& net, const std::optional<KnotVector>& u, const std::optional<KnotVector>& v,
             const std::string& name) {
        return made(u && v ? spline_face(net, *u, *v, name) : bezier_face(net, name), name);
      },
      arg("net"), arg("u"), arg("v"), arg("name"));
  module.def(
      "net_edge",
      [made](const Net& net, const std::optional<KnotVector>& knots, const std::string& name) {
        return made(knots ? spline_edge(net, *knots, name) : bezier_edge(net, name), name);
      },
      arg("net"), arg("knots"), arg("name"));
}

py::object report_of(const Answer& answer) {
  reports::Json report;
  {
    const py::gil_scoped_release released;
    report = answer.report();
  }
  return to_python(report);
}

SharedModel model_of(const Answer& answer) {
  const py::gil_scoped_release released;
  return answer.model ? answer.model() : nullptr;
}

void add_answers(py::module_& module) {
  py::class_<Answer>(module, "Answer")
      .def("report", &report_of)
      .def("model", &model_of)
      .def("records", [](const Answer& a) { return a.records ? a.records() : py::dict(); });
  module.def("intersect", &intersect, arg("a"), arg("b"), arg("control"));
  module.def("self_intersect", &self_intersect, arg("model"), arg("all_faces"), arg("control"));
  module.def("distance", &least_distance, arg("a"), arg("b"), arg("control"));
  module.def("does_intersect", &does_intersect, arg("a"), arg("b"), arg("control"));
  module.def("check", &check, arg("model"), arg("control"));
  module.def("info", &info, arg("model"), arg("edges"), arg("control"));
  module.def(
      "continuity",
      [](const SharedModel& model, double gap, double angle, double curvature,
         const std::string& require, const Control& control) {
        return continuity(model, {.gap = gap, .angle = angle, .curvature = curvature}, require,
                          control);
      },
      arg("model"), arg("gap"), arg("angle"), arg("curvature"), arg("require"), arg("control"));
  module.def("watertight", &watertight, arg("model"), arg("control"));
  module.def(
      "section",
      [](const SharedModel& model, const Triple& point, const Triple& normal,
         const Control& control) { return section(model, vec(point), vec(normal), control); },
      arg("model"), arg("point"), arg("normal"), arg("control"));
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

std::optional<SurfaceSide> side_of(const std::optional<std::string>& word) {
  static const std::map<std::string, SurfaceSide> sides = {{"umax", SurfaceSide::UMax},
                                                           {"umin", SurfaceSide::UMin},
                                                           {"vmax", SurfaceSide::VMax},
                                                           {"vmin", SurfaceSide::VMin}};
  if (!word) return std::nullopt;
  return sides.at(*word);
}

void add_strip(py::module_& module) {
  module.def(
      "strip",
      [](const SharedModel& a, const SharedModel& b, const std::optional<std::string>& edge_a,
         const std::optional<std::string>& edge_b, double weight_a, double weight_b,
         const Control& control) {
        return strip_between(a, b,
                             {.side_a = side_of(edge_a),
                              .side_b = side_of(edge_b),
                              .strip = {.weight_a = weight_a, .weight_b = weight_b}},
                             control);
      },
      arg("a"), arg("b"), arg("edge_a"), arg("edge_b"), arg("weight_a"), arg("weight_b"),
      arg("control"));
}

void add_fillet(py::module_& module) {
  module.def(
      "fillet",
      [](const SharedModel& part, const std::vector<int>& edges, const std::string& kind,
         const std::optional<std::pair<int, int>>& between, double radius, bool partial,
         const Control& control) {
        return fillet(part, {.edges = edges, .kind = kind, .between = between}, radius, partial,
                      control);
      },
      arg("part"), arg("edges"), arg("kind"), arg("between"), arg("radius"), arg("partial"),
      arg("control"));
}

nets::Cut cut_of(const std::vector<double>& interval, const std::vector<double>& rectangle,
                 const std::vector<double>& triangle, const std::vector<double>& q, int levels) {
  nets::Cut cut;
  cut.levels = levels;
  if (const auto& i = interval; !i.empty()) cut.interval = Interval{i[0], i[1]};
  if (const auto& r = rectangle; !r.empty())
    cut.rectangle = {Interval{r[0], r[1]}, Interval{r[2], r[3]}};
  if (const auto& t = triangle; !t.empty())
    cut.triangle = {Vec2{t[0], t[1]}, Vec2{t[2], t[3]}, Vec2{t[4], t[5]}};
  if (!q.empty()) cut.q = QParameters{q[0], q[1]};
  return cut;
}

void add_forms(py::module_& module) {
  using Numbers = std::vector<double>;
  module.def(
      "subdivide",
      [](const SharedModel& model, const Numbers& interval, const Numbers& rectangle,
         const Numbers& triangle, const Numbers& q, int levels, const Control& control) {
        return subdivide(model, cut_of(interval, rectangle, triangle, q, levels), control);
      },
      arg("model"), arg("interval"), arg("rectangle"), arg("triangle"), arg("q"), arg("levels"),
      arg("control"));
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
}  // namespace blossom::python

PYBIND11_MODULE(_core, module) {
  namespace bp = blossom::python;
  module.doc() = "The compiled part of the package blossom.";
  module.attr("__version__") = BLOSSOM_VERSION;
  module.attr("occt_version") = OCC_VERSION_COMPLETE;
  module.attr("has_swig_bridge") = bp::has_swig_bridge();
  blossom::occt::quiet_messages();
  bp::add_errors(module);
  bp::add_control(module);
  bp::add_model(module);
  bp::add_nets(module);
  bp::add_answers(module);
  bp::add_strip(module);
  bp::add_fillet(module);
  bp::add_forms(module);
}
