// SPDX-License-Identifier: LGPL-2.1-or-later
// Which wires bound one face: what is left of a face may be several.

#pragma once

#include <vector>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

namespace blossom::occt {

using Wires = std::vector<std::vector<TopoDS_Edge>>;

/// Wires sorted by outer ones, each with the holes in it: an outer wire has its inside to its left
/// in the chart, and a hole belongs to the smallest one that goes round it. All together if no more
/// than one is an outer wire, if a wire does not close in the chart, as one round a cylinder, or if
/// a hole lies in none.
///
/// face   forward; the wires' edges have curves in its chart
std::vector<Wires> nested(const Wires& wires, const TopoDS_Face& face);

}  // namespace blossom::occt
