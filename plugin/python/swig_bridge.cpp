// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/python/swig_bridge.h"

#ifdef BLOSSOM_WITH_SWIG
#include <swigpyrun.h>
#endif

namespace py = pybind11;

namespace blossom::python {

#ifdef BLOSSOM_WITH_SWIG

namespace {

swig_type_info* shape_type() { return SWIG_TypeQuery("TopoDS_Shape *"); }

}  // namespace

bool has_swig_bridge() { return true; }

std::optional<TopoDS_Shape> shape_from_swig(py::handle object) {
  swig_type_info* const type = shape_type();
  void* found = nullptr;
  if (type == nullptr || !SWIG_IsOK(SWIG_ConvertPtr(object.ptr(), &found, type, 0)) ||
      found == nullptr) {
    PyErr_Clear();
    return std::nullopt;
  }
  return *static_cast<const TopoDS_Shape*>(found);
}

py::object swig_from_shape(const TopoDS_Shape& shape) {
  swig_type_info* const type = shape_type();
  if (type == nullptr) return py::none();
  return py::reinterpret_steal<py::object>(
      SWIG_NewPointerObj(new TopoDS_Shape(shape), type, SWIG_POINTER_OWN));
}

#else

bool has_swig_bridge() { return false; }
std::optional<TopoDS_Shape> shape_from_swig(py::handle) { return std::nullopt; }
py::object swig_from_shape(const TopoDS_Shape&) { return py::none(); }

#endif

}  // namespace blossom::python
