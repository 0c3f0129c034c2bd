// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/version.h"

#include <oneapi/tbb/version.h>
#include <sys/stat.h>
#include <zlib.h>

#include <algorithm>

#include <CLI/Version.hpp>
#include <Standard_Version.hxx>
#include <boost/version.hpp>
#include <nlohmann/json.hpp>

namespace blossom::cli {
namespace {

// What is linked, as it is at this run where the library can tell.
std::string libraries() {
  std::string boost = BOOST_LIB_VERSION;  // "1_74"
  std::ranges::replace(boost, '_', '.');
  return "Open CASCADE " OCC_VERSION_COMPLETE ", oneTBB " + std::string(TBB_runtime_version()) +
         ", Boost " + boost + ", CLI11 " CLI11_VERSION ", JSON for Modern C++ " +
         nlohmann::json::meta()["version"]["string"].get<std::string>() + ", zlib " + zlibVersion();
}

}  // namespace

std::string version_number() { return BLOSSOM_VERSION; }

std::string build_name() {
  struct stat program {};
  stat("/proc/self/exe", &program);
  return version_number() + "/" + std::to_string(program.st_size) + "/" +
         std::to_string(program.st_mtim.tv_sec) + "." + std::to_string(program.st_mtim.tv_nsec);
}

std::string version_text() {
  constexpr bool kGpl = BLOSSOM_LINKS_GPL != 0;
  return "blossom " + version_number() + "\nLicence: " +
         (kGpl ? "GPL-3.0-or-later (CGAL's GPL parts are linked in)"
               : "LGPL-2.1-or-later (no GPL part is linked in)") +
         "\nLibraries: " + libraries();
}

}  // namespace blossom::cli
