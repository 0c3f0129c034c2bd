// SPDX-License-Identifier: LGPL-2.1-or-later
// Reports as Python's dictionaries, lists, numbers and texts.

#pragma once

#include <pybind11/pybind11.h>

#include "plugin/reports/text/json.h"

namespace blossom::python {

/// What is not finite is None, as in the files that the command line writes.
pybind11::object to_python(const reports::Json& json);

}  // namespace blossom::python
