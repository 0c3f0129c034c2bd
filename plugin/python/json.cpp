// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/python/json.h"

#include <cmath>
#include <cstdint>
#include <string>

namespace py = pybind11;

namespace blossom::python {

namespace {

// Between two moments in which other threads may have Python's lock; about a millisecond.
constexpr int kValuesAtOnce = 8192;

class Converter {
 public:
  py::object value(const reports::Json& json) {
    if (++count_ % kValuesAtOnce == 0) const py::gil_scoped_release others_may_go_on;
    if (json.is_object()) {
      py::dict made;
      for (const auto& [key, member] : json.items()) made[py::str(key)] = value(member);
      return made;
    }
    if (json.is_array()) {
      py::list made(json.size());
      for (std::size_t i = 0; i < json.size(); ++i) made[i] = value(json[i]);
      return made;
    }
    if (json.is_boolean()) return py::bool_(json.get<bool>());
    if (json.is_number_unsigned()) return py::int_(json.get<std::uint64_t>());
    if (json.is_number_integer()) return py::int_(json.get<std::int64_t>());
    if (json.is_number_float() && std::isfinite(json.get<double>()))
      return py::float_(json.get<double>());
    if (!json.is_string()) return py::none();
    // File names may hold bytes that are no UTF-8.
    const std::string& text = json.get_ref<const std::string&>();
    return py::reinterpret_steal<py::object>(
        PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace"));
  }

 private:
  int count_ = 0;
};

}  // namespace

py::object to_python(const reports::Json& json) { return Converter().value(json); }

}  // namespace blossom::python
