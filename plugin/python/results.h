// SPDX-License-Identifier: LGPL-2.1-or-later
// The answer of an intersection as Python sees it.

#pragma once

#include <memory>

#include <pybind11/pybind11.h>

#include "adapters/occt/convert/border_numbers.h"
#include "adapters/occt/intersection.h"

namespace blossom::python {

/// Shared by the answer and all its parts, so that numpy views stay alive.
struct Answer {
  occt::ShapeIntersection found;
  occt::BorderNumbers numbers_a, numbers_b;
  double seconds = 0;  ///< from shapes in memory to the finished answer
};

using SharedAnswer = std::shared_ptr<const Answer>;

/// Adds the class Intersection and those of its parts to the module.
void add_results(pybind11::module_& module);

/// A Python object of the class Intersection.
pybind11::object python_answer(Answer answer);

}  // namespace blossom::python
