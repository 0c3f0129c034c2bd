// SPDX-License-Identifier: LGPL-2.1-or-later
// The compiled part of the Python package `blossom`. Its callers are the package's own modules,
// which check what users pass; no message of the binding library is meant to be seen.

#include <exception>
#include <functional>
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
#include "adapters/occt/reading.h"
#include "core/base/errors.h"
#include "plugin/python/answers.h"
#include "plugin/python/control.h"
#include "plugin/python/json.h"
#include "plugin/python/loaded_model.h"
#include "plugin/python/mesh_questions.h"
#include "plugin/python/nets.h"
#include "plugin/python/questions.h"
#include "plugin/python/swig_bridge.h"
#include "plugin/reports/models/info.h"
#include "plugin/reports/models/reading.h"
#include "plugin/reports/models/repairs.h"
#include "plugin/reports/text/number_text.h"

namespace py = pybind11;
using py::arg;

namespace blossom::python {
namespace {

Control control_of(double tolerance, const std::string& form, double time_limit,
                   std::optional<long> budget, int threads, int nice,
                   std::shared_ptr<Cancel> cancel, py::object progress) {
  static const std::map<std::string, CellForm> forms = {
      {"auto", CellForm::Auto}, {"bezier", CellForm::Bezier}, {"monomial", CellForm::Monomial}};
  Control control;
  control.engine.tolerances.point = tolerance;
  control.engine.form = forms.at(form);
  control.engine.time_limit = time_limit;
  if (budget) control.engine.budget = *budget;
  control.engine.threads = threads;
  control.nice = nice;
  control.cancel = std::move(cancel);
  control.progress = std::move(progress);
  return control;
}

// No file may end the program that Python runs in, FreeCAD, say.
SharedModel read_file(const std::string& path, bool strict, const Control& control) {
  return interruptible(control, [&](const Watch& watch) {
    const auto stop = [&] {
      watch.stop();
      const double limit = control.engine.time_limit;
      if (limit > 0 && watch.seconds() > limit)
        throw occt::Failure(path + ": the time limit of " + reports::number_text(limit) +
                            " s was reached while reading it");
    };
    occt::Model model = occt::read_model_in_child(path, {.damaged = true}, stop);
    if (strict && model.reading().grade() == occt::ReadingGrade::ShapesLost)
      throw occt::BadModel(path + ": is refused as strict: " + model.reading().summary());
    return std::make_shared<LoadedModel>(path, std::move(model), reports::Repairing::Used);
  });
}

// Of a file that is there for the moment: the model is of none, so nothing would tell later what
// reading it lost.
SharedModel read_passing(const std::string& path, const std::string& name) {
  const py::gil_scoped_release released;
  const occt::Model model = occt::read_model(path);
  if (model.reading().grade() != occt::ReadingGrade::Whole)
    throw occt::BadModel(name + ": its STEP text loses what it has: " + model.reading().summary());
  return std::make_shared<LoadedModel>(name, model.copy(), reports::Repairing::Used);
}

// trusted   a program made them just now, and they are read at once
SharedModel read_bytes(const py::bytes& bytes, const std::string& name, bool trusted) {
  const std::string_view view = bytes;
  if (trusted) {
    const py::gil_scoped_release released;
    return std::make_shared<LoadedModel>(name, occt::shape_from_bytes(view, name));
  }
  return interruptible(Control(), [&](const Watch& watch) {
    const auto stop = [&watch] { watch.stop(); };
    return std::make_shared<LoadedModel>(name, occt::rehearsed_shape_from_bytes(view, name, stop));
  });
}

// An empty compound, as FreeCAD has it for what two solids have in common if that is nothing.
SharedModel nothing() {
  return std::make_shared<LoadedModel>("nothing", occt::compound_of(std::vector<TopoDS_Face>{}));
}

SharedModel from_swig(const py::handle& object, const std::string& name) {
  const std::optional<TopoDS_Shape> shape = shape_from_swig(object);
  if (!shape) return nullptr;
  if (shape->IsNull()) throw InvalidInput(name + ": the shape is null");
  return std::make_shared<LoadedModel>(name, *shape);
}

py::bytes brep_bytes(LoadedModel& model) {
  return py::bytes(in_turn(model, [](LoadedModel& m) { return occt::brep_text(m.shape()); }));
}

std::vector<std::string> write_file(LoadedModel& model, const std::string& path,
                                    const Control& control) {
  const std::vector<occt::WriteNote> notes = interruptible(control, [&](const Watch& watch) {
    const LoadedModel::Turn turn = model.turn(watch);
    const std::function<void()> stop = [&watch] { watch.stop(); };
    if (!model.is_part()) return occt::write_model(model.repaired_input(watch).model, path, stop);
    return occt::write_model(reports::alone(model.repaired_input(watch)), path, stop);
  });
  std::vector<std::string> told;
  for (const occt::WriteNote& note : notes)
    if (!note.within_tolerance) told.push_back(note.text);
  return told;
}

py::dict counts_of(LoadedModel& model) {
  py::dict counts;
  for (const reports::ShapeCount& each :
       in_turn(model, [](LoadedModel& m) { return reports::shape_counts(m.shape()); }))
    counts[each.many] = each.count;
  return counts;
}

py::object reading_of(const LoadedModel& model) {
  return to_python(in_turn(model, [](const LoadedModel& m) {
    const occt::Model* const file = m.file();
    return file ? reports::reading_json(file->file(), file->reading()) : reports::Json();
  }));
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
      if (occt::is_lack_of_memory())
        PyErr_NoMemory();
      else
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
           arg("threads"), arg("nice"), arg("cancel"), arg("progress"));
}

py::object model_repairs(LoadedModel& model) {
  return to_python(in_turn(model, [](LoadedModel& m) { return reports::repairs_json(m.input()); }));
}

SharedModel part_of(LoadedModel& model, const std::vector<int>& numbers,
                    const std::vector<std::string>& words, const std::string& name) {
  return in_turn(model, [&](LoadedModel& m) { return m.part(numbers, words, name); });
}

std::vector<std::string> words_in(LoadedModel& model, const std::string& list) {
  return in_turn(model, [&](LoadedModel& m) { return reports::words_in(m.model(), list); });
}

SharedModel usable_part(LoadedModel& model, const Control& control) {
  return interruptible(control, [&](const Watch& watch) {
    const LoadedModel::Turn turn = model.turn(watch);
    return model.usable_part(watch);
  });
}

// What faces have that it was made without, and their numbers.
py::dict left_out(const LoadedModel& model) {
  const reports::UnusableFaces& faces = model.left_out();
  py::dict numbers;
  if (!faces.open.empty()) numbers["lost a border"] = faces.open;
  if (!faces.lines.empty()) numbers["no width"] = faces.lines;
  return numbers;
}

TopoDS_Shape chosen_shape(LoadedModel& model) { return model.shape(); }

/// A property that `ask(model)` tells in the model's turn.
template <class Ask>
auto told(Ask ask) {
  return [ask](LoadedModel& model) {
    return in_turn(model, [ask](LoadedModel& m) { return std::invoke(ask, m); });
  };
}

void add_model(py::module_& module) {
  py::class_<LoadedModel, SharedModel>(module, "Model")
      .def_property_readonly("name", &LoadedModel::name)
      .def_property_readonly("face_count", told(&LoadedModel::face_count))
      .def_property_readonly("counts", &counts_of)
      .def_property_readonly("file", told([](const LoadedModel& m) {
                               return m.file() ? m.file()->file().string() : std::string();
                             }))
      .def_property_readonly("file_unit", told([](const LoadedModel& m) {
                               return m.file() ? m.file()->file_unit() : std::string();
                             }))
      .def_property_readonly("reading", &reading_of)
      .def("numbers", told([](LoadedModel& m) { return m.input().numbers; }))
      .def("face_names", told([](LoadedModel& m) { return m.input().model.face_names(); }))
      .def("part_paths", told([](LoadedModel& m) { return m.input().model.part_paths(); }))
      .def("repairs", &model_repairs)
      .def("part", &part_of, arg("numbers"), arg("words"), arg("name"))
      .def("words_in", &words_in, arg("list"))
      .def("usable_part", &usable_part, arg("control"))
      .def_property_readonly("left_out", &left_out)
      .def("brep", &brep_bytes)
      .def("swig", [](LoadedModel& m) { return swig_from_shape(in_turn(m, chosen_shape)); })
      .def("write", &write_file, arg("path"), arg("control"));
  module.def("read_file", &read_file, arg("path"), arg("strict"), arg("control"));
  module.def("read_passing", &read_passing, arg("path"), arg("name"));
  module.def("read_bytes", &read_bytes, arg("brep"), arg("name"), arg("trusted"));
  module.def("nothing", &nothing);
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
  bp::add_questions(module);
  bp::add_mesh_questions(module);
}
