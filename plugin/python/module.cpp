// SPDX-License-Identifier: LGPL-2.1-or-later
// The compiled part of the Python package `blossom`. Shapes come and go as BRep bytes.

#include <chrono>
#include <cmath>
#include <exception>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/exchange/brep_bytes.h"
#include "adapters/occt/intersection.h"
#include "adapters/occt/intersection_edges.h"
#include "adapters/occt/shapes.h"
#include "adapters/occt/strip.h"
#include "core/base/errors.h"
#include "plugin/python/interruptible.h"
#include "plugin/python/nets.h"
#include "plugin/python/results.h"

namespace py = pybind11;

namespace blossom::python {
namespace {

template <class Value>
Value one_of(const std::map<std::string, Value>& known, const std::string& word,
             const std::string& name) {
  if (const auto found = known.find(word); found != known.end()) return found->second;
  std::string words;
  for (const auto& [key, value] : known) words += (words.empty() ? "" : ", ") + key;
  throw InvalidInput(name + ": '" + word + "' is none of " + words);
}

const std::map<std::string, CellForm> kForms = {
    {"auto", CellForm::Auto}, {"bezier", CellForm::Bezier}, {"monomial", CellForm::Monomial}};

const std::map<std::string, SurfaceSide> kSides = {{"umax", SurfaceSide::UMax},
                                                   {"umin", SurfaceSide::UMin},
                                                   {"vmax", SurfaceSide::VMax},
                                                   {"vmin", SurfaceSide::VMin}};

IntersectionOptions options_from(double tolerance, const std::string& form, double time_limit,
                                 std::optional<long> budget, int threads) {
  if (!(tolerance > 0) || !std::isfinite(tolerance))
    throw InvalidInput("tolerance: '" + std::to_string(tolerance) + "' is no positive number");
  if (!(time_limit >= 0) || !std::isfinite(time_limit))
    throw InvalidInput("time_limit: '" + std::to_string(time_limit) +
                       "' is no positive number and not 0");
  if (budget && *budget < 1)
    throw InvalidInput("budget: " + std::to_string(*budget) + " is less than 1");
  if (threads < 0) throw InvalidInput("threads: " + std::to_string(threads) + " is negative");
  IntersectionOptions options;
  options.tolerances.point = tolerance;
  options.form = one_of(kForms, form, "form");
  options.time_limit = time_limit;
  if (budget) options.budget = *budget;
  options.threads = threads;
  return options;
}

std::vector<TopoDS_Face> faces_from(const TopoDS_Shape& shape, const std::string& name) {
  std::vector<TopoDS_Face> faces = occt::faces_of(shape);
  if (faces.empty()) throw occt::BadModel(name + ": there is no face in it");
  return faces;
}

TopoDS_Face one_face(const std::string& bytes, const std::string& name) {
  const std::vector<TopoDS_Face> faces = faces_from(occt::shape_from_bytes(bytes, name), name);
  if (faces.size() > 1)
    throw occt::BadModel(name + ": one face is wanted, got " + std::to_string(faces.size()));
  return faces.front();
}

py::object intersect_bytes(const std::string& a, const std::string& b, double tolerance,
                           const std::string& form, double time_limit, std::optional<long> budget,
                           int threads) {
  IntersectionOptions options = options_from(tolerance, form, time_limit, budget, threads);
  return python_answer(interruptible([&](const std::atomic<bool>& cancelled) {
    const TopoDS_Shape shape_a = occt::shape_from_bytes(a, "a");
    const TopoDS_Shape shape_b = occt::shape_from_bytes(b, "b");
    const std::vector<TopoDS_Face> faces_a = faces_from(shape_a, "a");
    const std::vector<TopoDS_Face> faces_b = faces_from(shape_b, "b");
    options.cancelled = [&] { return cancelled.load(); };
    const auto start = std::chrono::steady_clock::now();
    Answer answer{occt::intersect(faces_a, faces_b, options), occt::BorderNumbers(shape_a),
                  occt::BorderNumbers(shape_b)};
    answer.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return answer;
  }));
}

std::optional<SurfaceSide> side_from(const std::optional<std::string>& word,
                                     const std::string& name) {
  if (!word) return std::nullopt;
  return one_of(kSides, *word, name);
}

py::dict contact_dict(const StripContact& contact) {
  using namespace py::literals;
  return py::dict("gap"_a = contact.gap, "normal_angle"_a = contact.normal_angle,
                  "scale"_a = contact.scale);
}

py::dict strip_bytes(const std::string& a, const std::string& b,
                     const std::optional<std::string>& edge_a,
                     const std::optional<std::string>& edge_b, double weight_a, double weight_b) {
  using namespace py::literals;
  occt::FaceStripOptions options{.side_a = side_from(edge_a, "edge_a"),
                                 .side_b = side_from(edge_b, "edge_b"),
                                 .strip = {.weight_a = weight_a, .weight_b = weight_b}};
  occt::FaceStrip strip;
  std::string text;
  {
    const py::gil_scoped_release released;
    strip = occt::strip_between(one_face(a, "a"), one_face(b, "b"), options);
    text = occt::brep_text(strip.face);
  }
  return py::dict("brep"_a = py::bytes(text), "edge_a"_a = to_string(strip.side_a),
                  "edge_b"_a = to_string(strip.side_b), "backward"_a = strip.strip.backward,
                  "continuity_a"_a = contact_dict(strip.strip.contacts[0]),
                  "continuity_b"_a = contact_dict(strip.strip.contacts[1]));
}

/// Bad input is a ValueError, everything else blossom.Error; Open CASCADE's failures too, which
/// Python would otherwise call an unknown exception.
void add_errors(py::module_& module) {
  static py::exception<occt::Failure> error(module, "Error", PyExc_RuntimeError);
  py::register_exception_translator([](std::exception_ptr current) {
    try {
      if (current) std::rethrow_exception(current);
    } catch (const occt::BadModel& bad) {
      PyErr_SetString(PyExc_ValueError, bad.what());
    } catch (const occt::Failure& failure) {
      error(failure.what());
    } catch (const Standard_Failure&) {
      error(occt::current_failure_text().c_str());
    }
  });
}

}  // namespace
}  // namespace blossom::python

PYBIND11_MODULE(_core, module) {
  namespace bp = blossom::python;
  module.doc() = "The compiled part of the package blossom.";
  module.attr("__version__") = BLOSSOM_VERSION;
  blossom::occt::quiet_messages();
  bp::add_errors(module);
  bp::add_results(module);
  module.def("intersect", &bp::intersect_bytes, py::arg("a"), py::arg("b"), py::arg("tolerance"),
             py::arg("form"), py::arg("time_limit"), py::arg("budget"), py::arg("threads"),
             "All intersections of two shapes given as BRep bytes.");
  module.def("blend_strip", &bp::strip_bytes, py::arg("a"), py::arg("b"), py::arg("edge_a"),
             py::arg("edge_b"), py::arg("weight_a"), py::arg("weight_b"),
             "The strip between two faces given as BRep bytes.");
  module.def(
      "brep_of_net",
      [](const py::array_t<double>& net, const std::string& name) {
        return py::bytes(bp::brep_of_net(net, name));
      },
      py::arg("net"), py::arg("name"), "The face on a Bezier net, as BRep bytes.");
}
