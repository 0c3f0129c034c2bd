// SPDX-License-Identifier: LGPL-2.1-or-later
// The words of a failure of Open CASCADE.

#include "adapters/occt/errors.h"

#include <exception>

#include <Standard_Type.hxx>

namespace blossom::occt {

std::string current_failure_text() {
  const std::exception_ptr current = std::current_exception();
  if (!current) return "no failure";
  try {
    std::rethrow_exception(current);
  } catch (const Standard_Failure& failure) {
    const std::string message =
        failure.GetMessageString() != nullptr ? failure.GetMessageString() : "";
    const std::string type = failure.DynamicType()->Name();
    return message.empty() ? type : type + ": " + message;
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "unknown failure";
  }
}

}  // namespace blossom::occt
