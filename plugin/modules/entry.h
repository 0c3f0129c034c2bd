// SPDX-License-Identifier: LGPL-2.1-or-later
// How the program and its modules meet: one function of each module, by its name. All else in a
// module is hidden: it has its own copy of what it shares with the program.

#pragma once

#include <string_view>

namespace blossom {

/// Its name in every module.
inline constexpr const char* kModuleEntry = "blossom_module";

/// interface  BLOSSOM_INTERFACE of who asks, which stands for the headers it was built with
/// returns    the StepModule, DocumentModule or ThreeMfModule; null for another interface
using ModuleEntry = const void*(const char* interface);

/// What an entry answers.
inline const void* module_for(const char* interface, const void* module) {
  return std::string_view(interface) == BLOSSOM_INTERFACE ? module : nullptr;
}

}  // namespace blossom

extern "C" __attribute__((visibility("default"))) blossom::ModuleEntry blossom_module;
