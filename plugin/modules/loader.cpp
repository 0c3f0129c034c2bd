// SPDX-License-Identifier: LGPL-2.1-or-later
// The program's own step_module, document_module and three_mf_bytes: they load what the libraries
// of Open CASCADE's exchange and of 3MF are linked to, when it is first asked for.

#include <dlfcn.h>

#include <array>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "adapters/occt/base/errors.h"
#include "adapters/occt/exchange/modules.h"
#include "plugin/modules/entry.h"
#ifdef BLOSSOM_WITH_LIB3MF
#include "plugin/modules/three_mf.h"
#endif

namespace blossom {
namespace {

namespace fs = std::filesystem;

/// Where modules are, from the folder of the program: where it was built, and where it is
/// installed.
constexpr std::array kFolders{"modules", BLOSSOM_MODULE_FOLDER};

fs::path file_of(const std::string& name) {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path();
  fs::path file;
  for (const char* folder : kFolders) {
    file = (program / folder / name).lexically_normal();
    if (fs::exists(file, error)) break;
  }
  return file;
}

[[noreturn]] void fail(const std::string& what, const std::string& cause) {
  throw occt::Failure("what is needed for " + what + " cannot be loaded: " + cause +
                      "; Blossom has to be installed again");
}

/// what     it is needed for, in words
const void* load(const std::string& name, const std::string& what) {
  const fs::path file = file_of(name);
  void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) fail(what, dlerror());
  const auto entry = reinterpret_cast<ModuleEntry*>(dlsym(library, kModuleEntry));
  const void* const module = entry == nullptr ? nullptr : entry(BLOSSOM_INTERFACE);
  if (module == nullptr) fail(what, file.string() + " belongs to another version");
  return module;
}

}  // namespace

namespace occt {

const StepModule& step_module() {
  static const void* const module = load("blossom_step.so", "STEP files");
  return *static_cast<const StepModule*>(module);
}

const DocumentModule& document_module() {
  static const void* const module =
      load("blossom_documents.so", "assemblies, colours, IGES and the writing of STEP");
  return *static_cast<const DocumentModule*>(module);
}

}  // namespace occt

#ifdef BLOSSOM_WITH_LIB3MF
namespace {

const ThreeMfModule& three_mf_module() {
  static const void* const module = load("blossom_three_mf.so", "3MF files");
  return *static_cast<const ThreeMfModule*>(module);
}

}  // namespace

void lib3mf::load_three_mf() { three_mf_module(); }

std::string lib3mf::three_mf_bytes(const std::vector<ThreeMfObject>& objects) {
  return three_mf_module().bytes(objects);
}
#endif

}  // namespace blossom
