// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/version.h"

#include <Standard_Version.hxx>

namespace blossom::cli {

std::string version_number() { return BLOSSOM_VERSION; }

std::string version_text() {
  constexpr bool kGpl = BLOSSOM_LINKS_GPL != 0;
  return "blossom " + version_number() + "\nOpen CASCADE " OCC_VERSION_COMPLETE "\nLicence: " +
         (kGpl ? "GPL-3.0-or-later (CGAL's GPL parts are linked in)"
               : "LGPL-2.1-or-later (no GPL part is linked in)");
}

}  // namespace blossom::cli
