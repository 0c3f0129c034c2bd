// SPDX-License-Identifier: LGPL-2.1-or-later
// What triangles of a file are, in words and as JSON (schema blossom.mesh-info/1).

#pragma once

#include <functional>
#include <string>

#include "core/meshes/mesh_facts.h"
#include "plugin/meshes/mesh_files.h"
#include "plugin/reports/text/json.h"

namespace blossom::meshes {

/// As mesh_facts of these triangles.
MeshFacts facts_of(const FileMesh& mesh, const std::function<void()>& ask = {});

reports::Json mesh_info_report(const std::string& file, const FileMesh& mesh,
                               const MeshFacts& facts);

/// groups   whether they are listed
std::string mesh_info_text(const std::string& file, const FileMesh& mesh, const MeshFacts& facts,
                           bool groups);

/// "closed, volume 2", or "not closed, area 7".
std::string enclosed_text(const MeshFacts& facts);

/// A line where an open mesh has points at one place, or no two triangles a side in common; else
/// nothing.
std::string loose_text(const FileMesh& mesh, const MeshFacts& facts);

}  // namespace blossom::meshes
