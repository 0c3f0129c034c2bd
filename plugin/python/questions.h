// SPDX-License-Identifier: LGPL-2.1-or-later
// The questions of the module as functions of Python.

#pragma once

#include <pybind11/pybind11.h>

namespace blossom::python {

/// `Answer`, and a function for each question.
void add_questions(pybind11::module_& module);

}  // namespace blossom::python
