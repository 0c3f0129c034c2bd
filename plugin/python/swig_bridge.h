// SPDX-License-Identifier: LGPL-2.1-or-later
// Shapes of other Python modules in the same process, without a copy: they stay the same shapes.
//
// FreeCAD's Part, and pythonOCC, hand over shapes as SWIG's objects of the type `TopoDS_Shape *`.
// SWIG's modules share a table of types; the package's module `swig_shapes` enters that type.

#pragma once

#include <optional>

#include <pybind11/pybind11.h>
#include <TopoDS_Shape.hxx>

namespace blossom::python {

/// Whether the type can be in SWIG's table.
bool has_swig_bridge();

/// The shape of such an object; nothing if it is none.
std::optional<TopoDS_Shape> shape_from_swig(pybind11::handle object);

/// Such an object; None if no module has entered the type.
pybind11::object swig_from_shape(const TopoDS_Shape& shape);

}  // namespace blossom::python
