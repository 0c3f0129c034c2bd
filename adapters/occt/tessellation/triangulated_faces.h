// SPDX-License-Identifier: LGPL-2.1-or-later
// Facets as the triangulations that Open CASCADE keeps on faces.

#pragma once

#include <TopoDS_Shape.hxx>

#include "adapters/occt/tessellation.h"

namespace blossom::occt {

/// Puts the facets of a shape on its faces, with parameters and normals; one that is there several
/// times has one triangulation, that of its first place. What was there before is taken away.
void put_on_faces(const ShapeTessellation& tessellation, const TopoDS_Shape& shape);

}  // namespace blossom::occt
