// SPDX-License-Identifier: LGPL-2.1-or-later
// Meshes of triangles as they are, and what is asked of them, as functions of Python.

#pragma once

#include <pybind11/pybind11.h>

namespace blossom::python {

/// `Triangles`, which is a mesh, and a function for each question of one.
void add_mesh_questions(pybind11::module_& module);

}  // namespace blossom::python
