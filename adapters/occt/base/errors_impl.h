// SPDX-License-Identifier: LGPL-2.1-or-later
// The body of `guarded`; included by errors.h alone.

#pragma once

#include <utility>

#include <Standard_Failure.hxx>

namespace blossom::occt {

template <class Work>
auto guarded(const std::string& doing, Work&& work) -> decltype(work()) {
  try {
    return std::forward<Work>(work)();
  } catch (const Standard_Failure&) {
    throw Failure(doing + ": " + current_failure_text());
  }
}

}  // namespace blossom::occt
