// SPDX-License-Identifier: LGPL-2.1-or-later
// Facets that are finer where they would be at fault, as where they cross.

#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "core/tessellation/facet_options.h"
#include "core/tessellation/shape_facets.h"
#include "core/tessellation/shape_model.h"

namespace blossom {

/// By the number of each face whose facets are at fault how much is wrong with them; nothing if
/// nobody looks, as at too many.
using FacetFaults =
    std::function<std::optional<std::map<int, std::size_t>>(const ShapeFacets& facets)>;

struct MendedFacets {
  ShapeFacets facets;
  std::vector<int> finer;  ///< numbers of faces that keep less than the deviation
  int looked = -1;         ///< the call of `faults` that saw these facets, from 0 on; none: -1
};

/// The facets of all faces, where the faces at fault, with their edges, keep a quarter of the
/// deviation, and again, up to three times: sides are half as long then each time. A face whose
/// faults do not become fewer is as coarse as was asked, as finer facets do not end them: where
/// surfaces themselves cross they become more. So is one whose finer facets would make them all
/// more than four times as many, and more than 50 000.
///
/// model    each face's part is 1
/// throws   as shape_facets, and what `faults` throws
MendedFacets mended_facets(ShapeModel model, const FacetOptions& options, const FacetFaults& faults,
                           const std::function<bool()>& ask = {});

}  // namespace blossom
