// SPDX-License-Identifier: LGPL-2.1-or-later
// Errors of reading, converting and writing models, in words a user can act on.

#pragma once

#include <stdexcept>
#include <string>

namespace blossom::occt {

/// The input cannot be used: a missing or corrupt file, a face that does not exist, geometry
/// that is no geometry. The message names the file, the face or entity, and the cause.
class BadModel : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The result cannot be produced or written: an unwritable folder, a full disk, an operation
/// of Open CASCADE that failed. The message names the file and the cause.
class Failure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs `work` and turns Open CASCADE's `Standard_Failure`, which is no std::exception, into
/// Failure("<doing>: <what that means for a model>"), and its want of memory into std::bad_alloc.
/// doing     what is being done, for example "reading part.step"
template <class Work>
auto guarded(const std::string& doing, Work&& work) -> decltype(work());

/// Whether the failure that is being handled is want of memory, in Open CASCADE or elsewhere.
bool is_lack_of_memory();

/// The failure that is being handled, in words about a model: "something needed is missing".
/// Want of memory says nothing about a model: it goes on as std::bad_alloc, so that nobody takes
/// what there was no room for as lost or damaged.
std::string current_failure_text();

}  // namespace blossom::occt

#include "adapters/occt/base/errors_impl.h"
