// SPDX-License-Identifier: LGPL-2.1-or-later
// Sections with planes as files of drawings: .dxf and .svg.

#pragma once

#include <filesystem>
#include <functional>

#include "plugin/reports/queries/section.h"

namespace blossom::drawings {

/// .dxf or .svg in any case.
bool is_drawing_file(const std::filesystem::path& file);

/// Polylines are within 1e-5 of the size of all sections; lines, circles and arcs are such. Whole
/// or not at all.
/// file     see is_drawing_file
/// stop     see occt::write_text
/// throws   occt::Failure if it cannot be written
void write_section_drawing(const reports::SectionsAnswer& answer, const std::filesystem::path& file,
                           const std::function<void()>& stop = {});

}  // namespace blossom::drawings
