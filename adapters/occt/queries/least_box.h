// SPDX-License-Identifier: LGPL-2.1-or-later
// The least box along the axes around a shape.

#pragma once

#include <functional>

#include <TopoDS_Shape.hxx>

#include "core/bounds/box_tree.h"

namespace blossom::occt {

class KeptForms;

struct LeastBox {
  Box box;               ///< each side goes through a point of the shape; model units
  double precision = 0;  ///< proven: the shape reaches no farther beyond any side
};

/// The box of faces within their trims, of edges and vertices; tolerances do not count. Faces of
/// straight lines go no farther than their edges, and straight edges no farther than their ends;
/// arcs of circles and ellipses are in closed form. Of the rest, what has no control point beyond
/// these is not looked at; sides that others may pass are searched in that coordinate alone, to
/// 1e-7, to the tolerances of edges that faces may pass, or to the error of approximated forms.
///
/// shape       with at least a vertex
/// cancelled   asked now and then; when true, the precision is what is known by then
/// forms       of faces; those that are taken from there are gone
/// throws      as MeasuredShape
LeastBox least_box(const TopoDS_Shape& shape, const std::function<bool()>& cancelled = {},
                   KeptForms* forms = nullptr);

}  // namespace blossom::occt
