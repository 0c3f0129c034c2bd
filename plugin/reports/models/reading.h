// SPDX-License-Identifier: LGPL-2.1-or-later
// What reading a file lost, as the member `reading` of reports lists it.

#pragma once

#include <filesystem>

#include "adapters/occt/reading.h"
#include "plugin/reports/text/json.h"

namespace blossom::reports {

/// An entry of that list.
Json reading_json(const std::filesystem::path& file, const occt::ReadingReport& report);

}  // namespace blossom::reports
