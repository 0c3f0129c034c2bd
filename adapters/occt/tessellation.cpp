// SPDX-License-Identifier: LGPL-2.1-or-later
#include "adapters/occt/tessellation.h"

#include <algorithm>
#include <utility>

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "adapters/occt/tessellation/shape_reader.h"

namespace blossom::occt {
namespace {

// Of the deviation: what conversion may add to it, and no less than models are exact.
constexpr double kConversionPart = 1e-3;
constexpr double kFinest = 1e-7;  // model units

}  // namespace

ShapeTessellation tessellation(const TopoDS_Shape& shape, const FacetOptions& options,
                               const std::function<bool()>& ask, const FacetFaults& faults) {
  ReadShape read = read_shape(shape, std::max(kFinest, kConversionPart * options.deviation));
  ShapeTessellation result;
  MendedFacets made = mended_facets(std::move(read.model), options, faults, ask);
  result.facets = std::move(made.facets);
  result.finer = std::move(made.finer);
  result.looked = made.looked;
  for (std::size_t f = 0; f < result.facets.faces.size(); ++f)
    if (!read.refusals[f].empty()) result.facets.faces[f].obstacle = read.refusals[f];
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  for (int k = 1; k <= faces.Extent(); ++k)
    result.reversed.push_back(faces(k).Orientation() == TopAbs_REVERSED);
  return result;
}

std::vector<std::array<int, 3>> triangles_of(const ShapeTessellation& tessellation,
                                             std::vector<int>* face) {
  std::size_t count = 0;
  for (const MeshedFace& meshed : tessellation.facets.faces) count += meshed.triangles.size();
  std::vector<std::array<int, 3>> result;
  result.reserve(count);
  if (face) face->reserve(count);
  for (std::size_t f = 0; f < tessellation.facets.faces.size(); ++f) {
    const MeshedFace& meshed = tessellation.facets.faces[f];
    for (const std::array<int, 3>& triangle : meshed.triangles) {
      std::array<int, 3> made{};
      for (std::size_t k = 0; k < 3; ++k)
        made[k] = meshed.vertices[static_cast<std::size_t>(triangle[k])];
      if (tessellation.reversed[f]) std::swap(made[1], made[2]);
      result.push_back(made);
      if (face) face->push_back(static_cast<int>(f));
    }
  }
  return result;
}

}  // namespace blossom::occt
