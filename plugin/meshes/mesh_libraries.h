// SPDX-License-Identifier: LGPL-2.1-or-later
// What the program loads for formats of meshes.

#pragma once

namespace blossom::meshes {

/// Loads what the writing of .3mf needs, once; nothing where that is linked, or was not built in.
/// throws   occt::Failure if it is not there or of another build
void load_three_mf();

}  // namespace blossom::meshes
