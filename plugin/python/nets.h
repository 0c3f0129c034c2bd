// SPDX-License-Identifier: LGPL-2.1-or-later
// Bezier nets of numpy as faces.

#pragma once

#include <string>

#include <pybind11/numpy.h>

namespace blossom::python {

/// The face on a Bezier patch, as BRep bytes.
/// net      (n + 1, m + 1, 3) points, or (n + 1, m + 1, 4) points x, y, z and weight; rows along u
/// name     what the caller calls the argument, for messages
/// throws   InvalidInput if the shape, a degree, a number or a weight is bad
std::string brep_of_net(const pybind11::array_t<double>& net, const std::string& name);

}  // namespace blossom::python
