// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plugin/cli/output/reasons.h"

namespace blossom::cli {

std::vector<std::string> reported_reasons(const Certificate& certificate, Contacts contacts) {
  static const std::string kListed = "in the listed contacts";
  std::vector<std::string> reasons = certificate.reasons;
  if (contacts == Contacts::NotListed)
    for (std::string& reason : reasons)
      if (const std::size_t at = reason.find(kListed); at != std::string::npos)
        reason.replace(at, kListed.size(), "in places");
  return reasons;
}

}  // namespace blossom::cli
