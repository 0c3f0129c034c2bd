// SPDX-License-Identifier: GPL-3.0-or-later
// What CGAL says of meshes, and the memory that it takes to make them.

#pragma once

#include <functional>

#include <TopoDS_Shape.hxx>

#include "tests/bench/meshes_measure.h"

namespace blossom::bench {

struct MeshVerdict {
  bool closed = true, manifold = true;
  int crossings = 0;
};

/// Of the facets of each solid by itself, since solids may touch; of the faces that are in none
/// together.
MeshVerdict judged_mesh(const TopoDS_Shape& shape, const FacetMesh& mesh);

/// By how much work raises the peak of memory in a process of its own; 0 if it does not get done.
double peak_megabytes(const std::function<void()>& work);

}  // namespace blossom::bench
